#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# source.sh OUT: writes OUT/vesica-<version>.tar.gz of the last commit's files, and prints it. One commit gives the same
# bytes each time.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# = 1 ] || { echo 'usage: source.sh OUT' >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
name=vesica-$(sed -n 's/^project(vesica VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
git -C "$root" -c tar.umask=0022 archive --format=tar --prefix="$name/" HEAD | gzip -9n >"$out/$name.tar.gz"
echo "$out/$name.tar.gz"
