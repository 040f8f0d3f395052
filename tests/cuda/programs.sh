#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# programs.sh TESTS: the benchmark and the test for devices compile and link with nvcc, the libraries being those that the
# preset "test" built in the folder TESTS. Where there is a device, for it and all pairs, and the test must pass on it; where
# there is none, for one pair, and both must say so.
set -euo pipefail
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

architecture=sm_90 pairs=(-DVESICA_ONE_PAIR)
device=no
if nvidia-smi -L 2>/dev/null | grep '^GPU' >/dev/null; then
  device=yes architecture=native pairs=()
fi

"$root/bench/cuda/build.sh" "$work/bench" "$architecture" "$build/capi" "${pairs[@]}"
flags=(-std=c++20 -O1 "-I$root/include" "-I$root/capi/include" "-I$root/bench" "-I$root/tests" -c --output-directory "$work"
  -x cu --expt-relaxed-constexpr "-arch=$architecture" "${pairs[@]}")
nvcc "${flags[@]}" "-DVESICA_VECTORS=\"$root/bindings/vectors/vectors.txt\"" "$here/device_test.cpp"
nvcc "${flags[@]}" "$root/bench/cuda/any_pair.cpp"
nvcc -o "$work/test" "$work/device_test.o" "$work/any_pair.o" "-L$build/tests" -lvesica_workloads -lvesica_corpus \
  -lvesica_oracle "-L$build/capi" -lvesica -Xlinker "-rpath=$build/capi" -lgtest -lgmpxx -lgmp

if [ $device = yes ]; then
  "$work/test"
  "$work/bench" --pairs 100000 rect_rect
  exit
fi
for program in test bench; do
  code=0
  said=$("$work/$program" 2>&1) || code=$?
  echo "$program: $said"
  if [ $code != 3 ] || ! grep -q 'no CUDA device' <<<"$said"; then
    echo "programs.sh: without a device, exit status $code"
    exit 1
  fi
done
