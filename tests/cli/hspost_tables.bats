#!/usr/bin/env bats
# Tables as laboratories write them: one curve (tests/data/records) in many forms.

bats_require_minimum_version 1.5.0
load ../curves

setup() {
    records="$BATS_TEST_DIRNAME/../data/records"
    curve=$records/voce.csv
    cd "$BATS_TEST_TMPDIR" || return 1
}

# same FILE OPTIONS...: the properties of the curve; what was taken is left in the file said.  Tolerances: what the
# forms' rounding of the curve to five digits does.
same() {
    hspost "$@" -p p.csv -o curve.csv 2>said || { cat said; return 1; }
    near "$(value modulus p.csv)" 69.88 0.1
    near "$(value proof_strength_0.2 p.csv)" 152.88 0.1
    near "$(value tensile_strength p.csv)" 221.29 0.01
    near "$(value extension_at_maximum_force p.csv)" 14.2 0.2
    near "$(value extension_at_fracture p.csv)" 18.36 0.01
    near "$(value plastic_extension_at_fracture p.csv)" 18.08 0.01
}

numbers() { sed 1d "$curve"; }

@test "commas and points, as hspost itself writes" {
    same "$curve"
    same - <"$curve"
}

@test "a block of facts, names, units in brackets, quoted numbers, per cent" {
    same "$records/header_block.csv"
    grep -q "strain = column 4 'Tensile strain' in %, stress = column 5 'Tensile stress' in MPa" said
    grep -q 'S0 = 20 mm2, L0 = 50 mm, rows from line 6 to 227' said
    grep -q '^# table: strain = column 4' curve.csv
    near "$(value section p.csv)" 2e-5 1e-12
    near "$(value gauge_length p.csv)" 0.05 1e-12
}

@test "German, semicolons, decimal commas, Latin-1, CR LF, section in the header" {
    same "$records/german_latin1.csv"
    grep -q "strain = column 3 'Dehnung' in %, force = column 2 'Standardkraft' in N, time = column 1 'Prüfzeit'" said
    grep -q 'WINDOWS-1252' said
}

@test "force and stroke, every value quoted, the specimen above" {
    same "$records/quoted_force_stroke.csv" --section '20 mm2' --gauge-length '50 mm'
    run ! --separate-stderr hspost "$records/quoted_force_stroke.csv" --section '20 mm2'
    [[ $stderr == *"does not say the gauge length; give --gauge-length"* ]]
}

@test "force and extension with units behind the names" {
    same "$records/force_extension.csv" --section '20 mm2' --gauge-length '50 mm'
    run ! --separate-stderr hspost "$records/force_extension.csv" --gauge-length '50 mm'
    [[ $stderr == *"does not say the section; give --section"* ]]
}

@test "character sets and line ends" {
    { printf '\xef\xbb\xbf'; sed 's/$/\r/' "$curve"; } >bom.csv
    same bom.csv
    tr '\n' '\r' <"$curve" >cr.csv
    same cr.csv
    { printf 'Prüfer;N.N.\nDehnung;Spannung\n;N/mm²\n'; numbers | tr ,. ';,'; } >german.csv
    for set in UTF-8 UTF-16 UTF-16LE UTF-16BE LATIN1; do
        iconv -f UTF-8 -t "$set" german.csv >set.csv
        same set.csv
    done
    grep -q "stress = column 2 'Spannung' in N/mm²" said
}

@test "names and units in other forms" {
    for names in Strain,Stress_MPa 'engineering strain, engineering stress [MPa]' 'Dehnung,Spannung / MPa' \
        '"Strain [-]","Stress [N/mm^2]"' 'Nominal strain (mm/mm),Nominal stress in MPa' '# strain,stress (MPa)'; do
        { echo "$names"; numbers; } >t.csv
        same t.csv
    done
    { echo 'engineering_strain_%,engineering_stress_MPa'; numbers | awk -F, '{printf "%.6f,%s\n", 100 * $1, $2}'; } >t.csv
    same t.csv
    { echo 'Load (kN),Extensometer (µm)'; numbers | awk -F, '{printf "%.8f,%.6f\n", $2 * 20 / 1000, $1 * 50000}'; } >t.csv
    same t.csv --section '20 mm2' --gauge-length '50 mm'
    { echo 'Stress (ksi),Extension (%)'; numbers | awk -F, '{printf "%.9f,%.6f\n", $2 / 6.894757293, $1 * 100}'; } >t.csv
    same t.csv
}

@test "delimiters, quotes, a row of units, trailing delimiters, footers, blank lines" {
    for form in 's/,/\t/' 's/,/  /' 's/\([^,]*\),\(.*\)/"\1","\2"/' 's/$/,/' '1s/$/\n-,MPa/' '$s/$/\nEnd of test/' \
        '$s/$/\n\nMaximum;3825.87;N\n/' '3s/^/\n/'; do
        sed "$form" "$curve" >t.csv
        same t.csv
    done
    { echo 'Strain Stress_MPa'; numbers | tr ,. ' ,'; } >t.csv
    same t.csv
    { printf 'Strain\tStress_MPa\n'; numbers | tr ,. '\t,'; } >t.csv
    same t.csv
}

@test "thousands, remarks, dates and times of the day beside the numbers" {
    { echo '"Load (N)","Extension (mm)"'; numbers | perl -F, -lane '$n = sprintf "%.5f", $F[0 + 1] * 200; 1 while $n =~ s/^(\d+)(\d{3})/$1,$2/; printf "\"%s\",\"%.7f\"\n", $n, $F[0] * 50'; } >t.csv
    grep -q '^"[0-9]*,[0-9]*\.' t.csv
    same t.csv --section '200 mm2' --gauge-length '50 mm'
    { echo 'Kraft [N];Weg [mm]'; numbers | perl -F, -lane '$n = sprintf "%.5f", $F[1] * 200; $n =~ tr/./,/; 1 while $n =~ s/^(\d+)(\d{3})/$1.$2/; $w = sprintf "%.7f", $F[0] * 50; $w =~ tr/./,/; print "$n;$w"'; } >t.csv
    same t.csv --section '200 mm2' --gauge-length '50 mm'
    { echo 'Zeit;Dehnung;Spannung (MPa);Datum;Bemerkung'; numbers | awk -F, '{printf "00:%02d:%02d;%s;%s;2020-01-02 10:00;%s\n", NR / 60, NR % 60, $1, $2, NR == 30 ? "yields" : ""}'; } >t.csv
    same t.csv
    grep -q "strain = column 2 'Dehnung' as it is, stress = column 3 'Spannung (MPa)' in MPa, rows from" said
}

# whole SCALE: force in whole N with thousands dots, extension with decimal commas, of a section of SCALE times 20 mm2
whole() { numbers | perl -F, -lane '$n = sprintf "%.0f", $F[1] * 20 * '"$1"'; 1 while $n =~ s/^(-?\d+)(\d{3})/$1.$2/; $w = sprintf "%.7f", $F[0] * 50; $w =~ tr/./,/; print "$n;$w"'; }

@test "thousands dots of whole numbers beside decimal commas, where the column says that they are" {
    { echo 'Kraft [N];Weg [mm]'; whole 100; } >t.csv
    grep -q '^[1-9][0-9]*\.[0-9]*;' t.csv
    grep -q '^[0-9]*;' t.csv
    same t.csv --section '2000 mm2' --gauge-length '50 mm'
    # nothing below a thousand, or a thousand without its dot, or a point that parts no thousands
    ambiguous() { fails "is not a finite number" hspost "$@" --section '2000 mm2' --gauge-length '50 mm'; }
    { echo 'Kraft [N];Weg [mm]'; whole 100 | grep '^[^;]*\.'; } >all.csv
    ambiguous all.csv
    sed '100s/\.//' t.csv >some.csv
    ambiguous some.csv
    [[ $stderr == *"thousands or decimals? the other numbers of its column do not say"* ]]
    sed '100s/^[^;]*/1.5/' t.csv >some.csv
    ambiguous some.csv
    { echo 'L0;1.000;mm'; cat t.csv; } >some.csv
    fails 'does not say the gauge length' hspost some.csv --section '2000 mm2'
}

@test "name and symbol, thickness and width, diameter, more headings in German" {
    body() { numbers | awk -F, '{printf "%.5f;%.7f\n", $2 * 20, $1 * 50}' | tr . ,; }
    for facts in 'Querschnitt S0 [mm²];20,00|Messlaenge L0 [mm];50,0' 'Dicke a0 [mm];2,0|Breite b0 [mm];10,0|Anfangsmesslänge L0;50,0;mm' \
        'Probendurchmesser d0;5,0462650;mm|Gauge length L0;50;mm'; do
        for names in 'Kraft F [N];Dehnweg [mm]' 'PRÜFKRAFT [N];VERLÄNGERUNG ΔL [mm]' 'Pruefkraft F [N];Verlaengerung dL [mm]' 'Last [N];Verformung [mm]' 'Standardkraft in N;Wegaufnehmer in mm' 'Kraft [N];Kolbenweg [mm]' 'Kraft [N];Traverse absolut [mm]'; do
            { tr '|' '\n' <<<"$facts"; echo "$names"; body; } >t.csv
            same t.csv
        done
    done
    near "$(value section p.csv)" 2e-5 1e-11
    { echo 'Dehnung ε;Nennspannung R [MPa]'; numbers | tr ,. ';,'; } >t.csv
    same t.csv
    # a round and a flat one at once say nothing
    { printf 'Dicke;2;mm\nBreite;10;mm\nDurchmesser;5;mm\nL0;50;mm\nKraft [N];Weg [mm]\n'; body; } >t.csv
    fails 'does not say the section; give --section' hspost t.csv
}

@test "Greek, the extensometer before the crosshead, names right below a fact" {
    { echo 'ε,σ [MPa]'; numbers; } >t.csv
    same t.csv
    { echo 'Nominal strain,Strain,Standard force (N)'; numbers | awk -F, '{print 1.3 * $1 "," $1 "," 20 * $2}'; } >t.csv
    same t.csv --section '20 mm2'
    { printf 'Querschnitt;20;mm²\nDehnung [%%];Kraft [N]\n'; numbers | awk -F, '{printf "%.6f;%.5f\n", 100 * $1, 20 * $2}'; } >t.csv
    same t.csv
}

@test "facts above: section, gauge length, specimen, in English and German, with their units" {
    for facts in 'S0 [mm²]: 20|L0 [mm]: 50' 'Querschnitt = 0,2 cm²|Anfangsmesslänge = 5 cm' 'Area: 20 mm^2|Gauge length: 0.05 m'; do
        { echo 'Specimen name;Al 1'; echo "${facts%|*}"; echo "${facts#*|}"; echo 'Kraft [N];Weg [mm]'
          numbers | awk -F, '{printf "%.5f;%.7f\n", $2 * 20, $1 * 50}' | tr . ,; } >t.csv
        same t.csv
        grep -q '^# title: Al 1$' curve.csv
    done
}

@test "which column is what, by option" {
    numbers >bare.csv
    same bare.csv --columns-of strain=1,stress=2:MPa
    { echo 'A,B (MPa)'; numbers; } >t.csv
    same t.csv --columns-of strain=A,stress=B
    same t.csv --columns-of 'strain=1,stress=B (MPa)'
    numbers | awk -F, '{print NR / 10, 100 * $1, $2}' >t.txt
    same t.txt --columns-of strain=2:%,stress=3:MPa
    { echo 'true strain,true stress (MPa)'; numbers | awk -F, '{printf "%.9f,%.6f\n", log(1 + $1), $2 * (1 + $1)}'; } >t.csv
    same t.csv
}

# fails PATTERN COMMAND...: exit 2, and the message
fails() {
    local pattern=$1
    shift
    run -2 --separate-stderr "$@" </dev/null
    [[ $stderr == *"$pattern"* ]] || { echo "$stderr"; return 1; }
    [ -z "$output" ]
}

@test "what is wrong is told by line and column" {
    numbers >t.csv
    fails 't.csv:1:1: numbers without a row of column names above them; say which column is what, as in --columns-of' hspost t.csv
    fails "no column 'C', expected a name or a number from 1 to 2" hspost t.csv --columns-of strain=1,stress=C
    fails "'stretch', expected strain=NAME" hspost t.csv --columns-of stretch=1,stress=2
    fails 'has no unit' hspost t.csv --columns-of strain=1,stress=2
    { echo 'Strain,Stress'; numbers; } >t.csv
    fails "t.csv:1: the column 'Stress' (stress) has no unit" hspost t.csv
    { echo 'Temperature,Voltage'; numbers; } >t.csv
    fails "t.csv:1: no columns of strain and stress, or of force and extension, among 'Temperature', 'Voltage'" hspost t.csv
    sed '100s/,/,x/' "$curve" >t.csv
    fails "t.csv:100:12: 'x" hspost t.csv
    sed '100s/,.*//' "$curve" >t.csv
    fails 't.csv:100: 1 fields, expected 2' hspost t.csv
    sed '100s/$/,7/' "$curve" >t.csv
    fails 't.csv:100:22: more fields than the 2 columns' hspost t.csv
    cat "$curve" "$curve" >t.csv
    fails 't.csv:225: a second table of numbers beside that of lines 2 to 223' hspost t.csv
    # not two rows and two hundred of a footer
    { echo '"Load (N)","Extension (mm)"'; numbers | awk -F, 'NR < 4 {print $2 "," $1; next} {printf "\"%s kN\",%s\n", $2, $1}'; } >t.csv
    fails "t.csv:5:1: '11.24819 kN' is not a finite number" hspost t.csv --section '20 mm2' --gauge-length '50 mm'
    sed '100s/.*/NaN,NaN/' "$curve" >t.csv
    fails "t.csv:100:1: 'NaN' is not a finite number" hspost t.csv
    { echo 'Strain,Stress (MPa)'; numbers | sed '99s/,.*/,/'; } >t.csv
    fails "t.csv:100: the stress (column 2 'Stress (MPa)') is blank in this row, expected a number" hspost t.csv
    { echo 'Strain,Stress (MPa),Strain,Stress (MPa)'; numbers | awk -F, '{print $0 "," $0}'; } >t.csv
    fails "t.csv:1: two columns of strain, 1 'Strain' and 3 'Strain'; say which by --columns-of strain=1" hspost t.csv
    { echo 'Strain;Stress (MPa)'; numbers | tr , ';' | awk 'NR > 100 {gsub(/\./, ",")} {print}'; } >t.csv
    fails 'is not a finite number' hspost t.csv
    { echo 'engineering strain (-) engineering stress (MPa)'; numbers | tr , ' '; } >t.csv
    fails '6 words above 2 columns of numbers' hspost t.csv
    same t.csv --columns-of strain=1,stress=2:MPa
}

@test "files of other programs are named" {
    printf 'PK\003\004rest' >a.xlsx
    fails 'a.xlsx is an Excel workbook (xlsx)' hspost a.xlsx
    printf '%%PDF-1.4' >a.pdf
    fails 'a.pdf is a PDF' hspost a.pdf
    printf '*Heading\n*Node\n1, 0., 0., 0.\n2, 1., 0., 0.\n' >a.inp
    fails 'an input of Abaqus' hspost a.inp
    printf '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n' >a.msh
    fails 'a mesh of Gmsh' hspost a.msh
    printf '***tesr\n **format\n   2.1\n' >a.tesr
    fails 'a voxel tessellation of Neper' hspost a.tesr
    printf '\001\000\002\003\000\000\005' >a.bin
    fails 'neither an Exodus history nor a table of text' hspost a.bin
    printf '\x89HDF\r\n\x1a\n' >a.h5
    fails 'a.h5 is an HDF5 file of another program: export its columns as text' hspost a.h5
    printf '\x89HDF\r\n\x1a\n_NCProperties' >a.nc
    fails 'a.nc: cannot read it as Exodus' hspost a.nc
    printf 'II*\0\1' >a.tif
    fails 'a.tif is a picture (TIFF)' hspost a.tif
    printf '<!DOCTYPE html>\n<table>' >a.html
    fails 'a.html is a page of the web' hspost a.html
}
