#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# coverage.sh [TEST...]: what the library's own tests reach of include/, src/ and capi/, by folder, and the lines that
# none of them reaches, or leaves one way only. Clang 19 counts: it knows modified condition and decision coverage. With
# names of tests only these are built and run. Works under build/coverage. Exit status 1 where there is a line that
# exceptions.txt does not name.
set -euo pipefail

# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../../tools/run/common.sh"
here=$root/tools/coverage
folder=$root/build/coverage

# Tests of other things than the library's own code.
foreign='^(abi_|bench_|constexpr_|consumer|platforms|cuda_docs|declarations_|demo_|description_|bindings_|figures_|flags_|header_|install'
foreign+='|.*isa_symbols|join_|lint_|oracle_|package_|readme_|run_|sanitize|subproject_)'
# Of the library's own tests those that only `./run test --all` has.
later=(batch_portable_test cast_contracted_test filter_fused_test stress_slowest stress_rare
  invalid_shapes_every_pair_test relation_filter_fused_test)
later_by_environment=(batch_queries_portable index_bytes_portable near_tie_hash_portable)

mkdir -p "$root/build"
need "${coverage_packages[@]}"
flags='-fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc'
cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVESICA_TESTS=ON -DVESICA_LINKER_HAS_z_defs=OFF \
  -DCMAKE_C_COMPILER=clang-19 -DCMAKE_CXX_COMPILER=clang++-19 "-DCMAKE_C_FLAGS=$flags" "-DCMAKE_CXX_FLAGS=$flags" \
  -DCMAKE_C_FLAGS_RELEASE=-O1 -DCMAKE_CXX_FLAGS_RELEASE=-O1 >"$folder.log"
if [ $# = 0 ]; then
  mapfile -t tests < <(
    ctest --test-dir "$folder" -N -LE '^slow$' -E "$foreign" | sed -n 's/^ *Test *#[0-9]*: //p')
  set -- "${tests[@]}" "${later[@]}" "${later_by_environment[@]}"
fi
these="^($(IFS='|' && echo "$*"))\$"
# The programs of these tests, and what is loaded before one of them; no other is built.
mapfile -t programs < <(find "$folder" -name CTestTestfile.cmake -exec cat {} + | python3 "$here/programs.py" "$these")
cmake --build "$folder" --target "${programs[@]}" >>"$folder.log"

rm -rf "$folder/profiles"
# Programs that run at once merge into a pool of four files each.
LLVM_PROFILE_FILE=$folder/profiles/%4m.profraw ctest --test-dir "$folder" -R "$these" \
  -j "$CTEST_PARALLEL_LEVEL" --output-on-failure >"$folder/tests.log" || { tail -n 40 "$folder/tests.log" >&2; exit 1; }
llvm-profdata-19 merge -sparse "$folder"/profiles/*.profraw -o "$folder/profile"

# Every program and library that was run: a template is reached where any of them reaches it.
objects=()
while read -r object; do objects+=(-object "$object"); done < <(
  find "$folder/capi" "$folder/tests" "$folder/tools" -maxdepth 3 -type f -perm -u+x ! -name '*.sh' ! -path '*/CMakeFiles/*')
export_coverage() {
  llvm-cov-19 export "$@" -instr-profile "$folder/profile" "${objects[@]}" \
    -ignore-filename-regex "^(/usr|$root/(tests|tools|bench|docs))" 2>/dev/null
}
export_coverage -format=lcov >"$folder/lines"
export_coverage -format=text -skip-expansions >"$folder/details"
python3 "$here/table.py" "$root" "$folder/lines" "$folder/details" "$here/exceptions.txt"
