//! The clamp without an engine, as callers of other engines use it.
#![cfg(feature = "clamp")]
use std::panic::{catch_unwind, AssertUnwindSafe};
use tamis::{BodyId, ClampOptions, Inertia, Motion, Pose, Shape, Velocity, WantedStep, World};

fn at(z: f64) -> Pose {
    Pose { position: [0.0, 0.0, z], rotation: [0.0; 3] }
}

/// A plate that falls from z = 1 to z = -1, onto another one; one of the functions may panic.
struct Falling {
    bodies: [BodyId; 1],
    plate: Shape,
    panics: &'static str,
}

impl Falling {
    fn panic_in(&self, function: &str) {
        assert!(function != self.panics, "{function} gives up");
    }
}

impl WantedStep for Falling {
    fn moving(&self) -> &[BodyId] {
        &self.bodies
    }
    fn pose(&self, _: BodyId, fraction: f64) -> Pose {
        self.panic_in("pose");
        at(1.0 - 2.0 * fraction)
    }
    fn radius(&self, _: BodyId) -> f64 {
        self.panic_in("radius");
        1.0
    }
    fn collides(&self, _: BodyId, _: BodyId) -> bool {
        self.panic_in("collides");
        true
    }
    fn collides_at(&self, _: (BodyId, i32), _: (BodyId, i32)) -> bool {
        self.panic_in("collides_at");
        true
    }
    fn seconds(&self) -> f64 {
        1.0
    }
    fn shape(&self, _: BodyId) -> &Shape {
        &self.plate
    }
    fn inertia(&self, _: BodyId) -> Inertia {
        Inertia { inverse_mass: [1.0; 3], ..Inertia::default() }
    }
    fn friction(&self, _: BodyId, _: BodyId) -> f64 {
        0.0
    }
    fn velocity(&self, body: BodyId) -> Velocity {
        self.panic_in("velocity");
        self.way(body)
    }
    fn way(&self, _: BodyId) -> Velocity {
        Velocity { linear: [0.0, 0.0, -2.0], angular: [0.0; 3] }
    }
    fn set_way(&mut self, _: BodyId, _: &Velocity) {}
}

/// Bug: a panic went from the step's functions into C, which aborted the process.
#[test]
fn a_panic_in_the_step_comes_to_the_caller() {
    let plate = || Shape::new(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]]).unwrap();
    let mut world = World::new(1).unwrap();
    world.add(&plate(), &Motion::at(at(0.0))).unwrap();
    let body = world.add(&plate(), &Motion::interpolated(at(1.0), at(1.0))).unwrap();
    let options = ClampOptions::default();
    for panics in ["pose", "radius", "collides", "collides_at", "velocity"] {
        let mut step = Falling { bodies: [body], plate: plate(), panics };
        let payload = catch_unwind(AssertUnwindSafe(|| world.clamp(&mut step, &options))).unwrap_err();
        assert_eq!(*payload.downcast::<String>().unwrap(), format!("{panics} gives up"));
        world.move_body(body, &Motion::interpolated(at(1.0), at(1.0))).unwrap();
    }
    let clamped = world.clamp(&mut Falling { bodies: [body], plate: plate(), panics: "" }, &options).unwrap();
    assert!((clamped.ends[0].fraction - 0.4995).abs() < 1e-4);
}
