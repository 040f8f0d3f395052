#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh FOLDER: the extension vesica_sqlite.so into FOLDER, against the library that pkg-config finds.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
common=$here/../common
. "$common/linking.sh"
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wmissing-prototypes -Werror)
"${CC:-cc}" -std=c99 -O2 -fPIC -shared -fvisibility=hidden "${warnings[@]}" "-I$common" \
  -o "$1/vesica_sqlite.so" "$here/vesica_sqlite.c" "$common"/*.c "${linking[@]}" -lm
