# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Searches for the slowest input of every query and pair of kinds.
#
#   ./run slowest [SECONDS [QUERY [KIND KIND]]]       each search takes so long, 10 seconds by default
#   ./run slowest --replay FILE                       times inputs found before: tools/slowest/slowest.txt

{
  need "${test_packages[@]}"
  build test vesica_slowest
} >&2
"$root/build/test/tools/slowest/vesica_slowest" "$@"
