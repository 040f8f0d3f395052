#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package.sh DIRECTORY: the Debian package postgresql-15-vesica into DIRECTORY, built against libvesica-dev of this tree.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The library as its own packages have it; it is not installed here.
dpkg-deb -x "$out"/libvesica0_*.deb "$work/library"
dpkg-deb -x "$out"/libvesica-dev_*.deb "$work/library"
PKG_CONFIG_PATH=$(dirname "$(find "$work/library" -name vesica.pc)")
export PKG_CONFIG_PATH PKG_CONFIG_SYSROOT_DIR=$work/library
library=$(dpkg-deb -f "$out"/libvesica0_*.deb Version)

cp -r "$here/../common" "$here" "$work"
make -s -C "$work/postgresql" with_llvm=no RPATH= install "DESTDIR=$work/package"
strip --strip-unneeded "$work"/package/usr/lib/postgresql/15/lib/vesica.so
install -D -m 644 "$here/README.md" "$work/package/usr/share/doc/postgresql-15-vesica/README.md"
install -D -m 644 "$here/../../packaging/debian/copyright" "$work/package/usr/share/doc/postgresql-15-vesica/copyright"
mkdir "$work/package/DEBIAN"
cat >"$work/package/DEBIAN/control" <<CONTROL
Package: postgresql-15-vesica
Version: $library
Architecture: $(dpkg --print-architecture)
Section: database
Priority: optional
Maintainer: $(dpkg-deb -f "$out"/libvesica0_*.deb Maintainer)
Depends: postgresql-15, libvesica0 (>= $library), libc6
Description: exact overlap queries between plain 2D shapes, for PostgreSQL
 The type vshape for points, segments, circles, boxes, rotated rectangles and
 ellipses, with operators, an index for overlap, containment and the nearest
 shapes, and a join. CREATE EXTENSION vesica.
CONTROL
dpkg-deb --root-owner-group --build "$work/package" "$out" >/dev/null
ls "$out"/postgresql-15-vesica_*.deb
