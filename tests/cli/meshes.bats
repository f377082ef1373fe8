# Meshes, texts and decks of other programs, through the tools: what the same body answers in each of them.

bats_require_minimum_version 1.5.0
load ../columns
load ../curves

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    # A bar of 12 x 4 x 4 cubes of 0.1 mm; sets low_x and high_x are its end faces, one layer of cubes each.
    awk -v nx=12 -v ny=4 -v nz=4 -v lx=1.2e-3 -v ly=0.4e-3 -v lz=0.4e-3 -v form=box \
        -f "$BATS_TEST_DIRNAME/../mesh.awk" >bar.cdl
    ncgen -k 64-bit-offset -o bar.g bar.cdl
    cat >study.yaml <<'DECK'
title: Bar
materials:
  A: {model: correspondence_elastic, density: 7800, youngs_modulus: 200 GPa, poissons_ratio: 0.3}
boundary:
  - {set: low_x, direction: x, displacement: 0}
  - {set: high_x, direction: x, displacement: "1e-6*t"}
solver: {type: quasi_static, horizon: 1, accept: true, end_time: 1, step: 1, tolerance: 1e-8}
DECK
    hssolve -q -d study.yaml -i bar.g -H bar.e
    columns bar.e force_left_N force_right_N | tail -1 >bar.forces
}

setup() {
    cd "$BATS_TEST_TMPDIR"
    cp "$BATS_FILE_TMPDIR"/{bar.cdl,bar.g,study.yaml,bar.forces} .
}

# same FILE [RELATIVE]: the bar's forces, run from a mesh or text with the deck study.yaml; the tolerance of the residual, 1e-8,
# leaves a millionth of them at most.
same() {
    hssolve -q -d study.yaml -i "$1" -H same.e
    columns same.e force_left_N force_right_N | tail -1 | cat bar.forces - | awk -v most="${2:-1e-6}" '
        NR == 1 { left = $1; right = $2 }
        NR == 2 { print left, right, $1, $2; found = 1
            exit !((l = $1/left - 1) < most && l > -most && (r = $2/right - 1) < most && r > -most) }
        END { if (!found) exit 1 }'
}

# refused MESSAGE ARGUMENTS...: by hssolve, with exit code 2.
refused() {
    local message=$1
    shift
    run hssolve -q "$@" -H refused.e
    if [ "$status" -ne 2 ] || [[ "$output" != *"$message"* ]]; then
        echo "$status: $output"
        return 1
    fi
}

@test "a bar's force is that of the theory of bars, more by what grips of one layer stiffen" {
    # E A u/L, L from middle to middle of the held layers: 29.09 N
    awk '{ print; exit !(-$1 > 29.09 && -$1 < 1.06 * 29.09 && $2 > 29.09 && $2 < 1.06 * 29.09) }' bar.forces
}

@test "netCDF-4 of either model is read as the classic file" {
    ncgen -k nc4 -o bar4.g bar.cdl
    ncgen -k nc7 -o bar7.g bar.cdl
    nccopy -k nc4 -d 9 bar.g packed.g
    for file in bar4.g bar7.g packed.g; do
        hssolve -q -d study.yaml -i "$file" -H same.e
        columns same.e force_left_N force_right_N | tail -1 | cmp - bar.forces
    done
    # Through a pipe, and from a checkpoint, which has the mesh inside.
    sed -e 's/end_time: 1/end_time: 2/' -e '$a output: {checkpoint: {every: 1 steps}}' study.yaml >two.yaml
    for file in bar.g bar4.g; do hssolve -q -d two.yaml -H "$file.e" --checkpoint "$file.checkpoint" < <(cat "$file"); done
    hssolve -q -j 2 --restart bar4.g.checkpoint -H again.e
    columns bar.g.e time_s force_left_N >two
    [ "$(wc -l <two)" -eq 3 ]
    for file in bar4.g.e again.e; do columns "$file" time_s force_left_N | cmp - two; done
    head -c 20000 bar4.g >cut.g
    refused "cut.g: cannot read it as Exodus" -d study.yaml -i cut.g
}

@test "a domain of hsgen is read from a copy in any form of netCDF, and a copied history is told how to copy back" {
    cat >lattice.yaml <<'DECK'
domain: {specimen: plate, size: [80 um, 20 um, 20 um], spacing: 10 um, topology: homogeneous, phase: A, grips: {length: 10 um, phase: A}}
materials: {A: {model: corner, law: elastic, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3}}
boundary:
  - {set: grip_left, direction: x, velocity: 0}
  - {set: grip_right, direction: x, velocity: 1e-7 m/s}
solver: {end_time: 1, step: 1}
DECK
    hsgen -q lattice.yaml -o own.g
    hssolve -q -i own.g -H own.e
    for form in classic cdf5 nc4; do
        nccopy -k $form own.g $form.g
        hssolve -q -i $form.g -H same.e
        cmp <(columns own.e force_left_N) <(columns same.e force_left_N)
        nccopy -k $form own.e copy.e
        run -2 hspost -q copy.e
        [[ $output == *'copy.e: netCDF of a form (ncdump -k) that these tools do not write'*'nccopy -k 64-bit-offset IN OUT'* ]]
        run -2 hssolve --repair copy.e
        [[ $output == *'copy.e: netCDF of a form'*'copy the original again'* ]]
        nccopy -k 64-bit-offset copy.e back.e
        cmp <(columns own.e force_left_N) <(columns back.e force_left_N)
    done
}

@test "unnamed node sets answer to set_N and to Peridigm's nodelist_N" {
    sed 's/^ns_names = .*/ns_names = "", "", "", "" ;/; s/^ns_prop1 = .*/ns_prop1 = 10, 20, 3, 4 ;/' bar.cdl >unnamed.cdl
    ncgen -k 64-bit-offset -o unnamed.g unnamed.cdl
    for name in set nodelist; do
        sed "s/low_x/${name}_10/; s/high_x/${name}_20/" "$BATS_FILE_TMPDIR/study.yaml" >study.yaml
        same unnamed.g
    done
    refused "no node set 'low_x' in the domain, which has: set_10, set_20, set_3, set_4" \
        -d "$BATS_FILE_TMPDIR/study.yaml" -i unnamed.g
}

@test "a node set of an edge is the elements on it" {
    # Of the 25 nodes of the end faces the five at the edge y < 0, z: those of four elements
    sed 's/num_nod_ns1 = 25/num_nod_ns1 = 5/; s/^node_ns1 = .*/node_ns1 = 1, 66, 131, 196, 261 ;/' bar.cdl >edge.cdl
    ncgen -k 64-bit-offset -o edge.g edge.cdl
    cat >>study.yaml <<'DECK'
output:
  quantities:
    - {name: held, quantity: force_x, reduce: sum, set: low_x}
    - {name: edge, quantity: force_x, reduce: sum, where: "x < -0.5e-3 && y < -0.1e-3"}
DECK
    hssolve -q -d study.yaml -i edge.g -H edge.e
    columns edge.e held edge | tail -1 | awk '{ print; exit !($1 > 1 && $1 == $2) }'
}

@test "side sets are sets of the elements that have the sides" {
    awk '{
        if (/^num_nodes|num_elem_blk|dimensions:/) sub(/dimensions:/, "dimensions: num_side_sets = 2; num_side_ss1 = 16; num_side_ss2 = 16; ")
        print
        if (/^ns_prop1:name/) print "int ss_status(num_side_sets); int ss_prop1(num_side_sets); ss_prop1:name = \"ID\"; " \
            "char ss_names(num_side_sets, len_name); int elem_ss1(num_side_ss1); int side_ss1(num_side_ss1); " \
            "int elem_ss2(num_side_ss2); int side_ss2(num_side_ss2);"
        if (/^data:/) {
            print "ss_status = 1, 1; ss_prop1 = 7, 8; ss_names = \"near\", \"\";"
            for (i = 0; i < 16; i++) { a = a sprintf("%s%d", i ? ", " : "", 1 + 12 * i); b = b sprintf("%s%d", i ? ", " : "", 12 + 12 * i)
                s = s (i ? ", 4" : "4"); t = t (i ? ", 2" : "2") }
            printf "elem_ss1 = %s; side_ss1 = %s; elem_ss2 = %s; side_ss2 = %s;\n", a, s, b, t
        }
    }' bar.cdl >sides.cdl
    ncgen -k 64-bit-offset -o sides.g sides.cdl
    sed -i 's/low_x/near/; s/high_x/surface_8/' study.yaml
    same sides.g
    # Corners of hexahedra are held at the nodes of the sides, as at those of the node sets.
    sed -i 's/correspondence_elastic/corner, law: elastic/; s/horizon: 1, //' study.yaml
    hssolve -q -d study.yaml -i sides.g -H sides.e
    sed -i 's/near/low_x/; s/surface_8/high_x/' study.yaml
    hssolve -q -d study.yaml -i sides.g -H nodes.e
    cmp <(columns sides.e force_left_N force_right_N) <(columns nodes.e force_left_N force_right_N)
}

# tetra: each hexahedron of bar.cdl becomes six tetrahedra about its diagonal, in tetra.g
tetra() {
    awk 'function corner(k) { return value[8 * e + k + 1] }
        /^connect1 = / {
            sub(/connect1 = /, ""); sub(/ ;/, ""); n = split($0, value, ", ")
            split("1 2 3 7 4 5 1", around, " ")
            for (e = 0; 8 * e < n; e++) for (k = 1; k <= 6; k++)
                list = list sprintf("%s%d, %d, %d, %d", m++ ? ", " : "", corner(0), corner(around[k]), corner(around[k + 1]), corner(6))
            print "connect1 = " list " ;"; next }
        { gsub(/num_elem = 192/, "num_elem = 1152"); gsub(/num_el_in_blk1 = 192/, "num_el_in_blk1 = 1152")
          gsub(/num_nod_per_el1 = 8/, "num_nod_per_el1 = 4"); gsub(/HEX8/, "TETRA"); print }' bar.cdl >tetra.cdl
    ncgen -k 64-bit-offset -o tetra.g tetra.cdl
}

@test "tetrahedra are particles: a bar of them has its modulus, and corner says what it takes" {
    tetra
    sed -i 's/horizon: 1, //' study.yaml
    cat >>study.yaml <<'DECK'
domain: {gauge: {planes: [-0.3 mm, 0.3 mm]}, section: 0.16 mm2}
DECK
    hssolve -q -d study.yaml -i tetra.g -H tetra.e
    # The gauge's nodes are those within half a spacing of its planes; centroids scatter there: 4 %
    columns tetra.e force_right_N extension_m | tail -1 | awk '{ E = $1 / 0.16e-6 / ($2 / 0.6e-3)
        print E; exit !(E > 0.96 * 200e9 && E < 1.04 * 200e9) }'
    sed -i 's/correspondence_elastic/corner, law: elastic/' study.yaml
    refused "no hexahedra" -d study.yaml -i tetra.g
}

@test "lengths in mm are those in m" {
    awk '/^coord/ { n = split($0, value, /[ ,;]+/); out = value[1] " ="
            for (i = 3; i < n; i++) out = out sprintf("%s %.17g", i > 3 ? "," : "", 1e3 * value[i]); print out " ;"; next }
        { print }' bar.cdl >mm.cdl
    ncgen -k 64-bit-offset -o mm.g mm.cdl
    echo 'domain: {length_unit: mm}' >>study.yaml
    same mm.g
    sed -i 's/length_unit: mm/length_unit: s/' study.yaml
    refused "study.yaml:8:23: 's' is no unit of length" -d study.yaml -i mm.g
    sed -i 's/length_unit: s/lenght_unit: mm/' study.yaml
    refused "lenght_unit" -d study.yaml -i mm.g
}

# along_y: bar.cdl turned: x becomes y, y z, z x; in turned.g
along_y() {
    sed 's/^coordx = /coordY = /; s/^coordy = /coordZ = /; s/^coordz = /coordX = /; s/^coordX/coordx/; s/^coordY/coordy/; s/^coordZ/coordz/' \
        bar.cdl >turned.cdl
    ncgen -k 64-bit-offset -o turned.g turned.cdl
}

@test "a test along y has the columns of one along x" {
    along_y
    for model in 'corner' 'correspondence'; do
        horizon='horizon: 1, '
        [ $model = correspondence ] || horizon=
        cat >x.yaml <<DECK
title: Bar
domain: {axis: x, grips: {length: 0.2 mm}, gauge: {length: 0.6 mm}}
materials:
  A: {model: $model, density: 7800, youngs_modulus: 200 GPa, poissons_ratio: 0.3,
      hardening: {law: linear, yield: 200 MPa, modulus: 2 GPa}}
boundary:
  - {set: grip_left, direction: x, velocity: -1 m/s}
  - {set: grip_right, direction: x, velocity: 1 m/s}
  - {set: grip_left, direction: y, velocity: 0}
  - {set: grip_left, direction: z, velocity: 0}
solver: {type: quasi_static, ${horizon}end_strain: 0.004, tolerance: 1e-9, step: 0.001, first_step: 0.0005}
DECK
        sed 's/axis: x/axis: y/; s/direction: z/direction: X/; s/direction: y/direction: z/; s/direction: x/direction: y/; s/direction: X/direction: x/' \
            x.yaml >y.yaml
        hssolve -q -d x.yaml -i bar.g -H x.e
        hssolve -q -d y.yaml -i turned.g -H y.e
        # Sums in another order, and residuals of 1e-9 of the forces; columns near zero are left out.
        paste <(columns x.e force_left_N force_right_N extension_m A_stress_Pa A_true_stress_Pa A_strain minimum_section_ratio) \
            <(columns y.e force_left_N force_right_N extension_m A_stress_Pa A_true_stress_Pa A_strain minimum_section_ratio) |
            awk '{ for (i = 1; i <= 7; i++) if ($i != 0 && ((d = $(i + 7) / $i - 1) > 1e-5 || d < -1e-5)) { print NR, i, $i, $(i + 7); bad = 1 } }
                END { print NR, $0; exit bad || NR < 5 }'
    done
}

# text SEPARATOR HEADER BLOCK: the bar as lines
text() {
    [ -z "$2" ] || echo "$2"
    awk -v s="$1" -v block="$3" 'BEGIN { for (k = 0; k < 4; k++) for (j = 0; j < 4; j++) for (i = 0; i < 12; i++)
        printf "%.10g%s%.10g%s%.10g%s%d%s1e-12\n", (i - 5.5) * 1e-4, s, (j - 1.5) * 1e-4, s, (k - 1.5) * 1e-4, s, block, s }'
}

@test "text with commas, with PeriLab's first line, with columns in another order and any blocks" {
    cat >ends.awk <<'AWK'
BEGIN { for (i = 0; i < 16; i++) print (end ? 12 : 1) + 12 * i }
AWK
    { echo "header: global_id"; awk -v end=0 -f ends.awk; } >left.txt
    awk -v end=1 -f ends.awk | paste -sd ' ' >right.txt
    echo 'domain: {node_sets: {low_x: left.txt, high_x: right.txt}}' >>study.yaml
    text ' ' '' 1 >plain.txt
    text ', ' '' 1 >commas.txt
    text ' ' 'header: x y z block_id volume' 1 >perilab.txt
    text ' ' '' 1 | awk 'BEGIN { print "volume,tag,block,z,y,x" } { print $5 ",a" NR "," $4 "," $3 "," $2 "," $1 }' >columns.txt
    for file in plain commas perilab columns; do same "$file.txt"; done
    text ' ' '' 70 >seventy.txt
    refused "study.yaml:3:3: seventy.txt has block 70, but there are 1 materials: call its material 'block_70'" \
        -d study.yaml -i seventy.txt
    sed 's/  A:/  block_70:/' study.yaml >seventy.yaml
    mv seventy.yaml study.yaml
    same seventy.txt
    echo 193 >>right.txt
    refused "node set 'high_x': node 193, expected 1 to 192" -d study.yaml -i seventy.txt
    echo one >>left.txt
    refused "left.txt:18: expected numbers of nodes, found 'one'" -d study.yaml -i seventy.txt
}

@test "text without z is a sheet" {
    awk 'BEGIN { print "header: x y block_id volume"
        for (j = 0; j < 4; j++) for (i = 0; i < 12; i++) print (i - 5.5) * 1e-4, (j - 1.5) * 1e-4, 1, "1e-12" }' >sheet.txt
    sed -i 's/set: low_x/where: "x < -0.4e-3"/; s/set: high_x/where: "x > 0.4e-3"/' study.yaml
    echo 'domain: {gauge: {length: 0.4 mm}}' >>study.yaml
    refused "a body of one layer needs 'plane: stress' or 'plane: strain'" -d study.yaml -i sheet.txt
    sed -i 's/horizon: 1, /horizon: 1, plane: strain, /' study.yaml
    hssolve -q -d study.yaml -i sheet.txt -H sheet.e
    # E/(1 - nu^2) = 219.8 GPa, over four layers of particles in the middle
    columns sheet.e force_right_N A_strain | tail -1 | awk '{ print; E = $1 / 4e-8 / $2
        exit !(E > 0.97 * 219.8e9 && E < 1.03 * 219.8e9) }'
}

@test "files of other programs are called what they are" {
    printf '*Heading\n** a\n*Node\n' >a.inp
    printf '$MeshFormat\n4.1 0 8\n' >a.msh
    printf '***tesr\n **format\n' >a.tesr
    printf '\x89PNG\r\n' >a.png
    refused "a.inp is an input deck of Abaqus or CalculiX" -d study.yaml -i a.inp
    refused "a.msh is a mesh of Gmsh" -d study.yaml -i a.msh
    refused "a.tesr is a raster tessellation of Neper" -d study.yaml -i a.tesr
    refused "a.png is a PNG image" -d study.yaml -i a.png
}

@test "a horizon in mm is one in spacings" {
    sed -i 's/horizon: 1, /horizon: 0.15 mm, /' study.yaml
    hssolve -q -d study.yaml -i bar.g -H length.e
    sed -i 's/horizon: 0.15 mm, /horizon: 1.5, /' study.yaml
    hssolve -q -d study.yaml -i bar.g -H spacings.e
    cmp <(columns length.e force_left_N force_right_N) <(columns spacings.e force_left_N force_right_N)
}

@test "a body that fills little of its box is told so before its load steps" {
    # A band along the diagonal of a plate
    awk 'BEGIN { for (k = 0; k < 3; k++) for (j = 0; j < 24; j++) for (i = 0; i < 24; i++)
        if (i - j <= 1 && j - i <= 1) print i * 1e-4, j * 1e-4, k * 1e-4, 1, "1e-12" }' >band.txt
    sed -i 's/correspondence_elastic/corner, law: elastic/; s/horizon: 1, //; s/set: low_x/where: "x < 0.15e-3"/; s/set: high_x/where: "x > 2.15e-3"/' study.yaml
    run hssolve -d study.yaml -i band.txt -H band.e
    [[ $output == *"the body fills "*" % of its box, which the preconditioner of load steps is made for"* ]]
    run hssolve -d "$BATS_FILE_TMPDIR/study.yaml" -i bar.g -H bar.e
    [[ $output != *"of its box"* ]]
}

@test "the deck that formats.md gives for a mesh of one's own pulls one" {
    sed -n '/^title: My specimen/,/^```/p' "$BATS_TEST_DIRNAME/../../docs/formats.md" | sed '$d' >own.yaml
    awk -v form=dogbone -v nx=24 -v ny=4 -v nz=2 -v lx=40 -v ly=4 -v lz=2 -f "$BATS_TEST_DIRNAME/../mesh.awk" | ncgen -o mesh.e
    sed -n 's/^    \(hssolve .*own.yaml.*\)/\1/p' "$BATS_TEST_DIRNAME/../../docs/formats.md" >commands
    [ "$(wc -l <commands)" -eq 2 ]
    bash -e -o pipefail commands
    [ -s own.svg ]
    # E of the deck in the parallel part of 4 x 2 mm: heads that are held sideways are 6 mm from the gauge, so within 1 %
    near "$(sed -n 's/^# slope_Pa: //p' own.csv)" 206e9 2e9
}

@test "grips and gauge of a deck that do not fit the body are refused, a section is warned of" {
    # 20 x 4 x 4 particles of 1 mm
    awk 'BEGIN { for (i = 0; i < 20; i++) for (j = 0; j < 4; j++) for (k = 0; k < 4; k++) print i - 9.5, j - 1.5, k - 1.5, 1, 1 }' >bar.txt
    awk '{ print $2, $1, $3, $4, $5 }' bar.txt >turned.txt
    # facts GRIPS GAUGE [MORE]
    facts() {
        cat >deck.yaml <<DECK
domain: {length_unit: mm, grips: {$1}, gauge: {$2}$3}
materials:
  A: {model: correspondence_elastic, density: 7800, youngs_modulus: 200 GPa, poissons_ratio: 0.3}
boundary:
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, displacement: "1e-6*t"}
solver: {type: quasi_static, horizon: 1, end_time: 1, step: 1}
DECK
    }
    facts 'length: 2 mm' 'length: 17 mm'
    refused "deck.yaml:1:57: the gauge planes (0.017 m apart, at -0.0085 and 0.0085 m) lie in the grips" -d deck.yaml -i bar.txt
    facts 'length: 2 mm' 'length: 25 mm'
    refused "are not both in the body, which is from -0.01 to 0.01 m along x" -d deck.yaml -i bar.txt
    facts 'length: 2 mm' 'planes: [2 mm, 2.5 mm]'
    refused "less than a spacing apart" -d deck.yaml -i bar.txt
    awk '$1 < 3 || $1 > 6' bar.txt >gap.txt
    facts 'length: 2 mm' 'planes: [-5 mm, 4.4 mm]'
    refused "no layer of particles is within half a spacing of the gauge plane at 0.0044 m; the nearest is at 0.0025 m" -d deck.yaml -i gap.txt
    facts 'length: 0 mm' 'length: 8 mm'
    refused "no particle lies in grip_left" -d deck.yaml -i bar.txt
    facts 'length: 2 mm' 'length: 2 mm'
    refused "leave none of the body free, which is 0.004 m long along x; it is longest along y: 'axis: y'" -d deck.yaml -i turned.txt
    facts 'length: 2 mm' 'length: 15 mm' ', section: 25 mm2'
    hssolve -q --check -d deck.yaml -i bar.txt 2>said
    grep -q 'domain.section is 25 mm2, and the body has 16 mm2 between the gauge planes' said
    sed -i 's/25 mm2/20 mm2/' deck.yaml
    hssolve -q --check -d deck.yaml -i bar.txt 2>said
    [ ! -s said ]
}
