use crate::answers::Contact;
use crate::error::Error;
use crate::motion::Pose;
use crate::sys;
use crate::world::{BodyId, World};
use std::ffi::{c_int, c_void};

/// A step that an engine wants to make. What is proven is the way of each body from `pose(body, 0)` to where it is put
/// at last: origin straight, turn by the shorter way about a fixed axis.
pub trait WantedStep {
    /// Bodies that want to move and may be held back, each once.
    fn moving(&self) -> &[BodyId];
    /// Where a body is once it has gone `fraction` of its way, in [0, 1]: rounded as the engine keeps it. Less than half
    /// a turn from 0 to 1.
    fn pose(&self, body: BodyId, fraction: f64) -> Pose;
    /// How far the points of any body are from its origin, at most.
    fn radius(&self, body: BodyId) -> f64;
    /// Does the engine collide these two?
    fn collides(&self, first: BodyId, second: BodyId) -> bool;
    /// Of two that it does: here, too? For bodies of several parts that differ in what they collide with. A vertex of
    /// each body's shape.
    fn collides_at(&self, _first: (BodyId, i32), _second: (BodyId, i32)) -> bool {
        true
    }
}

/// How bodies are held back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClampOptions {
    /// > 0, in the unit of the positions: how far from a contact a body is stopped.
    pub gap: f64,
    /// How often all are asked anew with shorter ways; after that, bodies that still touch stay where they are.
    pub rounds: i32,
}

impl Default for ClampOptions {
    fn default() -> Self {
        ClampOptions { gap: 1e-3, rounds: 8 }
    }
}

/// What may be done of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Clamped {
    /// One a body of `moving`: which part of its way it may go.
    pub fractions: Vec<f64>,
    /// Questions that this took; 1 where nobody is held back.
    pub questions: i32,
    /// Pairs of bodies that overlap at the start, and are not held back because of each other.
    pub overlapping: usize,
    /// What held bodies back: of each question and pair of bodies the first contact.
    pub limits: Vec<Contact>,
}

impl World {
    /// With the answered parts of their ways, no two bodies touch at any time, but those that overlap at the start.
    /// Leaves the world with the proven motions. Refuses a gap or rounds out of range, and poses that are not finite.
    pub fn clamp(&mut self, step: &dyn WantedStep, options: &ClampOptions) -> Result<Clamped, Error> {
        let moving = step.moving();
        let mut user = step;
        let wanted = sys::tamis_wanted_step {
            size: size_of::<sys::tamis_wanted_step>(),
            user: (&mut user as *mut &dyn WantedStep).cast(),
            moving: moving.as_ptr(),
            moving_count: moving.len(),
            pose: Some(pose),
            radius: Some(radius),
            collides: Some(collides),
            gap: options.gap,
            rounds: options.rounds,
            collides_at: Some(collides_at),
        };
        let mut fractions = vec![0.0; moving.len()];
        let (mut count, mut clamped) = (0, sys::tamis_clamped::default());
        // SAFETY: one fraction a body; `user` outlives the call, and the functions below take it for what it is.
        let status =
            unsafe { sys::tamis_world_clamp(self.handle, &wanted, fractions.as_mut_ptr(), &mut count, &mut clamped) };
        self.checked(status)?;
        let limits = self.copied(count, sys::tamis_world_copy_contacts)?;
        Ok(Clamped { fractions, questions: clamped.questions, overlapping: clamped.overlapping, limits })
    }
}

/// # Safety
/// `user` points to a `&dyn WantedStep`.
unsafe fn step_of<'a>(user: *mut c_void) -> &'a dyn WantedStep {
    *user.cast::<&dyn WantedStep>()
}

unsafe extern "C" fn pose(user: *mut c_void, body: i32, fraction: f64, pose: *mut Pose) {
    *pose = step_of(user).pose(body, fraction);
}

unsafe extern "C" fn radius(user: *mut c_void, body: i32) -> f64 {
    step_of(user).radius(body)
}

unsafe extern "C" fn collides_at(user: *mut c_void, first: i32, at_first: i32, second: i32, at_second: i32) -> c_int {
    c_int::from(step_of(user).collides_at((first, at_first), (second, at_second)))
}

unsafe extern "C" fn collides(user: *mut c_void, first: i32, second: i32) -> c_int {
    c_int::from(step_of(user).collides(first, second))
}
