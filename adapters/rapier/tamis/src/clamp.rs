use crate::answers::Contact;
use crate::error::Error;
use crate::motion::Pose;
use crate::sys;
use crate::world::{BodyId, World};
use std::ffi::{c_int, c_void};

/// A step that an engine wants to make. The proof is about each body's way from `pose(body, 0)` to its final pose: the
/// origin goes straight, and the body turns the shorter way about a fixed axis.
pub trait WantedStep {
    /// Bodies that are to move and may be held back, each once. All others stay where the world has them.
    fn moving(&self) -> &[BodyId];
    /// The pose of a body after `fraction` of its way, in [0, 1], rounded as the engine keeps it: so the proof is about
    /// what the engine does. At 0 the body is where it is now; at 1 it has turned by less than half a turn.
    fn pose(&self, body: BodyId, fraction: f64) -> Pose;
    /// The largest distance of a body's points from its origin, or a bound of it; for all bodies.
    fn radius(&self, body: BodyId) -> f64;
    /// Does the engine collide these two bodies?
    fn collides(&self, first: BodyId, second: BodyId) -> bool;
    /// Does the engine collide two bodies, for which `collides` is true, at these vertices of their shapes? For bodies
    /// of several parts that collide with different things.
    fn collides_at(&self, _first: (BodyId, i32), _second: (BodyId, i32)) -> bool {
        true
    }
}

/// How bodies are held back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClampOptions {
    /// > 0, in the unit of the positions: how far before a contact a body is stopped.
    pub gap: f64,
    /// How often the question is asked again with shorter ways. After these rounds bodies that still touch stay where
    /// they are.
    pub rounds: i32,
}

impl Default for ClampOptions {
    fn default() -> Self {
        ClampOptions { gap: 1e-3, rounds: 8 }
    }
}

/// How much of a step may be made.
#[derive(Debug, Clone, PartialEq)]
pub struct Clamped {
    /// For each body of `moving` the fraction of its way that it may go.
    pub fractions: Vec<f64>,
    /// How many questions were asked; 1 if no body is held back.
    pub questions: i32,
    /// The number of pairs of bodies that overlap at the start; they are not held back because of each other.
    pub overlapping: usize,
    /// The contacts that held bodies back: for each question and pair of bodies the first one.
    pub limits: Vec<Contact>,
}

impl World {
    /// Shortens the ways of bodies so that no two bodies touch at any time, except pairs that overlap at the start.
    /// Leaves the world with the proven motions, after a refusal with those of before. Refuses a gap or rounds out of range, and poses that are not finite.
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
        // SAFETY: `fractions` has one number a body. `user` outlives the call, and the functions below cast it back to
        // what it points to.
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
