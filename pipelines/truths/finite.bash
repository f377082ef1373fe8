# CalculiX on the bodies of common.bash, sourced behind it; ccx is Debian's calculix-ccx.

# elastic_card PHASE E_MPa NU [PLASTIC]: PLASTIC is an expression of awk in p, MPa.
elastic_card() {
    echo "*MATERIAL, NAME=M$1
*ELASTIC
$2,$3"
    # At most 200 rows, close together where laws bend.
    [ -z "${4:-}" ] || { echo '*PLASTIC'; awk 'BEGIN {for (i = 0; i < 190; i++) {p = 0.8 * (exp(i / 189 * 8) - 1) / (exp(8) - 1); printf "%.9g,%.9g\n", '"$4"', p}}'; }
    echo "*SOLID SECTION, ELSET=PHASE$1, MATERIAL=M$1"
}

# elements NAME ELEMENT PARTICLES HOLD [OPTIONS of elements.awk]: runs CalculiX with the cards in NAME.cards; HOLD is the body of
# hold(n, x, y, z).  Leaves NAME.csv: increment time,node,x,y,z,ux,uy,uz,fx,fy,fz [particles, mm, N].
elements() {
    local run="$folder/$1"
    echo "function hold(n, x, y, z) { $4 }" >"$run.hold"
    awk -v element="$2" -v spacing="$SPACING" -v cards="$run.cards" -v places="$run.places" "${@:5}" -f "$run.hold" -f "$here/elements.awk" "$3" >"$run.inp"
    (cd "$folder" && OMP_NUM_THREADS=1 ccx "$1" >"$1.ccx.log")
    # ccx ends with 0 whatever happens
    if ! grep -q 'Job finished' "$run.ccx.log"; then echo "$case_name: CalculiX did not end $1, see $run.ccx.log" >&2; return 1; fi
    awk -v OFS=, 'FILENAME ~ /places$/ {at[$1] = $2 "," $3 "," $4; next}
        /displacements/ {what = "u"; time = $NF; next}
        /forces/ {what = "f"; time = $NF; next}
        NF == 4 && what == "u" {u[$1] = $2 "," $3 "," $4}
        NF == 4 && what == "f" {print time, $1, at[$1], u[$1], $2, $3, $4}' "$run.places" "$run.dat" >"$run.csv"
    # x,y,z,XX,YY,ZZ,XY,XZ,YZ,phase of each element, means over its points [m, Pa].
    [ ! -e "$run.inside" ] || awk -v OFS=, 'FILENAME ~ /inside$/ {split($0, f, ","); at[f[1]] = f[2] "," f[3] "," f[4]; phase[f[1]] = f[5]; next}
        NF == 8 && $1 in at {for (k = 1; k <= 6; k++) s[$1, k] += 1e6 * $(k + 2); m[$1]++}
        END {for (e in m) {line = at[e]; for (k = 1; k <= 6; k++) line = line "," s[e, k] / m[e]; print line "," phase[e]}}' "$run.inside" "$run.dat" >"$run.stress.csv"
    rm -f "$folder/$1".{inside,dat,frd,cvg,inp,places,hold,12d}
}
