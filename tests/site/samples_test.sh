#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# samples_test.sh MOVED WORK MODULES PACKAGES: every program that the site shows compiles, runs, and says what the page
# says. PACKAGES is where bindings/*/build.sh have built the packages of Go, Java and C#.
. "$(dirname "${BASH_SOURCE[0]}")/../install/prefix.sh"
root=$(cd "$here/../.." && pwd) modules=$3 packages=$4
samples=$root/docs/site/samples
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

mkdir -p "$work/rust/src"
cp "$samples/first.rs" "$work/rust/src/main.rs"
cat >"$work/rust/Cargo.toml" <<END
[package]
name = "first"
version = "0.1.0"
edition = "2021"
[dependencies]
vesica = { path = "$root/bindings/rust/vesica" }
END
says first.rs env CARGO_TARGET_DIR="$work/rust/target" cargo run --quiet --offline --manifest-path "$work/rust/Cargo.toml"

mkdir "$work/go"
cp "$samples/first.go" "$work/go/main.go"
(cd "$work" && unzip -q "$packages"/go/vesica-go-*.zip)
cat >"$work/go/go.mod" <<'END'
module first

go 1.19

require example.org/vesica v0.0.0
replace example.org/vesica => ../vesica-go
END
says first.go env -C "$work/go" GOFLAGS=-mod=mod GOPROXY=off GOCACHE="$work/cache" go run .

jars=("$packages"/java/vesica-*.jar)
cp "$samples/first.java" "$work/First.java"
javac -Xlint:all -Werror -cp "${jars[0]}" -d "$work" "$work/First.java"
says first.java java -cp "${jars[0]}:$work" First

(cd "$work" && unzip -q "$packages"/csharp/vesica-csharp-*.zip)
cp "$work"/vesica-csharp/Vesica.dll "$work"/vesica-csharp/libvesica.so "$work"
mcs -langversion:latest -warn:4 -warnaserror -r:"$work/Vesica.dll" -out:"$work/First.exe" "$samples/first.cs"
says first.cs mono "$work/First.exe"

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
[ "$(find "$samples" -type f | wc -l)" = 8 ]
for sample in "$samples"/*; do
  grep -q "\"${sample##*.}\": \"" "$root/docs/site/build.py" || { echo "the page lacks $sample"; failures=1; }
done
# The README's program is the same.
diff <(awk '$0 == "```c" { inside = 1; next } $0 == "```" && inside { exit } inside' "$root/README.md") "$samples/first.c" || failures=1
[ "$failures" = 0 ]
