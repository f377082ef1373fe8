# The disk fails at each call that a small run of each tool makes, and runs are killed there: what appears under a final name
# is whole, what went wrong is told, and a restart leads to the same numbers.  ALL=1 (make faults): each call, else a few.

bats_require_minimum_version 1.5.0

load ../columns
load ../bodies
setup_file() {
    cd "$BATS_FILE_TMPDIR"
    read -ra compiler <<<"${CC:-cc}"
    "${compiler[@]}" -D_GNU_SOURCE -shared -fPIC -O1 -o faults.so "$BATS_TEST_DIRNAME/faults.c" -ldl
    cat >s.yaml <<END
title: Faults
$(even 10 4 2 2 4)
materials:
  M: {density: 8900 kg/m3, model: correspondence_elastic, $elastic}
$(pulled '1 m/s')
solver: {type: explicit, horizon: 1, stabilisation: {law: mix}, end_steps: 40}
output: {history: 40, fields: {frames: 4, variables: [displacement]}, checkpoint: {every: 4 steps, keep: 2}}
END
    hsgen -q "$BATS_FILE_TMPDIR/s.yaml" -o s.g
    hssolve -q -i s.g -H s.e -o f.e --checkpoint s.checkpoint
    hspost -q s.e -o c.csv -p p.csv -j p.json
    for name in s.g s.e f.e; do numbers $name >$name.numbers; done
    for name in c.csv p.csv; do grep -v '^#' $name >$name.numbers; done
}

setup() { cd "$BATS_TEST_TMPDIR"; }

# count TOOL COMMAND...: lines "CALL NUMBER" of the calls that it makes
count() {
    local tool=$1
    shift
    rm -f count
    HS_FAULT_COUNT=$PWD/count LD_PRELOAD=$BATS_FILE_TMPDIR/faults.so ASAN_OPTIONS=verify_asan_link_order=0 "$@" >/dev/null 2>&1
    awk -v tool="$tool" '$1 == tool { n[$2] += $3 } END { for (call in n) if (n[call]) print call, n[call] }' count | sort
    rm -f count
}

# With the fault of that name: HS_FAULT
faulty() { HS_FAULT=$1 LD_PRELOAD=$BATS_FILE_TMPDIR/faults.so ASAN_OPTIONS=verify_asan_link_order=0 "${@:2}"; }

# whole NAME: it is not there, or has the numbers that it should
whole() {
    [ -e "$1" ] || return 0
    case $1 in
    *.csv) grep -v '^#' "$1" ;;
    *) numbers "$1" ;;
    esac | cmp - "$BATS_FILE_TMPDIR/$1.numbers"
}

# which NUMBER MOST: all numbers up to it, or as many as MOST of them, the last ones too
which() {
    if [ -n "${ALL:-}" ]; then seq 1 "$1"; else
        awk -v n="$1" -v most="$2" 'BEGIN { for (k = 0; k < most; k++) { i = 1 + int(k * (n - 1) / (most > 1 ? most - 1 : 1) + 0.5); if (i != last) print i; last = i } }'
    fi
}

# breaks MOST OUTPUTS TOOL COMMAND...: each call of it fails in turn, by a full disk or a broken one
breaks() {
    local most=$1 outputs=$2 tool=$3 call number n code name faults=0
    shift 3
    while read -r call number; do
        [ "$call" != any ] || continue
        for n in $(which "$number" "$most"); do
            for error in 28 5; do
                rm -rf ./*
                code=0
                timeout 60 bash -c "\"\$@\"" x env HS_FAULT="$call $n $error" LD_PRELOAD="$BATS_FILE_TMPDIR/faults.so" ASAN_OPTIONS=verify_asan_link_order=0 "$@" >/dev/null 2>said || code=$?
                faults=$((faults + 1))
                for name in $outputs; do
                    whole "$name" || { echo "$tool: $call $n $error: $name is not whole"; return 1; }
                    # Success is success of all.
                    [ "$code" -ne 0 ] || [ -e "$name" ] || { echo "$tool: $call $n $error: 0 without $name"; return 1; }
                done
                # Told, not died of: by an error, or by the harmless ones (a checkpoint, room kept) a warning or nothing.
                [ "$code" -le 2 ] || { echo "$tool: $call $n $error: $code"; cat said; return 1; }
                [ "$code" -eq 0 ] || grep -q "^$tool: " said || { echo "$tool: $call $n $error: no word"; return 1; }
            done
        done
    done < <(count "$tool" "$@")
    echo "# $tool: $faults faults" >&3
    [ "$faults" -gt 3 ]
}

@test "hsgen: no call that fails leaves half a domain, or success" {
    breaks 2 s.g hsgen hsgen -q "$BATS_FILE_TMPDIR/s.yaml" -o s.g
}

@test "hssolve: no call that fails leaves half a history, or half fields" {
    breaks 3 's.e f.e' hssolve hssolve -q -i "$BATS_FILE_TMPDIR/s.g" -H s.e -o f.e --checkpoint s.checkpoint
}

@test "hspost: no call that fails leaves half a curve" {
    breaks 2 'c.csv p.csv' hspost hspost -q "$BATS_FILE_TMPDIR/s.e" -o c.csv -p p.csv -j p.json
}

# after NAME: of a run that was killed, the same numbers, from its checkpoint or from the start
after() {
    local from=(-i "$BATS_FILE_TMPDIR/s.g")
    [ ! -e s.checkpoint ] || from=(--restart s.checkpoint)
    hssolve -q "${from[@]}" -j "$1" -H s.e -o f.e --checkpoint s.checkpoint 2>said
    numbers s.e | cmp - "$BATS_FILE_TMPDIR/s.e.numbers"
}

@test "killed at any call, and asked to stop there, a run goes on to the same numbers" {
    local n what code kills=0 restarts=0 total
    total=$(count hssolve hssolve -q -i "$BATS_FILE_TMPDIR/s.g" -H s.e -o f.e --checkpoint s.checkpoint | awk '$1 == "any" { print $2 }')
    for n in $(which "$total" 6); do
        for what in kill term; do
            rm -rf ./*
            code=0
            faulty "any $n $what" hssolve -q -i "$BATS_FILE_TMPDIR/s.g" -H s.e -o f.e --checkpoint s.checkpoint >/dev/null 2>said || code=$?
            whole s.e
            whole f.e
            # A request that comes behind the last step, or before the first, finds nothing to stop in order.
            [ "$code" -eq 137 ] || [ "$code" -eq 143 ] || [ "$code" -eq 0 ] || { echo "$n $what $code"; cat said; return 1; }
            [ "$code" -eq 0 ] || kills=$((kills + 1))
            [ ! -e s.checkpoint ] || restarts=$((restarts + 1))
            after 1 || { echo "$n $what"; cat said; return 1; }
        done
    done
    echo "# $kills kills, $restarts restarts" >&3
    [ "$kills" -gt 4 ]
    [ "$restarts" -gt 2 ]
}

@test "a run that is killed at a name of its checkpoint has one under it" {
    local n code
    for n in $(which 8 4); do
        rm -rf ./*
        code=0
        faulty "rename $n kill" hssolve -q -i "$BATS_FILE_TMPDIR/s.g" -H s.e --checkpoint s.checkpoint >/dev/null 2>said || code=$?
        [ "$code" -eq 137 ]
        [ ! -e s.checkpoint.1 ] || [ -e s.checkpoint ]
    done
}

@test "a rank that is killed ends all, is told, and the run goes on from its checkpoint" {
    local rank n code kills=0 total
    total=$(count hssolve hssolve -q -i "$BATS_FILE_TMPDIR/s.g" -H s.e -o f.e --checkpoint s.checkpoint | awk '$1 == "any" { print $2 }')
    for n in $(which "$((total / 2))" 2); do
        for rank in 0 1; do
            rm -rf ./*
            # The rank kills itself; the one that started it all, and mpirun, are no ranks.
            printf '#!/bin/sh\n[ "${OMPI_COMM_WORLD_RANK:-}" = %s ] && export LD_PRELOAD=%s HS_FAULT="any %s kill"\nexec %s "$@"\n' \
                "$rank" "$BATS_FILE_TMPDIR/faults.so" "$n" "$(command -v hssolve)" >ranked
            chmod +x ranked
            code=0
            mpirun --allow-run-as-root --oversubscribe --bind-to none -np 2 ./ranked -q -i "$BATS_FILE_TMPDIR/s.g" -H s.e -o f.e --checkpoint s.checkpoint >/dev/null 2>&1 || code=$?
            whole s.e
            [ "$code" -ne 0 ] || [ -e s.e ]
            kills=$((kills + (code != 0)))
            after 2
        done
    done
    [ "$kills" -gt 1 ]
}
