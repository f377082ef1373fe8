# awk -F, -f table.awk elastic.csv plates.csv: both as Markdown.  Numbers are measured over nominal.

function key(where, dimension, name, horizon, volumes, correction) {
    return where SUBSEP dimension SUBSEP name SUBSEP horizon SUBSEP volumes SUBSEP correction
}
# E, or nu with its nominal value taken off
function E(where, dimension, name, horizon, volumes, correction,   k) {
    k = key(where, dimension, name, horizon, volumes, correction)
    return k in modulus ? sprintf("%.3f", modulus[k]) : ""
}
function nu(where, dimension, name, horizon, volumes, correction,   k) {
    k = key(where, dimension, name, horizon, volumes, correction)
    return k in ratio ? sprintf("%.3f", ratio[k]) : ""
}
function row(n, cells,   i, line) {
    for (i = 1; i <= n; i++) line = line "| " cells[i] " "
    print line "|"
}
function head(titles,   n, i, cells) {
    n = split(titles, cells, ";")
    print ""
    row(n, cells)
    for (i = 1; i <= n; i++) cells[i] = "---"
    row(n, cells)
}

/^#/ || /^where,/ { next }
/^model,/ { yields = 1; next }
yields {
    plastic[++plastics] = "| " $1 " | " $2 " | " $3 " | " $4 " | " $5 " | " sprintf("%.3f | %.2f |", $6, $7)
    next
}
{
    name = $3 " | " $4
    k = key($1, $2, name, $5, $6, $7)
    modulus[k] = $8
    ratio[k] = $9
    if ($1 == "bulk") { c44[k] = $11; prime[k] = $12; yield[k] = $13; slope[k] = $14 }
    if (!(($1, $2, name) in seen)) {
        seen[$1, $2, name] = 1
        order[$1, $2, ++number[$1, $2]] = name
        nominal[$1, $2, name] = $10
    }
}

function bulk(dimension, full,   i, name, k, line) {
    head("model;influence;E 2.015;3.015;4.015;partial 2.015;3.015;4.015;nu (nominal);C44;C'" \
         (full ? ";yield;slope" : ""))
    for (i = 1; i <= number["bulk", dimension]; i++) {
        name = order["bulk", dimension, i]
        k = key("bulk", dimension, name, "3.015", "whole", "none")
        line = "| " name
        line = line " | " E("bulk", dimension, name, "2.015", "whole", "none")
        line = line " | " E("bulk", dimension, name, "3.015", "whole", "none")
        line = line " | " E("bulk", dimension, name, "4.015", "whole", "none")
        line = line " | " E("bulk", dimension, name, "2.015", "partial", "none")
        line = line " | " E("bulk", dimension, name, "3.015", "partial", "none")
        line = line " | " E("bulk", dimension, name, "4.015", "partial", "none")
        line = line " | " sprintf("%.3f (%.3f)", ratio[k], nominal["bulk", dimension, name])
        line = line " | " sprintf("%.3f | %.3f", c44[k], prime[k])
        if (full) line = line " | " (yield[k] == "" ? " | " : sprintf("%.3f | %.3f", yield[k], slope[k]))
        print line " |"
    }
}
function plates(where, dimension, others,   i, name, line) {
    head("model;influence;E none;partial;volume;energy" \
         (others ? ";2.015 none;energy;4.015 none;energy" : "") ";nu (nominal) none;energy")
    for (i = 1; i <= number[where, dimension]; i++) {
        name = order[where, dimension, i]
        if (name ~ /correspondence/) continue
        line = "| " name
        line = line " | " E(where, dimension, name, "3.015", "whole", "none")
        line = line " | " E(where, dimension, name, "3.015", "partial", "none")
        line = line " | " E(where, dimension, name, "3.015", "whole", "volume")
        line = line " | " E(where, dimension, name, "3.015", "whole", "energy")
        if (others) {
            line = line " | " E(where, dimension, name, "2.015", "whole", "none")
            line = line " | " E(where, dimension, name, "2.015", "whole", "energy")
            line = line " | " E(where, dimension, name, "4.015", "whole", "none")
            line = line " | " E(where, dimension, name, "4.015", "whole", "energy")
        }
        line = line " | " nu(where, dimension, name, "3.015", "whole", "none") \
            sprintf(" (%.3f)", nominal[where, dimension, name])
        line = line " | " nu(where, dimension, name, "3.015", "whole", "energy")
        print line " |"
    }
}
function correspondence(   i, h, name) {
    head("model;influence;horizon;E;nu (nominal)")
    for (i = 1; i <= number["plate", "space"]; i++) {
        name = order["plate", "space", i]
        for (h = 1; h <= 3 && name ~ /correspondence/; h++)
            print "| " name " | " h " | " \
                sprintf("%.4f | %.4f (%.3f) |", modulus[key("plate", "space", name, h, "whole", "none")],
                        ratio[key("plate", "space", name, h, "whole", "none")],
                        nominal["plate", "space", name])
    }
}

END {
    print "\n### Bulk, three dimensions"; bulk("space", 1)
    print "\n### Bulk, plane stress"; bulk("plane stress", 0)
    print "\n### Bulk, plane strain"; bulk("plane strain", 0)
    print "\n### Plate of 8 x 8"; plates("plate", "space", 1); correspondence()
    print "\n### Plate of 40 x 8"; plates("plate40", "space", 0)
    print "\n### Strip of 8, plane stress"; plates("plate", "plane stress", 0)
    print "\n### Strip of 8, plane strain"; plates("plate", "plane strain", 0)
    print "\n### Yield and hardening, plate of 8 x 8"
    head("model;influence;horizon;volumes;correction;Rp0.2;slope")
    for (i = 1; i <= plastics; i++) print plastic[i]
}
