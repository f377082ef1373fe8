# What the runs must show: awk -f check.awk table.csv

function must(holds, what) {
    if (holds) return
    print "rates: " what > "/dev/stderr"
    failed = 1
}
function size(a) { return a < 0 ? -a : a }

BEGIN { FS = "," }
FNR > 1 { two[$1] = size($4); five[$1] = size($5); forces[$1] = $8 }
END {
    must(two["explicit-5"] < two["explicit-20"] && two["explicit-20"] < two["explicit-40"], "faster grips are not worse at 2 %")
    # Inertia times 100 is what ten times the speed is, for the waves and for the steps.
    must(two["mass-100"] > two["explicit-5"], "scaled inertia is free")
    must(size(forces["explicit-5"] / forces["mass-100"] / 10 - 1) < 0.03, "inertia times 100: " forces["explicit-5"] / forces["mass-100"] " times fewer steps")
    # Half steps of 0.25 % between records bend the curve by a few hundredths of a per cent.
    must(two["static"] < 0.1 && five["static"] < 0.1, "load steps are off by " two["static"] " and " five["static"] " %")
    if (failed) exit 1
    print "rates: all checks hold"
}
