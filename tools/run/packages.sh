# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2034
# To be sourced: the Debian packages that each command needs.

build_packages=(g++ cmake ninja-build pkg-config)
test_packages=("${build_packages[@]}" libgmp-dev libgtest-dev libmpfr-dev libxml2-utils python3-cffi python3-numpy)

# A nodejs that is not Debian's comes with npm, and cannot be installed beside Debian's.
npm=()
command -v npm >/dev/null || npm=(npm)

# The packages for other languages, and what tests the folders of bindings/small.
python_packages=(g++ cmake python3-numpy python3-pandas python3-pip python3-setuptools python3-venv python3-wheel)
rust_packages=(g++ cmake cargo rustc)
go_packages=(g++ cmake golang-go unzip zip)
java_packages=(g++ cmake default-jdk-headless python3)
csharp_packages=(g++ cmake mono-mcs mono-runtime python3 unzip zip)
wasm_packages=(binaryen clang lld wasi-libc libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32 nodejs)
javascript_packages=("${build_packages[@]}" "${wasm_packages[@]}" python3 "${npm[@]}")
small_packages=(fp-compiler gfortran gnat guile-3.0 libffi-platypus-perl luajit php-cli r-base-core ruby tcl-dev
  "${npm[@]}")

debian_packages=(build-essential cmake debhelper python3)
linux_packages=("${build_packages[@]}" g++-aarch64-linux-gnu qemu-user)
windows_packages=(cmake ninja-build g++-mingw-w64-x86-64 zip)
cross_packages=(googletest g++-aarch64-linux-gnu g++-s390x-linux-gnu qemu-user)
engine_packages=(libopenmpi-dev libsqlite3-dev make openmpi-bin postgresql-15 postgresql-server-dev-15 python3-dask
  python3-distributed python3-numpy sqlite3 "${npm[@]}")
site_packages=(doxygen python3-markdown)
lint_packages=(clang-format-14 clang-tidy-14)
mutant_packages=("${test_packages[@]}" clang-19 python3-clang-19)
coverage_packages=("${test_packages[@]}" clang-19 llvm-19 libclang-rt-19-dev)
fuzz_packages=("${build_packages[@]}" clang)
bench_packages=("${build_packages[@]}" libbenchmark-dev libboost-dev libgeos-dev libgeos++-dev libbox2d-dev libcgal-dev
  libchipmunk-dev libfcl-dev libgmp-dev libmpfr-dev)

# All of this for the slow tests. Chromium runs the site's tests.
slow_packages=("${python_packages[@]}" "${rust_packages[@]}" "${go_packages[@]}" "${java_packages[@]}"
  "${csharp_packages[@]}" "${wasm_packages[@]}" "${small_packages[@]}" "${debian_packages[@]}" "${cross_packages[@]}"
  "${engine_packages[@]}" "${site_packages[@]}" "${lint_packages[@]}" "${mutant_packages[@]}"
  abigail-tools chromium lintian man-db)
