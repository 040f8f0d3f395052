#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY: packs both crates into DIRECTORY, unpacks them into a fresh folder without network, and runs their
# tests there, and those without std. VESICA_ARCHIVE names a folder with a libvesica.a to be linked; without it the
# crate builds the library.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ -z "${VESICA_ARCHIVE:-}" ] || export VESICA_LIBRARY=$VESICA_ARCHIVE
export VESICA_STATIC=1 CARGO_NET_OFFLINE=true CARGO_TARGET_DIR=$work/target

# The crate of the C functions takes the library's sources along.
cp -r "$here" "$work/rust"
rm -rf "$work/rust/target"
sources=$work/rust/vesica-sys/vesica
mkdir "$sources"
(cd "$here/../.." && cp -r CMakeLists.txt LICENSE capi include pkgconfig src "$sources")
cd "$work/rust"
cargo package --quiet --offline --allow-dirty --no-verify -p vesica-sys
# Not yet in a registry, the first crate is found by its path.
cargo package --quiet --offline --allow-dirty --no-verify -p vesica \
  --config "patch.crates-io.vesica-sys.path='$work/rust/vesica-sys'"
rm -f "$directory"/vesica*.crate
cp "$work"/target/package/*.crate "$directory"

mkdir "$work/fresh"
cd "$work/fresh"
for crate in "$directory"/*.crate; do tar -xzf "$crate"; done
cat >Cargo.toml <<END
[workspace]
members = ["vesica-0*", "vesica-sys-*"]
[patch.crates-io]
vesica-sys = { path = "$(echo vesica-sys-*)" }
END

# Only a build for this machine takes a library that is installed on it.
rustc --edition 2021 -o "$work/build_script" vesica-sys-*/build.rs
mkdir -p "$work/tools" "$work/out/cmake/capi"
touch "$work/out/cmake/capi/libvesica.a"
for tool in pkg-config cmake; do printf '#!/bin/sh\n' >"$work/tools/$tool"; done
chmod +x "$work"/tools/*
linked() {
  env -u VESICA_LIBRARY -u VESICA_STATIC PATH="$work/tools:$PATH" HOST=here TARGET="$1" OUT_DIR="$work/out" \
    CARGO_MANIFEST_DIR="$(echo vesica-sys-*)" "$work/build_script" | sed -n 's/^cargo:rustc-link-lib=//p'
}
[ "$(linked here)" = vesica ] || { echo "rust: the library that is installed is not linked" >&2; exit 1; }
[ "$(linked there)" = $'static=vesica\nm' ] || { echo "rust: for another machine, this one's is linked" >&2; exit 1; }

export VESICA_CALLS_FILE=$here/../calls/calls.txt
cargo test --quiet --offline --release -p vesica
cargo build --quiet --offline --release -p vesica --no-default-features
RUSTDOCFLAGS='-D warnings' cargo doc --quiet --offline --no-deps -p vesica -p vesica-sys
ls "$directory"/*.crate
