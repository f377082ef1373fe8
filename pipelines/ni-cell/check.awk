# What the cell of harmonic nickel must show: awk -v study=ni-cell -v blank=all [-v small=yes] -f pipelines/must.awk -f check.awk curve.csv

# Stress at maximum force of Voce's law [MPa], and its engineering strain.
function considere(yield, saturation, rate,   a, b, k, p) {
    a = 0; b = 2
    for (k = 0; k < 60; k++) {
        p = (a + b) / 2
        if (saturation * rate * exp(-rate * p) > yield + saturation * (1 - exp(-rate * p))) a = p; else b = p
    }
    strain_at_maximum = exp(p) - 1
    return (yield + saturation * (1 - exp(-rate * p))) / exp(p)
}
/^# slope_Pa: / { slope = substr($0, 13) / 1e9 }
/^#/ { next }
!("engineering_strain" in column) { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    e = $column["engineering_strain"] + 0; s = $column["engineering_stress_MPa"] + 0
    if (e > 0.0099 && !proof) proof = s
    if (s > most) { most = s; at = e }
}
END {
    must(off(slope, 210) < 1, "modulus of " slope " GPa")
    must(proof > 58 && proof < 300, "stress of " proof " MPa at 1 %")
    if (!small) {
        # between the cores alone and the shell alone, with steps of 0.5 % beside the maximum
        must(most > considere(58, 513, 5.32) && at < strain_at_maximum + 0.005, "maximum of " most " MPa at " at)
        must(most < considere(239, 513, 5.32) && at > strain_at_maximum - 0.005, "maximum of " most " MPa at " at)
    }
    finish()
}
