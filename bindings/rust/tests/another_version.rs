//! `scripts/test_rust.sh` runs this with a library that says it is version 99.0.0.
use tamis::{Shape, World};

#[test]
#[ignore = "needs a library of another version"]
fn a_library_of_another_version_is_refused_with_a_sentence() {
    assert_eq!(tamis::version(), "99.0.0");
    for error in [World::new(1).err().unwrap(), Shape::new(&[], &[]).err().unwrap()] {
        assert!(error.message.starts_with("libtamis_c 99.0.0 is loaded, but this crate is for 0.1."), "{error}");
        assert!(error.message.contains("install libtamis_c 0.1."), "{error}");
    }
}
