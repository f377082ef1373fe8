# Rows of tests/bench/error from a history.  The exact curve: Voce's law, Kirchhoff stress over logarithmic strain.

function law(p) { return 182.1 + 513.0 * (1 - exp(-5.320 * p)) }
function exact(strain,   e, low, high, p, k) {
    e = log(1 + strain); low = 0; high = e
    if (e < 182.1 / 210e3) return 210e3 * e * exp(-e)
    for (k = 0; k < 60; k++) { p = (low + high) / 2; if (p + law(p) / 210e3 < e) low = p; else high = p }
    return law(p) * exp(-e)
}
function row(quantity, value, answer) {
    printf "%s,%s,%.4g,%s,%s,%s,%.6g,%.6g,%.5f,%s\n", model, solver, spacing, horizon, influence, quantity, value, answer, value / answer - 1, seconds
}
BEGIN { FS = ","; flows = model ~ /plastic|correspondence|corner/; wanted = split("0.05 0.1 0.2", at, " ") }
/^# gauge_length_m/ { split($0, word, ": "); gauge = word[2] }
/^# section_m2/ { split($0, word, ": "); section = word[2] }
/^#/ { next }
!n { n = split($0, names); for (i = 1; i <= n; i++) column[names[i]] = i; next }
{
    strain = $column["extension_m"] / gauge
    stress = 1e-6 * ($column["force_right_N"] - $column["force_left_N"]) / 2 / section
    if (strain > 0.00004 && strain < 0.0007) { sxx += strain * strain; sxy += strain * stress; sxe += strain * (flows ? exact(strain) : 210e3 * strain) }
    x[++m] = strain; s[m] = stress
    if (stress > s[top]) top = m
}
END {
    row("E_MPa", sxy / sxx, sxe / sxx)
    if (!flows) exit
    for (i = 2; i <= m && s[i] > 210e3 * (x[i] - 0.002); i++);
    if (i <= m) {
        a = s[i - 1] - 210e3 * (x[i - 1] - 0.002); b = s[i] - 210e3 * (x[i] - 0.002)
        low = 0.002; high = 0.01
        for (k = 0; k < 60; k++) { strain = (low + high) / 2; if (exact(strain) > 210e3 * (strain - 0.002)) low = strain; else high = strain }
        row("Rp02_MPa", s[i - 1] + (s[i] - s[i - 1]) * a / (a - b), exact(low))
    }
    for (k = 1; k <= wanted; k++)
        for (i = 2; i <= m; i++)
            if (x[i] >= at[k] && x[i - 1] < at[k]) { row("stress_at_" 100 * at[k] "_percent_MPa", s[i - 1] + (at[k] - x[i - 1]) / (x[i] - x[i - 1]) * (s[i] - s[i - 1]), exact(at[k])); break }
    if (top > 1 && top < m && s[m] < 0.9999 * s[top]) {
        for (p = 1e-4; 1 / (1 / (513.0 * 5.320 * exp(-5.320 * p)) + 1 / 210e3) > law(p); p += 1e-5);
        # Vertex of the parabola through the three highest records.
        a = x[top - 1] - x[top]; b = x[top + 1] - x[top]; low = s[top - 1] - s[top]; high = s[top + 1] - s[top]
        row("strain_at_maximum", x[top] + 0.5 * (high * a * a - low * b * b) / (high * a - low * b), exp(p + law(p) / 210e3) - 1)
    }
}
