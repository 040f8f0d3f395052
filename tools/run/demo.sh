# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Builds the library, installs it under build/install, and answers real bug reports or a scene of yours.
#
#   ./run                   answers tests/corpus/cases.csv with the C program of examples/demo
#   ./run SCENE             answers a scene file, such as examples/demo/example.scene
#   ./run --table [SCENE]   prints every answer in a table

table=()
if [ "${1:-}" = --table ]; then
  table=(--table)
  shift
fi
[ $# -le 1 ] || fail "one scene file at a time"
scene=${1:-$root/tests/corpus/cases.csv}
[ -e "$scene" ] || fail "'$scene' is not a file"
build_and_install
answer "$scene" "${table[@]}"
