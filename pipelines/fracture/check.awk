# What the four must show: awk -v study=fracture -v rows=4 -f pipelines/must.awk -f check.awk table.csv

FNR > 1 {
    must($4 > $3, $1 ": not broken behind its largest load: " $4 " and " $3)
    must($9 > 0 && $13 > 0, $1 ": no node is gone")
    # Until the largest load the body is at rest; explicit steps at 10 m/s let the grips' forces differ by waves.
    must($7 < 0.5, $1 ": grips apart by " $7 " % before the largest load")
    must($10 < 1e-2 && $10 > -1e-2, $1 ": energy balance " $10)
    broken[$1] = $4
    most[$1] = $2
}
END {
    must(most["cg"] < most["r40"] && most["r40"] < most["hs40"] && most["hs40"] < most["ufg"], "order of the largest stresses")
    must(broken["ufg"] < broken["r40"] && broken["hs40"] < broken["cg"], "order of the strains at fracture")
    complete(most, "largest stress")
    complete(broken, "strain at fracture")
    finish()
}
