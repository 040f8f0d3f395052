#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pack.sh TREE TARGET OUT [PROGRAM]: writes OUT/vesica-<version>-linux-<target>.tar.gz of what the build folder TREE
# installs, vesica-join as it is in the file PROGRAM, and the licence. It may be unpacked anywhere. One tree gives the
# same bytes each time. Prints the file.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# = 3 ] || [ $# = 4 ] || { echo 'usage: pack.sh TREE TARGET OUT [PROGRAM]' >&2; exit 2; }
mkdir -p "$3"
out=$(cd "$3" && pwd)
version=$(sed -n 's/^project(vesica VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
name=vesica-$version-linux-$2
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cmake --install "$1" --prefix "$stage/$name" --strip >/dev/null
cp "$root/LICENSE" "$stage/$name/LICENSE"
if [ -n "${4:-}" ]; then
  install -D "$4" "$stage/$name/bin/vesica-join"
  install -D -m 644 "$root/programs/join/vesica-join.1" "$stage/$name/share/man/man1/vesica-join.1"
fi
tar -C "$stage" --sort=name --mtime="@$("$root/packaging/date.sh")" --owner=0 --group=0 --numeric-owner \
  --mode=u=rwX,go=rX --format=ustar -cf - "$name" | gzip -9n >"$out/$name.tar.gz"
echo "$out/$name.tar.gz"
