# Curves of hspost side by side: engineering stress in MPa at a few strains (linear between records,
# blank beyond the end), the largest stress, and the strain there.  A star: the last record, not a
# maximum.
#   awk -f compare.awk a.csv b.csv

function finish(   i) {
    printf "\"%s\",%s", title, spacing
    for (i = 1; i <= count; i++) printf ",%s", at[i]
    printf ",%.1f,%.2f%s,%s,%s\n", most, 100 * where, where == strain ? "*" : "", ratio, horizon
}

BEGIN {
    FS = ","
    count = split("0.002 0.01 0.02 0.04 0.06 0.08", wanted, " ")
    printf "curve,spacing_um"
    for (i = 1; i <= count; i++) printf ",stress_at_%g_percent_MPa", 100 * wanted[i]
    print ",largest_stress_MPa,strain_there_percent,kinetic_to_internal_there,horizon"
}

FNR == 1 {
    if (NR > 1) finish()
    title = spacing = ratio = horizon = ""
    strain = stress = most = where = 0
    split("", at)
    split("", column)
}

/^# title: / { title = substr($0, 10) }
/^# spacing_m: / { spacing = 1e6 * substr($0, 14) }
/^# solver_horizon: / { horizon = substr($0, 19) }
/^#/ { next }

!("engineering_strain" in column) {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}

{
    before = strain
    stress_before = stress
    strain = $column["engineering_strain"]
    stress = $column["engineering_stress_MPa"]
    for (i = 1; i <= count; i++)
        if (before < wanted[i] && strain >= wanted[i])
            at[i] = sprintf("%.1f", stress_before + (stress - stress_before) * (wanted[i] - before) / (strain - before))
    if (stress > most) {
        most = stress
        where = strain
        ratio = "kinetic_to_internal" in column ? sprintf("%.4f", $column["kinetic_to_internal"]) : ""
    }
}

END { finish() }
