# Measured structures through hsgen, from the outside.

bats_require_minimum_version 1.5.0

load ../structures

setup() {
    images=$PWD/tests/data/images
    cd "$BATS_TEST_TMPDIR"
    cat >deck.yaml <<DECK
title: Image of the tests
domain:
  specimen: plate
  topology: image
  image: $images/text.vti
  voxel: 2 um
  labels: {CG: [1, 3], UFG: [2, 4..5]}
DECK
}

@test "voxels become nodes of their phases, in the file's proportions, and keep their labels as grains" {
    hsgen deck.yaml -o image.g -s image.csv -p image.svg 2>said
    grep -q 'text.vti (VTI), 4 x 3 x 2 voxels of 2 x 1 x 0.5 um' said
    [ "$(attribute image.g spacing_m)" = 2e-06 ] || [ "$(attribute image.g spacing_m)" = 2.e-06 ]
    [ "$(attribute image.g spacing_y_m)" = 1e-06 ] || [ "$(attribute image.g spacing_y_m)" = 1.e-06 ]
    [ "$(statistic image.csv nodes_all)" = 24 ]
    # 1 + (i + 2 j + 3 k) mod 5: labels 1 to 5 are there 5, 5, 5, 5, 4 times in some order
    awk 'BEGIN { for (k = 0; k < 2; k++) for (j = 0; j < 3; j++) for (i = 0; i < 4; i++)
        { v = 1 + (i + 2 * j + 3 * k) % 5; n += v == 1 || v == 3 } print n }' >expected
    [ "$(statistic image.csv nodes CG)" = "$(cat expected)" ]
    [ "$(statistic image.csv nodes UFG)" = $((24 - $(cat expected))) ]
    # of each phase its share at no distance, and the mean of its profile
    awk -F, -v n="$(cat expected)" '$1 == "two_point_CG" && $3 == 0 { d = $4 - n / 24; if (d * d > 1e-14) bad = 1; found++ }
        $1 == "profile_UFG" && $2 == "x" { sum += $4 / 4 }
        END { d = sum - 1 + n / 24; exit !(found == 3 && !bad && d * d < 1e-14) }' image.csv
    # radius, volume, grain of each element
    ncdump -v attrib1,connect1 image.g | tr -d ' ;' >found
    grep -q '^"GRAIN"' <(ncdump -v attrib_name1 image.g | tr -d ' ,;')
    ncdump -v attrib1 image.g | sed -n '/attrib1 =/,/;/p' | grep -o '[0-9.e+-]*, *[0-9.e+-]*, *[0-9]' | awk -F, '{ print $3 + 0 }' | sort -u >grains
    printf '1\n3\n' | cmp - grains
}

@test "grains go through hssolve to the fields, on one rank and two, of a file that is read by parts or at once" {
    cat >>deck.yaml <<'DECK'
materials:
  CG: {model: corner, law: elastic, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3}
  UFG: {model: corner, law: elastic, density: 8900, youngs_modulus: 100 GPa, poissons_ratio: 0.3}
boundary:
  - {where: "x < -3.9e-6", direction: x, displacement: 0}
  - {where: "x > 3.9e-6", direction: x, displacement: "1e-9*t"}
solver: {end_time: 1, step: 1}
output: {fields: {frames: 1, variables: [grain, phase]}}
DECK
    hsgen -q deck.yaml -o image.g
    nccopy -k nc4 image.g packed.g
    awk 'BEGIN { for (k = 0; k < 2; k++) for (j = 0; j < 3; j++) for (i = 0; i < 4; i++) print 1 + (i + 2 * j + 3 * k) % 5 }' >expected
    for run in 'image.g 1' 'packed.g 2'; do
        hssolve -q -i "${run% *}" -j "${run#* }" -H image.e -o fields.e
        grains=$(ncdump -v name_nod_var fields.e | sed -n '/name_nod_var =/,/;/p' | grep -o '"[A-Za-z]*"' | awk '/Grain/ { print NR }')
        ncdump -v "vals_nod_var$grains" fields.e | sed -n "/vals_nod_var$grains =/,/;/p" | tr -cs '0-9\n' ' ' | tr ' ' '\n' | grep -x '[0-9]' >found
        tail -24 found | cmp - expected
        grep -q '"GRAIN"' <(ncdump -v attrib_name1 fields.e | tr -d ' ,;')
    done
}

@test "another format, another spacing, periodic by its mirror image: the same phases everywhere" {
    for format in base64.vti binary16.tesr gzip.nrrd field.vtk; do
        sed "s/text.vti/$format/" deck.yaml | hsgen -q -s other.csv -o other.g
        hsgen -q deck.yaml -s image.csv -o image.g
        cmp image.csv other.csv
        cmp <(ncdump -v connect1,connect2 image.g | sed -n '/^data:/,$p') <(ncdump -v connect1,connect2 other.g | sed -n '/^data:/,$p')
    done
    # every voxel in 2 x 2 x 2 cells
    sed 's/voxel.*/&\n  spacing: [1 um, 0.5 um, 0.25 um]/' deck.yaml | hsgen -q -s fine.csv -o fine.g
    [ "$(statistic fine.csv nodes CG)" = $((8 * $(statistic image.csv nodes CG))) ]
    # doubled along all axes, so that nothing new meets at the ends
    sed 's/voxel.*/&\n  mirror: [x, y, z]\n  periodic: [x, y, z]/' deck.yaml | hsgen -s mirror.csv -o mirror.g 2>said
    for axis in x y z; do grep -q "seam along $axis: 0 % of the pairs" said; done
    # 1 + (i + 2 j + 3 k) mod 5 at i = 3 and at i = 0: of two phases where exactly one is 1 or 3
    awk 'BEGIN { for (k = 0; k < 2; k++) for (j = 0; j < 3; j++) {
        for (i = 0; i < 4; i += 3) { v = (i + 2 * j + 3 * k) % 5; coarse[i] = v == 0 || v == 2 }
        n += coarse[0] != coarse[3] } printf "seam along x: %.3g %% of", 100 * n / 6 }' >expected
    sed 's/voxel.*/&\n  periodic: [x]/' deck.yaml | hsgen -o wrapped.g 2>said
    grep -qF "$(cat expected)" said
    [ "$(statistic mirror.csv nodes CG)" = $((8 * $(statistic image.csv nodes CG))) ]
    [ "$(attribute mirror.g periodic)" = '"xyz"' ]
}

@test "a cell made by hsgen, written and read again as an image, is the same to the node" {
    cell '32 um' '1 um' '22.627 um' >cell.yaml
    hsgen -q cell.yaml -o cell.g -s cell.csv --export cell.vti
    cat >again.yaml <<'DECK'
domain:
  specimen: plate
  periodic: [x, y, z]
  topology: image
  image: cell.vti
  array: material
  labels: {CG: 0, UFG: 1}
DECK
    # without a word on the voxels: the file says that its lengths are in m
    hsgen -q again.yaml -o again.g -s again.csv
    for block in 1 2; do
        cmp <(ncdump -v connect$block cell.g | sed -n "/^ connect$block =/,\$p") <(ncdump -v connect$block again.g | sed -n "/^ connect$block =/,\$p")
    done
    [ "$(statistic cell.csv interface_area_per_volume)" = "$(statistic again.csv interface_area_per_volume)" ]
    # through Abaqus' format, too
    hsgen -q cell.yaml -o cell.g --export cell.inp
    sed 's/cell.vti/cell.inp/; s/array.*/voxel: 1 um/; s/labels.*/labels: {CG: CG, UFG: UFG}/' again.yaml >third.yaml
    hsgen -q third.yaml -o third.g
    cmp <(ncdump -v connect1 cell.g | sed -n '/^ connect1 =/,$p') <(ncdump -v connect1 third.g | sed -n '/^ connect1 =/,$p')
}

@test "grips are the image's own ends, or layers of another material beyond it" {
    { sed 's/text.vti/stack.tif/; s/voxel.*/voxel: 1 um/' deck.yaml; echo '  grips: {length: 1 um, phase: structure}'; } | hsgen -q -o within.g -s within.csv
    [ "$(statistic within.csv nodes_all)" = 24 ]
    [ "$(statistic within.csv nodes_counted)" = 12 ]
    { sed 's/text.vti/stack.tif/; s/voxel.*/voxel: 1 um/' deck.yaml; printf '  grips: {length: 2 um, phase: steel}\nmaterials: {steel: {}}\n'; } | hsgen -q -o beyond.g -s beyond.csv
    [ "$(statistic beyond.csv nodes_all)" = $((24 + 2 * 2 * 6)) ]
    [ "$(statistic beyond.csv nodes_counted)" = 24 ]
    ncdump -h beyond.g | grep -q 'num_el_in_blk3 = 24'
}

@test "pictures are sheets or go on along z; grey ones have a threshold" {
    sed 's/text.vti/grey16.png/; s/labels.*/threshold: {at: 700, below: UFG, above: CG}\n  thickness: 3 um/; s/voxel.*/voxel: 1 um/' deck.yaml >grey.yaml
    hsgen -q grey.yaml -o grey.g -s grey.csv
    [ "$(statistic grey.csv nodes_all)" = 36 ]
    # 256 v >= 700: v = 3, 4, 5
    awk 'BEGIN { for (j = 0; j < 3; j++) for (i = 0; i < 4; i++) n += (i + 2 * j) % 5 >= 2; print 3 * n }' >expected
    [ "$(statistic grey.csv nodes CG)" = "$(cat expected)" ]
    sed 's/specimen: plate/&\n  dimensions: 2/; s/thickness.*/thickness: 7 mm/' grey.yaml | hsgen -q -o sheet.g -s sheet.csv
    [ "$(statistic sheet.csv nodes_all)" = 12 ]
    [ "$(attribute sheet.g thickness_m)" = 0.007 ]
    # colours by their names
    sed "s/text.vti/colour.png/; s/labels.*/labels: {CG: '#ff0100', UFG: rest}\n  thickness: 1 um/; s/voxel.*/voxel: 1 um/" deck.yaml | hsgen -q -o colour.g -s colour.csv
    awk 'BEGIN { for (j = 0; j < 3; j++) for (i = 0; i < 4; i++) n += (i + 2 * j) % 5 == 0; print n }' >expected
    [ "$(statistic colour.csv nodes CG)" = "$(cat expected)" ]
}

@test "a map by the names of its phases, in its own unit; points that are not indexed get no node" {
    sed 's/text.vti/square.ctf/; /voxel/d; s/labels.*/labels: {A: Iron bcc (old), B: [Iron fcc, 3..4]}\n  empty: 5\n  thickness: 0.5 um/' deck.yaml >map.yaml
    hsgen -q map.yaml -o map.g -s map.csv
    [ "$(attribute map.g spacing_m)" = 5e-07 ] || [ "$(attribute map.g spacing_m)" = 5.e-07 ]
    awk 'BEGIN { for (j = 0; j < 3; j++) for (i = 0; i < 4; i++) n += (i + 2 * j) % 5 < 4; print n }' >expected
    [ "$(statistic map.csv nodes_all)" = "$(cat expected)" ]
}

@test "raw values are described in the deck" {
    sed 's/text.vti/values.raw/; s/voxel.*/voxel: [2 um, 1 um, 0.5 um]\n  raw: {voxels: [4, 3, 2], type: uint16, order: big, skip: 8}/' deck.yaml >raw.yaml
    hsgen -q raw.yaml -o raw.g -s raw.csv
    hsgen -q deck.yaml -o image.g -s image.csv
    cmp raw.csv image.csv
    sed 's/skip: 8/skip: 7/' raw.yaml >deck2.yaml
    refused deck2.yaml "values.raw: 56 bytes; 4 x 3 x 2 values of uint16 behind 7 bytes are 55"
}

@test "labels that are not there, or there and of no phase, are told with what the image has" {
    sed 's/\[1, 3\]/[1, 3, 7]/' deck.yaml >wrong.yaml
    refused wrong.yaml "wrong.yaml:7:23:" "has no such value" "1 (6), 2 (4)"
    sed 's/4..5/4/' deck.yaml >wrong.yaml
    refused wrong.yaml "the value 5 of" "first of voxel [2, 1, 0]" "belongs to no phase" "'rest' for those that are left"
    sed 's/\[2, 4..5\]/[2, 3..5]/' deck.yaml >wrong.yaml
    refused wrong.yaml "the value 3 is said to be of two phases, or twice"
    sed 's/\[1, 3\]/Iron/' deck.yaml >wrong.yaml
    refused wrong.yaml "'Iron' is no value, range such as 1..12"
    sed 's/labels.*/threshold: {at: 9, below: A, above: B}/' deck.yaml >wrong.yaml
    refused wrong.yaml "all of" "is on one side of the threshold"
    sed '/labels/d' deck.yaml >wrong.yaml
    refused wrong.yaml "an image needs either 'labels'"
}

@test "what does not fit is told with what would do" {
    sed '/voxel/d' deck.yaml >wrong.yaml
    refused wrong.yaml "wrong.yaml:5:10:" "a voxel is 0.5 x 0.25 x 0.125, and not in what unit" "voxel: 0.5 um"
    sed '/voxel/d; s/text.vti/stack.tif/' deck.yaml >wrong.yaml
    refused wrong.yaml "does not say how large a voxel is"
    sed 's/voxel.*/&\n  spacing: 3 um/' deck.yaml >wrong.yaml
    refused wrong.yaml "8e-06 m long along x, 2.666667 spacings" "take the spacing 2.66666667e-06 m"
    sed 's/voxel.*/&\n  crop: [[0, 0, 0], [5, 3, 2]]/' deck.yaml >wrong.yaml
    refused wrong.yaml "voxels 0 up to 5 along x are not in an image of 4 x 3 x 2"
    sed 's/voxel.*/&\n  size: [1, 1, 1]/' deck.yaml >wrong.yaml
    refused wrong.yaml "'size' belongs to topology: homogeneous or harmonic or random, not to topology: image"
    sed 's/text.vti/grey8.png/; s/voxel.*/voxel: 1 um/' deck.yaml >wrong.yaml
    refused wrong.yaml "one voxel thick: say by 'thickness'"
    sed 's/text.vti/none.vti/' deck.yaml >wrong.yaml
    refused wrong.yaml "cannot read the image"
    sed 's/specimen: plate/specimen: rod/' deck.yaml >wrong.yaml
    refused wrong.yaml "an image is a plate"
    run hsgen deck.yaml -c cores.txt -o never.g
    [ "$status" -eq 2 ]
    [[ $output == *"topology image has no cores"* ]]
}

@test "CalculiX takes the mesh: a block of two phases of one stiffness carries E eps A" {
    command -v ccx >/dev/null || skip "no CalculiX"
    sed 's/text.vti/stack.tif/; s/voxel.*/voxel: 20 um/' deck.yaml | hsgen -q -o block.g --export mesh.inp
    cat >job.inp <<'JOB'
*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=M
*ELASTIC
200e9, 0.3
*SOLID SECTION, ELSET=CG, MATERIAL=M
*SOLID SECTION, ELSET=UFG, MATERIAL=M
*BOUNDARY
X_LOW, 1, 1, 0.
Y_LOW, 2, 2, 0.
Z_LOW, 3, 3, 0.
*STEP
*STATIC
*BOUNDARY
X_HIGH, 1, 1, 8e-8
*NODE PRINT, NSET=X_HIGH, TOTALS=ONLY
RF
*END STEP
JOB
    ccx job >said
    # 80 x 60 x 40 um, strained by 1e-3: 200e9 Pa 1e-3 60e-6 m 40e-6 m, to the digits printed
    awk '$1 ~ /^[0-9.-]+E/ { found = $1 } END { exit !(found > 0.48 * (1 - 1e-5) && found < 0.48 * (1 + 1e-5)) }' job.dat
}

@test "through all programs: a mirrored image as a periodic cell has the modulus that its phases share" {
    sed 's/text.vti/stack.tif/; s/voxel.*/voxel: 10 um\n  spacing: 5 um\n  mirror: [x, y, z]\n  periodic: [x, y, z]/' deck.yaml >cell.yaml
    cat >>cell.yaml <<'DECK'
materials:
  CG: {model: corner, density: 8900 kg/m3, youngs_modulus: 210 GPa, poissons_ratio: 0.31, hardening: {law: linear, yield: 1 GPa, modulus: 0 GPa}}
  UFG: {model: corner, density: 8900 kg/m3, youngs_modulus: 210 GPa, poissons_ratio: 0.31, hardening: {law: linear, yield: 1 GPa, modulus: 0 GPa}}
macroscopic:
  - {component: xx, rate: 1 1/s}
solver: {type: quasi_static, end_time: 1e-4 s}
DECK
    hsgen -q cell.yaml | hssolve -q -H cell.e
    hspost -q cell.e -p cell.csv -o curve.csv
    # elastic, at a strain of 1e-4: the modulus but for terms of the order of the strain
    awk -F, '$2 == "m_E" { found = $3 } END { exit !(found > 209.9 && found < 210.1) }' cell.csv
}
