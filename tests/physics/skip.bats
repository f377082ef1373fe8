# What a scene does not ask for is left out: that changes no bit, and --profile says how much it was.

load ../bodies
setup() { cd "$BATS_TEST_TMPDIR"; }

# study MODEL SOLVER [REST]: a torn bar of 160 nodes, study.g
study() {
    cat >study.yaml <<END
title: Skip
$(even 12 4 4 3 "${GAUGE-4}")
materials:
  M: {density: 8900 kg/m3, $1}
$(pulled "20 m/s")
solver: {${TYPE:-type: explicit, end_steps: 200, energy_tolerance: 0.1}, $2}
${3:-}
END
    hsgen -q study.yaml -o study.g
}

models=("model: bond_based, youngs_modulus: 210 GPa|horizon: 3.015|{pair: [M, M], law: critical_stretch, value: 0.5}"
    "model: ordinary, $elastic|horizon: 2.015|{pair: [M, M], law: critical_stretch, value: 0.5}"
    "model: ordinary_plastic, $elastic, $soft|horizon: 2.015|{phase: M, law: plastic_strain, value: 0.9}"
    "model: correspondence, $elastic, $soft|horizon: 1, stabilisation: {law: mix}|{phase: M, law: plastic_strain, value: 0.9}"
    "model: correspondence, $elastic, $soft|horizon: 2, stabilisation: {law: capped}|{phase: M, law: ductile, onset: 0.8, full: 0.9}")

# The last values of a file's columns.
last() { hspost -q --columns "$1" | awk -F, '/^#/ { next } !n { n = NF; for (i = 1; i <= n; i++) name[i] = $i; next } { line = $0 }
    END { split(line, v, ","); for (i = 1; i <= n; i++) if (name[i] !~ /^all_/) print name[i], v[i] }'; }

# leaves_out MODEL: asked for everything in each step it ends with the bits of a run that is asked for the end alone.
leaves_out() {
    IFS='|' read -r material solver damage <<<"$1"
    study "$material" "$solver" 'output: {history: 1, fields: {frames: 1, variables: [displacement, velocity, force]}}'
    hssolve -q -i study.g -H little.e -o little-fields.e
    study "$material" "$solver" "damage:
  - $damage
output:
  history: 40000
  fields: {${EVERY:-every: 1 steps}, variables: [displacement, velocity, force, stress]}
  quantities:
    - {name: all_stress, quantity: von_mises, reduce: max, where: \"1\"}"
    hssolve -q -i study.g -H much.e -o much-fields.e
    cmp <(last little.e) <(last much.e)
    for name in DisplacementX VelocityY ForceZ; do
        for file in little much; do
            number=$(ncdump -v name_nod_var $file-fields.e | sed -n '/^ name_nod_var =/,$p' | grep '"' | grep -n "\"$name\"" | cut -d: -f1)
            ncdump -p 9,17 -v "vals_nod_var$number" $file-fields.e | sed -n "/^ vals_nod_var$number =/,/;/p" | tr -d ' \n;' | tr ',' '\n' | tail -n 100 >$file.values
        done
        [ "$name" = VelocityY ] || [ "$(sort -u little.values | wc -l)" -gt 20 ]
        cmp little.values much.values
    done
}

@test "records, frames, energies, quantities and laws of damage that never act change no bit" {
    for model in "${models[@]}"; do
        leaves_out "$model"
        # Some 200 records against two.
        [ "$(hspost -q --columns much.e | grep -cv '^#')" -gt 190 ]
    done
    for model in "${models[@]:0:4}"; do GAUGE='' leaves_out "$model"; done
}

@test "nor do they in load steps" {
    for model in "${models[@]:1:3}"; do
        TYPE='type: quasi_static, step: 0.001, end_strain: 0.006' EVERY='frames: 1' leaves_out "$model"
    done
}

@test "--profile changes no bit, and its sums are right" {
    for model in "${models[@]:2:2}"; do
        IFS='|' read -r material solver damage <<<"$model"
        study "$material" "$solver" "damage:
  - $damage
output: {history: 20}"
        hssolve -q -i study.g -H plain.e
        for ranks in 1 2; do
            hssolve -q -j $ranks --profile -i study.g -H profiled.e 2>report
            cat report
            cmp <(last plain.e) <(last profiled.e)
            cmp <(hspost -q --columns plain.e | grep -v "^#") <(hspost -q --columns profiled.e | grep -v "^#")
            records=$(hspost -q --columns plain.e | grep -v '^#' | sed 1d | wc -l)
            # Energies are looked at with each record, and each 16th step.
            awk -v records="$records" -v ranks=$ranks '
                /evaluations of the force/ { nodes = $1; of = $5; ok += $3 == ranks }
                / [0-9.]+% +[0-9.]+$/ { share += $(NF - 1) + 0; seconds += $(NF - 4); processor += $(NF - 2) }
                /^all / { total = $2; computed = $3 }
                /^energies/ { ok += $7 >= ranks * 12 && $7 <= ranks * (12 + records + 1) && $9 == ranks * 201 "," }
                /^record of a step/ { ok += $6 == ranks * records && $8 == ranks * 201 "," }
                /^frame of a step/ { ok += $6 == 0 }
                /^damage test/ { ok += $0 ~ /done 0 of/ }
                /^plastic flow/ { ok += $7 > 0 && $7 < $9 + 0 }
                END { print ok, share, seconds, total; exit !(ok == 6 && nodes == 192 && of == 201 && (share - 100) ^ 2 < 1 && (seconds - total) ^ 2 < 1e-4 && computed > 0 && (processor - computed) ^ 2 < 1e-4) }' report
        done
    done
}
