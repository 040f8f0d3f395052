# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Runs libFuzzer on the C functions and on the readers of the demo.
#
#   ./run fuzz [SECONDS]     each target for so long, 60 by default; what it finds is under build/fuzz

need "${fuzz_packages[@]}"
step 'configure fuzz' cmake -S tests/fuzz -B build/fuzz -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++
step 'build fuzz' cmake --build build/fuzz --target fuzz_c_face fuzz_scene
for target in c_face scene; do
  mkdir -p "$root/build/fuzz/corpus/$target"
  "$root/build/fuzz/fuzz_$target" -max_total_time="${1:-60}" -max_len=1024 -artifact_prefix="$root/build/fuzz/" \
    "$root/build/fuzz/corpus/$target" "$root/tests/fuzz/corpus/$target"
done
