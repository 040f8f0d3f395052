#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# hosts.sh DIRECTORY [HOST...]: the random calls of the packages for Python, Rust, Go, Java and C#, VESICA_CALLS of each
# (100000), on a library built in DIRECTORY with the address sanitizer, all but the kernels of instruction sets, which
# are linked as they are. It sees the library's own memory, and the arrays of Python, Rust and Go; those of Java and C#
# lie in heaps that it does not know. JavaScript needs none: what leaves a WebAssembly module's memory traps.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$1"
work=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- python rust go java csharp
export VESICA_CALLS=${VESICA_CALLS:-100000} VESICA_CALLS_FILE=$root/bindings/calls/calls.txt
/usr/bin/python3 -B "$root/bindings/declare" csharp java python
flags='-O1 -fsanitize=address -fno-omit-frame-pointer'

# The same objects twice: of the second build only the kernels are not made.
cmake -S "$root" -B "$work/plain" -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build "$work/plain" --target vesica
cmake -S "$root" -B "$work/sanitized" -G Ninja -DCMAKE_BUILD_TYPE=None "-DCMAKE_CXX_FLAGS=$flags"
kernels='/isa/(sse2|avx2|avx512|neon|portable)'
mapfile -t objects < <(cd "$work/plain" && find capi src -name '*.o' | grep -Ev "$kernels")
mapfile -t plain < <(find "$work/plain" -name '*.o' | grep -E "$kernels")
ninja -C "$work/sanitized" "${objects[@]}"
library=$work/library
rm -rf "$library" && mkdir "$library"
(cd "$work/sanitized" && ar qcs "$library/libvesica.a" "${objects[@]}" "${plain[@]}")
# shellcheck disable=SC2086
cc $flags -shared -Wl,-soname,libvesica.so.0 "-Wl,--version-script=$root/capi/vesica.map" -o "$library/libvesica.so.0" \
  -Wl,--whole-archive "$library/libvesica.a" -Wl,--no-whole-archive -lm

sanitized() {
  LD_PRELOAD=$(cc -print-file-name=libasan.so) LD_LIBRARY_PATH=$library ASAN_OPTIONS=detect_leaks=0:handle_segv=0 "$@"
}
python() {
  PYTHONPATH=$root/bindings/python:$root/bindings/python/tests sanitized \
    /usr/bin/python3 -B -m unittest test_any_arguments
}
rust() {
  VESICA_LIBRARY=$library RUSTFLAGS='-C link-arg=-lasan' cargo test --quiet --offline --release \
    --manifest-path "$root/bindings/rust/Cargo.toml" --target-dir "$work/rust" -p vesica --test arguments --no-run
  sanitized "$(find "$work/rust/release/deps" -name 'arguments-*' -executable -type f)" any_arguments --nocapture
}
go() {
  rm -rf "$work/go" && mkdir -p "$work/go/include" "$work/go/lib"
  cp "$root"/bindings/go/{*.go,*.h,go.mod} "$work/go"
  cp "$root"/capi/include/vesica*.h "$work/go/include"
  cp "$library/libvesica.a" "$work/go/lib"
  (cd "$work/go" && GOPROXY=off GOCACHE="$work/go-cache" ASAN_OPTIONS=detect_leaks=0 \
    command go test -asan -count=1 -v -run TestAnyArguments .)
}
java() {
  local jdk
  jdk=$(dirname "$(dirname "$(readlink -f "$(command -v javac)")")")
  javac -d "$work/java" "$root"/bindings/java/{src,generated}/vesica/*.java "$root"/bindings/java/tests/vesica/*.java
  # shellcheck disable=SC2086
  cc -std=c99 $flags -fPIC -shared -I "$jdk/include" -I "$jdk/include/linux" -I "$root/capi/include" -o "$work/java/jni.so" \
    -I "$root/bindings/java/native" "$root"/bindings/java/{native,generated}/*.c -L "$library" -l:libvesica.so.0 -lm
  sanitized "$jdk/bin/java" -Xcheck:jni -Xmx150m "-Dvesica.library=$work/java/jni.so" -cp "$work/java" \
    vesica.Arguments "$VESICA_CALLS"
}
csharp() {
  mkdir -p "$work/csharp"
  cd "$work/csharp"
  mcs -langversion:latest -unsafe -target:library -out:Vesica.dll "$root"/bindings/csharp/{src,generated}/*.cs
  mcs -langversion:latest -unsafe -r:Vesica.dll -out:VesicaTests.exe "$root"/bindings/csharp/tests/*.cs
  cp "$library/libvesica.so.0" libvesica.so
  sanitized mono VesicaTests.exe "$VESICA_CALLS_FILE" "$VESICA_CALLS"
}

for host in "$@"; do
  echo "== $host"
  "$host"
done
