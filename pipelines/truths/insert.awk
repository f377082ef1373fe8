# A table between its marks: awk -f insert.awk TABLE.md DOCUMENT.md

NR == FNR { table = table $0 "\n"; next }
/^<!-- end of truths/ { inside = 0 }
!inside { print }
/^<!-- truths / { inside = 1; found = 1; printf "%s\n", table }
END { if (!found) exit 1 }
