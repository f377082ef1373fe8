# strain of the gauge (0.4 mm) and engineering stress in MPa (0.02 mm2) from the table of results of CalculiX:
#   awk -f read.awk model.dat
/total force/ { time = $NF; want = "force"; next }
/set GAUGELEFT/ { want = "left"; sum = n = 0; next }
/set GAUGERIGHT/ { left = sum / n; want = "right"; sum = n = 0; next }
NF == 0 { next }
want == "force" { if (force != "" && n) finish(); force = $1; want = ""; next }
want == "left" || want == "right" { sum += $2; n++ }
function finish() { printf "%.8f,%.5f\n", (sum / n - left) / 0.4, force / 0.02 }
BEGIN { print "strain,stress_MPa" }
END { finish() }
