//! Finds the installed C library: where the linker looks, or in the folder `TAMIS_LIBRARY_DIR`.
fn main() {
    println!("cargo:rerun-if-env-changed=TAMIS_LIBRARY_DIR");
    if let Ok(folder) = std::env::var("TAMIS_LIBRARY_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
    }
    let library = if std::env::var("CARGO_FEATURE_CLAMP").is_ok() { "tamis_clamp" } else { "tamis_c" };
    println!("cargo:rustc-link-lib=dylib={library}");
}
