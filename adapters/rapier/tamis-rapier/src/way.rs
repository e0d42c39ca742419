//! How rapier moves a body in one step.
use crate::mesh::double_pose;
use glamx::DVec3;
use rapier3d::math::{Pose, Vector};
use tamis::Error;

/// The pose of the centre of mass. Tamis has a body's triangles in a frame with this origin, as the centre of mass goes
/// straight.
pub fn pose_of(pose: &Pose, centre: DVec3) -> Result<tamis::Pose, Error> {
    let q = pose.rotation.as_dquat();
    tamis::Pose::of_quaternion([q.w, q.x, q.y, q.z], double_pose(pose).transform_point(centre).to_array())
}

/// The way from one of rapier's poses to the next: the centre of mass goes straight, and the body turns the shorter way
/// at constant speed about a fixed axis.
pub struct Way {
    pub start: Pose,
    pub end: Pose,
    pub centre: DVec3,
}

impl Way {
    /// The pose after `fraction` of the way, rounded as rapier keeps it.
    pub fn at(&self, fraction: f64) -> Pose {
        if fraction <= 0.0 {
            return self.start;
        }
        if fraction >= 1.0 {
            return self.end;
        }
        let (start, end) = (double_pose(&self.start), double_pose(&self.end));
        let rotation = start.rotation.slerp(end.rotation, fraction).as_quat();
        let centre = start.transform_point(self.centre).lerp(end.transform_point(self.centre), fraction);
        let origin = centre - rotation.as_dquat().normalize() * self.centre;
        Pose::from_parts(Vector::new(origin.x as f32, origin.y as f32, origin.z as f32), rotation)
    }
}
