# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# C++20, by the installed header.
build() {
  "$CXX" -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -o "$work/vectors" "$host/vectors.cpp" "${flags[@]}"
}
run() { "$work/vectors" "$1"; }
