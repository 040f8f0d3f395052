#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# dump.sh ABIDW LIBRARY OUTPUT: writes the ABI of the library, which holds debug information, as abidw sees it.
# Only what a caller sees is written: types that the headers in ../include declare, and none of what depends on
# the place, the machine or the compiler (paths, lines, architecture). Type numbers are hashes, so that a refreshed
# baseline differs from the old one only where the ABI does.
set -euo pipefail

[ $# = 3 ] || { echo "usage: dump.sh ABIDW LIBRARY OUTPUT" >&2; exit 1; }
command -v "$1" >/dev/null || { echo "dump: no abidw ('$1'; Debian: abigail-tools): nothing can be written" >&2; exit 1; }
headers=$(cd "$(dirname "${BASH_SOURCE[0]}")/../include" && pwd)
"$1" --headers-dir "$headers" --drop-private-types --exported-interfaces-only --no-architecture --no-corpus-path --no-comp-dir-path --no-show-locs \
  --no-elf-needed --type-id-style hash --out-file "$3" "$2"
