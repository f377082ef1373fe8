#!/usr/bin/env bats
# Several curves: specimens, seeds, their means, their figure, and one long table.

bats_require_minimum_version 1.5.0
load ../curves

setup() {
    records="$BATS_TEST_DIRNAME/../data/records"
    cd "$BATS_TEST_TMPDIR" || return 1
}

# specimens N: s1.csv ... of the curve voce.csv, stresses times 0.97, 1.00, 1.03, 0.97, ...
specimens() {
    for ((k = 1; k <= $1; k++)); do
        awk -F, -v k="$k" '/^e/ {print; next} {print $1 "," $2 * (1 + 0.03 * (k % 3 - 1))}' "$records/voce.csv" >"s$k.csv"
    done
}

@test "mean, deviation and range of a group, of curves and of properties" {
    specimens 6
    hspost -q s?.csv "$records/unloading_loop.csv" --mean mean.csv --statistics statistics.csv --title Al
    [ "$(head -1 mean.csv)" = group,curves,engineering_strain,mean_stress_MPa,standard_deviation_MPa,least_MPa,largest_MPa ]
    [ "$(wc -l <mean.csv)" -eq 402 ]
    hspost -q s?.csv --mean mean.csv --statistics statistics.csv --title Al
    # 0.97, 1 and 1.03, twice each: deviation 0.03 sqrt(4/5) of the mean
    awk -F, 'NR > 2 && $3 > 0.01 && $3 < 0.18 && (($5 / $4 - 0.0268328) ^ 2 > 1e-10 || ($6 / $4 - 0.97) ^ 2 > 1e-10 || $2 != 6) {exit 1}' mean.csv
    grep -q '^Al,tensile_strength,Rm,MPa,6,' statistics.csv
    near "$(awk -F, '$2 == "tensile_strength" {print $6}' statistics.csv)" 221.29365 1e-3
    near "$(awk -F, '$2 == "tensile_strength" {print $7}' statistics.csv)" 5.93793 1e-3
    # blank where no curve has a value
    grep -q '^Al,upper_yield_strength,ReH,MPa,0,,,,$' statistics.csv
}

@test "the last row of a mean is that of the shortest curve's end, however its strain is rounded" {
    rod() { # END in units of 1e-4, E
        awk -v last="$1" -v young="$2" 'BEGIN {print "strain [1],stress [MPa]"
            for (i = 0; i < last + 1; i++) {e = 1e-4 * (i < last ? i : last); printf "%.12f,%.6f\n", e, e < 0.0015 ? young * e : 0.0015 * young + 1000 * (e - 0.0015)}}'
    }
    rod 205 201000 >long.csv
    for end in 200.0013 200.0026 200.0039 200.0104 200.0117; do
        rod "$end" 200000 >short.csv
        hspost -q short.csv long.csv --title rod --mean mean.csv
        # 300 and 301.5 MPa at yield, and 1 GPa from there on
        near "$(tail -n 1 mean.csv | cut -d, -f4)" 319.25 0.01
    done
}

@test "groups are curves of one title" {
    specimens 3
    for k in 1 2 3; do { echo "# title: soft"; cat "s$k.csv"; } >"t$k.csv"; done
    hspost -q t?.csv "$records/noise.csv" --mean mean.csv --statistics statistics.csv
    [ "$(cut -d, -f1,2 mean.csv | sort -u | grep -vc group)" -eq 2 ]
    grep -q '^soft,3,' mean.csv
    grep -q '^noise,1,' mean.csv
}

@test "every curve carries what tells it from its sisters" {
    for seed in 1 2 3; do
        cat >"seed$seed.yaml" <<DECK
title: scatter
domain:
  {specimen: plate, size: [0.4 mm, 0.1 mm, 0.1 mm], spacing: 25 um, topology: homogeneous, phase: M,
   grips: {length: 50 um, phase: M}, gauge: {length: 0.2 mm}}
materials:
  M:
    {model: correspondence, density: 7800, youngs_modulus: 200 GPa, poissons_ratio: 0.3,
     hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa},
     yield_scatter: {deviation: 0.1,
       seed: $seed}} # of the scatter
boundary:
  - {set: grip_left, direction: x, velocity: -1 m/s}
  - {set: grip_right, direction: x, velocity: 1 m/s}
solver: {type: quasi_static, horizon: 1, stabilisation: {law: mix, share: 0.1}, end_strain: 0.005}
DECK
        hsgen -q "seed$seed.yaml" | hssolve -q -H "run$seed.e"
    done
    hspost -q run?.e -p p.csv -j p.json --plot f.svg --tidy tidy.csv --statistics statistics.csv
    grep -q '^scatter (seed: 2}}),run2.e,seed: 2}},tensile_strength,' p.csv
    grep -q 'scatter (seed: 3}})' f.svg
    perl -MJSON::PP -e 'local $/; my @p = grep { $_->{property} eq "tensile_strength" } @{decode_json(<>)};
        exit !(@p == 3 && $p[0]{file} eq "run1.e" && $p[1]{varied} eq "seed: 2}}" && $p[2]{curve} eq "scatter (seed: 3}})")' p.json
    grep -q '^scatter,tensile_strength,Rm,MPa,3,' statistics.csv
    # the same deck twice: the files tell them apart
    cp run1.e again.e
    hspost -q run1.e again.e -p p.csv
    grep -q '^scatter (run1.e),run1.e,,' p.csv
    grep -q '^scatter (again.e),again.e,,' p.csv
}

@test "one long table without a comment, as many fields in every row" {
    specimens 2
    hspost -q s1.csv s2.csv "$records/header_block.csv" --tidy tidy.csv
    head -1 tidy.csv | grep -q '^curve,group,file,varied,engineering_strain,engineering_stress_MPa,true_strain,'
    run ! grep -q '^#' tidy.csv
    [ "$(grep -vc '^curve' tidy.csv)" -eq 666 ]
    awk -F, 'NR == 1 {n = NF} NF != n {exit 1}' tidy.csv
    # time is there for the one that has it, and empty for the others
    perl -ne 'chomp; my @f = split /,/, $_, -1; if ($. == 1) {($time) = grep {$f[$_] eq "time_s"} 0 .. $#f; next}
        $with{$f[2]}++ if $f[$time] ne ""; END {exit !(keys %with == 1 && (values %with)[0] == 222)}' tidy.csv
}

# A gnuplot that keeps its script.
keep_script() {
    mkdir bin
    printf '#!/bin/sh\ncat >script\necho drawn\n' >bin/gnuplot
    chmod +x bin/gnuplot
    PATH=$PWD/bin:$PATH
}

@test "eight curves in one figure have colours and dashes of their own, nine a panel each" {
    specimens 9
    keep_script
    hspost -q s[1-8].csv --plot f.svg
    [ "$(grep -oE 'dt [0-9(),]* lw 1.5 lc rgb .[#0-9A-F]*' script | sort -u | wc -l)" -eq 8 ]
    run ! grep -q 'linespoints\|multiplot' script
    hspost -q s?.csv --plot f.svg
    grep -q '^set multiplot layout 3,3' script
    [ "$(grep -c '^plot ' script)" -eq 9 ]
    # all have the axes of the strongest
    [ "$(grep -c '^set yrange' script)" -eq 1 ]
}

@test "a long legend makes the figure higher, and gnuplot finds no fault with it" {
    specimens 6
    for k in 1 2 3 4 5 6; do { echo "# title: Steel, annealed for $k h, spacing 12.5 um, as received"; cat "s$k.csv"; } >"t$k.csv"; done
    hspost -q t1.csv t2.csv --band --plot two.svg 2>said
    hspost -q t?.csv --band --plot six.svg 2>>said
    hspost -q t1.csv --title 'Harmonic nickel of forty per cent, hot isostatically pressed' --band --plot one.svg -o c.csv 2>>said
    for k in 1 2 3; do { echo "# title: Harmonic nickel of forty per cent, hot isostatically pressed $k"; cat "$records/unloading_loop.csv"; } >"l$k.csv"; done
    hspost -q l?.csv --tidy l.csv --plot-loops loops.svg 2>>said
    run ! grep -q difficulty said
    height() { sed -n 's/.* height="\([0-9]*\)".*/\1/p' "$1" | head -1; }
    # a heading and six rows, of which two have room
    [ "$(height six.svg)" -eq $((480 + 5 * 20)) ]
    [ "$(height two.svg)" -eq $((480 + 20)) ]
    # three curves, and the two stresses
    [ "$(height loops.svg)" -eq $((480 + 3 * 20)) ]
}

@test "more than eight curves of which some share a title are bands" {
    specimens 9
    keep_script
    hspost s?.csv --title Al --plot f.svg 2>said
    grep -q '9 curves in one figure: means' said
    [ "$(grep -c '^\$curve[0-9]* << EOD' script)" -eq 1 ]
    grep -q 'Al, mean and deviation of 9' script
}

@test "a figure ends at the fracture, unless the whole is asked for" {
    keep_script
    awk -F, '{print} END {print $1 + 0.001 ",0.5"; print $1 + 0.01 ",0.2"}' "$records/voce.csv" >broken.csv # which ends with such a row
    hspost -q broken.csv --plot f.svg -o curve.csv
    points() { sed -n '/^\$curve0 <</,/^EOD/p' script | sed '1d;$d'; }
    points | awk '$2 < 100 && $1 > 1 {exit 1}'
    shown=$(points | wc -l)
    hspost -q broken.csv --whole --plot f.svg -o curve.csv
    [ "$(points | wc -l)" -eq $((shown + 3)) ]
    points | tail -1 | grep -q ' 0.2$'
    run -2 hspost broken.csv --whole
}

@test "bands, and ranges of the axes" {
    specimens 6
    hspost -q s?.csv --title Al --band --plot f.svg --x-range 0:5 --y-range 100:250
    grep -q 'Al, mean and deviation of 6' f.svg
    grep -q '> 5<' f.svg
    run ! grep -q '> 6<' f.svg
    run -2 hspost s1.csv --band
}
