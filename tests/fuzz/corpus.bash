# All targets: decks, which are text, first.
# shellcheck disable=SC2034 # used by those who read this file
targets=(deck study peridigm expression text numbers loads values cores image table genesis netcdf4 history frames unfinished checkpoint)

# make_corpus FOLDER: FOLDER/TARGET/*, what each target takes as it is; binary files are made by the tools
make_corpus() {
    local here at kind
    here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
    cp -r "$here"/corpus/* "$1"
    mkdir -p "$1"/image
    cp "$here"/../data/images/*.* "$1"/image
    # what is described elsewhere, or refused as it is
    rm "$1"/image/{README.md,values.raw,detached.nhdr,detached.bytes}
    mkdir -p "$1"/{genesis,netcdf4,history,frames,unfinished,checkpoint}
    (
        cd "$1" || exit 1
        hsgen -q deck/two.yaml -o genesis/two.g || exit 1
        hssolve -q -i genesis/two.g -H history/two.e -o frames/two.e --checkpoint checkpoint/two || exit 1
        # a history whose length, its last word, was not entered
        cp history/two.e unfinished/two.e || exit 1
        at=$(grep -abo hs_file_bytes unfinished/two.e | head -n 1 | cut -d: -f1)
        head -c 8 /dev/zero | dd of=unfinished/two.e bs=1 seek=$((at + 24)) conv=notrunc status=none || exit 1
        # hexahedra in two blocks, with sets
        awk -v nx=6 -v ny=2 -v nz=2 -v lx=6 -v ly=2 -v lz=2 -v form=distorted -v parts=2 -f "$here"/../mesh.awk >mesh.cdl || exit 1
        for kind in classic 64-bit-data; do ncgen -k "$kind" -o genesis/"$kind".g mesh.cdl || exit 1; done
        ncgen -k netCDF-4 -o netcdf4/mesh.g mesh.cdl || exit 1
        rm mesh.cdl
    )
}
