#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package_test.sh WORK: the Debian packages of this tree. Takes some minutes; needs what
# `./run package` installs, and lintian, man-db and pkg-config.
#   - with VESICA_TWICE=1: two builds in folders of different names and depths give the same packages, byte for byte
#   - lintian has nothing to say, pedantry and experiments included, and nothing is overridden
#   - every exported function has a manual page, and groff has no warning about any
#   - unpacked under another root: pkg-config, CMake, a C program and vesica-join
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# = 1 ] || { echo 'usage: package_test.sh WORK' >&2; exit 2; }
for tool in lintian man pkg-config cmake dpkg-buildpackage; do
  command -v "$tool" >/dev/null || { echo "package_test: $tool is missing" >&2; exit 2; }
done
rm -rf "$1"
mkdir -p "$1"
work=$(cd "$1" && pwd)

fail() {
  echo "package_test: $1" >&2
  exit 1
}

step() {
  echo "[$SECONDS s] $1"
}

step 'build'
first=$work/first second=$work/another/place
"$root/packaging/debian/build.sh" "$first"
if [ "${VESICA_TWICE:-0}" = 1 ]; then
  step 'build again'
  # That of the source package: of the same files, whatever happens to the tree meanwhile.
  dpkg-source --no-check -x "$first"/*.dsc "$work/source" >/dev/null
  "$work/source/packaging/debian/build.sh" "$second"
  (cd "$first" && sha256sum ./*.deb ./*.tar.xz) | tee "$work/sums"
  (cd "$second" && sha256sum --check "$work/sums") || fail 'the second build is not the first'
fi

step 'lintian'
# The programs in examples/ are built by ./run, and not installed. bindings/calls/calls.txt has a call a
# line, some of them with whole arrays.
lintian -EviI --pedantic --show-overrides --fail-on error,warning,info,pedantic,experimental,override \
  --suppress-tags package-does-not-install-examples,very-long-line-length-in-source-file \
  "$first"/*.changes | tee "$work/lintian"
if grep -v '^N: ' "$work/lintian"; then fail 'lintian has something to say'; fi

step 'unpack'
unpacked=$work/root
for package in "$first"/libvesica0_*.deb "$first"/libvesica-dev_*.deb "$first"/vesica-tools_*.deb; do dpkg-deb -x "$package" "$unpacked"; done
libdir=$(dirname "$(find "$unpacked" -name libvesica.so)")
[ -n "$(find "$unpacked/usr/lib" -path "*/$(dpkg-architecture -q DEB_HOST_MULTIARCH)/libvesica.so.0")" ] ||
  fail 'the library is not in the multiarch folder'

readme=$unpacked/usr/share/doc/libvesica-dev/README.md
compgen -G "$readme*" >/dev/null || fail 'there is no README'
if zcat -f "$readme"* | grep '](' | grep -v '](https\?:'; then fail 'the README has links that lead nowhere'; fi

step 'manual'
pages=$unpacked/usr/share/man/man3
nm -D --defined-only "$libdir/libvesica.so.0" "$libdir/libvesica-methods.so.0" | awk '$2 == "T" { sub("@.*", "", $3); print $3 }' | sort >"$work/names"
for name in vesica_overlap_f64 vesica_method_rect_corners_f64; do
  grep -qx "$name" "$work/names" || fail "$name is not exported"
done
while read -r name; do
  [ -e "$pages/$name.3.gz" ] || fail "$name has no manual page"
done <"$work/names"
for page in "$pages"/* "$unpacked"/usr/share/man/man1/vesica-join.1.gz; do
  complaint=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
  [ -z "$complaint" ] || fail "$page: $complaint"
done

step 'pkg-config'
export PKG_CONFIG_PATH=$libdir/pkgconfig
flags=$(pkg-config --cflags --libs vesica | sed 's/ *$//')
[ "$flags" = -lvesica ] || fail "pkg-config says '$flags'"
methods=$(pkg-config --cflags --libs vesica-methods | sed 's/ *$//')
[ "$methods" = '-lvesica-methods -lvesica' ] || fail "pkg-config says '$methods' of the named methods"
export LD_LIBRARY_PATH=$libdir
cc -std=c99 -Wall -Wextra -Werror -isystem "$unpacked/usr/include" -o "$work/c_user" \
  "$root/tests/install/consumer/c_user.c" -L"$libdir" "$flags"
"$work/c_user"

step 'vesica-join'
program=$unpacked/usr/bin/vesica-join
if readelf -d "$program" | grep -E 'RPATH|RUNPATH'; then fail 'the program names a place of its own for the library'; fi
printf 'id,cx,cy,r\na,0,0,1\nb,2,0,1\n' >"$work/circles.csv"
[ "$("$program" --quiet --no-header --id id "$work/circles.csv")" = a,b ] || fail 'vesica-join does not find the pair'

step 'find_package'
cmake -S "$root/tests/install/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$unpacked/usr" >"$work/consumer.log"
grep -F "vesica_DIR:PATH=$libdir/cmake/vesica" "$work/consumer/CMakeCache.txt" >/dev/null || fail 'CMake found another'
cmake --build "$work/consumer" >>"$work/consumer.log"
for program in c_user methods_user cpp_user core_user; do "$work/consumer/$program"; done

step 'passed'
