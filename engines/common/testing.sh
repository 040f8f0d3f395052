# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# To be sourced by an engine's test, after prefix.sh: it has the shapes that data.sh drew in $data, and says what is
# wrong. `finish` ends a test.
common=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
data=${VESICA_ENGINES_DATA:?"the folder of data.sh"}
export LC_ALL=C
failures=0

check() {
  [ "$2" = "$3" ] && return
  printf '%s is\n%s\nand should be\n%s\n' "$1" "$3" "$2"
  failures=$((failures + 1))
}

# same_pairs WHAT FILE...: the pairs in these files are exactly those of one machine.
same_pairs() {
  check "$1" "$(cat "$common/expected.txt")" "$("$common/pairs.sh" "${@:2}")"
}

# contains WHAT TEXT OUTPUT
contains() {
  [[ $3 == *"$2"* ]] || check "$1" "text with '$2'" "$3"
}

finish() {
  [ $failures = 0 ] || exit 1
  echo "$(cat "$common/expected.txt"): the pairs of one machine"
}
