use crate::error::{check, Error};
use crate::sys;
pub use crate::sys::{Pose, RigidLink};

impl Pose {
    /// The pose of a quaternion (w x y z), as engines keep it, also in floats: its rounding errors are removed by
    /// taking the nearest rotation. Refuses a quaternion that is off by more (|q|^2 from 1 by more than 1e-4), and
    /// numbers that are not finite.
    pub fn of_quaternion(quaternion: [f64; 4], position: [f64; 3]) -> Result<Pose, Error> {
        let mut pose = Pose::default();
        // SAFETY: the quaternion has four numbers, the position three.
        let status = unsafe { sys::tamis_pose_of_quaternion(quaternion.as_ptr(), position.as_ptr(), &mut pose) };
        check(status, || {
            format!("{quaternion:?} at {position:?} is not a pose: give a quaternion of unit length and finite numbers")
        })?;
        Ok(pose)
    }

    /// The pose of a body that moves by this chain of links, at a time in [0, 1], for example after a step that is safe
    /// until then.
    pub fn on(chain: &[RigidLink], time: f64) -> Result<Pose, Error> {
        let mut pose = Pose::default();
        // SAFETY: the array has as many links as the call says.
        let status = unsafe { sys::tamis_pose_at(chain.as_ptr(), chain.len(), time, &mut pose) };
        check(status, || format!("no pose at {time} of {chain:?}: give finite numbers and a time in [0, 1]"))?;
        Ok(pose)
    }
}

/// How a body moves during a step.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// The body stays at this pose. No question looks at two bodies that stay.
    At(Pose),
    /// The body moves as a whole, by a chain of links: a point goes through the last link first. No links: it stays
    /// where its points are given.
    Along(Vec<RigidLink>),
    /// Each vertex goes straight from its place in `start` to its place in `end`.
    Deforming {
        /// One point a vertex, at t=0.
        start: Vec<[f64; 3]>,
        /// The same at t=1.
        end: Vec<[f64; 3]>,
    },
}

impl Motion {
    /// The motion of a body that stays at this pose.
    pub fn at(pose: Pose) -> Motion {
        Motion::At(pose)
    }

    /// The body moves with position and rotation vector linear in t.
    pub fn interpolated(start: Pose, end: Pose) -> Motion {
        Motion::Along(vec![RigidLink { start, end }])
    }

    /// From one pose to the other, by the shorter turn about a fixed axis, at constant speed, while `center`, a point
    /// in the body's own frame, goes straight. Engines take the centre of mass.
    pub fn between(start: &Pose, end: &Pose, center: [f64; 3]) -> Result<Motion, Error> {
        links_of(|links| unsafe { sys::tamis_chain_between(start, end, center.as_ptr(), links) })
    }

    /// The same by the given turn, of any angle: a rotation vector in the frame of the world. `center` goes straight to
    /// `end_position`.
    pub fn turned(start: &Pose, turn: [f64; 3], end_position: [f64; 3], center: [f64; 3]) -> Result<Motion, Error> {
        links_of(|links| unsafe {
            sys::tamis_turned_chain(start, turn.as_ptr(), end_position.as_ptr(), center.as_ptr(), links)
        })
    }
}

/// `write` fills two links.
fn links_of(write: impl FnOnce(*mut RigidLink) -> i32) -> Result<Motion, Error> {
    let mut links = vec![RigidLink::default(); 2];
    check(write(links.as_mut_ptr()), || "a number of a pose or a turn is not finite: give finite ones".to_owned())?;
    Ok(Motion::Along(links))
}
