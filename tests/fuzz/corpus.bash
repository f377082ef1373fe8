# make_corpus FOLDER: FOLDER/TARGET/*, what each target takes as it is; binary files are made by the tools

make_corpus() {
    local here
    here=$(dirname "${BASH_SOURCE[0]}")
    cp -r "$here"/corpus/* "$1"
    mkdir -p "$1"/image
    cp "$here"/../data/images/*.* "$1"/image
    # what is described elsewhere, or refused as it is
    rm "$1"/image/{README.md,values.raw,detached.nhdr,detached.bytes,bzip2.nrrd,hexagonal.ctf}
    mkdir -p "$1"/{genesis,history,frames,checkpoint}
    (
        cd "$1" || exit 1
        hsgen -q deck/two.yaml -o genesis/two.g || exit 1
        hssolve -q -i genesis/two.g -H history/two.e -o frames/two.e --checkpoint checkpoint/two || exit 1
    )
}
