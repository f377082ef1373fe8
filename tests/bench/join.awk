# Rows of tests/bench/kernels with the ratio to LAMMPS (lines "style ns", second file; empty where it is not installed):
#   awk -f join.awk kernels.csv lammps.txt
FNR == 1 { files++ }
files == 1 && FNR == 1 { print $0 ",ratio_to_lammps"; next }
files == 1 { row[++rows] = $0; next }
{ ns[$1] = $2 }
END {
    for (r = 1; r <= rows; r++) {
        split(row[r], part, "\"")
        split(part[3], value, ",")
        style = part[2] == "bond_based" ? "pmb" : part[2] == "ordinary" ? "lps" : part[2] ~ /yielding/ && part[2] ~ /^ordinary/ ? "eps" : ""
        printf "%s,%s\n", row[r], style in ns ? sprintf("%.1f", ns[style] / value[4]) : ""
    }
}
