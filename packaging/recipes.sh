#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# recipes.sh TAR OUT: copies the recipes of vcpkg, Conan, conda-forge and Homebrew to OUT, with the checksums of the tar
# of the sources in place of the zeros that they have here.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# = 2 ] || { echo 'usage: recipes.sh TAR OUT' >&2; exit 2; }
sha256=$(sha256sum "$1" | cut -d ' ' -f 1)
sha512=$(sha512sum "$1" | cut -d ' ' -f 1)
rm -rf "$2"
mkdir -p "$2"
cp -r "$root"/packaging/{vcpkg,conan,conda,homebrew} "$2"
sed -i "s/0\{64\}/$sha256/" "$2"/{conan/conandata.yml,conda/meta.yaml,homebrew/vesica.rb}
sed -i "s/SHA512 0$/SHA512 $sha512/" "$2/vcpkg/portfile.cmake"
[ "$(grep -rlE "$sha256|$sha512" "$2" | wc -l)" = 4 ] || { echo 'recipes.sh: a recipe has no place for the checksum' >&2; exit 1; }
echo "$2"
