# What the cases share; sourced by each.  A case is called as CASE FOLDER [small|decks] and writes rows of a table:
#   case,quantity,formulation,particles,error_percent,cpu_s (of block and cell: stress in MPa, which table.awk compares)
# decks: the decks alone, nothing is run; small: fewer of them.  hssolve and hspost are found in PATH.
#
# Bodies are written as text, particles of 1 mm (SPACING) and a phase each; lengths of the cases are in particles.
set -euo pipefail
shopt -s inherit_errexit
folder=$1 form=${2:-} # the source's arguments
case_name=$(basename "$0")
here=$(dirname "$0")
mkdir -p "$folder"
SPACING=1e-3

# What each formulation is called here, and what the deck says for it.
all='corner_flowing corner_four_points mix capped capped_2 ordinary bond_based'
[ "$form" != small ] || all='corner_flowing corner_four_points mix ordinary'

# sizes FEW MORE: what a case runs through; the few alone in the small form, the first of them for the decks.
sizes() { case $form in small) echo "$1" ;; decks) echo "${1%% *}" ;; *) echo "$1 $2" ;; esac; }

# material FORMULATION NAME E NU [HARDENING]: without hardening an elastic one.
material() {
    local model law=${5:+hardening: $5} nu=", poissons_ratio: $4"
    case $1 in
    corner*) model="corner${5:-, law: elastic}" model=${model%%\{*} ;;
    mix | capped*) model=correspondence$([ -n "${5:-}" ] || echo _elastic) ;;
    ordinary) model=ordinary$([ -z "${5:-}" ] || echo _plastic) ;;
    bond_based) model=bond_based nu='' ;;
    esac
    echo "  $2: {model: $model, density: 8000, youngs_modulus: $3$nu${law:+, $law}}"
}

# Keys of the section solver.
keys() {
    case $1 in
    corner_flowing) echo 'residual: {form: flowing}' ;;
    corner_four_points) echo 'residual: {form: four_points}' ;;
    mix) echo 'horizon: 1, stabilisation: {law: mix}' ;;
    capped) echo 'horizon: 1, stabilisation: {law: capped}' ;;
    capped_2) echo 'horizon: 2, stabilisation: {law: capped}' ;;
    # The means that bonds took before they were in series, which docs/errors.md compares under Interfaces.
    *) echo 'horizon: 3.015, influence: linear, surface_correction: energy, interfaces: mean' ;;
    esac
}

# Layers that a grip needs: those that a family reaches over, one of corners.
layers() {
    case $1 in
    corner*) echo 1 ;;
    mix | capped) echo 2 ;;
    capped_2) echo 4 ;;
    *) echo 4 ;;
    esac
}

# 1 where the nodes are the corners of the particles, half a spacing farther out.
corners() { case $1 in corner*) echo 1 ;; *) echo 0 ;; esac; }

# particles NX NY NZ EXPRESSION [FUNCTIONS [CUT]]: phases by an expression of awk in i, j, k from 0 and x, y, z in particles from the
# centre; 0: no particle.  CUT: the expression is asked at 32 x 32 places of a cell in the plane, and a particle has the share of the
# volume where it holds, if that is a twentieth.
particles() {
    awk -v nx="$1" -v ny="$2" -v nz="$3" -v dx=$SPACING -v cut="${6:-}" '
    function phase(i, j, k, x, y, z) { return '"$4"' }
    function part(i, j, k, x, y, z,    a, b, n) {
        for (a = -31; a < 32; a += 2) for (b = -31; b < 32; b += 2) n += phase(i, j, k, x + a / 64, y + b / 64, z) != 0
        return n / 1024
    }
    '"${5:-}"'
    function abs(v) { return v < 0 ? -v : v }
    BEGIN {
        for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++) {
            x = i - (nx - 1) / 2; y = j - (ny - 1) / 2; z = k - (nz - 1) / 2
            p = cut ? 1 : phase(i, j, k, x, y, z)
            share = cut ? part(i, j, k, x, y, z) : 1
            if (p && share >= 0.05) printf "%.10g %.10g %.10g %d %.10g\n", x * dx, y * dx, z * dx, p, share * dx ^ 3
        }
    }'
}

# deck FORMULATION NAME NX NY NZ PHASES SOLVER [DOMAIN]: the deck of a run, its materials, boundary and output from standard input.
# Load steps are those of SOLVER, with a residual that tables do not show.
# The domain is the box around the body, so that --check of hsgen reads it, too; with DOMAIN, further keys of it, such as a hole, it may
# be the body itself.
deck() {
    local plane='' sheet='' residual='accuracy: 1, tolerance: 1e-6, '
    case $7 in *tolerance:*) residual='accuracy: 1, ' ;; *accuracy:*) residual='' ;; esac
    if [ "$5" = 1 ]; then plane='plane: strain, ' sheet='dimensions: 2, '; fi
    {
        echo "title: $case_name $2 $1"
        echo "domain: {specimen: plate, ${sheet}size: [$3 spacings, $4 spacings, $([ "$5" = 1 ] && echo $SPACING || echo "$5 spacings")], spacing: $SPACING, topology: homogeneous, phase: $6${8:+, $8}}"
        cat
        echo "solver: {type: quasi_static, $residual$plane$7, $(keys "$1")}"
    } >"$folder/$2-$1.yaml"
}

# solve FORMULATION NAME PARTICLES: leaves NAME-FORMULATION.csv of the history, .nodes.csv of the last frame and .seconds of the processor.
solve() {
    local run="$folder/$2-$1"
    local TIMEFORMAT=%U
    { time hssolve -q -j 1 -d "$run.yaml" -i "$3" -H "$run.h" -o "$run.e" 2>&3; } 3>&2 2>"$run.seconds"
    tail -n 1 "$run.seconds" >"$folder/seconds" # of the last run, for the rows of it
    hspost -q --columns "$run.h" >"$run.csv"
    hspost --frames "$run.e" --csv >"$run.nodes.csv"
    rm "$run.h" "$run.e"
}

# A column of the last record.
last() { awk -F, -v name="$2" '/^#/ {next} !n {for (n = 1; $n != name; n++) if (n > NF) exit 1; next} {v = $n} END {print v}' "$1"; }

# row QUANTITY FORMULATION PARTICLES VALUE EXACT: what of the exact value is missing or too much.
row() { error "$1" "$2" "$3" "$(awk -v v="$4" -v e="$5" 'BEGIN {print 100 * (v / e - 1)}')"; }
# noise FORMULATION PARTICLES: rows of what noise.awk prints.
noise() {
    local value what
    read -r -a value
    for what in 'phase 1' 'phase 2' 'phase 1 averaged' 'phase 2 averaged'; do
        echo "noise,$what,$1,$2,${value[0]},"
        value=("${value[@]:1}")
    done
}
# error QUANTITY FORMULATION PARTICLES PERCENT
error() { printf '%s,%s,%s,%s,%.3f,%s\n' "$case_name" "$1" "$2" "$3" "$4" "$(cat "$folder/seconds")"; }
