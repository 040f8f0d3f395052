#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# servers_test.sh PACKAGE WORK: the packed package in the folder PACKAGE, installed into WORK beside tools of npm, under
# their development servers and in their production builds, in Debian's chromium.
set -euo pipefail
for tool in chromium npm node; do
  command -v $tool >/dev/null || { echo "servers_test: $tool is missing" >&2; exit 2; }
done
node -e "process.exit(process.versions.node.split('.')[0] >= 20 ? 0 : 1)" || { echo 'skipped: Vite 8 needs Node 20'; exit 77; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
package=$(realpath "$1"/vesica-*.tgz)
rm -rf "$2"
mkdir -p "$2"
cp "$here"/*.mjs "$here/package.json" "$2"
cd "$2"
npm install --silent --no-audit --no-fund
npm install --silent --offline --no-save --no-audit --no-fund "$package"
VESICA_CHROMIUM=$(command -v chromium)
export VESICA_CHROMIUM
node --test --test-concurrency=1
