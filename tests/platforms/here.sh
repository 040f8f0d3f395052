#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# here.sh [ARGUMENT...]: for systems that ./run test does not know, such as macOS and Windows. Builds the library and
# programs under build/here, with this machine's compiler and these arguments of cmake, and runs them: the near-tie
# hash by each instruction set, the answers that bindings are tested with, and the demo on the corpus. Any bash since
# 3.2 will do.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cmake -S "$root/tests/platforms" -B "$root/build/here" -DCMAKE_BUILD_TYPE=Release "$@"
cmake --build "$root/build/here" --target vesica vesica_methods near_tie_hash vectors demo
cd "$root/build/here"
./near_tie_hash
for set in portable sse2 avx2 avx512 neon; do
  status=0
  VESICA_ISA=$set ./near_tie_hash || status=$?
  [ $status = 0 ] || [ $status = 77 ] # 77: this processor has no such set
done
./vectors "$root/bindings/vectors/vectors.txt"
./demo -o demo.svg "$root/tests/corpus/cases.csv" | tail -n 1
