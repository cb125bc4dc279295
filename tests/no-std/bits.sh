#!/usr/bin/env bash
# The same bits everywhere: builds and runs the hashes of tests/src/bits for each target and prints one table: of 2,000 poses, and,
# but for a Cortex-M and Miri, which would take hours, of 4,000 aimed at singular sets.
#
#     tests/no-std/bits.sh [quick|all|TARGET …]
#
# `quick` (x86-64, x86-64-v3, wasm32) needs node; `all` also qemu-user, qemu-system-arm and an aarch64 linker. Neither includes
# `miri`, which needs a nightly toolchain, interprets everything and takes much longer; `miri-quick` is its first 33 poses.
# What is missing is installed, with rustup or apt-get; a refusal stops the script under its own name.
# Exit code 1 if a hash differs from golden.txt.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

read -r quick all aimed < golden.txt
out=${CARGO_TARGET_DIR:-target}/no-std
failed=0

refused() {
    printf '\nBITS STOPPED: refused or impossible: %s\n' "$*" >&2
    exit 2
}

target() { rustup target list --installed | grep -qx "$1" || rustup target add "$1" || refused "rustup target add $1"; }

tool() {
    command -v "$1" > /dev/null || { apt-get update && apt-get install -y "$2"; } || refused "apt-get install $2"
}

# The program of one target, built with the given compiler flags: name, target, flags, package.
build() {
    RUSTFLAGS="$3" cargo build --quiet --locked --release --target "$2" --target-dir "$out/$1" -p "$4"
}

judge() {
    local verdict=same
    if [ "$2" != "$3" ]; then
        verdict=DIFFERENT
        failed=1
    fi
    printf '%-12s %-34s %s\n' "$1" "${2:-nothing}" "$verdict"
}

x86-64() {
    build "$FUNCNAME" x86_64-unknown-linux-gnu "" host
    judge "$FUNCNAME" "$("$out/$FUNCNAME/x86_64-unknown-linux-gnu/release/host")" "$all $aimed"
}

x86-64-v3() {
    build "$FUNCNAME" x86_64-unknown-linux-gnu "-C target-cpu=x86-64-v3" host
    judge "$FUNCNAME" "$("$out/$FUNCNAME/x86_64-unknown-linux-gnu/release/host")" "$all $aimed"
}

wasm32() {
    tool node nodejs
    target wasm32-unknown-unknown
    build "$FUNCNAME" wasm32-unknown-unknown "" wasm
    judge "$FUNCNAME" "$(node wasm/run.mjs "$out/$FUNCNAME/wasm32-unknown-unknown/release/wasm.wasm")" "$all $aimed"
}

aarch64() {
    tool qemu-aarch64 qemu-user
    tool aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu
    target aarch64-unknown-linux-gnu
    build "$FUNCNAME" aarch64-unknown-linux-gnu \
        "-C linker=aarch64-linux-gnu-gcc -C target-feature=+crt-static" host
    judge "$FUNCNAME" "$(qemu-aarch64 "$out/$FUNCNAME/aarch64-unknown-linux-gnu/release/host")" "$all $aimed"
}

cortex-m4() {
    tool qemu-system-arm qemu-system-arm
    target thumbv7em-none-eabihf
    build "$FUNCNAME" thumbv7em-none-eabihf "-C link-arg=-Tlink.x" thumb
    judge "$FUNCNAME" "$(qemu-system-arm -machine mps2-an386 -nographic -semihosting-config enable=on,target=native \
        -kernel "$out/$FUNCNAME/thumbv7em-none-eabihf/release/thumb")" "$all"
}

# Interpreted by Miri, which looks for undefined behaviour and keeps no value that a processor would keep by luck. On x86-64 libm's
# square root is assembly, which it cannot read; on s390x it is not, and the bytes of a number stand the other way round.
interpreted() {
    local has
    has=$(rustup component list --toolchain nightly --installed) || refused "a nightly toolchain"
    for part in miri rust-src; do
        grep -q "^$part" <<< "$has" || rustup component add "$part" --toolchain nightly || refused "rustup component add $part"
    done
    cargo +nightly miri run --quiet --locked --target s390x-unknown-linux-gnu --target-dir "$out/miri" -p host -- "$@"
}

miri() { judge "$FUNCNAME" "$(interpreted all)" "$all"; }

miri-quick() { judge "$FUNCNAME" "$(interpreted quick)" "$quick"; }

case ${1:-quick} in
quick) set -- x86-64 x86-64-v3 wasm32 ;;
all) set -- x86-64 x86-64-v3 wasm32 aarch64 cortex-m4 ;;
esac
for each in "$@"; do
    "$each"
done
exit "$failed"
