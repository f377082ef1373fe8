# Periodic bodies from hsgen, from the outside.

bats_require_minimum_version 1.5.0

load ../columns
load ../structures

setup() {
    cd "$BATS_TEST_TMPDIR"
    cell '0.16 mm' '5 um' '0.1131 mm' >cell.yaml
    sed '/lattice/d; s/harmonic/random/; s/core_distance: .*/core_distance: 60 um/' cell.yaml >random.yaml
}

@test "a cell is written with its axes and periods, its fraction to the node, without sets" {
    hsgen cell.yaml -o cell.g -s cell.csv 2>said
    grep -q 'core distance taken as 113.137085 um (said: 113.1 um)' said
    grep -q 'periodic along xyz' said
    [ "$(attribute cell.g periodic)" = '"xyz"' ]
    for axis in x y z; do [ "$(attribute cell.g period_${axis}_m)" = 0.00016 ]; done
    run ! grep -q 'num_node_sets' <(ncdump -h cell.g)
    # 32768 nodes: round(0.4 * 32768) of them
    awk -v found="$(statistic cell.csv ufg_fraction_nodes '')" 'BEGIN { exit !((d = found - 13107 / 32768) < 1e-9 && d > -1e-9) }'
    for axis in x y z; do [ "$(statistic cell.csv percolates_ufg $axis)" = 1 ]; done
    # what does not go on around the body is not written
    sed '/periodic/d' cell.yaml | hsgen -q -o open.g
    [ -z "$(attribute open.g periodic)$(attribute open.g period_x_m)" ]
}

@test "axes along which a body ends keep their grips and gauge" {
    sed 's/size: .*/size: [0.8 mm, 0.16 mm, 0.16 mm]/; s/\[x, y, z\]/[z, y]/' cell.yaml >bar.yaml
    printf '  grips: {length: 50 um, phase: structure}\n  gauge: {length: 0.4 mm}\n' >>bar.yaml
    hsgen -q bar.yaml -o bar.g
    [ "$(attribute bar.g periodic)" = '"yz"' ]
    [ -z "$(attribute bar.g period_x_m)" ]
    ncdump -h bar.g | grep -q 'num_node_sets = 4'
}

@test "cores go through their file, and only into the body that they are for" {
    hsgen -q random.yaml -c cells.cores -o one.g --override
    grep -qx 'periodic xyz' cells.cores
    # (160 um / 60 um)^3 = 18.96
    grep -qx 'count 19' cells.cores
    sed '/core_distance/s/.*/  cores: cells.cores/' random.yaml >again.yaml
    hsgen -q again.yaml -o two.g --override
    cmp <(ncdump one.g | sed -n '/^data:/,$p' | grep -v info_records) <(ncdump two.g | sed -n '/^data:/,$p' | grep -v info_records) ||
        diff <(ncdump -v connect1 one.g | sed -n '/connect1 =/,$p') <(ncdump -v connect1 two.g | sed -n '/connect1 =/,$p')
    sed 's/\[x, y, z\]/[x, y]/' again.yaml >other.yaml
    refused other.yaml "for a body that is periodic along 'xyz', the deck's is along 'xy'"
    sed 's/size: .*/size: [0.15 mm, 0.16 mm, 0.16 mm]/' again.yaml >other.yaml
    refused other.yaml "repeats after 0.00016 m along x, the deck's does after 0.00015 m"
    sed 's/^periodic .*/periodic zx/' cells.cores >wrong.cores
    sed 's/cells.cores/wrong.cores/' again.yaml >other.yaml
    refused other.yaml "wrong.cores:5: found 'periodic zx', expected axes in their order"
}

@test "what cannot go on around is refused by what it is" {
    { cat cell.yaml; echo '  grips: {length: 20 um, phase: structure}'; } >deck.yaml
    refused deck.yaml "deck.yaml:12:10:" "periodic along x has no ends to be held" "leave out 'grips'"
    { cat cell.yaml; echo '  gauge: {length: 80 um}'; } >deck.yaml
    refused deck.yaml "deck.yaml:12:10:" "leave out 'gauge'"
    { cat cell.yaml; echo '  notch: {radius: 20 um, depth: 20 um}'; } >deck.yaml
    refused deck.yaml "a notched body is periodic along z at most"
    { cat cell.yaml; echo '  hole: {diameter: 40 um}'; } >deck.yaml
    refused deck.yaml "a body with a hole is periodic along z at most"
    { cat cell.yaml; echo '  angle: 30 degree'; } >deck.yaml
    refused deck.yaml "a body turned against the lattice is periodic along z at most"
    sed 's/specimen: plate/specimen: rod/' cell.yaml >deck.yaml
    refused deck.yaml "deck.yaml:6:13:" "a round body is not periodic"
    sed 's/specimen: plate/specimen: dogbone/; s/\[x, y, z\]/[y]/' cell.yaml >deck.yaml
    refused deck.yaml "a dogbone is not everywhere as wide"
    sed 's/specimen: plate/&\n  dimensions: 2/' cell.yaml >deck.yaml
    refused deck.yaml "a sheet is one layer thick"
    sed 's/\[x, y, z\]/[x, w]/' cell.yaml >deck.yaml
    refused deck.yaml "deck.yaml:6:17:" "'w'" "x, y, z"
    sed 's/\[x, y, z\]/[x, y, x]/' cell.yaml >deck.yaml
    refused deck.yaml "deck.yaml:6:20:" "x is in the list already"
    sed 's/\[x, y, z\]/xyz/' cell.yaml >deck.yaml
    refused deck.yaml "periodic is a list of axes: [x, y, z], or some of them"
    sed 's/\[x, y, z\]/[]/' cell.yaml >deck.yaml
    refused deck.yaml "periodic is a list of axes"
    run hsgen cell.yaml -o never.g --peridigm text
    [ "$status" -eq 2 ]
    [[ $output == *"no place for a periodic body"* ]]
}

@test "a flat body of any outline goes on along z" {
    cat >bone.yaml <<'DECK'
domain:
  specimen: dogbone
  size: [0.8 mm, 0.2 mm, 30 um]
  spacing: 10 um
  periodic: [z]
  topology: homogeneous
  phase: Ni
  gauge: {length: 0.3 mm, width: 0.1 mm, fillet: 0.12 mm}
DECK
    hsgen -q bone.yaml -o bone.g
    [ "$(attribute bone.g periodic)" = '"z"' ]
    [ "$(attribute bone.g period_z_m)" = 3e-05 ] || [ "$(attribute bone.g period_z_m)" = 3.e-05 ]
}

@test "a size that holds no whole cells is refused with the sizes and distances that would do" {
    sed 's/0.1131 mm/0.12 mm/' cell.yaml >deck.yaml
    refused deck.yaml "deck.yaml:10:18:" "repeats along each axis after 1.41421356 core distances (fcc)" \
        "use the core_distance 0.000113137085 m (1 cells)"
    # the distance that it names does
    sed -i 's/0.12 mm/0.000113137085 m/' deck.yaml
    hsgen -q deck.yaml -o cell.g
    sed 's/size: .*/size: [0.16 mm, 0.16 mm, 0.24 mm]/' cell.yaml >deck.yaml
    refused deck.yaml "deck.yaml:4:28:" "0.00024 m along z are 1.500000 cells of 0.00016 m; use 0.00016 m or 0.00032 m"
}

@test "what would be made is said before" {
    run hsgen --check cell.yaml
    [ "$status" -eq 0 ]
    [[ $output == *"32 x 32 x 32 sites of 5 um, 32768 nodes, 4 cores, periodic along xyz"* ]]
}

@test "with planes of symmetry nothing is made that is not its own image" {
    cat >half.yaml <<'DECK'
domain:
  specimen: plate
  size: [0.4 mm, 0.2 mm, 40 um]
  spacing: 10 um
  symmetry: [x, y]
  topology: homogeneous
  phase: Ni
DECK
    { cat half.yaml; echo '  hole: {centre: [-0.1 mm, 0], diameter: 60 um}'; } >deck.yaml
    refused deck.yaml "deck.yaml:8:18:" "the hole's x, -0.0001 m" "set it to 0, or take x out of 'symmetry'"
    sed -i 's/-0.1 mm, 0/0, 20 um/' deck.yaml
    refused deck.yaml "the hole's y, 2e-05 m"
    sed -i 's/0, 20 um/0, 0/' deck.yaml
    hsgen -q deck.yaml -o hole.g
    for box in '[[-50 um, 0, -1], [100 um, 1 mm, 1]]' '[[-1 mm, 0, -1], [-50 um, 1 mm, 1]]'; do
        { cat half.yaml; echo "  sets: [{name: s, box: $box}]"; } >deck.yaml
        refused deck.yaml "deck.yaml:8:25:" "across x the box is neither above the plane of symmetry"
    done
    { cat half.yaml; echo '  sets: [{name: s, box: [[-50 um, -1 mm, -1], [50 um, 1 mm, 1]]}]'; } >deck.yaml
    hsgen -q deck.yaml -o box.g
    # nodes of x = 5 to 45 um, y = 5 to 95 um, z = -15 to 15 um
    ncdump -h box.g | grep -q 'num_nod_ns1 = 200 '
    printf '  grips: {length: 20 um, phase: G}\nmaterials: {G: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3}}\n' >>deck.yaml
    hsgen -q --check deck.yaml 2>said
    [ ! -s said ]
    sed 's/homogeneous/harmonic/; s/phase: .*/phases: {cg: A, ufg: B}\n  lattice: sc\n  core_distance: 0.1 mm\n  ufg_fraction: 0.6/' half.yaml >cores.yaml
    hsgen -q --check cores.yaml 2>said
    [ ! -s said ]
    hsgen -q cores.yaml --cores own.cores -o /dev/null
    sed -e '/lattice/d; /core_distance/d' -e '$a\  cores: own.cores' cores.yaml >file.yaml
    hsgen -q --check file.yaml 2>said
    [ ! -s said ]
    # half a distance of cores: the plane lies between them
    { cat cores.yaml; echo '  offset: [50 um, 0, 0]'; } >between.yaml
    hsgen -q --check between.yaml 2>said
    [ ! -s said ]
    echo '  offset: [10 um, 0, 0]' >>cores.yaml
    hsgen -q --check cores.yaml 2>said
    grep -q 'across x the structure is the image of that above, not what the deck has there' said
    [ "$(wc -l <said)" -eq 1 ]
}

# To the square of a layer's share: in which of two ways a direction leads across a plane counts as often.
@test "the interface of a part of a body, with that across its planes, is the whole body's, to 1e-3" {
    for symmetry in '' 'symmetry: [x],' 'symmetry: [x, y, z],'; do
        hsgen -q --override - -o never.g -s part.csv <<DECK
domain: {specimen: plate, size: [0.4 mm, 0.2 mm, 0.2 mm], spacing: 10 um, $symmetry topology: harmonic, lattice: fcc, core_distance: 0.12 mm,
         phases: {cg: A, ufg: B}, ufg_fraction: 0.4, match: geometric}
DECK
        statistic part.csv interface_area_per_volume ''
        rm never.g
    done >found
    cat found
    awk '{ area[NR] = $1 } END { for (k = 2; k <= 3; k++) if ((area[k] / area[1] - 1) ^ 2 > 1e-6) exit 1; exit !(area[1] > 0 && NR == 3) }' found
}

# image 'MIRROR ROW...': what hsgen says of an image of these rows along y, with planes of symmetry across x and y, is in said
image() {
    local mirror=${1%% *}
    local rows=${1#* }
    read -ra list <<<"$rows"
    printf '%s' "${list[@]}" | tr '01' '\000\001' >rows.raw
    hsgen -q --check - 2>said <<DECK
domain: {specimen: plate, topology: image, image: rows.raw, raw: {voxels: [${#list[0]}, ${#list[@]}, 1], type: uint8}, voxel: 10 um,
         thickness: 20 um, labels: {A: 0, B: 1}, symmetry: [x, y]${mirror:+, mirror: [$mirror]}}
DECK
}

@test "an image that is its own image makes what it shows, and one that is not is warned of" {
    for rows in ' 0110 1001 1001 0110' 'x,y 011 100' 'x 001 110 110 001' 'y 1001 0110 0000'; do
        image "$rows"
        cat said
        [ ! -s said ]
    done
    image ' 0110 1001 1001 0100'
    grep -q 'plane of symmetry across x the structure .* not what rows.raw has there' said
    grep -q 'plane of symmetry across y the structure' said
    image 'y 1011 0110'
    grep -q 'across x' said
    [ "$(wc -l <said)" -eq 1 ]
}

@test "a part of a body is held and loaded as its images are" {
    hsgen -q -o half.g <<'DECK'
domain: {specimen: plate, size: [80 um, 40 um, 20 um], spacing: 10 um, symmetry: [x, y], topology: homogeneous, phase: Ni,
         sets: [{name: end, box: [[30 um, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]]}]}
DECK
    check() { # boundary entry
        cat >deck.yaml <<DECK
materials:
  Ni: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3,
       hardening: {law: voce, yield: 250 MPa, saturation: 220 MPa, rate: 12}}
boundary:
  - {direction: $1}
solver: {end_time: 0.1, step: 0.1}
DECK
        hssolve --check -d deck.yaml -i half.g
    }
    check 'x, box: [[35 um, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]], velocity: 1e-5 m/s'
    check 'y, where: "abs(y) > 1.5e-5", displacement: "1e-3*y"'
    run -2 check 'y, box: [[-10 um, -15 um, -1 mm], [10 um, 5 um, 1 mm]], velocity: 1e-5 m/s'
    [[ $output == *'deck.yaml:5:'*'below the plane of symmetry across y, at y = 0 m'* ]]
    run -2 check 'z, where: "x < 1e-5", velocity: 1e-5 m/s'
    [[ $output == *'deck.yaml:5:'*'across x, at x = 0 m'*'alike on both sides'* ]]
    run -2 check 'y, box: [[35 um, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]], velocity: 1e-5 m/s'
    [[ $output == *'deck.yaml:5:'*'acts along y on nodes in the plane of symmetry across y'* ]]
    check 'y, box: [[35 um, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]], velocity: "1e-5*y"'
    # What is meant on both sides is the image of itself: odd across the plane, else even.
    check 'z, where: "1", body_force: "1e9*t*cos(1e5*x)*y*y"'
    check 'x, where: "abs(x) > 3.5e-5", displacement: "1e-7*sign(x)*cos(1e5*y)"'
    check 'x, set: end, displacement: "1e-2*t*(y*y + 1e-5)"'
    run -2 check 'y, where: "abs(y) > 1.5e-5", velocity: 1e-5 m/s'
    [[ $output == *'deck.yaml:5:'*'acts along y on both sides of the plane of symmetry across y, by 1e-05 at ('*'and by 1e-05 at its image, where the image of the body has -1e-05: let the value be odd in y'* ]]
    run -2 check 'z, where: "1", body_force: "1e9*y"'
    [[ $output == *'deck.yaml:5:'*'acts along z on both sides of the plane of symmetry across y'*'let the value be even in y'* ]]
    run -2 check 'x, block: Ni, body_force: "1e9 + 1e12*x"'
    [[ $output == *'acts along x on nodes in the plane of symmetry across x'* ]]
    run -2 check 'x, block: Ni, body_force: "1e14*x*x"'
    [[ $output == *'acts along x on both sides of the plane of symmetry across x'* ]]
    for ends in 'set: end' 'box: [[35 um, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]]'; do
        run -2 check "x, $ends, displacement: '1e-2*t*(y + 1e-5)'"
        [[ $output == *'acts along x on both sides of the plane of symmetry across y'* ]]
    done
    # Quantities are of particles, whose places have gone when the run begins.
    observe() { # place of a quantity
        check "x, velocity: 0, where: 'x > 3.5e-5'}
output:
  quantities:
  - {name: q, quantity: stress_xx, reduce: mean, $1"
    }
    observe "where: 'x > 1e-5'"
    run -2 observe 'box: [[-20 um, -1 mm, -1 mm], [10 um, 1 mm, 1 mm]]'
    [[ $output == *'deck.yaml:8:'*'below the plane of symmetry across x'* ]]
    run -2 check "x, velocity: 0, where: 'x > 3.5e-5'}
initial:
  - {direction: x, where: '1', velocity: 1 m/s"
    [[ $output == *'deck.yaml:7:'*'load steps have no inertia, and a velocity at the start changes nothing'* ]]
}

@test "a flaw off a plane of symmetry is refused, a scatter of yields told" {
    body() { # CENTRE, or what stands for the flaw
        cat >part.yaml <<DECK
domain: {specimen: plate, size: [80 um, 40 um, 40 um], spacing: 10 um, symmetry: [x, y], topology: homogeneous, phase: Ni}
materials:
  Ni: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3, hardening: {law: linear, yield: 250 MPa, modulus: 1 GPa},
       $1}
boundary:
  - {where: "abs(x) > 35e-6", direction: x, displacement: "1e-2*t*x"}
solver: {end_time: 0.1, step: 0.1}
DECK
        hsgen -q part.yaml -o part.g
        hssolve -q --check -i part.g 2>said
    }
    body 'flaw: {centre: [0, 0, 3 um], radius: 10 um, reduction: 0.1}'
    [ ! -s said ]
    run -2 body 'flaw: {centre: [0, -5 um, 0], radius: 10 um, reduction: 0.1}'
    cat said
    grep -q "part.yaml:4:23: the flaw's y, -5e-06 m, is not in the plane of symmetry across y" said
    body 'yield_scatter: {deviation: 0.1, seed: 1}'
    grep -q 'below the plane of symmetry across x the yield scatters as above' said
    run -2 hsgen part.yaml --peridigm text -o never.g
    [[ $output == *'no place for planes of symmetry'* ]]
}

@test "a force on a part of a body is its share of that on the whole one" {
    for symmetry in '' 'symmetry: [y, z]' 'symmetry: [x, z]'; do
        cat >deck.yaml <<DECK
domain: {specimen: plate, size: [80 um, 40 um, 40 um], spacing: 10 um, topology: homogeneous, phase: A${symmetry:+, $symmetry},
         grips: {length: 2 spacings, phase: structure}}
materials:
  A: {model: corner, law: elastic, density: 8000 kg/m3, youngs_modulus: 200 GPa, poissons_ratio: 0.3}
boundary:
  - {box: [[-1 um, -1 mm, -1 mm], [1 um, 1 mm, 1 mm]], direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: 0.1 N}
solver: {type: quasi_static, end_steps: 1, step: 1, tolerance: 1e-9}
output: {history: 2, quantities: [{name: end, quantity: displacement_x, reduce: max, set: grip_right},
                                  {name: pull, quantity: external_force_x, reduce: sum, set: grip_right}]}
DECK
        hsgen -q deck.yaml -o part.g && hssolve -q -d deck.yaml -i part.g --history part.e
        columns part.e end pull | tail -n 1 >>ends
    done
    # a quarter has a quarter of 0.1 N, a half of either end's half
    awk 'NR == 1 { end = $1 } { ratio[NR] = $1 / end; pull[NR] = $2 } function near(a, b) { return (a - b) ^ 2 < 1e-12 * b * b }
         END { exit !(near(ratio[2], 1) && near(pull[1], 0.1) && near(pull[2], 0.025) && near(pull[3], 0.05)) }' ends
}
