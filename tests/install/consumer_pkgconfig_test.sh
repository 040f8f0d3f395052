#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# consumer_pkgconfig_test.sh MOVED WORK: programs in C and C++ built by pkg-config against the moved install.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

# The version in the file is the header's.
version=$(printf '#include <vesica.h>\nVESICA_VERSION_MAJOR VESICA_VERSION_MINOR VESICA_VERSION_PATCH\n' |
  "$CC" "${flags[@]}" -E -P - | tail -n 1)
[ "$(pkg-config --modversion vesica)" = "${version// /.}" ]

# With an archive libm comes after it; with a shared library alone, only the library itself asks for it.
pkg-config --static --libs vesica | grep -Eq -- '-lvesica .*-lm( |$)'
if [ -n "$(find "$moved" -name libvesica.so)" ]; then
  if pkg-config --libs vesica | grep -qw -- -lm; then exit 1; fi
fi

warnings=(-Wall -Wextra -Wpedantic -Werror)
"$CC" -std=c99 "${warnings[@]}" -o "$work/c_user" "$here/consumer/c_user.c" "${flags[@]}"
"$CXX" -std=c++11 "${warnings[@]}" -o "$work/cpp_user" "$here/consumer/cpp_user.cpp" "${flags[@]}"
# shellcheck disable=SC2162
read -a methods < <(pkg-config --cflags --libs vesica-methods)
"$CC" -std=c99 "${warnings[@]}" -o "$work/methods_user" "$here/consumer/methods_user.c" "${methods[@]}"
# shellcheck disable=SC2162
read -a include < <(pkg-config --cflags vesica)
"$CXX" -std=c++20 "${warnings[@]}" -o "$work/core_user" "$here/consumer/core_user.cpp" "${include[@]}"
for program in c_user methods_user cpp_user core_user; do "$work/$program"; done
