#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# reproducible_test.sh BUILD WORK: the tar for Linux and the wheel, of the library in the build folder BUILD, and the tar
# of the sources are packed twice, the second time with another umask and another zone of time: the bytes are the same.
# A program in C is compiled against the tar, and the wheel says that any Python from 3 on will do.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$1 work=$2
rm -rf "$work"
mkdir -p "$work"

pack() {
  "$root/packaging/linux/pack.sh" "$build" here "$work/$1"
  VESICA_BUILD=$build "$root/bindings/python/wheel.sh" "$work/$1"
  # Not in what was unpacked from a tar of the sources, which is no clone.
  [ ! -e "$root/.git" ] || "$root/packaging/source.sh" "$work/$1"
}
pack first
(umask 077 && TZ=Pacific/Auckland pack second)
diff -r "$work/first" "$work/second"

tar -C "$work" -xf "$work"/first/vesica-*-linux-here.tar.gz
prefix=$(echo "$work"/vesica-*-linux-here)
cc -std=c99 -o "$work/c_user" "$root/tests/install/consumer/c_user.c" -I "$prefix/include" -L "$prefix/lib" -lvesica
LD_LIBRARY_PATH=$prefix/lib "$work/c_user"
[ -s "$prefix/LICENSE" ] && [ -s "$prefix/share/vesica/vesica.spdx.json" ]
wheel=$(echo "$work"/first/vesica-*-py3-none-manylinux_2_17_*.whl)
/usr/bin/python3 -m zipfile -l "$wheel" | grep -F .dist-info/sboms/vesica.spdx.json
