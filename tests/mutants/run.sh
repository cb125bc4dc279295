#!/usr/bin/env bash
# Would the tests notice? A seeded sample of small changes to the solvers of kin-runtime and the algebra of kin-gen, each
# tested on a copy of the sources.
#
#     tests/mutants/run.sh [COUNT [SEED [FOLDER]]]      320 changes, seed 1, target/mutants
#
# Needs cargo-mutants (`cargo install cargo-mutants --version 27.1.0`). Each change is first given to the tests of its own
# crate; what these let through, to the tests of the `tests` member that the changed part can reach. Prints how many were
# caught of those that compile, and those that were not; survivors.md says why of each.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

count=${1:-320} seed=${2:-1} out=${3:-target/mutants}
scope=(-f 'kin-runtime/src/ik/**' -f 'kin-runtime/src/geometry.rs' -f 'kin-runtime/src/track/**'
    -f 'kin-runtime/src/choice.rs' -f 'kin-gen/src/algebra/**')
integration=(--test ik --test bases --test families --test track --test choice --test reliability --test seeds
    --test bits --test proof --test cost --test fk --test jacobian)

command -v cargo-mutants > /dev/null || { echo "MUTANTS STOPPED: cargo-mutants is not installed" >&2; exit 2; }
mkdir -p "$out"

# Names as a pattern that matches them and nothing else.
pattern() {
    sed 's/[][\.*^$()+?{}|/]/\\&/g' "$1" | paste -sd '|' | sed 's/.*/^(&)$/'
}

# Some of the lines of a file, the same for the same seed: in the order of what the generator of Park and Miller gives them.
sample() {
    awk -v seed="$seed" '{ seed = seed * 16807 % 2147483647; printf "%d\t%s\n", seed, $0 }' "$1" \
        | sort -n | awk -v count="$count" 'NR <= count' | cut -f 2-
}

# One round: a folder, the file of names, what to test with.
round() {
    local folder=$1 names=$2
    shift 2
    [ -s "$names" ] || return 0
    cargo mutants "${scope[@]}" --re "$(pattern "$names")" --output "$out/$folder" --timeout 120 --baseline skip \
        --no-times --colors never "$@" || [ $? -le 3 ]
}

cargo mutants --list "${scope[@]}" > "$out/all.txt"
sample "$out/all.txt" > "$out/sample.txt"
grep '^kin-gen/' "$out/sample.txt" > "$out/kin-gen.txt" || true
grep '^kin-runtime/' "$out/sample.txt" > "$out/kin-runtime.txt" || true
round kin-gen "$out/kin-gen.txt" -- --lib --test algebra
round kin-runtime "$out/kin-runtime.txt" -- --lib
cat "$out"/kin-{gen,runtime}/mutants.out/missed.txt > "$out/left.txt"
round all "$out/left.txt" --test-package tests -- "${integration[@]}"

# The last word on each: what the second round says of those that the first let through.
told() { cat "$out"/{kin-gen,kin-runtime}/mutants.out/"$1".txt | wc -l; }
[ -d "$out/all/mutants.out" ] || { mkdir -p "$out/all/mutants.out" && cp "$out/left.txt" "$out/all/mutants.out/missed.txt"; }
viable=$(($(told caught) + $(told missed) + $(told timeout)))
missed=$(wc -l < "$out/all/mutants.out/missed.txt")
echo "$(wc -l < "$out/sample.txt") of $(wc -l < "$out/all.txt") changes, seed $seed: $viable compile, $((viable - missed)) caught, $missed not:"
cat "$out/all/mutants.out/missed.txt"
