#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# samples_test.sh MOVED WORK MODULES: every program that the site shows compiles, runs, and says what the page says.
. "$(dirname "${BASH_SOURCE[0]}")/../install/prefix.sh"
root=$here/../.. samples=$root/docs/site/samples modules=$3
failures=0
/usr/bin/python3 -B "$root/bindings/declare" javascript python

# says PROGRAM COMMAND...: it prints the line that the start page has below the samples.
expected=$(sed -n 's,.*<samp>\(.*\)</samp>.*,\1,p' "$root/docs/site/index.html")
[ -n "$expected" ]
says() {
  local output
  output=$("${@:2}") || true
  [ "$output" = "$expected" ] && return
  printf '%s prints\n%s\nand should print\n%s\n' "$1" "$output" "$expected"
  failures=$((failures + 1))
}

"$CC" -std=c11 -Wall -Wextra -Wpedantic -Werror -o "$work/in_c" "$samples/first.c" "${flags[@]}"
says first.c "$work/in_c"
"$CXX" -std=c++20 -Wall -Wextra -Wpedantic -Werror -o "$work/in_cpp" "$samples/first.cpp" "${flags[@]}"
says first.cpp "$work/in_cpp"
says first.py env PYTHONPATH="$root/bindings/python" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$samples/first.py"
rustc --edition 2021 -o "$work/in_rust" -L "$LD_LIBRARY_PATH" -l vesica "$samples/first.rs"
says first.rs "$work/in_rust"
mkdir -p "$work/node_modules/vesica"
cp "$root"/bindings/javascript/*.mjs "$root/bindings/javascript/package.json" "$modules/vesica.wasm" "$work/node_modules/vesica"
cp "$modules/simd/vesica.wasm" "$work/node_modules/vesica/vesica-simd.wasm"
cp "$samples/first.mjs" "$work"
says first.mjs node "$work/first.mjs"

# Lines of docs/hosts.md and README.md, which take names for granted.
block() {
  awk -v open="\`\`\`$1" '$0 == open { inside = 1; next } $0 == "```" { inside = 0 } inside' "$root/${2:-docs/hosts.md}"
}
printf 'import vesica\n%s\nassert vesica.overlap(cars, people).all() and vesica.iou_matrix(cars, cars)[0, 1] == 0\n' \
  "$(block python README.md)" >"$work/readme.py"
PYTHONPATH="$root/bindings/python" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$work/readme.py" || failures=1
printf 'import vesica\narray = [[0, 0, 4, 2, 30], [9, 1, 4, 2, 0]]\n%s\nassert vesica.iou_matrix(boxes, boxes)[0, 0] == 1\n' \
  "$(block python)" >"$work/lines.py"
PYTHONPATH="$root/bindings/python" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$work/lines.py" || failures=1
printf 'import { circle, load, rect } from "vesica";\nconst vesica = await load();\nconst hit = %s\nif (hit !== true) process.exit(1);\n' \
  "$(block js)" >"$work/lines.mjs"
node "$work/lines.mjs" || failures=1

# What is on the page is what was run here.
[ "$(find "$samples" -type f | wc -l)" = 5 ]
for sample in "$samples"/*; do
  grep -q "<!-- sample $(basename "$sample") -->" "$root/docs/site/index.html" || { echo "the page lacks $sample"; failures=1; }
done
# The README's program is the same.
diff <(awk '$0 == "```c" { inside = 1; next } $0 == "```" && inside { exit } inside' "$root/README.md") "$samples/first.c" || failures=1
[ "$failures" = 0 ]
