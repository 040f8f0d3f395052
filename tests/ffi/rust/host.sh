# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Rust, by declarations of its own; no crate is needed.
build() {
  cargo build --quiet --locked --offline --manifest-path "$host/Cargo.toml" --target-dir "$work/target" \
    --example vectors --example index
}
run() { "$work/target/debug/examples/vectors" "$1"; }
run_index() { "$work/target/debug/examples/index"; }
