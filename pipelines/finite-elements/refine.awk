# Particles as text (hsgen --peridigm), each cut into n^3: awk -v n=2 -v spacing=25e-6 -f refine.awk domain.txt
/^#/ { print; next }
{
    for (c = 0; c < n; c++)
        for (b = 0; b < n; b++)
            for (a = 0; a < n; a++)
                printf "%.17g %.17g %.17g %d %.17g\n", $1 + ((a + 0.5) / n - 0.5) * spacing, $2 + ((b + 0.5) / n - 0.5) * spacing, \
                    $3 + ((c + 0.5) / n - 0.5) * spacing, $4, $5 / n ^ 3
}
