# A quarter of the bar's meridian for CalculiX, quadratic axisymmetric elements, finer towards the middle; mm, MPa:
#   awk -v across=N -v along=N -v increment=I -f mesh.awk

BEGIN {
    radius = 6.413; half = 26.667
    q = 3.26 ^ (1 / (along - 1)) # the outermost elements are so many times as long as the innermost
    for (j = 0; j < along; j++) whole += q ^ j
    for (j = 0; j < along; j++) {
        h = half * q ^ j / whole
        z[2 * j + 1] = z[2 * j] + h / 2
        z[2 * j + 2] = z[2 * j] + h
    }
    print "*NODE, NSET=ALL"
    for (j = 0; j <= 2 * along; j++) for (i = 0; i <= 2 * across; i++) {
        if (i % 2 && j % 2) continue
        number[i, j] = ++n
        printf "%d,%.9g,%.9g,0\n", n, radius * i / (2 * across), z[j]
        if (i == 0) axis = axis n ",\n"
        if (j == 0) middle = middle n ",\n"
        if (j == 2 * along) end = end n ",\n"
    }
    print "*ELEMENT, TYPE=CAX8R, ELSET=BAR"
    for (j = 0; j < 2 * along; j += 2) for (i = 0; i < 2 * across; i += 2)
        printf "%d,%d,%d,%d,%d,%d,%d,%d,%d\n", ++e, number[i, j], number[i + 2, j], number[i + 2, j + 2], number[i, j + 2], \
            number[i + 1, j], number[i + 2, j + 1], number[i + 1, j + 2], number[i, j + 1]
    printf "*NSET, NSET=AXIS\n%s*NSET, NSET=MIDDLE\n%s*NSET, NSET=END\n%s*NSET, NSET=NECK\n%d,\n", axis, middle, end, number[2 * across, 0]
    print "*MATERIAL, NAME=M\n*ELASTIC\n200000,0.3\n*PLASTIC"
    print "451,0\n476,.006\n525,.019\n583,.038\n642,.066\n710,.147\n777,.5\n831,1"
    print "*SOLID SECTION, ELSET=BAR, MATERIAL=M\n*BOUNDARY\nMIDDLE,2,2\nAXIS,1,1\nEND,1,1"
    print "*STEP, NLGEOM, INC=4000\n*STATIC\n0.002,1,1e-7," increment "\n*BOUNDARY\nEND,2,2,7"
    print "*NODE PRINT, NSET=END, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=NECK\nU\n*EL PRINT, ELSET=BAR\nPEEQ\n*END STEP"
}
