# The tables of docs/errors.md: awk -F, [-v csv=FILE] -f table.awk CASE.csv... CALCULIX; csv: all errors, for check.awk.
#
# A row a quantity, a column a formulation or element, errors in per cent in the order of the particles; in brackets the order
# of convergence over the last three, where they have one sign.

BEGIN { if (csv) print "case,quantity,formulation,particles,error_percent,cpu_s" > csv }
FNR == 1 && $1 == "case" { next } # CalculiX' header
NF < 5 { next }
{
    name = $1
    what = $2
    value = $5
    seconds[$1, $2, $3, $4] = $6
    # Stresses: to be compared once all are there.
    if (name == "block" || name == "cell") { stress[name, what, $3, $4] = $5; of[++n_stresses] = $0; next }
    add(name, what, $3, $4, value)
}

function add(name, what, who, n, value) {
    if (!((name, what) in seen)) { seen[name, what] = 1; quantity[name, ++quantities[name]] = what }
    if (!((name, who) in known)) { known[name, who] = 1; column[name, ++columns[name]] = who }
    if (!((name, n) in sized)) { sized[name, n] = 1; size[name, ++sizes[name]] = n + 0 }
    error[name, what, who, n] = value
    if (csv) printf "%s,%s,%s,%s,%.3f,%s\n", name, what, who, n, value, seconds[name, what, who, n] > csv
}

# Of the finest C3D20R.
function finest(name, what,    n, best) {
    for (n = 64; n > 0; n--) if ((name, what, "C3D20R", n) in stress) return n
    return 0
}

function compare(    k, f, best, base, to) {
    for (k = 1; k <= n_stresses; k++) {
        split(of[k], f, ",")
        if (f[1] == "cell") {
            best = finest(f[1], f[2])
            add(f[1], f[2], f[3], f[4], 100 * (f[5] / stress[f[1], f[2], "C3D20R", best] - 1))
        } else {
            best = finest(f[1], f[2])
            if (f[2] == "nu 0.3") { add(f[1], "two phases " f[2], f[3], f[4], 100 * (f[5] / stress[f[1], f[2], "C3D20R", best] - 1)); continue }
            base = stress[f[1], "nu 0.3", f[3], f[4]]
            to = stress[f[1], f[2], "C3D20R", best] / stress[f[1], "nu 0.3", "C3D20R", best]
            add(f[1], "two phases " f[2] " over 0.3", f[3], f[4], 100 * (f[5] / base / to - 1))
        }
    }
}

function size_of(v) { return v < 0 ? -v : v }
function short(v,    a) {
    a = size_of(v)
    if (a < 0.005) return "0"
    return sprintf(a < 0.995 ? "%+.2f" : a < 99.5 ? "%+.1f" : "%+.0f", v)
}

# Errors of a formulation, and their order.
function cell_of(name, what, who,    i, n, text, last, count, e, at, order) {
    for (i = 1; i <= sizes[name]; i++) {
        n = size[name, i]
        if (!((name, what, who, n) in error)) { if (what_sizes[name, what, n]) text = text (text == "" ? "" : " / ") "."; continue }
        e[++count] = error[name, what, who, n]
        at[count] = n
        text = text (text == "" ? "" : " / ") (name == "noise" ? sprintf("%.0f", e[count]) : short(e[count]))
    }
    if (!count) return ""
    if (count >= 3 && e[count] * e[count - 1] > 0 && e[count - 1] * e[count - 2] > 0 && size_of(e[count]) > 0.005)
        text = text sprintf(" (%.1f)", log(size_of(e[count - 2] / e[count])) / log(at[count] / at[count - 2]))
    return text
}

function sort_sizes(name,    i, j, t) {
    for (i = 2; i <= sizes[name]; i++)
        for (j = i; j > 1 && size[name, j - 1] > size[name, j]; j--) { t = size[name, j]; size[name, j] = size[name, j - 1]; size[name, j - 1] = t }
}

function table(name, title,    i, k, line, all) {
    if (!quantities[name]) return
    sort_sizes(name)
    for (k in error) { split(k, f, SUBSEP); if (f[1] == name) what_sizes[name, f[2], f[4] + 0] = 1 }
    for (i = 1; i <= sizes[name]; i++) all = all (i > 1 ? " / " : "") size[name, i]
    print "\n### " title
    print "\nOf " all ", as far as there are.\n"
    line = "| |"
    rule = "|---|"
    for (k = 1; k <= columns[name]; k++) { line = line " " column[name, k] " |"; rule = rule "---|" }
    print line "\n" rule
    for (i = 1; i <= quantities[name]; i++) {
        line = "| " quantity[name, i] " |"
        for (k = 1; k <= columns[name]; k++) line = line " " cell_of(name, quantity[name, i], column[name, k]) " |"
        print line
    }
}

END {
    compare()
    table("bending", "Bending: particles of height")
    table("torsion", "Torsion: particles of width")
    table("laminate", "Layers: particles to a layer")
    table("bar", "Bar of 16 x 4 x 4: grips and unloading")
    table("flow", "Shear to 3 and turning: load steps (of turning, particles)")
    table("circles", "Hole, inclusion, cylinder: particles of diameter (cylinder: of its wall)")
    table("inclined", "Bars inclined to the lattice: particles of width")
    table("limit", "Limit loads: particles of ligament, of the hole's diameter, of the wall")
    table("block", "Block of two phases near incompressibility: particles to an edge")
    table("noise", "Pressure in the harmonic cell: noise from particle to particle, MPa, particles to an edge")
    table("cell", "Cells of two phases in plastic flow: particles to an edge")
}
