// SPDX-License-Identifier: Apache-2.0
//! Finds the library, or builds it from its C++ sources.
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The first version that has what is declared.
const VERSION: &str = "0.1.0";

fn main() {
    for name in ["VESICA_LIBRARY", "VESICA_STATIC", "PKG_CONFIG_PATH"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    if let Some(folder) = env::var_os("VESICA_LIBRARY") {
        link_statically(Path::new(&folder));
    } else if env::var_os("VESICA_STATIC").is_some() || !link_what_is_installed() {
        link_statically(&build());
    }
}

fn link_statically(folder: &Path) {
    if !folder.join("libvesica.a").exists() {
        panic!("there is no libvesica.a in {}: VESICA_LIBRARY names the folder that it is in", folder.display());
    }
    println!("cargo:rerun-if-changed={}", folder.join("libvesica.a").display());
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rustc-link-lib=static=vesica");
    println!("cargo:rustc-link-lib=m");
}

/// What pkg-config finds is for the machine that builds.
fn link_what_is_installed() -> bool {
    if env::var_os("HOST") != env::var_os("TARGET") {
        return false;
    }
    let answer = Command::new("pkg-config").args(["--libs-only-L", &format!("vesica >= {VERSION}")]).output();
    let directories = match answer {
        Ok(answer) if answer.status.success() => String::from_utf8_lossy(&answer.stdout).into_owned(),
        _ => return false,
    };
    for directory in directories.split(" -L").map(|text| text.trim().trim_start_matches("-L")) {
        if !directory.is_empty() {
            println!("cargo:rustc-link-search=native={}", directory.replace("\\ ", " "));
        }
    }
    println!("cargo:rustc-link-lib=vesica");
    true
}

/// By cmake, from the sources in this crate, or from the repository that it is part of.
fn build() -> PathBuf {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap());
    let packed = here.join("vesica");
    let sources = if packed.exists() { packed } else { here.join("../../..") };
    let to = PathBuf::from(env::var_os("OUT_DIR").unwrap()).join("cmake");
    fs::create_dir_all(&to).unwrap();
    run(Command::new("cmake")
        .arg("-S")
        .arg(&sources)
        .arg("-B")
        .arg(&to)
        .args(["-DCMAKE_BUILD_TYPE=Release", "-DBUILD_SHARED_LIBS=OFF"]));
    // Without a number, make starts all compilers at once.
    let jobs = env::var("NUM_JOBS").unwrap_or_else(|_| "1".into());
    run(Command::new("cmake").arg("--build").arg(&to).args(["--target", "vesica", "--parallel", &jobs]));
    println!("cargo:rerun-if-changed={}", sources.join("src").display());
    println!("cargo:rerun-if-changed={}", sources.join("capi").display());
    println!("cargo:rerun-if-changed={}", sources.join("include").display());
    to.join("capi")
}

fn run(command: &mut Command) {
    match command.status() {
        Ok(status) if status.success() => (),
        Ok(status) => panic!("{command:?} failed: {status}"),
        Err(error) => panic!("{command:?} cannot be run ({error}): cmake and a C++20 compiler build the library"),
    }
}
