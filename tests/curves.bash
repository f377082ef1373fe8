# What tests of curves share.

# value NAME FILE: a property's value
value() { awk -F, -v name="$1" '$1 == name {print $3}' "$2"; }

# near A B TOLERANCE: absolute
near() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN {exit !(a != "" && a - b <= t && b - a <= t)}' || { echo "$1, expected $2 within $3"; return 1; }; }
