# What the bars must show: awk -v study=necking-bar [-v small=yes] -f pipelines/must.awk -f check.awk table.csv

FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
FNR > 1 {
    name = $1
    for (c in column) of[name, c] = $column[c]
    seen[name] = 1
    # However coarse the body: the largest force where it belongs, within 0.05 mm, and half a per cent of the force to 4 mm.
    must(off($column["at_mm"], 3.43) < 0.05, name ": largest force at " $column["at_mm"] " mm")
    for (u = 1; u <= 4; u++) must(size($column["error_" u "_mm"]) < 0.5, name ": force at " u " mm off by " $column["error_" u "_mm"] " %")
}
function error(bar, at) { return size(of[bar, "error_" at "_mm"]) }
END {
    must("CAX8R 10x40/0.0025" in seen && "3-150" in seen && "6-150" in seen, "rows of two bars and of the elements")
    # What the reference itself is known to.
    must(error("CAX8R 10x40/0.0025", 7) < 1 && error("CAX8R 10x40/0.0025", 6.5) < 0.5, "the elements still move")
    must(error("6-150", 7) < 0.65 * error("3-150", 7), "twice as fine across: " error("6-150", 7) " % at 7 mm, after " error("3-150", 7))
    # Half of what is left is the residual's limit.
    must(error("6-150-soft", 7) < 0.6 * error("6-150", 7), "a soft residual leaves " error("6-150-soft", 7) " % at 7 mm of " error("6-150", 7))
    if (!small) {
        must(error("12-150", 7) < 0.65 * error("6-150", 7), "twice as fine across: " error("12-150", 7) " % at 7 mm, after " error("6-150", 7))
        must(error("6-150", 7) < error("6-50", 7) && error("6-50", 7) < error("6-25", 7), "finer along the axis is no better")
        # Aims: 1.5 % of the force to 6.5 mm, the neck's radius within a hundredth, 3 % at 7 mm.
        must(error("12-300", 6.5) < 1.5 && size(of["12-300", "radius_6.5_mm"]) < 0.01, "12-300 at 6.5 mm: " error("12-300", 6.5) " %")
        must(error("12-300-soft", 7) < 3 && size(of["12-300-soft", "radius_7_mm"]) < 0.01, "12-300-soft at 7 mm: " error("12-300-soft", 7) " %, " of["12-300-soft", "radius_7_mm"])
    }
    finish()
}
