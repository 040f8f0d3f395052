# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# C, by the installed header.
build() {
  "$CC" -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -o "$work/vectors" "$host/vectors.c" "${flags[@]}"
}
run() { "$work/vectors" "$1"; }
