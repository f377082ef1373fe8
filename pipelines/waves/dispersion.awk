# Speeds of longitudinal waves along [100] over that of the solid, by the symbol, of long waves first:
#   awk -F, -f symbol.awk -f dispersion.awk bodies.csv > dispersion.csv

BEGIN { print "body,waves_per_spacing,speed" }
!/^#/ && $1 != "name" {
    for (i = 0; i <= 100; i++) {
        k1 = i ? pi * i / 100 : 1e-4
        symbol($1, k1, 0, 0)
        printf "%s,%.4f,%.5f\n", $1, k1 / 2 / pi, frequency(1, 0, 0) / k1 / sqrt(lambda + 2)
    }
}
