# A deck of ../finite-elements/mesh.awk with the programme of a looped test instead of its one pull:
#   awk -v to="0.005 ... 0.04" -f calculix.awk amplitude mesh.inp > bar.inp
# amplitude is what programme.awk prints; the last strain is that of the prescribed displacement.
BEGIN { n = split(to, up, " ") }
FNR == NR {
    amplitude = amplitude $0 "\n"
    legs = FNR - 2
    next
}
/^\*STEP/ {
    printf "%s*STEP, NLGEOM, INC=20000\n", amplitude
    step = 1
    next
}
/^\*STATIC/ {
    print
    getline
    printf "0.02,%d,1e-6,0.02\n", legs
    next
}
/^\*BOUNDARY/ && step { $0 = "*BOUNDARY, AMPLITUDE=PROGRAMME" }
/^LEFT,1,1/ { $0 = sprintf("LEFT,1,1,%.9g", -up[n] * 0.35) }
/^RIGHT,1,1/ { $0 = sprintf("RIGHT,1,1,%.9g", up[n] * 0.35) }
{ print }
