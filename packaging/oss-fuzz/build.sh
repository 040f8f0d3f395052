#!/bin/bash -eu
# SPDX-License-Identifier: Apache-2.0
# Builds the fuzzers of tests/fuzz as OSS-Fuzz asks, in the folder of the sources: compilers, their flags and the engine
# come in CC, CXX, CFLAGS, CXXFLAGS and LIB_FUZZING_ENGINE. The programs and their corpora go to OUT.
cmake -S tests/fuzz -B "$WORK/fuzz" -G Ninja
cmake --build "$WORK/fuzz" --target fuzz_c_face fuzz_scene
for target in c_face scene; do
  cp "$WORK/fuzz/fuzz_$target" "$OUT/"
  (cd "tests/fuzz/corpus/$target" && cmake -E tar cf "$OUT/fuzz_${target}_seed_corpus.zip" --format=zip .)
  printf '[libfuzzer]\nmax_len = 1024\n' >"$OUT/fuzz_$target.options"
done
