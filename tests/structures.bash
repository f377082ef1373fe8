# What tests of hsgen ask of it.

# statistic FILE QUANTITY AXIS: its value in the statistics.
statistic() { awk -F, -v q="$2" -v a="$3" '$1 == q && $2 == a { print $4; exit }' "$1"; }

# attribute FILE NAME: of a domain.
attribute() { ncdump -h "$1" | sed -n "s/.*:hs_$2 = \(.*\) ;/\1/p"; }

# refused DECK TEXT...: by hsgen with exit code 2 and each of these texts, and nothing is written.
refused() {
    run hsgen "$1" -o never.g
    [ "$status" -eq 2 ]
    [ ! -e never.g ]
    shift
    for text in "$@"; do [[ $output == *"$text"* ]] || { echo "$output"; return 1; }; done
}

# cell LENGTH SPACING DISTANCE: the deck of a periodic harmonic cell, of cores on fcc
cell() {
    cat <<DECK
title: Cell of the tests
domain:
  specimen: plate
  size: [$1, $1, $1]
  spacing: $2
  periodic: [x, y, z]
  topology: harmonic
  phases: {cg: CG, ufg: UFG}
  lattice: fcc
  core_distance: $3
  ufg_fraction: 0.40
DECK
}
