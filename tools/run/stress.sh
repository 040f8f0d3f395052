# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Attacks the library with random pairs at contact, and holds every answer against its laws.
#
#   ./run stress [N]         N pairs, a million by default
#   ./run stress --help      lists options

[ "${1:-}" = --help ] && exec 3>/dev/null || exec 3>&2
{
  need "${test_packages[@]}"
  build test vesica_stress
} >&3
[ "${1:-}" = --help ] || set -- "$@" --known "$root/tools/stress/known_faults.txt"
"$root/build/test/tools/stress/vesica_stress" "$@"
