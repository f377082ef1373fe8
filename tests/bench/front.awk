# Which setting for which error: of tests/bench/error's rows those that nothing cheaper is as near as, per quantity
#   awk -v quantity=E_MPa -f front.awk error.csv       lines "seconds error", for error.gp
#   awk -f front.awk error.csv                         the page error.md
BEGIN { FS = ","; order = split("E_MPa Rp02_MPa stress_at_5_percent_MPa stress_at_10_percent_MPa stress_at_20_percent_MPa strain_at_maximum", asked, " ")
    split("E|Rp0.2|stress at 5 %|stress at 10 %|stress at 20 %|strain at the largest load", title, "|"); bounds = split("0.03 0.01 0.003 0.001 0.0003", bound, " ") }
NR > 1 { n++; what[n] = $6; off[n] = $9 < 0 ? -$9 : +$9; cost[n] = $10
    across = int(200e-6 / $3 + 0.5)
    setting[n] = $1 ($2 ~ /explicit/ ? ", " $2 : "") ($4 > 1 ? ", horizon " $4 ", " $5 : "") ", " across; gsub("_", " ", setting[n]) }
function best(quantity, most,   i, found) {
    for (i = 1; i <= n; i++) if (what[i] == quantity && off[i] <= most && (!found || cost[i] < cost[found] || (cost[i] == cost[found] && off[i] < off[found]))) found = i
    return found
}
END {
    if (quantity) {
        for (most = 1e9; i = best(quantity, most); most = off[i] * 0.999999 - 1e-12) print cost[i], (off[i] > 1e-5 ? off[i] : 1e-5)
        exit
    }
    print "# Which setting for which error\n"
    print "Bars of 1.6 x 0.2 x 0.2 mm whose curve is known (Voce; E alone of elastic ones), made by `make bench`. In each place the cheapest run that is as near: model,"
    print "horizon, influence and particles across, and its CPU seconds; \"none\" where no run was. Load steps where nothing else is said. All runs: [error.csv](error.csv).\n"
    line = "| error of |"; rule = "|---|"
    for (k = 1; k <= bounds; k++) { line = line " under " 100 * bound[k] " % |"; rule = rule "---|" }
    print line; print rule
    for (q = 1; q <= order; q++) {
        line = "| " title[q] " |"
        for (k = 1; k <= bounds; k++) line = line " " ((i = best(asked[q], bound[k])) ? setting[i] ": " cost[i] " s" : "none") " |"
        print line
    }
    print "\n![Error against CPU time](error.svg)"
}
