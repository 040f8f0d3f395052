#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# c_only.sh NM READELF LIBRARY: seen from outside, the library is C. It exports no mangled name, asks for none and for
# nothing of a C++ runtime, and needs libc and libm alone.
set -euo pipefail

fail() {
  echo "c_only: $1" >&2
  exit 1
}

[ $# = 3 ] || fail "usage: c_only.sh NM READELF LIBRARY"
command -v "$1" >/dev/null || fail "no nm ('$1'): nothing can be checked"
command -v "$2" >/dev/null || fail "no readelf ('$2'): nothing can be checked"
names=$("$1" -D "$3" | awk '{print $NF}')
grep -q '^vesica_[a-z0-9_]*@' <<<"$names" || fail "$3 exports no vesica_...: not the library"
# __cxa_finalize and __cxa_atexit are libc's; every other __cxa_ and every _Unwind_ is of a C++ runtime.
if grep -E '^_Z|^__cxa_|^__gxx|^_Unwind_' <<<"$names" | grep -Ev '^__cxa_(finalize|atexit)(@|$)'; then
  fail "these names are C++"
fi
needed=$("$2" -dW "$3" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p')
[ -n "$needed" ] || fail "readelf shows no needed library, not even libc"
if grep -Ev '^lib[cm]\.so(\.[0-9]+)?$' <<<"$needed"; then
  fail "these libraries are needed beside libc and libm"
fi
echo "no C++ name; needs ${needed//$'\n'/ }"
