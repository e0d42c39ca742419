//! Builds the C library from the sources that the crate carries, or from those of the checkout around it, and links it
//! into the program. The feature `system`, or a folder in `TAMIS_LIBRARY_DIR`, takes the installed library instead.
use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

fn main() {
    println!("cargo:rerun-if-env-changed=TAMIS_LIBRARY_DIR");
    let folders = env::var("TAMIS_LIBRARY_DIR").unwrap_or_default();
    let library = if has("CLAMP") { "tamis_clamp" } else { "tamis_c" };
    if has("SYSTEM") || !folders.is_empty() {
        for folder in env::split_paths(&folders).filter(|folder| !folder.as_os_str().is_empty()) {
            println!("cargo:rustc-link-search=native={}", folder.display());
        }
        println!("cargo:rustc-link-lib=dylib={library}");
    } else {
        build(library);
    }
}

fn has(feature: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{feature}")).is_some()
}

fn build(library: &str) {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap());
    let (carried, checkout) = (here.join("library"), here.join("../.."));
    let is_carried = carried.join("CMakeLists.txt").exists();
    let sources = if is_carried { &carried } else { &checkout };
    need_cmake();
    for part in ["CMakeLists.txt", "cmake", "include", "src", "bindings/c", "integrations"] {
        println!("cargo:rerun-if-changed={}", sources.join(part).display());
    }
    let libraries = PathBuf::from(env::var_os("OUT_DIR").unwrap()).join("libraries");
    let mut cmake = cmake::Config::new(sources);
    // Release: else each question takes several times as long in cargo's own debug builds.
    cmake.profile("Release").build_target(library);
    // One folder, whatever the generator.
    cmake.define("CMAKE_ARCHIVE_OUTPUT_DIRECTORY", format!("$<1:{}>", libraries.display()));
    for (option, is_on) in [
        ("TAMIS_BUILD_C", true),
        ("TAMIS_C_STATIC", true),
        ("TAMIS_TBB", has("TBB")),
        ("TAMIS_BUILD_ADAPTERS", has("CLAMP")),
        ("BULLET_INCLUDE", false), // the clamp alone
        ("TAMIS_BUILD_TOOLS", false),
        ("TAMIS_BUILD_LAB", false),
        ("TAMIS_BUILD_MPI", false),
        ("TAMIS_BUILD_TESTS", false),
        ("TAMIS_INSTALL", false),
        ("BUILD_SHARED_LIBS", false),
    ] {
        cmake.define(option, if is_on { "ON" } else { "OFF" });
    }
    cmake.define("CMAKE_UNITY_BUILD_BATCH_SIZE", "32");
    if is_carried {
        let headers = carried.join("third_party");
        cmake.define("Boost_INCLUDE_DIR", &headers).define("xsimd_DIR", &headers);
    }
    cmake.build();
    link(&libraries, library);
}

fn link(folder: &Path, library: &str) {
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rustc-link-lib=static={library}");
    if has("CLAMP") {
        println!("cargo:rustc-link-lib=static=tamis_adapters");
    }
    println!("cargo:rustc-link-lib=static=tamis");
    if has("TBB") {
        println!("cargo:rustc-link-lib=dylib=tbb");
    }
    let target = |key: &str| env::var(format!("CARGO_CFG_TARGET_{key}")).unwrap_or_default();
    if target("VENDOR") == "apple" {
        println!("cargo:rustc-link-lib=dylib=c++");
    } else if target("ENV") != "msvc" {
        println!("cargo:rustc-link-lib=dylib=stdc++");
    }
}

fn need_cmake() {
    let program = env::var_os("CMAKE").unwrap_or_else(|| "cmake".into());
    if Command::new(&program).arg("--version").stdout(Stdio::null()).status().is_err() {
        panic!(
            "tamis: {} cannot be run: install CMake 3.20 or newer (Debian: cmake) and a C++20 compiler, \
             or link an installed library with the feature `system`",
            program.to_string_lossy()
        );
    }
}
