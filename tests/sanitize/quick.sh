#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# quick.sh FOLDER: what the sanitizers can be asked in minutes, on every merge: address and undefined behaviour over the
# C face, thread over the tests of threads. sanitize.sh asks the rest. Builds below the folder.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
TIMEFORMAT='  %1lR, of processors %1lU'
# Tests of guard pages end in a segmentation fault on purpose.
export ASAN_OPTIONS=handle_segv=0:detect_stack_use_after_return=1 TSAN_OPTIONS=handle_segv=0

check() {
  cmake -S "$here" -B "$1" -G Ninja "-DVESICA_SANITIZE=$2" >"$1.log"
  cmake --build "$1" >>"$1.log" || { tail -n 40 "$1.log"; return 1; }
  ctest --test-dir "$1" -j "${CTEST_PARALLEL_LEVEL:-2}" --output-on-failure
}

mkdir -p "$1"
for sanitizer in address thread; do
  echo "sanitize: $sanitizer"
  time check "$1/$sanitizer" "$sanitizer"
done
