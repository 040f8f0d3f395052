# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Builds packages into build/package.
#
#   ./run package            the Debian packages
#   ./run package NAME       csharp, go, java, javascript or rust: the package for that language, tested in a fresh
#                            folder or environment. Those of csharp and java are for the four systems of c
#   ./run package c          tars of the library for Linux: x86_64 and aarch64, for glibc 2.17 or later and for musl
#   ./run package python     wheels for the same four, for Python 3.9 and later
#   ./run package wheel      the wheel for this machine alone, in a minute
#   ./run package postgresql the Debian packages, and that of the extension for PostgreSQL 15
#   ./run package source     the tar of the last commit's files, and recipes with its checksums
#   ./run package windows    the zip for Windows

out=$root/build/package
case "$*" in
  "")
    need "${debian_packages[@]}"
    step 'build Debian packages' packaging/debian/build.sh "$out"
    ;;
  c)
    need "${linux_packages[@]}"
    step 'build for Linux' packaging/linux/build.sh "$out"
    ;;
  csharp | java)
    # shellcheck disable=SC2178
    declare -n packages=$1_packages
    need "${packages[@]}" "${linux_packages[@]}"
    step 'build libraries' packaging/linux/library.sh
    export VESICA_TREES=$root/build/linux VESICA_SHARED=$root/build/linux/$(uname -m)-gnu/capi
    step "build and test $1" "bindings/$1/build.sh" "$out"
    ;;
  go | javascript | rust)
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
  python)
    need "${python_packages[@]}" "${linux_packages[@]}"
    step 'build and test wheels' bindings/python/wheels.sh "$out"
    ;;
  wheel)
    need "${python_packages[@]}"
    build_and_install
    VESICA_BUILD=$root/build/release step 'build the wheel' bindings/python/wheel.sh "$out"
    ;;
  source)
    step 'pack the sources' packaging/source.sh "$out"
    tars=("$out"/vesica-*[0-9].tar.gz)
    step 'write recipes' packaging/recipes.sh "${tars[-1]}" "$out/recipes"
    ;;
  windows)
    need "${windows_packages[@]}"
    step 'build for Windows' packaging/windows/build.sh "$out"
    ;;
  *) fail "package takes c, csharp, go, java, javascript, postgresql, python, rust, source, wheel, windows or nothing" ;;
esac
echo "packages: $out"
