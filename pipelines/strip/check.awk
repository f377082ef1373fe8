# What the strips must do: awk -v study=strip -v blank="first slow released broken running of_bonds speed" -f pipelines/must.awk -f check.awk table.csv

FNR > 1 && !/^#/ {
    name = $1 " " $2 " " $3 " " $4 " " $5
    seen[name] = 1
    reach = int($3)
    # What the lattice makes of the moduli in a plane, and of the height between clamped edges.
    must($6 > 0.85 && $6 < 1.1, name ": the strip holds " $6 " of E (2 u)^2/(2 (1 - nu^2) H)")
    if ($9 != "" && $5 == 0 && $2 == "critical_stretch" && reach >= 3)
        # Rivlin and Thomas: a strip torn through at one load loses W H for each unit of area; ends are a part in twenty of the ligament.
        must(off($9 / $8, 1) < 0.1, name ": released " $9 ", put in " $8)
    if ($8 != "" && $11 != "" && $5 == 0) must($8 > $11, name ": slow, at " $8 ", is not above running, at " $11)
    # The criterion, of bonds as stiff as the lattice makes them.
    if ($12 != "" && reach >= 3) must(off($12 / $6, 1) < 0.12, name ": bonds broken by a running crack hold " $12 " in a strip that has " $6)
}
END {
    must(length(seen) >= 2, "fewer than two strips")
    finish()
}
