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
    must(most["static-0.005"] < 0.5, "steps of 0.5 % are off by " most["static-0.005"] " %")
    # The hybrid is the static curve until it switches, and follows the explicit one of its speed from there.
    must(mean["hybrid"] < 0.5, "the hybrid is off by " mean["hybrid"] " %")
    must(mean["explicit-2"] < mean["explicit-10"], "slower grips are not nearer")
    must(forces["static-0.005"] < forces["explicit-10"], "load steps took more forces than explicit steps at 10 m/s")
    if (failed) exit 1
    print "solver-switch: all checks hold"
}
