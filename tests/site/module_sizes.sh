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
limit "$modules/vesica.wasm" 2270 686
limit "$modules/simd/vesica.wasm" 2424 728
limit "$modules/vesica-overlap.wasm" 744 232
limit "$modules/simd/vesica-overlap.wasm" 826 246
limit "$modules/vesica-methods.wasm" 106 49
[ $failures = 0 ]
