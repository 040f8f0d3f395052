#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# module_sizes.sh MODULES: how large the WebAssembly modules are, as they lie there and by gzip, in kB; each has a limit.
set -euo pipefail
failures=0

# limit MODULE KB KB_GZIP
limit() {
  local size packed
  size=$(($(stat -c %s "$1") / 1000))
  packed=$(($(gzip -9c "$1" | wc -c) / 1000))
  echo "${1#"$modules/"}: $size kB, $packed kB by gzip"
  [[ $size -le $2 && $packed -le $3 ]] || { echo "more than $2 and $3"; failures=1; }
}

modules=$1
limit "$modules/vesica.wasm" 1935 597
limit "$modules/simd/vesica.wasm" 2092 640
limit "$modules/vesica-overlap.wasm" 722 225
limit "$modules/simd/vesica-overlap.wasm" 801 238
limit "$modules/vesica-methods.wasm" 106 49
[ $failures = 0 ]
