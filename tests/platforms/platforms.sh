#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# platforms.sh [--quick] [NAME...]: the library's answers on other processors, systems and compilers: all rows of the
# table below, or those named. --quick: the near-tie hash, the programs in C and the index alone, not the corpus and
# the batches. Installs what a row needs, builds under build/cross-<build>, prints each row's minutes. Exit status 0
# when every row passes.
# shellcheck disable=SC2154,SC2317
set -euo pipefail

# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../../tools/run/common.sh"
here=$root/tests/platforms
export WINEPREFIX=${WINEPREFIX:-$root/build/wine} WINEDEBUG=${WINEDEBUG:--all}

# build: a folder; rows that share one share its programs. For triplets of Debian's cross compilers it is the triplet.
# run by: the command in front of a program; empty for this machine itself, which may lack some of the instruction sets.
# checks: batches/N takes one case in N of the tests of batches, to bound a row's minutes under an emulator.
table='
# name         | build                 | run by                   | sets                      | checks
aarch64        | aarch64-linux-gnu     | qemu-aarch64 -L SYSROOT  | portable neon             | c index corpus batches/5
armhf          | arm-linux-gnueabihf   | qemu-arm -L SYSROOT      | portable                  | c index corpus batches/5
i686           | i686-linux-gnu        | SYSROOT/lib/ld-linux.so.2 --library-path SYSROOT/lib | portable | c index corpus batches/1 x87_refused
ppc64le        | powerpc64le-linux-gnu | qemu-ppc64le -L SYSROOT  | portable                  | c index corpus batches/5
riscv64        | riscv64-linux-gnu     | qemu-riscv64 -L SYSROOT  | portable                  | c index corpus batches/5
s390x          | s390x-linux-gnu       | qemu-s390x -L SYSROOT    | portable                  | c index corpus batches/5
nehalem        | gcc-release           | qemu-x86_64 -cpu Nehalem | sse2             | c index corpus batches/5
haswell        | gcc-release           | qemu-x86_64 -cpu Haswell-noTSX,-pcid,-x2apic,-tsc-deadline,-invpcid | sse2 avx2        | c index corpus batches/5
gcc-debug      | gcc-debug             |                          | sse2 avx2 avx512 |
clang-release  | clang-release         |                          | sse2 avx2 avx512 | c
clang-debug    | clang-debug           |                          | sse2 avx2 avx512 |
musl           | musl                  |                          | sse2 avx2 avx512 | c no_libstdcxx
windows        | windows               | wine                     | sse2 avx2 avx512 | c corpus batches/1 dll/vesica,vesica.map dll/vesica-methods,methods.map zip
'

# Debian packages, CMake arguments of a build.
settings() {
  case $1 in
    gcc-release) packages=(qemu-user) arguments=(-DCMAKE_BUILD_TYPE=Release) ;;
    gcc-debug) packages=() arguments=(-DCMAKE_BUILD_TYPE=Debug) ;;
    clang-*)
      packages=(clang lld)
      arguments=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ "-DCMAKE_BUILD_TYPE=${1#clang-}"
        -DCMAKE_SHARED_LINKER_FLAGS=-fuse-ld=lld -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld)
      ;;
    musl)
      packages=(musl-tools)
      arguments=("-DCMAKE_TOOLCHAIN_FILE=$root/packaging/linux/musl.cmake" -DVESICA_CROSS_NO_LIBSTDCXX=ON -DCMAKE_BUILD_TYPE=Release)
      ;;
    windows)
      packages=(g++-mingw-w64-x86-64 wine wine64 zip)
      arguments=("-DCMAKE_TOOLCHAIN_FILE=$root/packaging/windows/mingw.cmake" -DVESICA_INSTALL=ON
        -DCMAKE_EXE_LINKER_FLAGS=-static -DCMAKE_BUILD_TYPE=Release)
      ;;
    *)
      packages=("g++-$1" qemu-user)
      arguments=("-DCMAKE_TOOLCHAIN_FILE=$here/linux.cmake" "-DVESICA_TRIPLET=$1" -DCMAKE_BUILD_TYPE=Release)
      [ "$1" != i686-linux-gnu ] || arguments+=("-DCMAKE_C_FLAGS=-msse2 -mfpmath=sse" "-DCMAKE_CXX_FLAGS=-msse2 -mfpmath=sse")
      ;;
  esac
}

# Nothing but these rows compiles neon, the DLL and musl, so warnings count.
compile() {
  local packages arguments log=$folder.log targets=(vesica vesica_methods near_tie_hash vectors demo)
  settings "$build"
  case $checks in *index* | *batches*) arguments+=(-DVESICA_CROSS_GOOGLETEST=/usr/src/googletest) ;; esac
  case $checks in *index*) targets+=(index_bytes_test) ;; esac
  case $checks in *batches*) targets+=(corpus_test batch_test) ;; esac
  need g++ cmake ninja-build googletest "${packages[@]}"
  mkdir -p "$root/build"
  if ! { cmake -S "$here" -B "$folder" -G Ninja -DVESICA_DEVELOPER=ON "${arguments[@]}" &&
    cmake --build "$folder" --target "${targets[@]}"; } >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    return 1
  fi
}

# program NAME ARGUMENT...: a program of this row's build.
program() {
  local file=$folder/$1
  [ -e "$file" ] || file+=.exe
  "${emulator[@]}" "$file" "${@:2}"
}

# Programs for Windows end lines their own way.
say() {
  tr -d '\r' | while read -r line; do echo "$name: $line"; done
}

symbols() {
  local nm unoptimised=()
  case $build in *-debug) unoptimised=(--unoptimised) ;; esac
  nm=$(sed -n 's/^CMAKE_NM:FILEPATH=//p' "$folder/CMakeCache.txt")
  find "$folder" -path '*/isa/*.o*' -print0 | xargs -0 "$root/tests/batch/isa_symbols.sh" "${unoptimised[@]}" "$nm" | say
}

# Whatever the linker, the library exports what its map lists. check_dll does this for Windows.
exports() {
  [ "$build" != windows ] || return 0
  "$root/tests/abi/exported_names.sh" nm "$folder/libvesica.so" "$root/capi/vesica.map" | say || return 1
  "$root/tests/abi/exported_names.sh" nm "$folder/libvesica-methods.so" "$root/capi/methods.map" | say
}

# The sets by name; but where the processor is given, the last one is for the library to choose by itself.
hashes() {
  local set output status
  for set in $sets; do
    status=0
    output=$(
      export VESICA_ISA=$set
      if given_processor && [ "$set" = "${sets##* }" ]; then unset VESICA_ISA; fi
      program near_tie_hash
    ) || status=$?
    say <<<"$output"
    [ $status != 77 ] || given_processor || continue
    [ $status = 0 ] || return 1
    [ "${output%%:*}" = "$set" ] || { echo "$name: took ${output%%:*}, not $set" >&2; return 1; }
  done
}

given_processor() {
  [ "$run_by" != "" ] && [ "$run_by" != wine ]
}

check_c() {
  program vectors "$root/bindings/vectors/vectors.txt" | say || return 1
  (cd "$folder" && program demo -o demo.svg "$root/tests/corpus/cases.csv") | tail -n 1 | say || return 1
}

# The bytes of indexes and the order of pairs, by each instruction set. A join in parts is the same work many times over.
check_index() {
  local set output
  for set in $sets; do
    output=$(VESICA_ISA=$set program index_bytes_test --gtest_brief=1 '--gtest_filter=-*.PartsAndCapacities') ||
      { tail -n 60 <<<"$output" >&2; return 1; }
    tail -n 1 <<<"$output" | sed "s/^/$set: index: /" | say
  done
}

check_corpus() {
  program corpus_test --gtest_brief=1 | tail -n 1 | say
}

# Tests of guard pages end in a segmentation fault on purpose: what they print is for the failure alone.
check_batches() {
  local output
  output=$(GTEST_TOTAL_SHARDS=$1 GTEST_SHARD_INDEX=0 program batch_test --gtest_brief=1 2>&1) ||
    { tail -n 60 <<<"$output" >&2; return 1; }
  grep -E '^\[ +(PASSED|SKIPPED) +\]' <<<"$output" | say
}

# x87's extra precision is refused by the compiler, and the message says what to do.
check_x87_refused() {
  local flags complaint
  for flags in '' -mfpmath=387 -msse; do
    # shellcheck disable=SC2086
    if complaint=$(i686-linux-gnu-g++ -std=c++20 $flags "-I$root/include" -fsyntax-only -x c++ - 2>&1 \
      <<<'#include <vesica/overlap.hpp>'); then
      echo "$name: '$flags' is not refused" >&2
      return 1
    fi
    grep -q 'on 32-bit x86 compile with -msse2 -mfpmath=sse' <<<"$complaint" || { echo "$complaint" >&2; return 1; }
  done
  echo "$name: x87 is refused"
}

# The libraries need musl's libc and nothing else.
check_no_libstdcxx() {
  local library needed
  for library in libvesica libvesica-methods; do
    needed=$(readelf -d "$folder/$library.so" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
    [ "$needed" = libc.so ] || { echo "$name: $library needs $needed" >&2; return 1; }
  done
}

# check_dll LIBRARY,MAP: the DLL exports the names of the version script and nothing else, and imports from the system
# alone.
check_dll() {
  local headers listed foreign dll=$folder/${1%,*}.dll
  headers=$(x86_64-w64-mingw32-objdump -p "$dll") || return 1
  listed=$(sed -n 's/^ *\(vesica_[a-z0-9_]*\);$/\1/p' "$root/capi/${1#*,}" | sort)
  [ -n "$listed" ] || return 1
  diff <(sed -n '/^\[Ordinal\/Name Pointer\]/,/^$/s/.* \(vesica_[a-z0-9_]*\)$/\1/p' <<<"$headers" | sort) \
    <(echo "$listed") || return 1
  foreign=$(sed -n 's/.*DLL Name: //p' <<<"$headers" | grep -Fvx -e KERNEL32.dll -e msvcrt.dll || true)
  [ -z "$foreign" ] || { echo "$name: $dll needs $foreign" >&2; return 1; }
  echo "$name: $(wc -l <<<"$listed") names in $(basename "$dll")"
}

# The zip, made of what was tested: a program elsewhere finds it by CMake, and runs beside the DLL.
check_zip() {
  local work=$folder/zip consumer=$root/tests/install/consumer program
  rm -rf "$work"
  "$root/packaging/windows/build.sh" "$work" "$folder" || return 1
  (cd "$work" && cmake -E tar xf ./*.zip && mv vesica-*/ unpacked) || return 1
  { cmake -S "$consumer" -B "$work/consumer" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$root/packaging/windows/mingw.cmake" \
    "-Dvesica_DIR=$work/unpacked/lib/cmake/vesica" -DCMAKE_EXE_LINKER_FLAGS=-static && cmake --build "$work/consumer"; } >"$work/log" 2>&1 ||
    { tail -n 20 "$work/log" >&2; return 1; }
  for program in c_user methods_user cpp_user core_user; do
    WINEPATH="Z:$work/unpacked/bin" wine "$work/consumer/$program.exe" || { echo "$name: $program fails" >&2; return 1; }
  done
  [ -s "$work/unpacked/LICENSE.txt" ] || return 1
  echo "$name: the zip's CMake package, by four programs"
}

row() {
  local check folder=$root/build/cross-$build emulator
  read -r -a emulator <<<"${run_by//SYSROOT//usr/$build}"
  compile && symbols && hashes && exports || return 1
  for check in $checks; do
    case $check in
      */*) "check_${check%/*}" "${check#*/}" || return 1 ;;
      *) "check_$check" || return 1 ;;
    esac
  done
}

wanted() {
  [ $# -gt 1 ] || return 0
  case " ${*:2} " in *" $1 "*) return 0 ;; *) return 1 ;; esac
}

trim() {
  sed 's/^ *//; s/ *$//' <<<"$1"
}

# Elapsed time, and processors' time, which another load on the machine does not lengthen.
TIMEFORMAT='  %1lR, of processors %1lU'

main() {
  local name build run_by sets checks failures=0 rows=0 result quick=''
  if [ "${1:-}" = --quick ]; then
    quick=yes
    shift
  fi
  while IFS='|' read -r name build run_by sets checks; do
    name=$(trim "$name") build=$(trim "$build") run_by=$(trim "$run_by") sets=$(trim "$sets")
    case $name in '' | '#'*) continue ;; esac
    wanted "$name" "$@" || continue
    [ -z "$quick" ] || checks=$(sed -E 's#corpus|batches/[0-9]+##g' <<<"$checks")
    rows=$((rows + 1))
    # A fault ends the row, not the table. Nothing of a row reads the table.
    if time row </dev/null; then result=passed; else result=FAILED failures=$((failures + 1)); fi
    printf 'platforms: %-14s %s\n' "$name" $result
  done <<<"$table"
  [ $rows -gt 0 ] || { echo 'platforms: no such row' >&2; exit 2; }
  [ $failures = 0 ] || exit 1
  echo "platforms: $rows rows passed"
}

main "$@"
exit
