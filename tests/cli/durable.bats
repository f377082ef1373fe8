# What is left of a run that did not come to its end: ended in order by a signal or a time limit, or killed.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
load ../ranks
setup_file() {
    cd "$BATS_FILE_TMPDIR"
    # Hours at a speed that strains little, with a record at almost every step.
    cat >study.yaml <<DECK
title: Long test of a small plate
$(even 16 6 4 3 8)
materials:
  M: {model: correspondence, density: 8900 kg/m3, $elastic, $soft}
$(pulled '1 mm/s')
solver:
  type: explicit
  end_time: 1 ms
output:
  history: 100000
  fields: {every: 200 steps, variables: [displacement, stress]}
DECK
    hsgen -q study.yaml -o domain.g
}

setup() {
    cd "$BATS_TEST_TMPDIR"
    ln -s "$BATS_FILE_TMPDIR/domain.g" .
}

# until_there PATTERN SIZE PID: waits for a file that has grown beyond the size while the process lives.
until_there() {
    until [ -n "$(find . -name "$1" -size "+$2")" ]; do
        kill -0 "$3"
        sleep 0.1
    done
}

# rows FILE: the numbers of a history, a line a record.
rows() { hspost -q --columns "$1" | grep -v '^#'; }

# same_start A B: one history is the beginning of the other, and both have more than a few records.
same_start() {
    local least
    least=$(for file in "$1" "$2"; do rows "$file" | wc -l; done | sort -n | head -n 1)
    [ "$least" -gt 20 ]
    cmp <(rows "$1" | head -n "$least") <(rows "$2" | head -n "$least")
}

# ended PID: fills status (run would not see the child).
ended() {
    status=0
    wait "$1" || status=$?
}

no_rank_left() { none_left 'domain.g .*-H out.e|domain.g .*history out.e'; }

@test "signals end a run in order: 143, one line, the history and the last frame" {
    for ranks in 1 2; do
        for signal in TERM HUP USR1 XCPU; do
            rm -f ./*.failed ./*.checkpoint
            hssolve -q -j "$ranks" -i domain.g -H out.e -o fields.e 2>said &
            solver=$!
            until_there 'out.e.partial-*' 40k "$solver"
            kill -"$signal" "$solver"
            ended "$solver"
            [ "$status" -eq 143 ]
            [ "$(grep -c 'stopped at step' said)" -eq 1 ]
            # what reaches the ranks of a launcher is not the signal that it was sent
            [ "$ranks" = 1 ] || grep -q 'stopped at step.*(a signal)' said
            no_rank_left
            [ "$(ls)" = "domain.g
fields.e.failed
out.e.checkpoint
out.e.failed
said" ]
            same_start out.e.failed out.e.failed
            # The last frame is of the last step, as the last record is of one near it.
            hspost -q --frames fields.e.failed --csv -o last.csv
            step=$(sed -n 's/.*stopped at step [0-9]*, t = \([0-9.e+-]*\) s.*/\1/p' said)
            awk -F': ' -v stop="$step" '/^# time_s/ { t = $2 } END { print t, stop; exit !(t > 0 && t / stop - 1 < 1e-3 && t / stop - 1 > -1e-3) }' last.csv
            rm last.csv
        done
    done
}

@test "a time limit, and the end of a batch job, are obeyed as a signal is" {
    for ranks in 1 2; do
        rm -f ./*.failed
        run hssolve -q -j "$ranks" -i domain.g -H out.e --time-limit '3 s'
        [ "$status" -eq 143 ]
        [[ "$output" == *"(the time limit)"* ]]
        [ -s out.e.failed ]
    done
    SLURM_JOB_END_TIME=$(($(date +%s) + 63)) run hssolve -q -i domain.g -H out.e
    [ "$status" -eq 143 ]
    run hssolve -q -i domain.g -H out.e --time-limit 5m
    [ "$status" -eq 2 ]
    run hssolve -q -i domain.g -H out.e --time-limit '-5 s'
    [ "$status" -eq 2 ]
}

@test "the history of a pipe that is stopped is kept in the working directory, and the reader is told nothing" {
    hssolve -q -i domain.g -o fields.e >pipe 2>said &
    solver=$!
    until_there 'fields.e.partial-*' 100k "$solver"
    kill -TERM "$solver"
    ended "$solver"
    [ "$status" -eq 143 ]
    [ ! -s pipe ]
    grep -q 'kept in hssolve-history.failed' said
    rows hssolve-history.failed >/dev/null
}

@test "records are on disk as they are made: after kill -9 a repair gives them back, the same to the last bit" {
    hssolve -q -i domain.g -H out.e --time-limit '4 s' || true
    mv out.e.failed stopped.e
    mkdir scratch
    export TMPDIR=$PWD/scratch
    for ranks in 1 2; do
        rm -f ./*.failed
        hssolve -q -j "$ranks" -i domain.g -H out.e -o fields.e 2>said &
        solver=$!
        until_there 'out.e.partial-*' 100k "$solver"
        until_there 'fields.e.partial-*' 100k "$solver"
        if [ "$ranks" -eq 1 ]; then
            kill -KILL "$solver"
            ended "$solver"
            mv out.e.partial-* left.e
            run hspost -q left.e
            [ "$status" -eq 2 ]
            [[ "$output" == *"was never finished"*"hssolve --repair"* ]]
            run hssolve --repair left.e
            [ "$status" -eq 0 ]
            [[ "$output" =~ "left.e is whole up to record "[1-9][0-9]+", t = " ]]
            same_start left.e stopped.e
            run hssolve --repair left.e
            [ "$status" -eq 2 ]
            [[ "$output" == *"nothing to repair"* ]]
        else
            # A rank is killed, as where memory runs out: that is told, the history kept, and no folder of mpirun left.
            [ -n "$(find scratch -name 'hstools-*')" ]
            pkill -KILL -n -P "$(pgrep -P "$solver")"
            ended "$solver"
            [ "$status" -eq 1 ]
            grep -q 'ended by signal 9 (Killed' said
            same_start out.e.failed stopped.e
            [ -z "$(find scratch -name 'hstools-*')" ]
        fi
        no_rank_left
        mv fields.e.partial-* left.f
        hssolve -q --repair left.f
        [ "$(hspost -q --frames left.f | wc -l)" -gt 0 ]
        hspost -q --frames left.f --csv >/dev/null
    done
}

@test "what reached the disk in part is left out by a repair" {
    hssolve -q -i domain.g -H out.e --time-limit '3 s' || true
    records=$(ncdump -h out.e.failed | sed -n 's/.*time_step = UNLIMITED.*(\([0-9]*\) currently).*/\1/p')
    cp out.e.failed cut.e
    # As of a file that was never finished, whose last time is that of nothing.
    at=$(grep -abo 'hs_file_bytes' cut.e | head -n 1 | cut -d: -f1)
    printf '\0\0\0\0\0\0\0\0' | dd of=cut.e bs=1 seek=$((at + 24)) conv=notrunc status=none
    run hspost -q cut.e
    [[ "$output" == *"was never finished"* ]]
    size=$(stat -c %s cut.e)
    columns=$(ncdump -h cut.e | sed -n 's/.*num_glo_var = \([0-9]*\) .*/\1/p')
    printf '\0\0\0\0\0\0\0\0' | dd of=cut.e bs=1 seek=$((size - 8 * (columns + 1))) conv=notrunc status=none
    hssolve -q --repair cut.e
    rows cut.e >cut.csv
    rows out.e.failed | head -n "$records" | cmp - cut.csv
    # As of a copy that stopped within the last record.
    head -c -12 out.e.failed >cut.e
    run hspost -q cut.e
    [[ "$output" == *"it has $((size - 12)) bytes, and had $size when it was finished; hssolve --repair"* ]]
    hssolve -q --repair cut.e
    rows cut.e | cmp - cut.csv
}

# A short run with checkpoints, kept as whole.e and whole.e.checkpoint, .checkpoint.1 ...; its deck: short.yaml
short_run() {
    sed -e 's/end_time: 1 ms/end_time: 0.3 us/; s/history: .*/history: 30/; s,1 mm/s,20 m/s,; s/every: 200/every: 30/' \
        -e '$a\  checkpoint: {every: 20 steps, keep: 3}' "$BATS_FILE_TMPDIR/study.yaml" >short.yaml
    hsgen -q short.yaml -o short.g
    hssolve -q -i short.g -H whole.e
}

@test "checkpoints change no number of a run, the oldest go, and the names say which is which" {
    short_run
    [ "$(ls whole.e.checkpoint*)" = "whole.e.checkpoint
whole.e.checkpoint.1
whole.e.checkpoint.2" ]
    sed 's/checkpoint: .*/checkpoint: {every: 1 h}/' short.yaml >other.yaml
    hssolve -q -i short.g -d other.yaml -H other.e
    cmp <(rows whole.e) <(rows other.e)
    [ ! -e other.e.checkpoint ]
    # Without a word of the deck: by the option, and by time.
    sed '/checkpoint:/d' short.yaml >other.yaml
    hssolve -q -i short.g -d other.yaml -H other.e --checkpoint here.checkpoint
    [ ! -e here.checkpoint ]
    sed 's/every: 20 steps/every: 1 ms/' short.yaml >other.yaml
    hssolve -q -i short.g -d other.yaml -H other.e --checkpoint here.checkpoint
    [ -s here.checkpoint.2 ]
}

@test "a run that was stopped by a signal goes on from its checkpoint as if it had not, in a pipe, too" {
    sed 's/end_time: 1 ms/end_steps: 12000/; s/history: .*/history: 300/; s/every: 200/every: 500/' "$BATS_FILE_TMPDIR/study.yaml" >steps.yaml
    hsgen -q steps.yaml >steps.g
    hssolve -q -i steps.g -H whole.e -o whole.f
    for ranks in 1 2; do
        hsgen -q steps.yaml | hssolve -q -j "$ranks" --checkpoint run.checkpoint --time-limit '1.5 s' -o run.f >run.e || status=$?
        # Where the machine is quick the run is over by then.
        if [ "${status:-0}" -ne 0 ]; then
            [ "$status" -eq 143 ]
            [ ! -s run.e ]
            hssolve -q --restart run.checkpoint -j $((3 - ranks)) -o run.f >run.e
        fi
        cmp <(numbers whole.e) <(numbers run.e)
        cmp <(numbers whole.f) <(numbers run.f)
    done
    # its own checkpoint, which nobody asked for, and what was kept of it go when it is whole
    for ranks in 1 2; do
        run -143 hssolve -q -i steps.g -H own.e -o own.f --time-limit '1 ms'
        [ -s own.e.failed ]
        [ -s own.f.failed ]
        hssolve -q --restart own.e.checkpoint -j "$ranks" -H own.e -o own.f
        cmp <(numbers whole.e) <(numbers own.e)
        cmp <(numbers whole.f) <(numbers own.f)
        [ -z "$(ls own.e.* own.f.* 2>/dev/null)" ]
    done
    # frames that went nowhere else stay
    run -143 hssolve -q -i steps.g -H own.e -o own.f --time-limit '1 ms'
    hssolve -q --restart own.e.checkpoint -H own.e
    [ "$(ls own.e.* own.f.* 2>/dev/null)" = own.f.failed ]
}

# bad TEXT OPTION...: refused with exit 2 and the text, and nothing is left
bad() {
    local text=$1
    shift
    run hssolve -q -H out.e "$@"
    echo "$output"
    [ "$status" -eq 2 ]
    [[ "$output" == *"$text"* ]]
    [ ! -e out.e ]
    [ -z "$(find . -name 'out.e*')" ]
}

@test "a checkpoint that is damaged, cut, foreign, of another version or another deck is refused with the reason" {
    short_run
    local of=whole.e.checkpoint size at
    size=$(stat -c %s "$of")
    cp "$of" good
    bad 'no checkpoint of hssolve' --restart short.g
    bad 'too short' --restart /dev/null || bad 'is no file' --restart /dev/null
    bad 'nowhere: cannot be opened: No such file' --restart nowhere
    bad 'a checkpoint has its domain inside' --restart "$of" -i short.g
    sed 's/density: 8900/density: 8800/' short.yaml >other.yaml
    bad 'of another deck than other.yaml' --restart "$of" -d other.yaml
    # Any byte of it: in the domain, the states, the heads of tables.
    for at in 100 3000 $((size / 3)) $((size / 2)) $((size - 9000)) $((size - 2)); do
        cp good "$of"
        printf '\125' | dd of="$of" bs=1 seek="$at" conv=notrunc status=none
        if cmp -s good "$of"; then printf '\252' | dd of="$of" bs=1 seek="$at" conv=notrunc status=none; fi
        bad "; an older one is $of.1" --restart "$of"
        bad 'damaged' --restart "$of" -j 2
    done
    head -c $((size - 8)) good >"$of"
    bad 'truncated' --restart "$of"
    cp good "$of"
    printf '\0\0\0\0\0\0\0\0' | dd of="$of" bs=1 seek=32 conv=notrunc status=none
    bad 'was never finished' --restart "$of"
    cp good "$of"
    printf '9' | dd of="$of" bs=1 seek=19 conv=notrunc status=none
    bad 'of another version' --restart "$of"
    rm "$of"
    bad "cannot be opened: No such file or directory; an older one is $of.1" --restart "$of"
    # The older one that was named goes on.
    hssolve -q --restart "$of.1" -H again.e
    cmp <(numbers whole.e) <(numbers again.e)
}

@test "a checkpoint for which there is no room is left out with a warning, and the run goes on" {
    short_run
    # Files of at most 60 kB: history and partial checkpoint have to do with that.
    run bash -c 'ulimit -f 60; exec hssolve -q -i short.g -H out.e --checkpoint small'
    [ "$status" -eq 0 ]
    [[ "$output" == *"no checkpoint in small: File too large"* ]]
    [ -z "$(find . -name 'small*')" ]
    cmp <(numbers whole.e) <(numbers out.e)
    run hssolve -q -i short.g -H out.e --checkpoint nowhere/small
    [ "$status" -eq 0 ]
    [[ "$output" == *"no checkpoint in nowhere/small: No such file"* ]]
}
