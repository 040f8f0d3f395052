#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# wheel.sh DIRECTORY [PLATFORM]: builds the wheel into DIRECTORY, and prints it. One tree gives the same bytes each time.
# VESICA_BUILD names a build folder of cmake's whose library is taken. PLATFORM is that library's, such as
# musllinux_1_2_x86_64; by default it is this machine's own: a Linux with glibc 2.17 or later, whose symbols are checked.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
[ -z "${VESICA_BUILD:-}" ] || VESICA_BUILD=$(cd "$VESICA_BUILD" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
processor=$(uname -m)
platform=${2:-manylinux_2_17_$processor.manylinux2014_$processor}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
umask 022
SOURCE_DATE_EPOCH=$("$root/packaging/date.sh")
export SOURCE_DATE_EPOCH VESICA_PLATFORM=$platform PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INDEX=1

# The sources are built from a copy: setuptools writes beside them.
mkdir "$work/repository"
tar -C "$root" --exclude=./build --exclude=./.git --exclude=__pycache__ -cf - . | tar -C "$work/repository" -xf -
/usr/bin/python3 -m pip wheel --quiet --no-build-isolation --no-deps -w "$work" "$work/repository/bindings/python" >&2

(cd "$work" && /usr/bin/python3 -m zipfile -e vesica-*.whl unpacked)
library=$work/unpacked/vesica/libvesica.so.0
"$root/tests/abi/c_only.sh" "${NM:-nm}" readelf "$library" >&2
case $platform in manylinux_2_17_*) "$root/tests/abi/c_library.sh" "${NM:-nm}" "$library" >&2 ;; esac
mv "$work"/vesica-*.whl "$directory"
ls "$directory"/vesica-*-"$platform.whl"
