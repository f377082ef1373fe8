# What the solvers must show: awk -v study=solver-switch -v rows=7 -f pipelines/must.awk -f check.awk table.csv

FNR > 1 { mean[$1] = $2; most[$1] = $3; forces[$1] = $6 }
END {
    # Load steps of 1 % bring what those of 0.1 % do but for the interpolation between their records.
    must(most["static-0.01"] < 0.2, "steps of 1 % are off by " most["static-0.01"] " %")
    # The hybrid is the static curve until it switches, and follows the explicit one of its speed from there.
    must(most["hybrid"] < 0.2, "the hybrid is off by " most["hybrid"] " %")
    must(mean["explicit-2"] < mean["explicit-10"], "slower grips are not nearer")
    must(most["static-0.01"] < most["explicit-2"] && forces["static-0.01"] < forces["explicit-2"], "load steps are not the nearer and cheaper")
    complete(mean, "mean deviation")
    complete(most, "largest deviation")
    complete(forces, "number of forces")
    finish()
}
