#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# copy_tests.sh FOLDER: copies the tests there, and the pages and answers that they read, away from the sources.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cp -r "$here/tests" "$1"
cp "$here/README.md" "$here/../vectors/vectors.txt" "$here/../calls/calls.txt" \
  "$here"/../../docs/{cookbook,detection,planning}.md "$1"
