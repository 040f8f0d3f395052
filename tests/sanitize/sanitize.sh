#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sanitize.sh fast|slow|NAME...: the library and its own tests under sanitizers: the rows of the table below that are
# marked so, or those named. Builds under build/sanitize-<name>, prints each row's minutes and each report once. Exit
# status 0 when there is no report and every test passes.
# shellcheck disable=SC2154
set -euo pipefail

# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../../tools/run/common.sh"

table='
# name                compiler  sanitizers  build    when
gcc-address-debug     gcc       address     Debug    slow
gcc-address-release   gcc       address     Release  fast
gcc-thread-debug      gcc       thread      Debug    slow
gcc-thread-release    gcc       thread      Release  slow
clang-address-debug   clang     address     Debug    slow
clang-address-release clang     address     Release  slow
clang-thread-debug    clang     thread      Debug    fast
clang-thread-release  clang     thread      Release  slow
'

# What is not of the library, or is sanitized already, or loads it as a program without sanitizers does. Stack.*
# measures a stack that sanitizers make deeper.
foreign='^(abi_|bench_|consumer|platforms|csharp_|cuda_bench|declarations_|demo_|description_|engines_|exact_sanitized_test'
foreign+='|exact_stack_test|bindings_|figures_|flags_|go_|stress|header_|index_isa_symbols|index_memory_test|index_threads_test|install'
foreign+='|isa_symbols|java_|javascript_|join_|lint_|near_tie_hash_portable|package_|python_|reach|readme_|run_|rust_|sanitize|site_'
foreign+='|subproject_)'
# Millions of random pairs: what a sanitizer can see in them, it sees in thousands.
long='^(differential_|relation_differential_|area_accuracy_|nearest_accuracy_|boundary_distance_global_)'

configure() {
  local flags arguments=()
  case $sanitizers in
    address) flags='-fsanitize=address,undefined,float-cast-overflow,alignment' ;;
    thread) flags='-fsanitize=thread' ;;
  esac
  # -g, which Debug would add, lets g++ follow variables through the sanitizers' code: ten times as long for a kernel.
  flags+=' -fno-omit-frame-pointer -g1'
  if [ "$compiler" = clang ]; then
    # Its run-time library comes with the program alone: with one in C, the part for C++ and what that needs too, by
    # flags that CMake's first program in C has as well.
    arguments=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DVESICA_LINKER_HAS_z_defs=OFF
      "-DCMAKE_C_FLAGS=$flags -fsanitize-link-c++-runtime" -DCMAKE_EXE_LINKER_FLAGS=-lstdc++)
  fi
  cmake -S "$root" -B "$folder" -G Ninja "-DCMAKE_BUILD_TYPE=$build" -DVESICA_TESTS=ON \
    "-DCMAKE_C_FLAGS=$flags" "-DCMAKE_CXX_FLAGS=$flags" -DCMAKE_C_FLAGS_DEBUG= -DCMAKE_CXX_FLAGS_DEBUG= "${arguments[@]}"
}

# The programs of the row's tests, as paths in its folder: nothing else has to be built. CTest itself keeps silent about
# programs that are not there yet.
programs() {
  local names
  names=$(ctest --test-dir "$folder" -N "${selection[@]}" | sed -n 's/^ *Test *#[0-9]*: \([^ ]*\).*/\1/p')
  find "$folder" -name CTestTestfile.cmake -exec cat {} + | sed -nE 's/^add_test\((\[=*\[)?([^] ]*)(\]=*\])? "([^"]*)".*/\2 \4/p' |
    awk -v folder="$folder/" 'NR == FNR { wanted[$1]; next }
      $1 in wanted && index($2, folder) == 1 { print substr($2, length(folder) + 1) }' <(echo "$names") - | sort -u
}

row() {
  local folder=$root/build/sanitize-$name selection targets reports repeat=1 status=0
  local log=$folder/log
  mkdir -p "$folder"
  case $sanitizers,$when in
    thread,*) selection=(-R '^threads_test$') ;;
    *,fast) selection=(-E "$foreign|$long") ;;
    *) selection=(-E "$foreign") ;;
  esac
  if ! { configure && mapfile -t targets < <(programs) && cmake --build "$folder" --target "${targets[@]}"; } >"$log" 2>&1
  then
    tail -n 40 "$log" >&2
    return 1
  fi
  # Slow rows draw a quarter of the random pairs: what a sanitizer can see, it sees in few.
  [ "$when" = fast ] || repeat=0.25
  # Tests of guard pages end in a segmentation fault on purpose.
  export 'GTEST_FILTER=-Stack.*' UBSAN_OPTIONS=print_stacktrace=0
  export ASAN_OPTIONS=handle_segv=0:detect_stack_use_after_return=1 TSAN_OPTIONS=handle_segv=0
  VESICA_REPEAT=${VESICA_REPEAT:-$repeat} ctest --test-dir "$folder" "${selection[@]}" -j "$CTEST_PARALLEL_LEVEL" -V \
    >"$folder/tests.log" 2>&1 || status=$?
  reports=$(grep -hoE '[^ ]*: runtime error: .*|SUMMARY: (Address|Thread|Leak)Sanitizer: .*' "$folder/tests.log" |
    sed -E 's/0x[0-9a-f]{6,}/ADDRESS/; s/^[0-9]*: //' | sort | uniq -c | sort -rn)
  [ -z "$reports" ] || { echo "$reports" >&2; status=1; }
  sed -n '/tests passed\|The following tests FAILED/,/^Errors/p' "$folder/tests.log"
  return $status
}

wanted() {
  local word
  for word in "${words[@]}"; do [ "$word" != "$1" ] && [ "$word" != "$2" ] || return 0; done
  return 1
}

# Elapsed time, and processors' time, which another load on the machine does not lengthen.
TIMEFORMAT='  %1lR, of processors %1lU'

main() {
  local name compiler sanitizers build when failures=0 rows=0 result words=("$@")
  [ $# -gt 0 ] || { echo 'usage: sanitize.sh fast|slow|NAME...' >&2; exit 2; }
  while read -r name compiler sanitizers build when; do
    case $name in '' | '#'*) continue ;; esac
    wanted "$name" "$when" || continue
    need "${test_packages[@]}"
    rows=$((rows + 1))
    if time row </dev/null; then result=passed; else result=FAILED failures=$((failures + 1)); fi
    printf 'sanitize: %-22s %s\n' "$name" $result
  done <<<"$table"
  [ $rows -gt 0 ] || { echo 'sanitize: no such row' >&2; exit 2; }
  [ $failures = 0 ] || exit 1
}

main "$@"
