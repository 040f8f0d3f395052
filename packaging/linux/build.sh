#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh OUT [TARGET...]: builds the library for each target (targets.sh; all four unless told) and packs it into OUT
# (pack.sh). Then, elsewhere, programs in C are compiled against what was packed, by pkg-config and by CMake, and give
# the answers that bindings are tested with, and vesica-join finds pairs: on this processor, or under qemu-user.
# shellcheck disable=SC2154
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)

# check TARGET FILE: the programs against the packed file.
check() {
  # shellcheck source=/dev/null
  . "$root/packaging/linux/targets.sh" "$1"
  local work consumer=$root/tests/install/consumer prefix flags
  work=$(mktemp -d)
  # shellcheck disable=SC2064
  trap "rm -rf '$work'" EXIT
  tar -C "$work" -xf "$2"
  prefix=$(echo "$work"/vesica-*)

  cmake -S "$consumer" -B "$work/build" -G Ninja "${toolchain[@]}" "-Dvesica_DIR=$prefix/lib/cmake/vesica" >"$work/log"
  cmake --build "$work/build" --target c_user methods_user >>"$work/log"
  for program in c_user methods_user; do run "$prefix/lib" "$work/build/$program"; done

  read -r -a flags < <(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs vesica)
  local compiler=("$processor-linux-gnu-gcc")
  [ "$libc" = gnu ] || compiler+=("-specs=$work/build/musl-gcc.specs")
  "${compiler[@]}" -std=c99 -O2 -o "$work/vectors" "$root/bindings/small/c/vectors.c" "${flags[@]}" -lm
  run "$prefix/lib" "$work/vectors" "$root/bindings/vectors/vectors.txt"

  printf 'id,cx,cy,r\na,0,0,1\nb,2,0,1\n' >"$work/circles.csv"
  [ "$("${emulator[@]}" "$prefix/bin/vesica-join" --threads 3 --quiet --no-header --id id "$work/circles.csv")" = a,b ]
}

built=$("$root/packaging/linux/library.sh" "${@:2}")
while read -r target tree; do
  program=$("$root/packaging/linux/program.sh" "${target%-*}" </dev/null)
  packed=$("$root/packaging/linux/pack.sh" "$tree" "$target" "$out" "$program")
  (check "$target" "$packed") </dev/null
  echo "$packed"
done <<<"$built"
