#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The near-tie hash (tests/batch/near_tie_hash) beyond the default build: on a processor with other vectors (aarch64)
# and one of the other byte order (s390x) under qemu, and natively without optimisation and by clang and lld. Each must print
# the hash that is written there. On aarch64 the tests of batches (tests/batch) run too, over its instruction sets.
# Installs the cross compilers and qemu where they are missing; builds under build/cross-<name>. Exit status 0 when all
# agree.
set -euo pipefail

# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../../run"  # root, need, cross_packages, CMAKE_BUILD_PARALLEL_LEVEL
failures=0

failed() {
  echo "cross: FAILED: $1" >&2
  failures=$((failures + 1))
}

# build NAME CMAKE_ARGUMENT...
build() {
  local directory=$root/build/cross-$1 log=$root/build/cross-$1.log
  mkdir -p "$root/build"
  if ! { cmake -S "$root/tests/cross" -B "$directory" -G Ninja "${@:2}" &&
    cmake --build "$directory"; } >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    return 1
  fi
}

# hash NAME ISA COMMAND...: COMMAND runs the program of a build, or is empty for this machine's own.
hash() {
  local status=0 output line
  output=$(VESICA_ISA=$2 "${@:3}" "$root/build/cross-$1/near_tie_hash") || status=$?
  while read -r line; do echo "$1: $line"; done <<<"$output"
  return $status
}

# symbols NAME [--unoptimised]
symbols() {
  local nm
  nm=$(sed -n 's/^CMAKE_NM:FILEPATH=//p' "$root/build/cross-$1/CMakeCache.txt")
  find "$root/build/cross-$1" -path '*/isa/*.o' -print0 | xargs -0 "$root/tests/batch/isa_symbols.sh" "${@:2}" "$nm"
}

# batches NAME COMMAND...: the tests of batches, of which those of guard pages end in a segmentation fault on purpose.
batches() {
  local output
  output=$("${@:2}" "$root/build/cross-$1/batch_test" --gtest_brief=1 2>&1) || { echo "$output" >&2; return 1; }
  echo "$1: $(tail -n 1 <<<"$output") (batch_test)"
}

# foreign NAME PROCESSOR ISA...: under qemu every named set must be there. Nothing else compiles neon, so warnings count.
foreign() {
  local isa emulator=("qemu-$2" -L "/usr/$2-linux-gnu") googletest=
  [ "$2" != aarch64 ] || googletest=/usr/src/googletest
  build "$1" -DVESICA_DEVELOPER=ON -DCMAKE_BUILD_TYPE=Release "-DVESICA_CROSS_GOOGLETEST=$googletest" \
    "-DCMAKE_TOOLCHAIN_FILE=$root/tests/cross/$2.cmake" || return 1
  symbols "$1" || return 1
  for isa in "${@:3}"; do hash "$1" "$isa" "${emulator[@]}" || return 1; done
  [ -z "$googletest" ] || batches "$1" "${emulator[@]}"
}

# native NAME BUILD_TYPE COMPILER_C COMPILER_CXX [LINKER]: a set that this processor lacks is passed over, and says so.
native() {
  local isa status unoptimised=()
  [ "$2" != Debug ] || unoptimised=(--unoptimised)
  build "$1" -DVESICA_DEVELOPER=OFF "-DCMAKE_BUILD_TYPE=$2" "-DCMAKE_C_COMPILER=$3" "-DCMAKE_CXX_COMPILER=$4" \
    ${5:+"-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=$5" "-DCMAKE_SHARED_LINKER_FLAGS=-fuse-ld=$5"} || return 1
  symbols "$1" "${unoptimised[@]}" || return 1
  # Whatever the linker, the library exports what its map lists.
  "$root/tests/abi/exported_names.sh" nm "$root/build/cross-$1/vesica/capi/libvesica.so" "$root/capi/vesica.map" || return 1
  for isa in sse2 avx2 avx512; do
    status=0
    hash "$1" "$isa" || status=$?
    [ $status = 0 ] || [ $status = 77 ] || return 1
  done
}

need g++ cmake ninja-build "${cross_packages[@]}"
foreign aarch64 aarch64 portable neon || failed aarch64
foreign s390x s390x portable || failed s390x
if [ "$(uname -m)" = x86_64 ]; then
  native gcc-debug Debug gcc g++ || failed gcc-debug
  if command -v clang++ >/dev/null; then
    native clang-release Release clang clang++ lld || failed clang-release
    native clang-debug Debug clang clang++ || failed clang-debug
  else
    echo "cross: clang++ is not installed: its builds are skipped"
  fi
fi
[ $failures = 0 ] || exit 1
echo "cross: every hash agrees"
