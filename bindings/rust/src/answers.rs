pub use crate::sys::{Contact, Intersection, NearPair};

/// How far all bodies may go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Earliest {
    /// A fraction of the step: nothing touches before; 1 if nothing touches at all.
    pub toi_lower: f64,
    /// A contact that is proven happens at this time or before; 1 if there is none.
    pub toi_upper: f64,
    /// The first contact; `None` if nothing touches.
    pub contact: Option<Contact>,
}
