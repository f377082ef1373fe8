# Studies as job arrays, on a real Slurm of one node that this test starts and stops (make check-slurm).

bats_require_minimum_version 1.5.0
load node
load ../columns
load ../bodies

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    start_node "$BATS_FILE_TMPDIR"
    {
        echo 'title: Queued'
        even 16 4 4 2 8
        echo "materials: {M: {model: corner, density: 8900 kg/m3, $elastic, $soft}}"
        pulled '50 mm/s'
        echo 'solver: {type: explicit, safety: 0.8, end_steps: STEPS}'
        echo 'output: {history: 40, checkpoint: {every: 10 min}}'
    } >deck.yaml
}

teardown_file() { stop_node "$BATS_FILE_TMPDIR"; }

setup() {
    cd "$BATS_TEST_TMPDIR"
    unset MAKEFLAGS MFLAGS MAKELEVEL
    export SLURM_CONF=$BATS_FILE_TMPDIR/slurm.conf
}

# study STEPS: queued, a study of two runs, and what it makes without Slurm, whole
study() {
    sed "s/STEPS/$1/" "$BATS_FILE_TMPDIR/deck.yaml" >study.yaml
    echo 'vary: {safety: [0.8, 0.7], scatter: safety}' >>study.yaml
    hsgen -q --study study.yaml -o whole
    make -s -C whole -j2 >/dev/null
    hsgen -q --study study.yaml --slurm -o queued
}

same() {
    cat queued/slurm-*.out
    for run in 0001 0002; do cmp <(numbers "whole/$run/history.e") <(numbers "queued/$run/history.e"); done
}

# Until nothing is queued any more.
emptied() { while [ -n "$(squeue -h)" ]; do sleep 1; done; }

@test "a time limit cuts the runs off; queued again they go on to the same bits, and then are gathered" {
    # Some forty seconds at the speed of now; Slurm looks at times twice a minute: the signal comes within thirty.
    sed 's/STEPS/1000000000/' "$BATS_FILE_TMPDIR/deck.yaml" | hsgen -q | hssolve -q -H speed.e --time-limit '4 s' 2>speed || true
    study $((12 * $(sed -n 's/.*stopped at step \([0-9]*\),.*/\1/p' speed)))
    bash queued/slurm.sh --time=1 --signal=USR1@45
    emptied
    same
    grep -q 'goes on from its checkpoint' queued/slurm-*.out
    grep -q '2 runs done, 0 not run, 0 stopped, 0 failed' queued/slurm-*.out
    [ -s queued/gathered/tidy.csv ]
    # What is done stays.
    stat -c '%n %y' queued/*/history.e >before
    (cd queued && sbatch slurm.sh)
    emptied
    diff before <(stat -c '%n %y' queued/*/history.e)
}

@test "two ranks that srun starts give the same bits, and so does -j within a job" {
    study 1000
    (cd queued && sbatch --ntasks=2 --array=0 slurm.sh)
    emptied
    (cd queued && sbatch --ntasks=2 --output=slurm-%j.out --wrap 'make -s RANKS=2 0002/curve.csv')
    emptied
    same
    run ! grep -L 'solver_ranks = 2' <(ncdump -h queued/0001/history.e)
}

@test "a run that fails is told, and the others are gathered" {
    study 10
    rm queued/0002/deck.yaml
    sed 's/safety: 0.7/safety: 70/' whole/0002/deck.yaml >queued/0002/deck.yaml
    bash queued/slurm.sh
    emptied
    cat queued/slurm-*.out
    [ -s queued/0001/curve.csv ]
    [ -s queued/0002/failed ]
    grep -q '1 runs done, 0 not run, 0 stopped, 1 failed' queued/slurm-*.out
}
