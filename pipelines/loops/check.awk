# What loops of unloading must show: awk -v study=loops -f pipelines/must.awk -f check.awk table.csv
# Columns: curve, loop, strain, plastic strain, flow stress, lowest, two slopes, reverse yield, reload yield, back stress, effective stress, ...

FNR == 1 { next }
{
    curve = $1
    flow = $5
    back = $11
    # A node hardens isotropically: a homogeneous body has no back stress, to 1 %
    if (curve ~ /^(CG|UFG)$/) {
        must(back != "" && size(back) <= 0.01 * flow, curve " has a back stress of " back " of " flow " MPa in loop " $2)
        homogeneous[curve]++
    }
    # The mismatch of the phases makes one
    if (curve == "HS40" && $2 > 1) must(back > 0.4 * flow, "HS40 has a back stress of " back " of " flow " MPa in loop " $2)
    if (curve ~ /^R40/ && $2 > 1) must(back > 0.2 * flow, curve " has a back stress of " back " of " flow " MPa in loop " $2)
    if (curve == "HS40") ours[$2] = back "," flow
    if (curve == "HS40 by CalculiX") theirs[$2] = back "," flow
    # A cell without grips, unloaded to no stress
    if (curve == "Cell") cell[$2] = back "," flow
    if (curve == "Cell by CalculiX") their_cell[$2] = back "," flow
}
END {
    must(homogeneous["CG"] == 4 && (small || homogeneous["UFG"] == 3), "loops of homogeneous bodies are missing")
    # By finite elements of the same voxels, which are as coarse: flow stress to 5 %, back stress to 10 %
    for (loop = 2; loop <= 4; loop++) {
        split(ours[loop], a, ",")
        split(theirs[loop], b, ",")
        must(b[1] > 0 && off(a[2], b[2]) <= 0.05 * b[2], "flow stress in loop " loop ": " a[2] ", CalculiX " b[2])
        must(b[1] > 0 && off(a[1], b[1]) <= 0.10 * b[1], "back stress in loop " loop ": " a[1] ", CalculiX " b[1])
    }
    # The cell and its mirror cell, without grips: to 3 % and 6 %
    for (loop = 1; loop <= 3; loop++) {
        split(cell[loop], a, ",")
        split(their_cell[loop], b, ",")
        must(a[1] > 0.4 * a[2], "the cell has a back stress of " a[1] " of " a[2] " MPa in loop " loop)
        must(b[1] > 0 && off(a[2], b[2]) <= 0.03 * b[2], "flow stress of the cell in loop " loop ": " a[2] ", CalculiX " b[2])
        must(b[1] > 0 && off(a[1], b[1]) <= 0.06 * b[1], "back stress of the cell in loop " loop ": " a[1] ", CalculiX " b[1])
    }
    finish()
}
