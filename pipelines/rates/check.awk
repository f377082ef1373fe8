# What the runs must show: awk -v study=rates -v rows=15 -v blank=E_error_percent -f pipelines/must.awk -f check.awk table.csv

FNR > 1 { two[$1] = size($4); five[$1] = size($5); forces[$1] = $8 }
END {
    must(two["explicit-5"] < two["explicit-20"] && two["explicit-20"] < two["explicit-40"], "faster grips are not worse at 2 %")
    # Inertia times 100 is what ten times the speed is, for the waves and for the steps.
    must(two["mass-100"] > two["explicit-5"], "scaled inertia is free")
    must(size(forces["explicit-5"] / forces["mass-100"] / 10 - 1) < 0.03, "inertia times 100: " forces["explicit-5"] / forces["mass-100"] " times fewer steps")
    # Half steps of 0.25 % between records bend the curve by a few hundredths of a per cent.
    must(two["static"] < 0.1 && five["static"] < 0.1, "load steps are off by " two["static"] " and " five["static"] " %")
    complete(two, "stress at 2 %")
    complete(five, "stress at 5 %")
    complete(forces, "number of forces")
    finish()
}
