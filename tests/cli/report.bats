#!/usr/bin/env bats
# hspost --report: a page that stands alone.

bats_require_minimum_version 1.5.0

setup_file() {
    cd "$BATS_FILE_TMPDIR" || return 1
    sed 's/^post:/&\n  question: Is A < B \& "C" > D?/
        s/^solver:/output: {fields: {frames: 4, variables: [displacement, von_mises, equivalent_plastic_strain, damage]}}\n&/' \
        "$BATS_TEST_DIRNAME/../../pipelines/first/study.yaml" >study.yaml
    hsgen -q study.yaml | hssolve -q -o fields.e | tee run.e | hspost -q --report run.html --frames fields.e -p run.csv >curve.csv
}

setup() {
    cd "$BATS_TEST_TMPDIR" || return 1
    records="$BATS_TEST_DIRNAME/../data/records"
    run="$BATS_FILE_TMPDIR/run"
}

# A page: well-formed, nothing from elsewhere, no scripts, ids that are there once, links that lead to one.
whole() {
    if command -v xmlwf >/dev/null; then xmlwf "$1"; fi
    run ! grep -E '<script|<link|<iframe|[^g]src="[^d]|url\(|@import' "$1"
    grep -oE ' id=["'\''][^"'\'']*' "$1" | cut -c6- | sort >ids
    [ -z "$(uniq -d ids)" ] || { uniq -d ids; return 1; }
    grep -oE 'href=["'\'']#[^"'\'']*|url\(#[^)]*|labelledby="[^"]*' "$1" | sed 's/.*["#(]//; s/.*#//' | sort -u >links
    [ -s links ]
    [ -z "$(comm -13 <(sort -u ids) links)" ] || { comm -13 <(sort -u ids) links; return 1; }
}

# has FILE ID...: sections of the page, in this order.
has() {
    local page=$1
    shift
    [ "$(grep -oE '<section id="[a-z]*' "$page" | sed 's/.*"//' | xargs)" = "$*" ]
}

# Numbers of a CSV that stand in none of the page's: columns of its header, by name.
missing() {
    perl - "$@" <<'PERL'
        my ($page, $csv, @names) = @ARGV;
        open my $f, '<', $page or die; my %there;
        while (<$f>) { $there{$1 + 0}++ while /<data value="([^"]*)"/g }
        open $f, '<', $csv or die; my (@header, $count);
        while (<$f>) {
            chomp; my @field;
            push @field, defined $1 ? $1 : $2 while /\G(?:"((?:[^"]|"")*)"|([^,]*))(?:,|$)/g;
            if (!@header) { @header = @field; next }
            my %row; @row{@header} = @field;
            for (@names) { next if $row{$_} eq '' || $row{$_} =~ /inf/; $count++; print "$_ $row{$_}\n" unless $there{$row{$_} + 0} }
        }
        print "no numbers\n" unless $count;
PERL
}

@test "a run at the end of a pipe: the curve goes on, the page has all sections and every number" {
    whole "$run.html"
    has "$run.html" curves properties phases structure fields quality provenance deck cite
    grep -q '^time_s,' "$BATS_FILE_TMPDIR/curve.csv"
    [ -z "$(missing "$run.html" "$run.csv" value uncertainty)" ] || { missing "$run.html" "$run.csv" value uncertainty; return 1; }
    # what the eye sees of strength and slope: four digits, and two of an error between 0.01 and 0.1
    IFS=, read -r _ _ strength _ <<<"$(grep '^tensile_strength,' "$run.csv")"
    IFS=, read -r _ _ slope _ error _ <<<"$(grep '^modulus,' "$run.csv")"
    grep -qF "$(printf '<dt>Rm</dt><dd><data value="%s">%.1f</data> <span class="unit">MPa</span>' "$strength" "$strength")" "$run.html"
    grep -qF "$(printf '">%.3f</data> ± <data value="%s">%.3f</data> <span class="unit">GPa' "$slope" "$error" "$error")" "$run.html"
    grep -q 'hssolve -q' "$run.html"
    grep -q 'core_distance: 0.25 mm' "$run.html"
}

@test "whatever stands in names, question, deck and commands is text" {
    whole "$run.html"
    grep -qF '<p class="question">Is A &lt; B &amp; &quot;C&quot; &gt; D?</p>' "$run.html"
    cp "$records/voce.csv" 'a<b>&"c".csv'
    { printf '# title: \001Stahl \xfcber <5 & "6"\n'; cat "$records/voce.csv"; } >latin.csv
    hspost -q 'a<b>&"c".csv' latin.csv --report page.html
    whole page.html
    grep -qF '<th scope="row">a&lt;b&gt;&amp;&quot;c&quot;</th>' page.html
    grep -q 'Stahl über &lt;5 &amp; &quot;6&quot;' page.html
    hspost -q latin.csv --title $'\xff\xfe <x>' --report page.html >/dev/null
    whole page.html
}

@test "several curves stand side by side, more than eight as means of a title" {
    for k in 1 2 3 4 5 6 7 8 9; do
        awk -F, -v k="$k" '/^e/ {print; next} {print $1 "," $2 * (1 + 0.01 * k)}' "$records/voce.csv" >"s$k.csv"
    done
    hspost -q s[12].csv --report two.html -p two.csv
    whole two.html
    has two.html curves properties quality provenance deck cite
    [ -z "$(missing two.html two.csv value uncertainty)" ]
    hspost -q s?.csv --title Al --report nine.html --statistics nine.csv
    whole nine.html
    grep '^[^,]*,tensile_strength,\|^g' nine.csv >strength.csv
    [ -z "$(missing nine.html strength.csv mean standard_deviation least largest)" ]
    grep -q '9 of 9' nine.html
    grep -q 'within a band of one standard deviation' nine.html
}

@test "films: as many frames as there are, below each other, of what is there and not 0" {
    frames=$(hspost --frames "$BATS_FILE_TMPDIR/fields.e" | grep -c '^[0-9]')
    [ "$(grep -c '<figure class="film"' "$run.html")" -eq 2 ]
    [ "$(grep -c "style=\"--n:$frames;" "$run.html")" -eq 2 ]
    grep -q 'alt="EquivalentPlasticStrain in a layer' "$run.html"
    run ! grep -q 'alt="Damage' "$run.html"
    # width and height of the first film's PNG [bytes 17 to 24], which are those of its frame times their number
    perl -MMIME::Base64 -ne 'next unless m{--n:(\d+);aspect-ratio:([\d.]+)/([\d.]+)"><img src="data:image/png;base64,([^"]*)"};
        my $png = decode_base64($4); my ($w, $h) = unpack "x16NN", $png; $count++;
        die "$w $h" unless substr($png, 1, 3) eq "PNG" && abs($w - 2 * $2) < 1.1 && abs($h - 2 * $3 * $1) < 1.1;
        END { exit !($count == 2) }' "$run.html"
    hspost -q "$run.e" --report one.html --frames "$BATS_FILE_TMPDIR/fields.e" --variables Damage --deformed 5 --slice x >/dev/null
    [ "$(grep -c '<figure class="film"' one.html)" -eq 1 ]
    grep -q 'displacements × 5' one.html
    whole one.html
    hspost -q "$run.e" --report none.html >/dev/null
    has none.html curves properties phases quality provenance deck cite
    run -2 hspost "$run.e" --report r.html --frames "$BATS_FILE_TMPDIR/fields.e" --picture a.png
}

@test "the page is the same however often it is made" {
    hspost -q "$run.e" --report one.html >/dev/null
    cp one.html two.html
    hspost -q "$run.e" --report one.html >/dev/null
    cmp one.html two.html
}

# The crate of a folder, checked: every reference leads to an entity, every file is there, every run has program, input and output.
crate() {
    perl -MJSON::PP -e '
        my $all = decode_json(do { local $/; open my $f, "<", "$ARGV[0]/ro-crate-metadata.json" or die; <$f> });
        my (%there, @ids);
        for (@{$all->{q(@graph)}}) { die "twice: $_->{q(@id)}" if $there{$_->{q(@id)}}; $there{$_->{q(@id)}} = $_ }
        sub collect { my ($v) = @_; ref $v eq "ARRAY" ? map(collect($_), @$v) : ref $v eq "HASH" ? $v->{q(@id)} : () }
        for my $e (values %there) { push @ids, map collect($e->{$_}), grep $_ ne q(@id), keys %$e }
        for (@ids) { die "nothing is $_" unless $there{$_} || $_ eq "https://w3id.org/ro/crate/1.1" }
        my $root = $there{"./"};
        die "root" unless $root->{conformsTo}{q(@id)} eq "https://w3id.org/ro/wfrun/process/0.5" && $root->{license} eq ($ENV{LICENSE} // "Not stated by who made it") && $root->{name};
        for (collect($root->{hasPart})) { die "no file $_" unless -s "$ARGV[0]/$_" && $there{$_}{q(@type)} eq "File" }
        for (collect($root->{mentions})) { my $a = $there{$_}; die "action $_" unless $a->{q(@type)} eq "CreateAction" && $a->{description}
            && @{$a->{object}} && @{$a->{result}} && $there{$a->{instrument}{q(@id)}}{softwareVersion} }
        print scalar(collect($root->{mentions})), " ", $root->{datePublished}, "\n"' "$1"
}

@test "a crate has what was read and made, and says by which programs and commands" {
    # through a pipe, as elsewhere
    SOURCE_DATE_EPOCH=86400 hspost -q --crate pipe --question 'Why "so" <much>?' <"$run.e" >curve.csv
    [ "$(crate pipe)" = "3 1970-01-02T00:00:00+00:00" ]
    cmp pipe/input-0001.e "$run.e"
    cmp pipe/deck-0001.yaml "$BATS_FILE_TMPDIR/study.yaml"
    cmp <(grep -v '^#' pipe/properties.csv) <(grep -v '^#' "$run.csv")
    whole pipe/report.html
    grep -q '"description": "Why \\"so\\" <much>?"' pipe/ro-crate-metadata.json
    grep -q '"description": "hsgen -q study.yaml"' pipe/ro-crate-metadata.json
    # and of measured tables, which nobody's run made
    hspost -q "$records/voce.csv" "$run.e" --crate both --license CC-BY-4.0
    LICENSE=CC-BY-4.0 crate both | grep -q '^3 '
    cmp both/input-0001.txt "$records/voce.csv"
    # into a folder that is there; not into a file
    hspost -q "$records/voce.csv" --crate both >curve.csv
    crate both | grep -q '^1 '
    run -2 hspost -q "$records/voce.csv" --crate curve.csv
    # nor among the files of somebody else, whoever else's crate they are
    mkdir foreign
    echo mine >foreign/report.html
    echo '{"@graph": [{"@id": "#other-run"}]}' >foreign/ro-crate-metadata.json
    run -2 hspost -q "$records/voce.csv" --crate foreign
    [[ $output == *"no crate of hspost's"* ]]
    [ "$(cat foreign/report.html)" = mine ]
}

@test "the script for ParaView names variables that hssolve writes" {
    script="$BATS_TEST_DIRNAME/../../docs/open_fields.py"
    sed 's/^output:.*/output: {fields: {frames: 1, variables: [displacement, stress, von_mises, equivalent_plastic_strain, damage, phase]}}/
        s/end_strain: 0.04/end_strain: 0.0005/' "$BATS_FILE_TMPDIR/study.yaml" >study.yaml
    hsgen -q study.yaml | hssolve -q -o fields.e >history.e
    hspost --frames fields.e | sed -n 's/^# variables: //p' | tr ' ' '\n' >there
    grep -oE '"(EquivalentPlasticStrain|Damage|VonMises|Phase|Displacement|Stress[XYZ]{2})"' "$script" | tr -d '"' | sort -u >named
    [ "$(wc -l <named)" -eq 11 ]
    while read -r name; do grep -q "^$name" there || { echo "no $name"; return 1; }; done <named
}

@test "a report cannot be made without gnuplot, of fields alone, or where it cannot be written" {
    program=$(command -v hspost)
    PATH=$PWD run -1 "$program" "$run.e" --report r.html
    [[ $output == *gnuplot* ]]
    run -2 hspost "$run.e" --report nowhere/r.html
    [ ! -e r.html ]
}
