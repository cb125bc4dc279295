#!/usr/bin/env bash
# The embedded contract: programs for a Cortex-M4 that link only if no panic path is left, and what they take.
#
#     tests/no-std/contract.sh [link|figures]
#
# `link` (what CI runs) builds each task of contract/src for thumbv7em-none-eabihf with opt-level 3 and "s", in
# double and in single precision, with a panic handler that calls a function which nobody defines; and one program that
# can panic, which must not link. `figures` also runs them in qemu-system-arm, on a Cortex-M4 and, for doubles in hardware,
# on a Cortex-M7, and writes contract.md, which RELIABILITY.md quotes.
# Exit code 1 if something links that must not, or the other way round.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

out=${CARGO_TARGET_DIR:-target}/no-std
target=thumbv7em-none-eabihf
tasks=(forward elbow slide oblique general batch position choice track ball short trajectory watch velocity)
# A feature by itself is no argument: the number format, or nothing.
declare -A format=([f64]="" [f32]="--features single")
declare -A profile=([3]=release [s]=small)

refused() {
    printf '\nCONTRACT STOPPED: refused or impossible: %s\n' "$*" >&2
    exit 2
}

tool() {
    command -v "$1" > /dev/null || { apt-get update && apt-get install -y "$2"; } || refused "apt-get install $2"
}

# Some of the programs: optimisation, number format, processor, then the arguments that name them.
build() {
    # shellcheck disable=SC2086
    RUSTFLAGS="-C link-arg=-Tlink.x -C target-cpu=$3" cargo build --quiet --locked --profile "${profile[$1]}" \
        --target "$target" --target-dir "$out/contract-$3" -p contract ${format[$2]} "${@:4}"
}

# Where they are.
place() {
    printf '%s/contract-%s/%s/%s' "$out" "$2" "$target" "${profile[$1]}"
}

link() {
    local name log
    log=$(mktemp)
    for name in "${tasks[@]}"; do
        set -- "$@" --bin "$name"
    done
    build "$1" "$2" cortex-m4 "${@:3}" || { echo "a path to a panic is left at opt-level $1, $2"; exit 1; }
    if build "$1" "$2" cortex-m4 --bin caught 2> "$log" || ! grep -q a_path_to_a_panic_is_left "$log"; then
        echo "the program that can panic was not refused for that at opt-level $1, $2"
        cat "$log"
        exit 1
    fi
    rm "$log"
    echo "no panic path is left at opt-level $1, $2: ${tasks[*]}"
}

# Bytes of text and constants, the vector table of 1 KiB among them.
size_of() {
    size "$1" | awk 'END { print $1 + $2 }'
}

# Stack, mean and largest number of instructions of each task.
run() {
    timeout 1800 qemu-system-arm -machine "$1" -nographic -icount shift=0 -semihosting-config \
        enable=on,target=native -kernel "$2/figures" || refused "qemu-system-arm -machine $1"
}

figures() {
    local opt cpu kind machine row name
    tool qemu-system-arm qemu-system-arm
    tool size binutils
    {
        echo "| task | processor, numbers | opt-level | flash, bytes | stack, bytes | instructions, mean | largest |"
        echo "|---|---|---|---|---|---|---|"
        for row in "cortex-m4 f64 mps2-an386" "cortex-m4 f32 mps2-an386" "cortex-m7 f64 mps2-an500"; do
            read -r cpu kind machine <<< "$row"
            for opt in 3 s; do
                build "$opt" "$kind" "$cpu" "${tasks[@]/#/--bin=}" --bin=figures
                run "$machine" "$(place "$opt" "$cpu")" | while read -r name stack mean largest; do
                    echo "| $name | $cpu, $kind | $opt | $(size_of "$(place "$opt" "$cpu")/$name") |" \
                        "$stack | $mean | $largest |"
                done
            done
        done
    } > contract.new
    mv contract.new contract.md
    cat contract.md
}

rustup target list --installed | grep -qx "$target" || rustup target add "$target" || refused "rustup target add $target"
for opt in 3 s; do
    for kind in f64 f32; do
        link "$opt" "$kind"
    done
done
if [ "${1:-link}" = figures ]; then
    figures
fi
