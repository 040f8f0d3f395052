#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# c_library.sh NM LIBRARY: the library runs with any glibc since 2.17, as the wheels promise: no symbol that it asks for
# has a newer version.
set -euo pipefail

fail() {
  echo "c_library: $1" >&2
  exit 1
}

[ $# = 2 ] || fail "usage: c_library.sh NM LIBRARY"
command -v "$1" >/dev/null || fail "no nm ('$1'): nothing can be checked"
oldest=2.17
asked=$("$1" -D --undefined-only "$2" | sed -n 's/.* \([^ ]*@GLIBC_[0-9.]*\)$/\1/p')
[ -n "$asked" ] || fail "$2 asks for no symbol of glibc: not the library, or not of glibc"
newest=$(sed 's/.*@GLIBC_//' <<<"$asked" | sort -V | tail -n 1)
if [ "$(printf '%s\n' "$newest" "$oldest" | sort -V | tail -n 1)" != "$oldest" ]; then
  grep "@GLIBC_$newest\$" <<<"$asked"
  fail "these symbols need glibc $newest, and the oldest that is promised is $oldest"
fi
echo "$(wc -l <<<"$asked") symbols of glibc, the newest of $newest"
