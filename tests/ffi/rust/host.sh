# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Rust, by the declarations of rust/vesica-sys; no crate is needed.
build() {
  cp -r "$host" crate
  cp "$here/../../rust/vesica-sys/src/declarations.rs" crate/src
  cargo build --quiet --locked --offline --manifest-path crate/Cargo.toml --target-dir "$work/target" \
    --example vectors --example index
}
run() { "$work/target/debug/examples/vectors" "$1"; }
run_index() { "$work/target/debug/examples/index"; }
