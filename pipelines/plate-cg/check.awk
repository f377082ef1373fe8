# What goes in must come back: awk -v study=plate-cg -v blank=all -f pipelines/must.awk -f check.awk curve.csv

# Kirchhoff stress over logarithmic strain: 182.1 + 513.0 (1 - exp(-5.320 p)), e = p + stress/E.
function law(e,   low, high, p, k) {
    high = e
    for (k = 0; k < 60; k++) {
        p = (low + high) / 2
        if (p + (182.1 + 513.0 * (1 - exp(-5.320 * p))) / 210e3 < e) low = p; else high = p
    }
    return 182.1 + 513.0 * (1 - exp(-5.320 * p))
}

/^# slope_Pa: / { slope = substr($0, 13) / 1e9 }
/^#/ { next }
!("engineering_strain" in column) { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    strain = $column["engineering_strain"]
    stress = $column["engineering_stress_MPa"] * (1 + strain)
    flow = law(log(1 + strain))
    # Beyond 0.1 % of plastic strain
    if (flow < 182.1 + 513.0 * (1 - exp(-5.320e-3))) next
    records++
    error = off(stress / flow, 1)
    if (error > most) most = error
}
END {
    # Waves and the grips' ends, which the deck keeps this small (README)
    must(off(slope, 210) < 0.001 * 210, "E of " slope " GPa")
    must(records > 100 && most < 0.001, "flow stress off by " 100 * most " % in one of " records " records")
    must(strain > 0.249, "ends at a strain of " strain)
    finish()
}
