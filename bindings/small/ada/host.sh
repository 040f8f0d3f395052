# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Ada 2012, by Interfaces.C.
build() {
  gnatmake -q -gnat2012 -gnatwae -gnaty3M120 -D "$work" -o "$work/vectors" "$host/vectors.adb" -largs "${flags[@]}"
}
run() { "$work/vectors" "$1"; }
