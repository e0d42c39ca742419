//! Tests, independent of the clamp, whether a throw was stopped.
use crate::scenes::{Flight, Throw, Triangles};
use glamx::DPose3;
use parry3d_f64::query::contact;
use parry3d_f64::shape::TriMesh;
use rapier3d::math::Pose;
use tamis::{Motion, PathOptions, Shape, World};
use tamis_rapier::Error;

impl Throw {
    /// Is each step free? Asks a new world of Tamis, made from the poses alone; true is a proof.
    pub fn is_proven(&self, flight: &Flight) -> Result<bool, Error> {
        let mut world = World::new(1)?;
        world.add(&shape_of(&self.fixed)?, &Motion::at(tamis::Pose::default()))?;
        let body = world.add(&shape_of(&self.flying())?, &Motion::at(tamis::Pose::default()))?;
        for ends in flight.poses.windows(2) {
            world.move_body(body, &Motion::between(&pose_of(&ends[0])?, &pose_of(&ends[1])?, [0.0; 3])?)?;
            if !world.is_free(&PathOptions::default())? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Does a triangle of one mesh lie in one of the other by more than `DEPTH`, at one of `samples` times in a step?
    /// By parry, in doubles. Misses crossings between the times.
    pub fn is_seen_crossing(&self, flight: &Flight, samples: usize) -> bool {
        let mesh = |t: &Triangles| {
            TriMesh::new(t.points.iter().map(|p| p.as_dvec3()).collect(), t.faces.clone()).expect("a mesh")
        };
        let (flying, fixed) = (mesh(&self.flying()), mesh(&self.fixed));
        flight.poses.windows(2).any(|ends| {
            let (start, end) = (double(&ends[0]), double(&ends[1]));
            (1..=samples).any(|sample| {
                let pose = start.lerp(&end, sample as f64 / samples as f64);
                contact(&pose, &flying, &DPose3::IDENTITY, &fixed, 0.0)
                    .expect("meshes")
                    .is_some_and(|c| c.dist < -DEPTH)
            })
        })
    }
}

/// In metres. To parry, triangles that are 1e-10 apart already lie in each other.
const DEPTH: f64 = 1e-8;

fn double(pose: &Pose) -> DPose3 {
    DPose3::from_parts(pose.translation.as_dvec3(), pose.rotation.as_dquat().normalize())
}

/// REQUIRES: the body's centre of mass is its origin, as that of all bodies here.
fn pose_of(pose: &Pose) -> Result<tamis::Pose, Error> {
    let q = pose.rotation.as_dquat();
    tamis::Pose::of_quaternion([q.w, q.x, q.y, q.z], pose.translation.as_dvec3().to_array())
}

fn shape_of(triangles: &Triangles) -> Result<Shape, Error> {
    let points: Vec<_> = triangles.points.iter().map(|p| p.as_dvec3().to_array()).collect();
    let faces: Vec<_> = triangles.faces.iter().map(|f| f.map(|corner| corner as i32)).collect();
    Shape::new(&points, &faces)
}
