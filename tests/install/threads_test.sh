#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# threads_test.sh MOVED WORK: the join that C11 threads, OpenMP and a pool divide among them (examples/threads) gives the
# same index and the same pairs in the same order, whatever the number of threads; all of the pairs, as single calls say.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

threads=$here/../../examples/threads
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror)
# One caller, beside the library's own build, and all pairs by single calls.
cat >"$work/alone.c" <<'EOF'
int run_example(int argc, char **argv);
#define main run_example
#include "main.c"
#undef main
#include <string.h>

void each_part(int threads, int64_t parts, void (*task)(int64_t part, void *user), void *user) {
  (void)threads;
  for (int64_t part = 0; part < parts; part++) task(part, user);
}

int main(int argc, char **argv) {
  if (run_example(argc, argv) != 0) return 1;
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(VESICA_RECT, count, cars, sizeof *cars, &shapes);
  const int64_t size = vesica_index_size(count), scratch = vesica_index_scratch(count);
  void *const whole = memory(size);
  const int64_t used = vesica_index_build_f64(&shapes, 1, whole, size, memory(scratch), scratch);
  require(memcmp(whole, build(&shapes, 1), (size_t)used) == 0, "steps do not build what the library does");
  int all = 0;
  for (int i = 0; i < count; i++)
    for (int k = 0; k < count; k++) all += vesica_overlap_f64(VESICA_RECT, &cars[i], VESICA_CIRCLE, &posts[k]);
  printf("%d pairs\n", all);
  return 0;
}
EOF
compile() {
  "$CC" -std=c11 -O1 "${warnings[@]}" -I"$threads" -o "$work/$1" "${@:2}" "${flags[@]}"
}
compile alone "$work/alone.c"
compile c11 "$threads/main.c" "$threads/c11.c" -pthread
compile openmp "$threads/main.c" "$threads/openmp.c" -fopenmp
compile pool "$threads/main.c" "$threads/pool.c" -pthread

{ read -r expected && read -r every; } < <("$work/alone" 1)
[[ $expected == "$every, "* && $every != '0 pairs' ]]
failures=0
for way in c11 openmp pool; do
  for number in 1 2 3 8; do
    found=$("$work/$way" $number)
    [ "$found" = "$expected" ] && continue
    echo "$way by $number threads finds $found, and a single caller $expected"
    failures=$((failures + 1))
  done
done
[ $failures = 0 ]
echo "$expected"
