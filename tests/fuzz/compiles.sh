#!/bin/bash
# compiles.sh FOLDER: the fuzzer's own sources compile by clang, as ./run fuzz does it. The library beneath is left out,
# as it takes minutes with the sanitizers.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cmake -S "$here" -B "$1" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ >/dev/null
objects=$(ninja -C "$1" -t targets all | sed -n 's/^\(CMakeFiles\/fuzz_[^:]*\.o\):.*/\1/p')
[ "$(wc -w <<<"$objects")" -ge 10 ] || { echo "compiles: only these: $objects"; exit 1; }
# shellcheck disable=SC2086  # a list
ninja -C "$1" $objects
