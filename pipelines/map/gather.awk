# The runs of the map and what came out: awk -v folder=RUNS -f gather.awk RUNS/study.csv
#
# A row a run: the factors as numbers (arrangement 1 sc, 2 bcc, 3 fcc; particles along an edge), the proof strength, nominal stresses at
# 2 and 10 %, and the gain: the share of what the mixture at equal strain has over CG alone, at 2 %.  The curves of the phases alone
# are those of their laws.

function proof(file,   line, field, n, i, head, found) {
    while ((getline line < file) > 0) {
        gsub(/"[^"]*"/, "text", line)
        n = split(line, field, ",")
        if (!("symbol" in head)) for (i = 1; i <= n; i++) head[field[i]] = i
        else if (field[head["symbol"]] == "Rp0.2") found = field[head["value"]]
    }
    close(file)
    return found
}

# Nominal stress where the strain is this one, between records.
function stress(file, strain,   line, field, n, i, head, e, s, was_e, was_s, found) {
    while ((getline line < file) > 0 && found == "") {
        if (line ~ /^#/) continue
        n = split(line, field, ",")
        if (!("engineering_strain" in head)) { for (i = 1; i <= n; i++) head[field[i]] = i; continue }
        e = field[head["engineering_strain"]]; s = field[head["engineering_stress_MPa"]]
        if (e >= strain - 1e-9 && e > was_e) found = was_s + (s - was_s) * (strain - was_e) / (e - was_e)
        was_e = e; was_s = s
    }
    close(file)
    return found
}

# Of a phase alone: sigma = yield + saturation (1 - exp(-rate p)), p = ln(1 + strain) - sigma/E.
function alone(strain, yield, saturation, rate,   s, n) {
    for (n = 0; n < 100; n++) s = (s + yield + saturation * (1 - exp(-rate * (log(1 + strain) - s / 210e3)))) / 2
    return s / (1 + strain)
}

BEGIN {
    FS = ","
    number["sc"] = 1; number["bcc"] = 2; number["fcc"] = 3
    print "run,fraction,UFG_yield_MPa,UFG_hardening_MPa,CG_hardening_MPa,arrangement,jitter,particles,Rp02_MPa,MPa_at_2,MPa_at_10,gain"
}
FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    f = $at["domain.ufg_fraction"]; uy = $at["UFG.hardening.yield"] + 0; us = $at["UFG.hardening.saturation"] + 0
    cs = $at["CG.hardening.saturation"] + 0
    curve = folder "/" $1 "/curve.csv"
    at2 = stress(curve, 0.02); cg = alone(0.02, 182.1, cs, 5.320)
    printf "%s,%.6g,%.6g,%.6g,%.6g,%d,%.6g,%d,%.6g,%.6g,%.6g,%.6g\n", $1, f, uy, us, cs, number[$at["domain.lattice"]], $at["domain.jitter"],
        int(400 / $at["domain.spacing"] + 0.5), proof(folder "/" $1 "/properties.csv"), at2, stress(curve, 0.1),
        (at2 - cg) / (f * (alone(0.02, uy, us, 238.5) - cg))
}
