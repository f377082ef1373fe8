# What the bars must show: awk -v study=taylor-bar -v rows=4 -f pipelines/must.awk -f check.awk table.csv

FNR > 1 {
    across = $1 + 0
    # Published codes: 21.4 to 21.5 mm, 7.0 to 7.2 mm, to a tenth, plastic strains of 2.5 to 3.2; a radius of three particles is coarse.
    must(off($3, 21.45) < (across > 3 ? 0.05 : 0.12), $1 ": " $3 " mm long")
    must($4 > 6.95 && $4 < 7.25, $1 ": a foot of " $4 " mm")
    foot[$1] = $4
    if (across > 3) must($5 > 2.5 && $5 < 3.3, $1 ": largest plastic strain " $5)
    # A plane of symmetry is a wall only as long as nothing pulls.
    must($6 > 0, $1 ": the wall pushes by " $6 " kN at the least")
    must($7 < 0.2, $1 ": still in motion, " $7 " %")
    must(size($8) < 0.5, $1 ": energy drifts by " $8 " %")
}
END {
    # Of one length of particles or of one width it is the same to a three-hundredth of its growth.
    if ("12-120" in foot) must(off(foot["6-60"], foot["6-120"]) < 0.02 && off(foot["6-120"], foot["12-120"]) < 0.01, "the foot moves with the spacing")
    finish()
}
