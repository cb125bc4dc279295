#!/usr/bin/env bash
# Would the tests notice? A seeded sample of small changes to the solvers of kin-runtime and the algebra of kin-gen.
#
#     tests/mutants/run.sh [COUNT [SEED [FOLDER]]]      320 changes, seed 1, target/mutants
#
# Needs cargo-mutants (`cargo install cargo-mutants --version 27.1.0`) and Python. The changes are those of cargo-mutants. To build
# every arm again for each of them would take days, so switch.py writes all of them into one copy of the sources, and a
# variable says which is on. Each is given to the programs of tests that meet its function, one after the other, until one fails.
# An hour or two on one core, most of it to build. Prints how many were caught of those that compile, and those that were not;
# survivors.md says why of each. Run again it goes on where it was ended, and asks anew only of programs that have changed; sources
# that have changed want a new folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

count=${1:-320} seed=${2:-1} out=$(realpath -m "${3:-target/mutants}")
scope=(-f 'kin-runtime/src/ik/**' -f 'kin-runtime/src/geometry.rs' -f 'kin-runtime/src/track/**'
    -f 'kin-runtime/src/choice.rs' -f 'kin-gen/src/algebra/**')

command -v cargo-mutants > /dev/null || { echo "MUTANTS STOPPED: cargo-mutants is not installed" >&2; exit 2; }
rm -rf "$out/plain"
mkdir -p "$out/plain"

# Names as a pattern that matches them and nothing else.
pattern() {
    sed 's/[][\.*^$()+?{}|/]/\\&/g' "$1" | paste -sd '|' | sed 's/.*/^(&)$/'
}

# Some of the lines of a file, the same for the same seed: in the order of what the generator of Park and Miller gives them.
sample() {
    awk -v seed="$seed" '{ seed = seed * 16807 % 2147483647; printf "%d\t%s\n", seed, $0 }' "$1" \
        | sort -n | awk -v count="$count" 'NR <= count' | cut -f 2-
}

cargo mutants --list "${scope[@]}" > "$out/all.txt"
cargo mutants --list --json "${scope[@]}" > "$out/all.json"
sample "$out/all.txt" > "$out/sample.txt"

git ls-files | tar c -T - | tar x -C "$out/plain"
CARGO_TARGET_DIR=$out/target CARGO_PROFILE_DEV_DEBUG=0 CARGO_INCREMENTAL=0 \
    python3 tests/mutants/switch.py "$out/all.json" "$out/sample.txt" "$out/plain" "$out/tree" "$out"

# What is fixed when the crate is built, cargo-mutants tries itself, one build each, on the tests of its own crate.
if [ -s "$out/apart.txt" ]; then
    cargo mutants "${scope[@]}" --re "$(pattern "$out/apart.txt")" --output "$out/apart" --timeout 300 --baseline skip \
        --no-times --colors never -- --lib || [ $? -le 3 ]
    # It tries those that delete a field whatever the pattern.
    grep -Fxf "$out/apart.txt" "$out/apart/mutants.out/missed.txt" >> "$out/missed.txt" || true
    grep -Fxf "$out/apart.txt" "$out/apart/mutants.out/unviable.txt" >> "$out/unviable.txt" || true
fi

viable=$(($(wc -l < "$out/sample.txt") - $(wc -l < "$out/unviable.txt"))) missed=$(wc -l < "$out/missed.txt")
echo "$(wc -l < "$out/sample.txt") of $(wc -l < "$out/all.txt") changes, seed $seed: $viable compile, $((viable - missed)) caught, $missed not:"
cat "$out/missed.txt"
