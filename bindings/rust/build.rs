//! Finds the installed C library: where the linker looks, or in the folders of `TAMIS_LIBRARY_DIR`.
fn main() {
    println!("cargo:rerun-if-env-changed=TAMIS_LIBRARY_DIR");
    let folders = std::env::var("TAMIS_LIBRARY_DIR").unwrap_or_default();
    for folder in std::env::split_paths(&folders).filter(|folder| !folder.as_os_str().is_empty()) {
        println!("cargo:rustc-link-search=native={}", folder.display());
    }
    let library = if std::env::var("CARGO_FEATURE_CLAMP").is_ok() { "tamis_clamp" } else { "tamis_c" };
    println!("cargo:rustc-link-lib=dylib={library}");
}
