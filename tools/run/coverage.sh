# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Lists the lines, branches and conditions (MC/DC, by Clang 19) of the library that the tests reach.
#
#   ./run coverage [TEST]... by all tests, or by the named ones; tools/coverage/README.md

"$root/tools/coverage/coverage.sh" "$@"
