# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Tcl, by a small extension in C (Debian: tcl-dev).
build() {
  local tcl
  read -ra tcl < <(pkg-config --cflags --libs tcl)
  "$CC" -std=c99 -O2 -fPIC -shared -Wall -Wextra -Wshadow -Werror -DUSE_TCL_STUBS -o "$work/libvesica_tcl.so" \
    "$host/vesica_tcl.c" "${tcl[@]}" "${flags[@]}"
}
run() { tclsh "$host/vectors.tcl" "$work/libvesica_tcl.so" "$1"; }
