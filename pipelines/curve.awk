# What a curve of a tension test must show, whatever the material: awk -v study=NAME -v blank=all -v end=STRAIN -f pipelines/must.awk
# -f pipelines/curve.awk CURVE...   (curves of hspost; end: the gauge strain that the deck asks for)

function end_of_curve() {
    if (name == "") return
    must(strain >= end, name ": ends at a strain of " strain ", not " end)
    # All phases have the same modulus.  Waves of grips at 1 to 10 m/s and their length leave per cents (README of the first study: 1.1).
    must(E > 0 && off(slope / E, 1) < 0.03, name ": slope of " slope / 1e9 " GPa, E of " E / 1e9)
    # Yield lies between that of CG and the flow stress of UFG at 30 % (voce: 182.1; 1259.8 + 564.5 MPa).
    must(most > 182 && most < 1824.3, name ": largest stress of " most " MPa")
    # The scheme's own error is of the order (omega dt)^2 of the waves, far below.
    must(drift < 1e-3, name ": energy balance off by " drift)
}

FNR == 1 {
    end_of_curve()
    name = FILENAME
    slope = E = most = drift = 0
    strain = ""
    split("", column)
}
/^# slope_Pa: / { slope = substr($0, 13) + 0 }
/^# youngs_modulus_Pa: / { E = substr($0, 22) + 0 }
/^#/ { next }
!("engineering_strain" in column) {
    for (i = 1; i <= NF; i++) column[$i] = i
    must(("engineering_strain" in column) && ("engineering_stress_MPa" in column) && ("energy_drift" in column), name ": columns are missing")
    next
}
{
    strain = $column["engineering_strain"] + 0
    if ($column["engineering_stress_MPa"] > most) most = $column["engineering_stress_MPa"]
    if (size($column["energy_drift"]) > drift) drift = size($column["energy_drift"])
}
END {
    end_of_curve()
    finish()
}
