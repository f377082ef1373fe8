# The table of the cells: awk -v folder=FOLDER -f table.awk FOLDER/STRUCTURE/study.csv...
#
# A row for each structure and each thing that varied but the seeds: mean and standard deviation over the seeds of the proof
# strength, the nominal stress at 0.5, 1, 2, 4 and 10 % of strain, tensile strength, uniform strain, work to 4 %, and of the phases at 2 %
# the mean nominal stresses and strains.  Where the maximum lies beyond the end, Rm
# and Ag are those of the last record.

# A property of a run by its symbol.
function proper(file, symbol,   line, field, head, n, i, found) {
    found = ""
    while ((getline line < file) > 0) {
        gsub(/"[^"]*"/, "text", line)
        n = split(line, field, ",")
        if (!("symbol" in head)) for (i = 1; i <= n; i++) head[field[i]] = i
        else if (field[head["symbol"]] == symbol) found = field[head["value"]]
    }
    close(file)
    return found
}

function add(quantity, value) {
    if (value == "") return
    count[row, quantity]++
    sum[row, quantity] += value
    square[row, quantity] += value * value
}

# What the curve says at strains.
function read_curve(file,   line, field, head, n, i, k, e, s, was_e, was_s, work, c, u, ce, ue) {
    k = 1
    work = was_e = was_s = 0
    split("0.005 0.01 0.02 0.04 0.1", wanted, " ")
    delete head
    while ((getline line < file) > 0) {
        if (line ~ /^#/) continue
        n = split(line, field, ",")
        if (!("engineering_strain" in head)) { for (i = 1; i <= n; i++) head[field[i]] = i; continue }
        e = field[head["engineering_strain"]]; s = field[head["engineering_stress_MPa"]]
        while (k <= 5 && e >= wanted[k] - 1e-9 && e > was_e) {
            add("MPa_at_" 100 * wanted[k], was_s + (s - was_s) * (wanted[k] - was_e) / (e - was_e))
            if (wanted[k] == 0.02) {
                c = field[head["CG_stress_MPa"]]; u = field[head["UFG_stress_MPa"]]
                ce = field[head["CG_strain"]]; ue = field[head["UFG_strain"]]
                add("CG_MPa_at_2", c); add("UFG_MPa_at_2", u); add("CG_percent_at_2", 100 * ce); add("UFG_percent_at_2", 100 * ue)
            }
            if (wanted[k] == 0.04) add("work_to_4", work + (0.04 - was_e) * was_s)
            k++
        }
        work += (e - was_e) * (e - was_e > 0 ? (s + was_s) / 2 : 0)
        was_e = e; was_s = s
    }
    close(file)
}

BEGIN { FS = "," }
FNR == 1 {
    structure = FILENAME
    sub(/\/study.csv$/, "", structure); path = structure; sub(/.*\//, "", structure)
    seed = 0
    for (i = 2; i <= NF; i++) if ($i == "seed") seed = i
    next
}
{
    label = structure "," (seed == 2 ? "" : $2)
    if (!(label in known)) { known[label] = ++rows; name[rows] = label }
    row = known[label]
    runs[row]++
    read_curve(path "/" $1 "/curve.csv")
    file = path "/" $1 "/properties.csv"
    add("Rp02", proper(file, "Rp0.2")); add("Rm", proper(file, "Rm")); add("Ag", proper(file, "Ag"))
}
END {
    columns = split("Rp02 MPa_at_0.5 MPa_at_1 MPa_at_2 MPa_at_4 MPa_at_10 Rm Ag work_to_4 CG_MPa_at_2 UFG_MPa_at_2 CG_percent_at_2 UFG_percent_at_2", quantity, " ")
    printf "structure,varied,runs"
    for (i = 1; i <= columns; i++) printf ",%s,%s_deviation", quantity[i], quantity[i]
    print ""
    for (r = 1; r <= rows; r++) {
        printf "%s,%d", name[r], runs[r]
        for (i = 1; i <= columns; i++) {
            n = count[r, quantity[i]]
            if (!n) { printf ",,"; continue }
            m = sum[r, quantity[i]] / n; v = n > 1 ? (square[r, quantity[i]] - n * m * m) / (n - 1) : 0
            printf ",%.6g,%.3g", m, (v > 0 ? sqrt(v) : 0)
        }
        print ""
    }
}
