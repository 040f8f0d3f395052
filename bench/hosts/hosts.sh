#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# hosts.sh DIRECTORY [HOST...]: what a call costs from each language's package, beside C in the same run, as a table. It
# builds in DIRECTORY. VESICA_ARCHIVE and VESICA_SHARED name folders with libraries to be taken, VESICA_WASM one with
# both WebAssembly modules.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$1"
work=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- rust go java csharp python javascript
static=$("$root/tools/build_library.sh" static "$work/static")
shared=$("$root/tools/build_library.sh" shared "$work/shared")
export LD_LIBRARY_PATH=$shared${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
# Go and numpy ask the kernel for huge pages themselves.
export GLIBC_TUNABLES=glibc.malloc.hugetlb=1
/usr/bin/python3 -B "$root/bindings/declare" csharp java javascript python
exec 3>&1 1>&2 # the table alone is the output

c() {
  cc -std=gnu99 -O2 -I "$root/capi/include" -o "$work/overhead" "$root/bench/hosts/overhead.c" "$shared/libvesica.so.0"
  "$work/overhead"
}
rust() {
  VESICA_LIBRARY=$static cargo run --quiet --offline --release --manifest-path "$root/bindings/rust/Cargo.toml" \
    --target-dir "$work/rust" -p vesica --example overhead
}
go() {
  rm -rf "$work/go" && mkdir -p "$work/go/include" "$work/go/lib"
  cp -r "$root"/bindings/go/{*.go,*.h,go.mod,overhead} "$work/go"
  cp "$root"/capi/include/vesica*.h "$work/go/include"
  cp "$static/libvesica.a" "$work/go/lib"
  (cd "$work/go" && GOPROXY=off GOCACHE="$work/go-cache" command go run ./overhead)
}
java() {
  local jdk
  jdk=$(dirname "$(dirname "$(readlink -f "$(command -v javac)")")")
  javac -d "$work/java" "$root"/bindings/java/{src,generated}/vesica/*.java "$root/bindings/java/overhead/Overhead.java"
  cc -std=c99 -O2 -fPIC -shared -I "$jdk/include" -I "$jdk/include/linux" -I "$root/capi/include" -o "$work/java/jni.so" \
    -I "$root/bindings/java/native" "$root"/bindings/java/{native,generated}/*.c "$static/libvesica.a" -lm
  command java -XX:+UseTransparentHugePages "-Dvesica.library=$work/java/jni.so" -cp "$work/java" Overhead
}
csharp() {
  mkdir -p "$work/csharp"
  mcs -langversion:latest -unsafe "-out:$work/csharp/overhead.exe" "$root"/bindings/csharp/{src,generated}/*.cs \
    "$root/bindings/csharp/overhead/Overhead.cs"
  cp "$shared/libvesica.so.0" "$work/csharp/libvesica.so"
  mono "$work/csharp/overhead.exe"
}
python() { PYTHONPATH=$root/bindings/python /usr/bin/python3 -B "$root/bindings/python/overhead.py"; }
javascript() {
  local modules=${VESICA_WASM:-$work/wasm}
  [ -n "${VESICA_WASM:-}" ] || "$root/bindings/small/wasm/build.sh" "$modules" >&2
  mkdir -p "$work/javascript"
  cp "$root"/bindings/javascript/*.mjs "$modules/vesica.wasm" "$work/javascript"
  cp "$modules/simd/vesica.wasm" "$work/javascript/vesica-simd.wasm"
  node "$work/javascript/overhead.mjs"
}

# Other work comes and goes: of three rounds the least.
: >"$work/rows"
for _ in 1 2 3; do
  for host in c "$@"; do "$host" >>"$work/rows"; done
done
sed -n 's/^model name[^:]*: /rect and rect, double; /p' /proc/cpuinfo | head -n 1 >&3
echo >&3
awk '
  { key = $1 " | " $2
    if (!(key in question)) { question[key] = $2; order[++n] = key }
    for (i = 3; i <= 5; ++i) if (!((key, i) in least) || $i + 0 < least[key, i]) least[key, i] = $i + 0 }
  END {
    print "| from | question | one call | 1e3, an element | 1e6, an element |"
    print "|---|---|---|---|---|"
    for (k = 1; k <= n; ++k) {
      printf "| %s", order[k]
      for (i = 3; i <= 5; ++i) {
        printf " | " (least[order[k], i] < 100 ? "%.3g" : "%.0f") " ns", least[order[k], i]
        if (order[k] !~ /^C /) printf ", %.2f of C", least[order[k], i] / least["C | " question[order[k]], i]
      }
      print " |"
    }
  }' "$work/rows" >&3
