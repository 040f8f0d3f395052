// SPDX-License-Identifier: Apache-2.0
//! Where the library is: pkg-config knows, unless it is where the linker looks anyway.
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    println!("cargo:rustc-link-lib=vesica");
    if let Ok(answer) = Command::new("pkg-config").args(["--variable=libdir", "vesica"]).output() {
        let directory = String::from_utf8_lossy(&answer.stdout).trim().to_owned();
        if answer.status.success() {
            println!("cargo:rustc-link-search=native={directory}");
        }
    }
}
