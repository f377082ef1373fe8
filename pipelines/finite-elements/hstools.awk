# Gauge strain and stress of hssolve's history: hspost --columns history.e | awk -f pipelines/columns.awk -F, -v spacing=25 -v cpu=1.2 -f hstools.awk

/^#/ { next }
header() { next }
$col("right") > 0 {
    printf "hstools,%s,%.8g,%.8g,%s\n", spacing, ($col("right") - $col("left")) / 0.4e-3, ($col("force_right_N") - $col("force_left_N")) / 2 / 0.02, cpu
}
