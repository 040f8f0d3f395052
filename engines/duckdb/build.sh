#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh FOLDER: the extension vesica.duckdb_extension, and DuckDB for node, into FOLDER. Headers and DuckDB are npm's.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
common=$here/../common
mkdir -p "$1"
cd "$1"
version=1.4.4
[ -f package.json ] || echo '{"private": true}' >package.json
[ -d node_modules/@duckdb/node-api ] || npm install --silent --no-audit --no-fund "@duckdb/node-api@$version-r.1" >/dev/null
if [ ! -d headers ]; then
  npm pack --silent "duckdb@$version" >/dev/null
  mkdir headers
  tar -xzf "duckdb-$version.tgz" -C headers --strip-components=5 package/src/duckdb/src/include/duckdb.h \
    package/src/duckdb/src/include/duckdb_extension.h
  rm "duckdb-$version.tgz"
fi

. "$common/linking.sh"
"${CC:-cc}" -std=gnu99 -O2 -fPIC -shared -fvisibility=hidden -Wall -Wextra -Wconversion -Wshadow -Werror -isystem headers \
  "-I$common" -o vesica.so "$here/vesica_duckdb.c" "$common"/*.c "${linking[@]}" -lm

# What DuckDB reads behind a library before it loads it: eight fields of 32 bytes, the last ones first, and the place of a
# signature, which is empty.
field() {
  printf '%s' "$1"
  head -c $((32 - ${#1})) /dev/zero
}
{
  cat vesica.so
  field '' && field '' && field ''
  field C_STRUCT                    # the interface, whose version does not change with DuckDB's
  field 0.1                         # of the extension
  field v1.2.0                      # of the interface
  field "linux_$(uname -m | sed "s/x86_64/amd64/; s/aarch64/arm64/")"
  field 4                           # of these fields
  head -c 256 /dev/zero
} >vesica.duckdb_extension
