use crate::answers::Contact;
use crate::error::Error;
use crate::motion::Pose;
use crate::shape::Shape;
use crate::sys;
pub use crate::sys::{End, Inertia, Velocity};
use crate::world::{BodyId, World};
use std::any::Any;
use std::cell::{Cell, RefCell};
use std::ffi::{c_int, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr::null;

/// A step that an engine wants to make. The proof is about each body's way from `pose(body, 0)` to its final pose: the
/// origin goes straight, and the body turns the shorter way about a fixed axis. The origin must be the centre of mass.
pub trait WantedStep {
    /// Bodies that are to move and may be held back, each once. All others stay where the world has them.
    fn moving(&self) -> &[BodyId];
    /// The pose of a body after `fraction` of its way, in [0, 1], rounded as the engine keeps it: so the proof is about
    /// what the engine does. At 0, also of bodies that stay, where the body is now; at 1 it has turned by less than
    /// half a turn.
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
    /// How long the step takes; > 0.
    fn seconds(&self) -> f64;
    /// In gaps, in (0, 1]: the distance that bodies keep from those that they lie on. Less than one where the engine's
    /// solver lets bodies come to rest a little nearer than a gap.
    fn carried_at(&self) -> f64 {
        1.0
    }
    /// The shape with which a body was added.
    fn shape(&self, body: BodyId) -> &Shape;
    /// How a body of `moving` answers impulses.
    fn inertia(&self, body: BodyId) -> Inertia;
    /// The coefficient of friction between two bodies.
    fn friction(&self, first: BodyId, second: BodyId) -> f64;
    /// With which the body begins its next step; also of bodies that stay, such as a platform that is yet to move.
    fn velocity(&self, body: BodyId) -> Velocity;
    /// With which a body of `moving` goes its way in this step. It may differ from `velocity` where an engine corrects
    /// positions.
    fn way(&self, body: BodyId) -> Velocity;
    /// From now on the body wants to go a whole step with this velocity instead, and `pose` is about that way.
    fn set_way(&mut self, body: BodyId, way: &Velocity);
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
        ClampOptions { gap: sys::DEFAULT_GAP, rounds: sys::DEFAULT_ROUNDS }
    }
}

/// How much of a step may be made.
#[derive(Debug, Clone, PartialEq)]
pub struct Clamped {
    /// For each body of `moving` where and how fast it ends. An engine must take both.
    pub ends: Vec<End>,
    /// How many questions were asked; 1 if no body is held back.
    pub questions: i32,
    /// The number of pairs of bodies that overlap at the start; they are not held back because of each other.
    pub overlapping: usize,
    /// The contacts that held bodies back: for each question and pair of bodies the first one.
    pub limits: Vec<Contact>,
}

impl World {
    /// Takes the speed by which bodies would come too near to those that carry them, and shortens the ways of bodies so
    /// that no two bodies touch at any time, except pairs that overlap at the start. Leaves the world with the proven
    /// motions, after a refusal with those of before. Refuses a gap, rounds or seconds out of range, and poses that are
    /// not finite. A panic of the step's functions goes on to the caller: tell the bodies of `moving` their motions
    /// again before the next question.
    pub fn clamp(&mut self, step: &mut dyn WantedStep, options: &ClampOptions) -> Result<Clamped, Error> {
        let (moving, seconds, carried_at) = (step.moving().to_vec(), step.seconds(), step.carried_at());
        let asked = Asked { step: RefCell::new(step), panic: Cell::new(None) };
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
            seconds,
            carried_at,
            shape: Some(shape),
            inertia: Some(inertia),
            friction: Some(friction),
            velocity: Some(velocity),
            way: Some(way),
            set_way: Some(set_way),
        };
        let mut ends = vec![End::default(); moving.len()];
        let (mut count, mut clamped) = (0, sys::tamis_clamped::default());
        // SAFETY: `ends` has one for each body. `asked` outlives the call, and the functions below cast `user` back
        // to it.
        let status =
            unsafe { sys::tamis_world_clamp(self.handle, &wanted, ends.as_mut_ptr(), &mut count, &mut clamped) };
        if let Some(panic) = asked.panic.take() {
            resume_unwind(panic);
        }
        self.checked(status)?;
        let limits = self.copied(count, sys::tamis_world_copy_contacts)?;
        Ok(Clamped { ends, questions: clamped.questions, overlapping: clamped.overlapping, limits })
    }
}

/// What `user` points to. No panic may pass through C: it waits here until the call returns.
struct Asked<'a> {
    step: RefCell<&'a mut dyn WantedStep>,
    panic: Cell<Option<Box<dyn Any + Send>>>,
}

/// Asks the step; after a panic the answer is `otherwise`.
///
/// # Safety
/// `user` points to an `Asked`.
unsafe fn ask<T>(user: *mut c_void, otherwise: T, question: impl FnOnce(&mut dyn WantedStep) -> T) -> T {
    let asked = &*user.cast::<Asked>();
    catch_unwind(AssertUnwindSafe(|| question(*asked.step.borrow_mut()))).unwrap_or_else(|panic| {
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

unsafe extern "C" fn shape(user: *mut c_void, body: i32) -> *const sys::tamis_shape {
    ask(user, null(), |step| step.shape(body).handle.cast_const())
}

unsafe extern "C" fn inertia(user: *mut c_void, body: i32, inertia: *mut Inertia) {
    *inertia = ask(user, Inertia::default(), |step| step.inertia(body));
}

unsafe extern "C" fn friction(user: *mut c_void, first: i32, second: i32) -> f64 {
    ask(user, 0.0, |step| step.friction(first, second))
}

unsafe extern "C" fn velocity(user: *mut c_void, body: i32, velocity: *mut Velocity) {
    *velocity = ask(user, Velocity::default(), |step| step.velocity(body));
}

unsafe extern "C" fn way(user: *mut c_void, body: i32, way: *mut Velocity) {
    *way = ask(user, Velocity::default(), |step| step.way(body));
}

unsafe extern "C" fn set_way(user: *mut c_void, body: i32, way: *const Velocity) {
    ask(user, (), |step| step.set_way(body, &*way));
}
