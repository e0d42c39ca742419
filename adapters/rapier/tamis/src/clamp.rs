use crate::answers::Contact;
use crate::error::Error;
use crate::motion::Pose;
use crate::sys;
use crate::world::{BodyId, World};
use std::any::Any;
use std::cell::Cell;
use std::ffi::{c_int, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};

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
    /// Leaves the world with the proven motions, after a refusal with those of before. Refuses a gap or rounds out of range, and poses that are not finite. A panic of the step's
    /// functions goes on to the caller: tell the bodies of `moving` their motions again before the next question.
    pub fn clamp(&mut self, step: &dyn WantedStep, options: &ClampOptions) -> Result<Clamped, Error> {
        let moving = step.moving();
        let asked = Asked { step, panic: Cell::new(None) };
        let wanted = sys::tamis_wanted_step {
            size: size_of::<sys::tamis_wanted_step>(),
            user: (&raw const asked).cast_mut().cast(),
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
        // SAFETY: `fractions` has one number a body. `asked` outlives the call, and the functions below cast `user` back
        // to it.
        let status =
            unsafe { sys::tamis_world_clamp(self.handle, &wanted, fractions.as_mut_ptr(), &mut count, &mut clamped) };
        if let Some(panic) = asked.panic.take() {
            resume_unwind(panic);
        }
        self.checked(status)?;
        let limits = self.copied(count, sys::tamis_world_copy_contacts)?;
        Ok(Clamped { fractions, questions: clamped.questions, overlapping: clamped.overlapping, limits })
    }
}

/// What `user` points to. No panic may pass through C: it waits here until the call returns.
struct Asked<'a> {
    step: &'a dyn WantedStep,
    panic: Cell<Option<Box<dyn Any + Send>>>,
}

/// Asks the step; after a panic the answer is `otherwise`.
///
/// # Safety
/// `user` points to an `Asked`.
unsafe fn ask<T>(user: *mut c_void, otherwise: T, question: impl FnOnce(&dyn WantedStep) -> T) -> T {
    let asked = &*user.cast::<Asked>();
    catch_unwind(AssertUnwindSafe(|| question(asked.step))).unwrap_or_else(|panic| {
        asked.panic.set(Some(panic));
        otherwise
    })
}

/// The clamp refuses it.
const NOWHERE: Pose = Pose { position: [f64::NAN; 3], rotation: [f64::NAN; 3] };

unsafe extern "C" fn pose(user: *mut c_void, body: i32, fraction: f64, pose: *mut Pose) {
    *pose = ask(user, NOWHERE, |step| step.pose(body, fraction));
}

unsafe extern "C" fn radius(user: *mut c_void, body: i32) -> f64 {
    ask(user, 0.0, |step| step.radius(body))
}

unsafe extern "C" fn collides_at(user: *mut c_void, first: i32, at_first: i32, second: i32, at_second: i32) -> c_int {
    c_int::from(ask(user, true, |step| step.collides_at((first, at_first), (second, at_second))))
}

unsafe extern "C" fn collides(user: *mut c_void, first: i32, second: i32) -> c_int {
    c_int::from(ask(user, true, |step| step.collides(first, second)))
}
