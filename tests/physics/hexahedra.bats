# Corner in meshes of hexahedra, through the programs: exact solutions in states that vary, on elements that are no
# boxes; a lattice as a mesh; grading; ranks, restart, damage; what is refused.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

# mesh FORM NX NY NZ LX LY LZ [PARTS] [MOVED]: mesh.g
mesh() {
    awk -v form="$1" -v nx="$2" -v ny="$3" -v nz="$4" -v lx="$5" -v ly="$6" -v lz="$7" -v parts="${8:-1}" -v moved="${9:-1}" \
        -f "$BATS_TEST_DIRNAME/../mesh.awk" >mesh.cdl
    ncgen -k 64-bit-offset -o mesh.g mesh.cdl
}

# deck MATERIAL SOLVER BOUNDARY [OUTPUT]: deck.yaml
deck() {
    cat >deck.yaml <<END
title: Hexahedra
materials:
  A: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3, $1}
solver: {$2}
boundary:
$3
${4:-}
END
}

rest='type: quasi_static, end_time: 1, step: 1, tolerance: 1e-7, most_evaluations: 20000'

# solve: history.e; fields.e where the deck has some
solve() {
    local fields=()
    if grep -q 'fields:' deck.yaml; then fields=(-o fields.e); fi
    hssolve -q --deck deck.yaml -i mesh.g -H history.e "${fields[@]}" 2>log || { cat log && false; }
}

last() { columns history.e "$@" | tail -n 1; }

@test "uniaxial stress in a distorted mesh: the law's stress and contraction in every element, within 1e-7" {
    mesh distorted 6 4 3 3 2 1.5
    for residual in flowing four_points; do
        deck 'law: elastic' "$rest, residual: {form: $residual}" '  - {set: low_x, direction: x, displacement: 0}
  - {set: high_x, direction: x, displacement: 3e-3}
  - {set: low_y, direction: y, displacement: 0}
  - {where: "z < -0.7499", direction: z, displacement: 0}' 'output:
  quantities:
    - {name: least, quantity: stress_xx, reduce: min, block: A}
    - {name: most, quantity: stress_xx, reduce: max, block: A}
    - {name: across, quantity: stress_yy, reduce: max, block: A}
    - {name: y, quantity: displacement_y, nearest: [0, 0.75, 0]}
    - {name: below, quantity: displacement_y, nearest: [0, -0.75, 0]}'
        solve
        # Cauchy's stress E ln(1.001)/J, J = 1.001^(1 - 2 nu); lateral stretch 1.001^-nu between particles 1.5 apart
        last least most across y below | awk '
            { stress = 200e9 * log(1.001) / exp(0.4 * log(1.001)); print
              if (!($1 > stress * (1 - 1e-7) && $2 < stress * (1 + 1e-7) && $3 < 1e-7 * stress)) exit 1 }'
    done
}

# bent N RESIDUAL: energy of a beam of N x N elements across in pure bending over E I kappa^2 L/2, less 1 [%].  The faces have
# the exact u_x = -kappa x y; y and z are free there, as in Saint-Venant's solution.
bent() {
    mesh "$3" $((2 * $1)) "$1" "$1" 2 1 1
    deck 'law: elastic' "$rest, residual: {form: $2}" '  - {set: low_x, direction: x, displacement: "1e-4*y"}
  - {set: high_x, direction: x, displacement: "-1e-4*y"}
  - {where: "abs(z) < 1e-9 && abs(x) > 0.999", direction: z, displacement: 0}
  - {where: "abs(y) < 1e-9 && abs(x) > 0.999", direction: y, displacement: 0}'
    solve
    last stored_energy_J stabilisation_energy_J | awk '{ print 100 * (($1 + $2) / (200e9 / 12 * 1e-8 * 2 / 2) - 1) }'
}

# The two residuals on boxes: docs/errors.md.
@test "pure bending of a distorted mesh: right within the residual's share at four elements, second order" {
    for residual in flowing four_points; do
        coarse=$(bent 4 $residual distorted)
        fine=$(bent 8 $residual distorted)
        echo "$residual: $coarse %, $fine %"
        awk -v a="${coarse#-}" -v b="${fine#-}" -v most="$([ $residual = flowing ] && echo 1 || echo 6)" \
            'BEGIN { exit !(a < most && b < a / 2.5) }'
    done
}

# ring NU N: energy of a quarter of a thick-walled cylinder in plane strain, N elements through the wall, over Lame's, and
# the displacement outside over his, less 1 [%].  u = A (r + b^2/((1 - 2 nu) r)), a = 1, b = 2, u(a) given, p = -sigma_r(a).
ring() {
    mesh ring "$2" $((2 * $2)) 1 0.1 1 0.1
    deck "law: elastic" "$rest" '  - {where: "x*x + y*y < 1.00001", direction: x, displacement: "1e-5*x"}
  - {where: "x*x + y*y < 1.00001", direction: y, displacement: "1e-5*y"}
  - {where: "y < 1e-9 && x > 1.00001", direction: y, displacement: 0}
  - {where: "x < 1e-9 && y > 1.00001", direction: x, displacement: 0}
  - {where: "1", direction: z, displacement: 0}'
    sed -i "s/poissons_ratio: 0.3/poissons_ratio: $1/" deck.yaml
    solve
    last stored_energy_J stabilisation_energy_J | awk -v nu="$1" '{
        A = 1e-5 / (1 + 4 / (1 - 2 * nu)); mu = 200e9 / (2 * (1 + nu))
        p = 2 * mu * A * (4 - 1) / (1 - 2 * nu)
        print 100 * (($1 + $2) / (0.5 * p * 1e-5 * 3.14159265358979 / 2 * 0.1) - 1) }'
}

@test "a thick-walled cylinder: Lame's energy, of the second order, and no locking at a ratio of 0.499" {
    for nu in 0.3 0.499; do
        coarse=$(ring $nu 3)
        fine=$(ring $nu 6)
        echo "ratio $nu: $coarse %, $fine %"
        awk -v a="${coarse#-}" -v b="${fine#-}" 'BEGIN { exit !(a < 0.3 && b < a / 3.5) }'
    done
}

@test "a lattice written as a mesh: the energies of the lattice in plastic flow, within 1e-8" {
    grips='  - {where: "x < -3.99e-3", direction: x, displacement: "-4e-5*t"}
  - {where: "x > 3.99e-3", direction: x, displacement: "4e-5*t"}
  - {where: "x < -3.99e-3", direction: y, displacement: 0}
  - {where: "abs(y) < 1e-6 && abs(x) < 3.9e-3", direction: z, displacement: "0.1*x*t"}'
    mesh box 8 4 4 8e-3 4e-3 4e-3
    deck "$soft" "$rest, step: 0.5" "$grips"
    sed -i 's/step: 1, //; s/1e-7/1e-10/' deck.yaml
    solve
    mv history.e mesh.e
    { cat deck.yaml; echo 'domain: {specimen: plate, size: [8 mm, 4 mm, 4 mm], spacing: 1 mm, topology: homogeneous, phase: A}'; } >lattice.yaml
    hsgen -q lattice.yaml -o lattice.g
    hssolve -q -i lattice.g -H lattice.e
    columns mesh.e stored_energy_J plastic_energy_J stabilisation_energy_J external_work_J >mesh
    columns lattice.e stored_energy_J plastic_energy_J stabilisation_energy_J external_work_J >lattice
    cat mesh lattice
    [ "$(awk '$2 > 0' mesh | wc -l)" -gt 1 ]
    paste mesh lattice | awk '{ for (i = 1; i <= 4; i++) { d = $i - $(i + 4); if ((d < 0 ? -d : d) > 1e-8 * $(i + 4)) bad++ } }
        END { exit !(NR > 2 && !bad) }'
}

@test "a dog-bone of graded elements in two blocks that were meshed apart gives E within 1 %" {
    mesh dogbone 32 6 3 40e-3 4e-3 2e-3 2
    deck 'law: elastic' "$rest, coincident_nodes: join" '  - {set: low_x, direction: x, velocity: -1e-5 m/s}
  - {set: high_x, direction: x, velocity: 1e-5 m/s}'
    sed -i 's/^solver/  B: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3, law: elastic}\n&/' deck.yaml
    solve
    # Force over section and strain of the gauge, whose planes are nodes 3/8 and 5/8 of the way
    last force_right_N engineering_strain engineering_stress_MPa
    E=$(last force_right_N extension_m | awk '{ g = 40e-3 * (0.25 + 0.6 / (4 * 3.14159265358979)); print $1 / 8e-6 / ($2 / g) / 1e9 }')
    echo "$E GPa"
    awk -v E="$E" 'BEGIN { exit !(E > 198 && E < 202) }'
}

# torn RANKS: a distorted mesh of two blocks torn at 50 m/s, flowing, degrading and losing particles; in a directory RANKS
torn() {
    mkdir "$1"
    (cd "$1" && hssolve -q -j "$1" --deck ../deck.yaml -i ../mesh.g -o fields.e -H history.e)
    LC_ALL=C sed -i "s/ -j $1 / -j N /g" "$1/fields.e" "$1/history.e"
}

# torn_deck RESIDUAL
torn_deck() {
    mesh distorted 16 5 4 16e-4 5e-4 4e-4 2
    deck "$soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "type: explicit, end_time: 8 us, damping: 1e4 1/s, coincident_nodes: join, residual: {form: $1}" \
        '  - {set: low_x, direction: x, velocity: -20 m/s}
  - {set: high_x, direction: x, velocity: 20 m/s}' 'damage:
  - {phase: A, law: ductile, onset: 0.05, full: 0.15}
  - {phase: B, law: ductile, onset: 0.04, full: 0.10}
output:
  history: 20
  fields: {frames: 2, variables: [displacement, velocity, force, stress, equivalent_plastic_strain, damage, phase]}'
    sed -i "s/^solver/  B: {model: corner, density: 8800, youngs_modulus: 190 GPa, poissons_ratio: 0.3, $soft}\\n&/" deck.yaml
}

@test "a distorted mesh that is torn apart: 2, 3, 4 and 8 ranks give the bits of one" {
    torn_deck flowing
    torn 1
    columns 1/history.e removed_nodes energy_drift | tail -n 1
    [ "$(columns 1/history.e removed_nodes | awk '$1 > 2' | wc -l)" -gt 0 ]
    for ranks in 2 3 4 8; do
        torn $ranks
        cmp 1/history.e $ranks/history.e
        cmp 1/fields.e $ranks/fields.e
    done
}

@test "the same with the law at four points: 3 ranks give the bits of one" {
    torn_deck four_points
    torn 1
    torn 3
    cmp 1/history.e 3/history.e
    cmp 1/fields.e 3/fields.e
}

@test "a graded mesh by load steps into plastic flow: 2, 3 and 8 ranks give the bits of one" {
    mesh dogbone 32 6 3 40e-3 4e-3 2e-3 2
    deck "$soft" 'type: quasi_static, end_time: 1, step: 0.5, coincident_nodes: join' \
        '  - {set: low_x, direction: x, velocity: -5e-5 m/s}
  - {set: high_x, direction: x, velocity: 5e-5 m/s}'
    sed -i "s/^solver/  B: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3, $soft}\\n&/" deck.yaml
    for ranks in 1 2 3 8; do
        mkdir $ranks
        (cd $ranks && hssolve -q -j $ranks --deck ../deck.yaml -i ../mesh.g -H history.e)
        LC_ALL=C sed -i "s/ -j $ranks / -j N /g" $ranks/history.e
        cmp 1/history.e $ranks/history.e
    done
    columns 1/history.e plastic_energy_J | awk '{ last = $1 } END { exit !(last > 0) }'
}

refused() {
    run ! hssolve --deck deck.yaml -i mesh.g -H history.e
    [[ $output == *"$1"* ]] || { echo "$output" && false; }
}

@test "nodes that lie on each other have to be joined or parted, and elements have to be the right way round" {
    hold='  - {set: low_x, direction: x, displacement: 0}'
    mesh box 8 2 2 8 2 2 2
    deck 'law: elastic' "$rest" "$hold"
    sed -i 's/^solver/  B: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3, law: elastic}\n&/' deck.yaml
    refused '9 nodes of the mesh lie on others'
    sed -i 's/step: 1,/step: 1, coincident_nodes: part,/' deck.yaml
    hssolve -q --check --deck deck.yaml -i mesh.g
    mesh box 4 2 2 4 2 2
    # The last corner of the first element goes through the middle of it
    sed -i 's/^connect1 = 1, 2, 7, 6, 16, 17, 22, 21/connect1 = 1, 2, 7, 6, 21, 17, 22, 16/' mesh.cdl
    ncgen -k 64-bit-offset -o mesh.g mesh.cdl
    deck 'law: elastic' "$rest" "$hold"
    refused 'inside out'
    deck 'law: elastic' "$rest, horizon: 2" "$hold"
    refused "corner has no 'horizon'"
}

# stiffness COMPONENT PERIODS [OPTIONS]: Young's modulus of a periodic mesh of A, and of B where there are two parts
stiffness() {
    local block
    {
        echo "domain: {periodic: [x, y, z]${2:+, period: [$2]}}"
        echo 'materials:'
        for block in A:200:0.3 $([[ $2 != 8* ]] || echo B:20:0.2); do
            IFS=: read -r name E nu <<<"$block"
            echo "  $name: {model: corner, law: elastic, density: 8900, youngs_modulus: $E GPa, poissons_ratio: $nu}"
        done
        echo "macroscopic: [{component: $1, rate: 1 1/s}]"
        echo 'solver: {end_time: 1e-6, step: 1e-6, tolerance: 1e-9, most_evaluations: 20000, coincident_nodes: join}'
    } >cell.yaml
    hssolve -q --deck cell.yaml -i mesh.g -H history.e "${@:3}" 2>log || { cat log && return 1; }
    columns history.e "mean_stress_$1_Pa" "mean_gradient_$1" | tail -n 1 | awk '{ printf "%.12g", $1 / $2 }'
}

# The strain of 1e-6 is left of geometry.  Layers: Backus, J. Geophys. Res. 67 (1962) 4427, for halves of 200 GPa, 0.3 and 20 GPa, 0.2.
@test "a periodic mesh: a distorted one has its law's modulus, flat faces need no period, layers are Backus' to 1e-5, ranks give the same bits" {
    load ../cells
    mesh cell 6 4 3 3 2 1.5
    near_share "$(stiffness xx '3 m, 2 m, 1.5 m')" 200e9 2e-6
    mesh distorted 6 4 1 3.3 2 1.5
    run ! stiffness xx ''
    [[ "$output" == *'the mesh is periodic along y after 2 m, and its node at '*' has no image there: expected faces with the same nodes'* ]]
    mesh box 6 4 3 3.3 2 1.5
    near_share "$(stiffness yy '')" 200e9 2e-6
    mesh cell 8 4 4 8 4 4 2 1e-4
    near_share "$(stiffness xx '8 m, 4 m, 4 m')" 38701067615.7 1e-5
    along=$(stiffness yy '8 m, 4 m, 4 m')
    near_share "$along" 110095147479 1e-5
    [ "$(stiffness yy '8 m, 4 m, 4 m' -j 2)" = "$along" ]
    sed 's/coincident_nodes: join/coincident_nodes: part/' cell.yaml >apart.yaml
    run -2 hssolve -q --deck apart.yaml -i mesh.g -H history.e
    [[ "$output" == *'apart.yaml:'*'a periodic mesh has none of its nodes apart'* ]]
}
