# make_corpus FOLDER: FOLDER/TARGET/*, what each target takes as it is; binary files are made by the tools

make_corpus() {
    local here
    here=$(dirname "${BASH_SOURCE[0]}")
    cp -r "$here"/corpus/* "$1"
    mkdir -p "$1"/{genesis,history,frames,checkpoint}
    (
        cd "$1" || exit 1
        hsgen -q deck/two.yaml -o genesis/two.g || exit 1
        hssolve -q -i genesis/two.g -H history/two.e -o frames/two.e --checkpoint checkpoint/two || exit 1
    )
}
