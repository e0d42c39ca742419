//! Throws that engines are to stop: the plates of `integrations/bullet/throws`, and rods like those there.
use rapier3d::math::{Pose, Rotation, Vector};
use rapier3d::prelude::*;
use std::f64::consts::PI;
use std::time::{Duration, Instant};
use tamis_rapier::{Clamp, ClampOptions, Error};

/// The shape of the flying body, and what stops it.
#[derive(Clone, Copy)]
pub struct Method {
    pub name: &'static str,
    pub is_hull: bool,
    pub has_ccd: bool,
    pub is_clamped: bool,
}

const fn method(name: &'static str, is_hull: bool, has_ccd: bool, is_clamped: bool) -> Method {
    Method { name, is_hull, has_ccd, is_clamped }
}

pub const METHODS: [Method; 6] = [
    method("rapier, hull without CCD", true, false, false),
    method("rapier, hull", true, true, false),
    method("rapier, mesh without CCD", false, false, false),
    method("rapier, mesh", false, true, false),
    method("clamped, hull", true, false, true),
    method("clamped, mesh", false, false, true),
];

pub struct Triangles {
    pub points: Vec<Vector>,
    pub faces: Vec<[u32; 3]>,
}

/// Tests the poses of a flight.
type Judge = Box<dyn Fn(&[Pose]) -> bool>;

pub struct Throw {
    pub fixed: Triangles,
    half_extents: Vector,
    position: Vector,
    velocity: Vector,
    spin: Vector,
    steps: usize,
    seconds: f32,
    /// The body can only turn about z.
    on_axle: bool,
    /// Has the body passed through? True if a pose can be reached in no other way.
    is_through: Judge,
}

pub struct Flight {
    /// steps + 1
    pub poses: Vec<Pose>,
    pub time: Duration,
}

/// Random numbers, the same as in C++.
struct Random(rand_mt::Mt);

impl Random {
    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * f64::from(self.0.next_u32()) / 4294967296.0
    }
    fn normal(&mut self) -> f64 {
        let length = (-2.0 * self.between(0.5 / 4294967296.0, 1.0).ln()).sqrt();
        length * (2.0 * PI * self.between(0.0, 1.0)).cos()
    }
    fn direction(&mut self, length: f64) -> Vector {
        vector([length * self.normal(), length * self.normal(), length * self.normal()])
    }
}

fn vector(p: [f64; 3]) -> Vector {
    Vector::new(p[0] as f32, p[1] as f32, p[2] as f32)
}

/// A plate of 30 x 20 x 4 cm, at 20 to 120 m/s, turning at up to some 100 rad/s about any axis, against a wall of 2 x 2
/// m and 128 triangles.
pub fn spinning_plates(count: usize) -> Vec<Throw> {
    let mut random = Random(rand_mt::Mt::new(1));
    let throws = (0..count).map(|_| {
        let position = vector([0.013, 0.007, random.between(0.6, 3.0)]);
        let velocity = vector([0.0, 0.0, -random.between(20.0, 120.0)]);
        let spin = [0.0, 30.0, 100.0][random.between(0.0, 3.0) as usize];
        Throw {
            fixed: wall(),
            half_extents: Vector::new(0.15, 0.1, 0.02),
            position,
            velocity,
            spin: random.direction(spin),
            steps: 30,
            seconds: 1.0 / 60.0,
            on_axle: false,
            is_through: Box::new(|poses| poses.iter().any(|pose| is_behind_wall(pose.translation))),
        }
    });
    throws.collect()
}

/// A rod of 2 m, on an axle through its middle, that turns at 180 rad/s. A plate without thickness stands in its way,
/// somewhere in the 2.9 rad that rapier turns the rod in one step.
pub fn spinning_rods(count: usize) -> Vec<Throw> {
    let mut random = Random(rand_mt::Mt::new(1));
    let throws = (0..count).map(|_| {
        let angle = random.between(0.15, 2.7);
        let corner = |r: f64, z: f64| vector([r * angle.cos(), r * angle.sin(), z]);
        Throw {
            fixed: Triangles {
                points: vec![corner(0.4, -0.3), corner(0.8, -0.3), corner(0.8, 0.3), corner(0.4, 0.3)],
                faces: vec![[0, 1, 2], [0, 2, 3]],
            },
            half_extents: Vector::new(1.0, 0.01, 0.01),
            position: Vector::ZERO,
            velocity: Vector::ZERO,
            spin: Vector::new(0.0, 0.0, 180.0),
            steps: 4,
            seconds: 1.0 / 60.0,
            on_axle: true,
            is_through: Box::new(move |poses| {
                let turned = turned_by(poses);
                turned.iter().any(|&t| t > angle + 0.02 || t < angle - PI - 0.02)
            }),
        }
    });
    throws.collect()
}

/// The angle by which the body has turned about z after each step, added up.
fn turned_by(poses: &[Pose]) -> Vec<f64> {
    let mut turned = 0.0;
    let steps = poses.windows(2).map(|ends| {
        let turn: Rotation = ends[1].rotation * ends[0].rotation.inverse();
        turned += 2.0 * f64::from(turn.z * turn.w.signum()).atan2(f64::from(turn.w.abs()));
        turned
    });
    steps.collect()
}

/// Where a plate is not after it has left the wall over its edge.
fn is_behind_wall(p: Vector) -> bool {
    p.z < -0.3 && p.x.abs() < 1.0 && p.y.abs() < 1.0
}

fn wall() -> Triangles {
    const CELLS: u32 = 8;
    let at = |i: u32| 2.0 * i as f32 / CELLS as f32 - 1.0;
    let mut wall = Triangles { points: vec![], faces: vec![] };
    for i in 0..=CELLS {
        wall.points.extend((0..=CELLS).map(|j| Vector::new(at(i), at(j), 0.0)));
    }
    for i in 0..CELLS {
        for a in (0..CELLS).map(|j| i * (CELLS + 1) + j) {
            let b = a + CELLS + 1;
            wall.faces.extend([[a, b, a + 1], [a + 1, b, b + 1]]);
        }
    }
    wall
}

impl Throw {
    pub fn flying(&self) -> Triangles {
        let (points, faces) = Cuboid::new(self.half_extents).to_trimesh();
        Triangles { points, faces }
    }

    fn world(&self, method: &Method) -> (PhysicsWorld, RigidBodyHandle) {
        let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
        world.integration_parameters.dt = self.seconds;
        if !method.has_ccd {
            world.integration_parameters.max_ccd_substeps = 0;
        }
        let fixed = ColliderBuilder::trimesh(self.fixed.points.clone(), self.fixed.faces.clone());
        world.insert(RigidBodyBuilder::fixed(), fixed.expect("a wall"));
        let flying = self.flying();
        let collider = if method.is_hull {
            ColliderBuilder::convex_hull(&flying.points).expect("a hull")
        } else {
            ColliderBuilder::trimesh(flying.points, flying.faces).expect("a mesh")
        };
        let volume = 8.0 * self.half_extents.element_product();
        let mut body = RigidBodyBuilder::dynamic()
            .translation(self.position)
            .linvel(self.velocity)
            .angvel(self.spin)
            .allow_fast_rotation(true)
            .ccd_enabled(method.has_ccd)
            .additional_mass_properties(MassProperties::from_cuboid(1.0 / volume, self.half_extents));
        if self.on_axle {
            body = body.lock_translations().enabled_rotations(false, false, true);
        }
        let (flying, _) = world.insert(body, collider.density(0.0));
        (world, flying)
    }

    pub fn fly(&self, method: &Method) -> Result<Flight, Error> {
        let (mut world, flying) = self.world(method);
        let mut clamp = Clamp::new(ClampOptions::default(), 1)?;
        let mut poses = vec![*world.bodies[flying].position()];
        let begin = Instant::now();
        for _ in 0..self.steps {
            if method.is_clamped {
                clamp.step(&mut world)?;
            } else {
                world.step();
            }
            poses.push(*world.bodies[flying].position());
        }
        Ok(Flight { poses, time: begin.elapsed() })
    }

    pub fn steps(&self) -> usize {
        self.steps
    }

    pub fn is_through(&self, flight: &Flight) -> bool {
        (self.is_through)(&flight.poses)
    }
}
