#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# date.sh: prints the release's date in seconds since 1970. All packages take it for SOURCE_DATE_EPOCH, so that one tree
# always gives the same bytes.
set -euo pipefail
citation=$(dirname "${BASH_SOURCE[0]}")/../CITATION.cff
date -u -d "$(sed -n 's/^date-released: //p' "$citation")" +%s
