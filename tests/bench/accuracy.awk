# A row of tests/bench/accuracy: awk -v body=NAME -v model=NAME -f accuracy.awk REFERENCE.csv RUN.csv, both of hspost --columns.
# Compared at equal times, which are those of the prescribed motion.

BEGIN { k = 1; FS = ","; wanted = split("CG_true_stress_Pa CG_plastic_strain UFG_true_stress_Pa UFG_plastic_strain", name, " "); name[0] = "force_right_N" }
/^#/ { next }
FNR == 1 || !started[FILENAME] {
    started[FILENAME] = 1; file++; records = 0
    for (i in column) delete column[i]
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
{
    time = $column["time_s"]; records++
    if (file == 1) at[++n] = time
    else {
        evaluations = $column["force_evaluations"]
        if (time > at[n]) next # the reference ended a little earlier
        for (; k < n - 1 && at[k + 1] < time; k++);
        share = at[k + 1] > at[k] ? (time - at[k]) / (at[k + 1] - at[k]) : 1
    }
    for (q = 0; q <= wanted; q++) {
        if (!(name[q] in column)) continue
        value = $column[name[q]]
        if (file == 1) { curve[q, n] = value; size = value < 0 ? -value : value; if (size > top[q]) top[q] = size; continue }
        off = value - curve[q, k] - share * (curve[q, k + 1] - curve[q, k]); if (off < 0) off = -off
        if (off > worst[q]) worst[q] = off
    }
}
END {
    printf "%s,%s,%d,%d,%d", body, model, records - 1, evaluations, n - 1
    for (q = 0; q <= wanted; q++) printf ",%s", (top[q] > 0 ? sprintf("%.3f", 100 * worst[q] / top[q]) : "")
    print ""
}
