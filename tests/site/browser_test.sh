#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# browser_test.sh MOVED WORK SITE ORACLE: the site in Debian's chromium, driven by puppeteer-core and looked at by axe-core.
# ORACLE is the program oracle_answers. Screenshots go to WORK/pictures; docs/pictures has what they should be.
. "$(dirname "${BASH_SOURCE[0]}")/../install/prefix.sh"
for tool in chromium npm node; do
  command -v $tool >/dev/null || { echo "browser_test: $tool is missing" >&2; exit 2; }
done
cp "$here"/*.mjs "$here/package.json" "$work"
mkdir "$work/pictures"
cd "$work"
npm install --silent --no-audit --no-fund
VESICA_CHROMIUM=$(command -v chromium)
root=$(cd "$here/../.." && pwd)
export VESICA_PYTHON=$root/bindings/python VESICA_JAVASCRIPT=$root/bindings/javascript
/usr/bin/python3 -B "$root/bindings/declare" python
export VESICA_CHROMIUM VESICA_SITE=$3 VESICA_ORACLE=$4 VESICA_PICTURES=$here/../../docs/pictures VESICA_FLAGS="${flags[*]}"
node --test --test-concurrency=1
