# What the costs must show: awk -v study=solvers [-v small=yes] -f pipelines/must.awk -f check.awk runs.csv

$1 == "material" { next }
{ cost[$1, $3, $4, $5, $6] = $7 }

END {
    for (m = 1; m <= 2; m++) {
        material = m == 1 ? "cg" : "hs40"
        small = cost[material, "100x20x4", 1, "lbfgs", "0.0004"]
        # An elastic step costs as much whatever the number of nodes, and the length.
        must(small > 0 && small <= 40, material ": an elastic step takes " small)
        must(cost[material, "200x40x8", 1, "lbfgs", "0.0004"] <= 1.2 * small, material ": grows with 8 times the nodes")
        if (small == "") must(cost[material, "400x80x16", 1, "lbfgs", "0.0004"] <= 1.3 * small, material ": grows with 64 times the nodes")
        must(cost[material, "400x20x4", 1, "lbfgs", "0.0004"] <= 1.2 * small, material ": grows with 4 times the length")
        # Relaxation is there for comparison.
        must(cost[material, "100x20x4", 1, "relaxation", "0.0004"] > 3 * small, material ": relaxation is as good in elastic steps")
        must(cost[material, "100x20x4", 1, "relaxation", "0.005"] > 2 * cost[material, "100x20x4", 1, "lbfgs", "0.005"],
             material ": relaxation is as good in plastic steps")
    }
    complete(cost, "cost")
    finish()
}
