# Strain and stress in MPa of a mirror cell, edge in mm, from what CalculiX prints: awk -v edge=0.08 -f cell-curve.awk cell.dat
# With -F, -v turns=yes, of a curve of hspost: the strains at which it turns, those to which it reloads, and the last one.

BEGIN { if (!turns) print "engineering_strain,engineering_stress_MPa\n0,0" }

turns && /^#/ { next }
turns && !column { for (f = 1; f <= NF; f++) if ($f == "engineering_strain") column = f; next }
turns {
    step = $column - strain
    if (step * before < 0) {
        printf "%.9g ", strain
        if (before < 0) printf "%.9g ", top
        else top = strain
    }
    before = step
    strain = $column
    next
}

/total force/ { what = "force" }
/displacements/ { what = "way" }
what == "force" && NF == 3 && $1 + 0 == $1 { force = $1 }
what == "way" && NF == 4 && $2 + 0 == $2 { printf "%.9g,%.9g\n", $2 / edge, force / edge ^ 2; what = "" }

END { if (turns) printf "%.9g\n", strain }
