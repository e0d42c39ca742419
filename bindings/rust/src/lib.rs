//! Bodies that move, each with its own mesh: what touches, when first, and a proof where nothing does.
//!
//! ```
//! use tamis::{Motion, Pose, PathOptions, Shape, World};
//!
//! let wall = Shape::new(
//!     &[[0.0, -9.0, -9.0], [0.0, 9.0, -9.0], [0.0, 9.0, 9.0], [0.0, -9.0, 9.0]],
//!     &[[0, 1, 2], [0, 2, 3]],
//! )?;
//! let blade = Shape::new(&[[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.2]], &[[0, 1, 2]])?;
//! let start = Pose { position: [-2.0, 0.0, 0.0], ..Pose::default() };
//! let end = Pose { position: [-0.5, 0.0, 0.0], rotation: [0.0, 0.0, 0.5] };
//!
//! let mut world = World::new(1)?;
//! world.add(&wall, &Motion::at(Pose::default()))?;
//! let flying = world.add(&blade, &Motion::between(&start, &end, [0.0; 3])?)?;
//! let earliest = world.earliest(&PathOptions::default())?;
//! assert_eq!(earliest.contact.unwrap().bodies, [flying, 0]);
//! assert!((earliest.toi_lower - 0.708005).abs() < 1e-6);
//! # Ok::<(), tamis::Error>(())
//! ```
//!
//! The C library does the work: `docs/worlds.md` of Tamis says what is proven of which motion.
#![warn(missing_docs)]

mod answers;
#[cfg(feature = "clamp")]
mod clamp;
mod error;
mod motion;
mod shape;
#[rustfmt::skip] // generated
mod sys;
mod world;

pub use answers::{Contact, Earliest, Intersection, NearPair};
#[cfg(feature = "clamp")]
pub use clamp::{ClampOptions, Clamped, End, Inertia, Velocity, WantedStep};
pub use error::Error;
pub use motion::{Motion, Pose, RigidLink};
pub use shape::Shape;
pub use sys::TAMIS_INVALID_MESH;
pub use world::{AtStart, BodyId, PathOptions, World};

/// The version of the library that is linked, such as "0.1.0".
pub fn version() -> String {
    // SAFETY: the library's string lives as long as the program.
    error::text(unsafe { sys::tamis_version() })
}
