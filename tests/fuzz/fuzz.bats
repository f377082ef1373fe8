# Files that were changed at random: an answer, or an error with its place, never a crash.  make fuzz is guided by coverage,
# make fuzz-runs takes whole runs.

bats_require_minimum_version 1.5.0
load corpus

setup_file() { make_corpus "$BATS_FILE_TMPDIR"; }

@test "readers of files of users end in order, whatever is in them" {
    for target in "${targets[@]}"; do
        run -0 env HS_FUZZ="$target" ASAN_OPTIONS=detect_leaks=0 "$HS_BUILD/tests/fuzz/fuzz" "${COUNT:-400}" "$BATS_FILE_TMPDIR/$target"/*
        echo "# $target: $output" >&3
    done
}

@test "whole runs of decks that were changed end with an answer, an error with its place, or a stop with its reason" {
    "$BATS_TEST_DIRNAME/runs" "${RUNS:-40}" "$BATS_TEST_TMPDIR" >&3
}
