# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Checks all C and C++ by clang-format, for words that comments do without, and by clang-tidy.
#
#   ./run lint               checks
#   ./run lint --fix         formats

need "${lint_packages[@]}"
case "$*" in
  "")
    "$root/tools/lint/format.sh"
    "$root/tools/lint/words.sh"
    "$root/tools/lint/tidy.sh"
    ;;
  --fix) "$root/tools/lint/format.sh" --fix ;;
  *) fail "lint takes --fix or nothing" ;;
esac
