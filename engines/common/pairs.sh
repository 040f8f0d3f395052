#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pairs.sh FILE...: how many pairs `a,b` the files hold together, and the SHA-256 of these lines, sorted by number.
set -euo pipefail
export LC_ALL=C
sorted=$(mktemp)
trap 'rm -f "$sorted"' EXIT
sort -t, -k1,1n -k2,2n "$@" >"$sorted"
echo "$(wc -l <"$sorted") $(sha256sum <"$sorted" | cut -c1-64)"
