# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Runs ./run and then the library's tests.
#
#   ./run test               the library, and bindings for C, C++ and Python, with a quarter of the random cases
#   ./run test --all         all random cases; then the slow tests: every other language and compiler, WebAssembly, the
#                            site in a browser, emulated processors, sanitizers, packages, lint. A test fails if what
#                            it needs cannot be installed
#   ./run test --cross [ROW] every other processor, system and compiler that can be run here (docs/platforms.md)
#   ./run test --cuda        the CUDA kernels by nvcc: registers, stack, instructions a pair; and on a device, if there
#                            is one (docs/cuda.md). Without nvcc the other tests run them as C++
#   ./run test --engines     the engines alone: SQLite, PostgreSQL, MPI, Dask and DuckDB (docs/engines.md)
#   ./run test --sanitize    all tests under the sanitizers; --all has those that take minutes

# The library is built once: the tests are of the one that is installed and answers the scenes.
test_library() {
  need "${test_packages[@]}"
  build test
  step install cmake --install build/test
  answer "$root/tests/corpus/cases.csv"
  run_tests test
}

case "$*" in
  "")
    export VESICA_REPEAT=${VESICA_REPEAT:-0.25}
    test_library
    ;;
  --all)
    test_library
    need_if_possible "${slow_packages[@]}"
    step 'configure test' cmake --preset test
    step 'build slow' cmake --build --preset slow
    run_tests slow
    ;;
  --cuda)
    command -v nvcc >/dev/null || fail "test --cuda needs nvcc, which is not on the PATH; nothing was compiled"
    "$root/tests/cuda/compile.py" nvcc sm_80 sm_90 sm_100
    need "${test_packages[@]}"
    build test vesica vesica_workloads vesica_corpus
    "$root/tests/cuda/programs.sh" "$root/build/test"
    ;;
  --engines)
    need "${test_packages[@]}"
    need_if_possible "${engine_packages[@]}"
    step 'configure test' cmake --preset test
    step 'build engines' cmake --build --preset engines
    run_tests engines
    ;;
  --sanitize) "$root/tests/sanitize/sanitize.sh" slow fast ;;
  --cross*) "$root/tests/platforms/platforms.sh" "${@:2}" ;;
  *) fail "test takes --all, --cross, --cuda, --engines, --sanitize or nothing" ;;
esac
