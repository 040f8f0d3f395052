# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Free Pascal.
build() {
  fpc -v0ew -Sewn -O1 "-FE$work" "-FU$work" "-Fl$(pkg-config --variable=libdir vesica)" "$host/vectors.pas"
}
run() { "$work/vectors" "$1"; }
