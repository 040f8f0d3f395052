# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Builds packages into build/package.
#
#   ./run package            the Debian packages
#   ./run package NAME       csharp, go, java, javascript, python or rust: the package for that language, tested in a
#                            fresh folder or environment
#   ./run package postgresql the Debian packages, and that of the extension for PostgreSQL 15
#   ./run package windows    the zip for Windows

out=$root/build/package
case "$*" in
  "")
    need "${debian_packages[@]}"
    step 'build Debian packages' packaging/debian/build.sh "$out"
    ;;
  csharp | go | java | javascript | python | rust)
    # shellcheck disable=SC2178
    declare -n packages=$1_packages
    need "${packages[@]}"
    step "build and test $1" "bindings/$1/build.sh" "$out"
    ;;
  postgresql)
    need "${debian_packages[@]}" "${engine_packages[@]}"
    step 'build Debian packages' packaging/debian/build.sh "$out"
    step 'build the extension' engines/postgresql/package.sh "$out"
    ;;
  windows)
    need "${windows_packages[@]}"
    step 'build for Windows' packaging/windows/build.sh "$out"
    ;;
  *) fail "package takes csharp, go, java, javascript, postgresql, python, rust, windows or nothing" ;;
esac
echo "packages: $out"
