# What the solvers must show: awk -f check.awk table.csv

function must(holds, what) {
    if (holds) return
    print "solver-switch: " what > "/dev/stderr"
    failed = 1
}

BEGIN { FS = "," }
FNR > 1 { mean[$1] = $2; most[$1] = $3; forces[$1] = $6 }
END {
    # Load steps of 1 % bring what those of 0.1 % do but for the interpolation between their records.
    must(most["static-0.01"] < 0.2, "steps of 1 % are off by " most["static-0.01"] " %")
    # The hybrid is the static curve until it switches, and follows the explicit one of its speed from there.
    must(most["hybrid"] < 0.2, "the hybrid is off by " most["hybrid"] " %")
    must(mean["explicit-2"] < mean["explicit-10"], "slower grips are not nearer")
    must(most["static-0.01"] < most["explicit-2"] && forces["static-0.01"] < forces["explicit-2"], "load steps are not the nearer and cheaper")
    if (failed) exit 1
    print "solver-switch: all checks hold"
}
