# Splits each particle of Peridigm's text into by^3: awk -v by=2 -v spacing=25e-6 -f split.awk voxels.txt

/^#/ {
    print
    next
}

{
    for (k = 0; k < by; k++)
        for (j = 0; j < by; j++)
            for (i = 0; i < by; i++)
                printf "%.17g %.17g %.17g %d %.17g\n", $1 + shift(i), $2 + shift(j), $3 + shift(k), $4, $5 / by ^ 3
}

function shift(i) {
    return spacing * ((i + 0.5) / by - 0.5)
}
