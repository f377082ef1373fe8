# What a curve of a tension test must show, whatever the material: awk -v study=NAME -v blank=all -v end=STRAIN -f pipelines/must.awk
# -f pipelines/curve.awk CURVE...   (curves of hspost; end: the gauge strain that the deck asks for)

function end_of_curve() {
    if (name == "") return
    must(strain >= end, name ": ends at a strain of " strain ", not " end)
    # All phases have the same modulus, and elastic nominal stress is E ln(1 + e)/(1 + e): a line through strains a to b falls short of E by
    # 1.5 (a + b).  Forces of load steps are accurate to 0.1 %, at either end of it.  Explicit steps: the grips of a plate w wide hold what
    # starts to contract, nu w/2 times the rate of strain: 0.6 m/s in the plate HS40, whose waves are per cents of its yield stress.
    exact = E * (1 - 1.5 * (strains[first_row] + strains[last_row]))
    must(E > 0 && off(slope / exact, 1) < (moves ? 0.03 : 0.002), name ": slope of " slope / 1e9 " GPa, not " exact / 1e9)
    # Yield lies between that of CG and the flow stress of UFG at 30 % (voce: 182.1; 1259.8 + 564.5 MPa).
    must(most > 182 && most < 1824.3, name ": largest stress of " most " MPa")
    # The scheme's own error is of the order (omega dt)^2 of the waves, far below.
    must(drift < 1e-3, name ": energy balance off by " drift)
}

FNR == 1 {
    end_of_curve()
    name = FILENAME
    slope = E = most = drift = moves = row = 0
    strain = ""
    split("", column)
}
/^# slope_Pa: / { slope = substr($0, 13) + 0 }
/^# slope_rows: / { split($0, word, " "); first_row = word[3]; last_row = word[5] }
/^# youngs_modulus_Pa: / { E = substr($0, 22) + 0 }
/^#/ { next }
!("engineering_strain" in column) {
    for (i = 1; i <= NF; i++) column[$i] = i
    must(("engineering_strain" in column) && ("engineering_stress_MPa" in column) && ("energy_drift" in column) && ("kinetic_to_internal" in column), name ": columns are missing")
    next
}
{
    strain = strains[++row] = $column["engineering_strain"] + 0
    if ($column["engineering_stress_MPa"] > most) most = $column["engineering_stress_MPa"]
    if ($column["kinetic_to_internal"] > 0) moves = 1
    if (size($column["energy_drift"]) > drift) drift = size($column["energy_drift"])
}
END {
    end_of_curve()
    finish()
}
