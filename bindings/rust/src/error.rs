use std::ffi::{c_char, c_int, CStr};
use std::fmt;

/// An error of the library, with its own message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    /// `tamis_status` of the C interface.
    pub status: i32,
    /// What is wrong, where, and what to do.
    pub message: String,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// `text` ends with a zero.
pub(crate) fn text(text: *const c_char) -> String {
    // SAFETY: no string of the C interface is NULL, and each ends with a zero.
    unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
}

/// Refuses a library of another minor version, whose structs may differ: only an installed one can be.
pub(crate) fn check_version() -> Result<(), Error> {
    let (library, wanted) = (crate::version(), env!("CARGO_PKG_VERSION"));
    let minor = |version: &str| version.rsplitn(2, '.').last().map(str::to_owned);
    check(c_int::from(minor(&library) != minor(wanted)) * FAILED, || {
        format!(
            "libtamis_c {library} is loaded, but this crate is for {wanted}: install libtamis_c {wanted}, \
             or build without the feature `system`"
        )
    })
}

/// `TAMIS_FAILED`.
const FAILED: c_int = 8;

/// `message` is asked only after a failure.
pub(crate) fn check(status: c_int, message: impl FnOnce() -> String) -> Result<(), Error> {
    if status == 0 {
        return Ok(());
    }
    Err(Error { status, message: message() })
}
