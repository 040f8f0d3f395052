#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# model.sh BUILD: the loops of the batch kernels as llvm-mca models them on several processors, from the objects of the
# bench build in BUILD; and for aarch64 from objects that are compiled here, where its g++ is installed.
set -euo pipefail
build=$1
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mca=$(command -v llvm-mca-19)

model() { python3 -B "$root/bench/model/model.py" "$mca" "$@"; }

echo 'Cycles a vector and the ratio of the unfiltered kernel to the library'"'"'s; UnitAxes is the usual kernel, General'
echo 'that of axes that are no unit vectors, Checked that of matrices, Packed that of records without gaps. No caches, every'
echo 'jump predicted. The last column is the busiest unit.'
printf '%-16s %-16s %-21s %-9s %7s %7s %6s\n' processor pair layout kernel vesica plain ratio
library=$build/src/CMakeFiles/vesica_batch.dir/isa
plain=$build/bench/batch/CMakeFiles/vesica_bench_batch.dir/unfiltered
model objdump "$library/avx512.cpp.o" "$plain/avx512.cpp.o" skylake-avx512 sapphirerapids znver4
model objdump "$library/avx2.cpp.o" "$plain/avx2.cpp.o" haswell znver3
if command -v aarch64-linux-gnu-g++ >/dev/null; then
  # The options of src/CMakeLists.txt and of bench/batch/CMakeLists.txt.
  options=(-std=c++20 -O3 -DNDEBUG -fno-exceptions -fno-rtti -ffp-contract=fast -O2
    --param=sra-max-scalarization-size-Ospeed=2048 -I"$root/include" -I"$root/src" -I"$root/bench")
  aarch64-linux-gnu-g++ "${options[@]}" -c "$root/src/isa/neon.cpp" -o "$work/kernels.o"
  aarch64-linux-gnu-g++ "${options[@]}" -fschedule-insns -c "$root/bench/batch/unfiltered/neon.cpp" -o "$work/plain.o"
  model aarch64-linux-gnu-objdump "$work/kernels.o" "$work/plain.o" neoverse-n1 neoverse-v1
fi
