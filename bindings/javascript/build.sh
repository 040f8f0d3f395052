#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY [MODULES]: packs the npm package into DIRECTORY, installs it into a fresh folder without network,
# and runs the tests there; tsc, of npm, reads the declarations. MODULES is where bindings/small/wasm/build.sh has
# built the two modules already.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
modules=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ -z "$modules" ]; then
  modules=$directory/wasm
  "$here/../small/wasm/build.sh" "$modules"
fi

/usr/bin/python3 -B "$here/../declare" javascript
mkdir "$work/package" "$work/program"
cp "$here"/*.mjs "$here"/*.d.ts "$here/package.json" "$here/README.md" "$work/package"
cp "$modules/vesica.wasm" "$modules/vesica-overlap.wasm" "$modules/vesica-methods.wasm" "$work/package"
cp "$modules/simd/vesica.wasm" "$work/package/vesica-simd.wasm"
cp "$modules/simd/vesica-overlap.wasm" "$work/package/vesica-overlap-simd.wasm"
rm -f "$directory"/vesica-*.tgz
(cd "$work/package" && npm pack --silent --pack-destination "$directory")

cd "$work/program"
cp -r "$here"/tests/* "$here/../vectors/vectors.txt" "$here/../calls/calls.txt" "$here/README.md" .
echo '{ "private": true, "type": "module" }' >package.json
npm install --silent --offline --no-audit --no-fund "$directory"/vesica-*.tgz
node --test
npm install --silent --no-audit --no-fund --no-save typescript@5
npx tsc --noEmit --strict --target es2022 --lib es2022,dom --module nodenext --moduleResolution nodenext types.ts
ls "$directory"/vesica-*.tgz
