# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# To be sourced: what the commands of ./run share. Sets root and prefix, and the lists of packages.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
prefix=$root/build/install
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

# shellcheck source=/dev/null
. "$root/tools/run/packages.sh"

fail() {
  echo "run: $1" >&2
  exit 2
}

# step NAME COMMAND...: runs the command in the root and prints one line, the name and the seconds that it took. Its
# output goes to build/log/NAME, and the end of it is printed if the command fails.
step() {
  local name=$1 log=$root/build/log/${1// /-} start=$EPOCHREALTIME status=0 time
  mkdir -p "${log%/*}"
  [ ! -t 1 ] || printf '%s ...\r' "$name"
  (cd "$root" && "${@:2}") >"$log" 2>&1 </dev/null || status=$?
  time=$(((${EPOCHREALTIME/./} - ${start/./}) / 100000))
  if [ $status != 0 ]; then
    tail -n 40 "$log" >&2
    echo "run: $name failed; all of its output is in ${log#"$PWD/"}" >&2
    exit 1
  fi
  printf '%-32s %3d.%d s\n' "$name" $((time / 10)) $((time % 10))
}

# build PRESET [TARGET...]: configures and builds the preset.
build() {
  step "configure $1" cmake --preset "$1"
  step "build $1" cmake --build --preset "$1" ${2:+--target "${@:2}"}
}

# build_and_install: the library alone, into $prefix.
build_and_install() {
  need "${build_packages[@]}"
  build release
  step install cmake --install build/release
}

# compile NAME SOURCE...: compiles a C program as users do, from outside, by pkg-config, against what was installed.
compile() {
  local pc flags
  pc=$(find "$prefix" -name vesica.pc -printf '%h\n' | head -n 1)
  [ -n "$pc" ] || fail "no vesica.pc under $prefix"
  export PKG_CONFIG_PATH=$pc
  # pkg-config writes a space inside a path as backslash and space, which is how read without -r reads it.
  # shellcheck disable=SC2162
  read -a flags < <(pkg-config --cflags --libs vesica)
  step "compile $1" cc -std=c99 -O2 "-I$root/examples/demo" -o "$root/build/$1" "${@:2}" "${flags[@]}" -lm \
    "-Wl,-rpath,${pc%/pkgconfig}"
}

# answer SCENE [OPTION...]: the demo's answers, with its options; it is compiled against what was installed.
answer() {
  local picture=$root/build/scenes.svg status=0
  compile demo "$root"/examples/demo/*.c
  [ "$1" != "$root/tests/corpus/cases.csv" ] || cat "$root/tests/corpus/about.txt"
  "$root/build/demo" -o "$picture" "$@" || status=$?
  [ $status -gt 1 ] || echo "picture: $picture"
  return $status
}

# run_tests PRESET: runs ctest, and prints the failed tests and the summary; on a terminal, also how far it has come.
run_tests() {
  local terminal=0
  [ ! -t 2 ] || terminal=1
  (cd "$root" && ctest --preset "$1") | awk -v "terminal=$terminal" '
    /^ +Start +[0-9]+: / { next }
    /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .* Passed +[0-9.]+ sec$/ {
      if (terminal) printf "tests %s\r", $1 >"/dev/stderr"
      next
    }
    { print; fflush() }'
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# missing PACKAGE...: prints those of the packages that are not installed.
missing() {
  local package
  for package in "$@"; do
    # A package may be there for several architectures: a line each.
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -x installed >/dev/null || echo "$package"
  done | awk '!seen[$0]++'
}

install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}

# need PACKAGE...: installs those of the packages that are not installed.
need() {
  local packages
  if ! command -v dpkg-query >/dev/null; then
    echo "run: not a Debian system; this takes for granted: $*" >&2
    return
  fi
  mapfile -t packages < <(missing "$@")
  [ ${#packages[@]} -gt 0 ] || return 0
  echo "to be installed: ${packages[*]}"
  step 'apt-get update' as_root apt-get update
  step 'apt-get install' install "${packages[@]}"
}

# need_if_possible PACKAGE...: the same, but passes over what cannot be installed: the tests that need it will fail.
need_if_possible() {
  local package
  (need "$@") && return
  for package in $(missing "$@"); do
    (step "apt-get install $package" install "$package") 2>/dev/null || echo "run: cannot be installed: $package" >&2
  done
}
