//! rapier, but no body passes through another.
//!
//! ```
//! use rapier3d::prelude::*;
//! use tamis_rapier::{Clamp, ClampOptions};
//!
//! let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
//! world.integration_parameters.max_ccd_substeps = 0; // rapier's own CCD is not needed
//! world.colliders.insert(ColliderBuilder::cuboid(1.0, 1.0, 0.001));
//! let (plate, _) = world.insert(
//!     RigidBodyBuilder::dynamic().translation(Vector::new(0.0, 0.0, 1.0)).linvel(Vector::new(0.0, 0.0, -110.0)),
//!     ColliderBuilder::cuboid(0.15, 0.1, 0.02).contact_skin(0.001), // rest apart, not a little in each other
//! );
//! let mut clamp = Clamp::new(ClampOptions::default(), 1)?;
//! let step = clamp.step(&mut world)?; // was: world.step()
//! assert_eq!(step.held[0].0, plate);
//! assert!(world.bodies[plate].translation().z > 0.02);
//! # Ok::<(), tamis_rapier::Error>(())
//! ```
//!
//! rapier makes its step, then each body is put back to where it may be: before the first time at which the triangles of
//! two bodies would touch, on the way that rapier's integrator means, at a constant twist about the centre of mass.
//! `docs/hosts/rapier.md` of Tamis says what is proven, what it costs, and what is not looked at.
#![warn(missing_docs)]

mod clamp;
mod members;
mod mesh;
mod sleep;
mod wanted;
mod way;

pub use clamp::{Clamp, Step};
pub use tamis::{ClampOptions, Error};
