# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Finds all pairs of shapes that overlap in one or two files: vesica-join, built and installed.
#
#   ./run join A.csv B.csv >pairs.csv
#   ./run join --help                   lists file formats and questions

[ $# -gt 0 ] || fail "join takes one or two files of shapes"
# Standard output is the program's alone. With --help it says nothing else on standard error either.
[[ " $* " = *" --help "* ]] && exec 3>/dev/null || exec 3>&2
build_and_install >&3
"$prefix/bin/vesica-join" "$@"
