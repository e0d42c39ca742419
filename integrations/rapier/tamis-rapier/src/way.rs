//! How rapier moves a body in one step.
use crate::mesh::double_pose;
use glamx::{DQuat, DVec3};
use rapier3d::math::{Pose, Vector};
use tamis::{Error, Velocity};

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
    /// The way of a step that begins at `start` and takes `seconds`, at a constant velocity.
    pub fn by(velocity: &Velocity, start: Pose, centre: DVec3, seconds: f64) -> Way {
        let from = double_pose(&start);
        let turn = DQuat::from_scaled_axis(seconds * DVec3::from_array(velocity.angular));
        let to = from.transform_point(centre) + seconds * DVec3::from_array(velocity.linear);
        Way { start, end: rounded(turn * from.rotation, to, centre), centre }
    }

    pub fn velocity(&self, seconds: f64) -> Velocity {
        let (start, end) = (double_pose(&self.start), double_pose(&self.end));
        let turn = end.rotation * start.rotation.conjugate();
        let shorter = if turn.w < 0.0 { -turn } else { turn };
        let moved = end.transform_point(self.centre) - start.transform_point(self.centre);
        Velocity {
            linear: (moved / seconds).to_array(),
            angular: (shorter.normalize().to_scaled_axis() / seconds).to_array(),
        }
    }

    pub fn stays(&self) -> bool {
        self.start == self.end
    }

    /// The pose after `fraction` of the way, rounded as rapier keeps it.
    pub fn at(&self, fraction: f64) -> Pose {
        if fraction <= 0.0 || self.stays() {
            return self.start;
        }
        if fraction >= 1.0 {
            return self.end;
        }
        let (start, end) = (double_pose(&self.start), double_pose(&self.end));
        let centre = start.transform_point(self.centre).lerp(end.transform_point(self.centre), fraction);
        rounded(start.rotation.slerp(end.rotation, fraction), centre, self.centre)
    }
}

/// The pose that rapier keeps of a body that is turned so, with its centre of mass there. `local`: the centre in the
/// body's frame.
fn rounded(rotation: DQuat, centre: DVec3, local: DVec3) -> Pose {
    let rotation = rotation.as_quat();
    let origin = centre - rotation.as_dquat().normalize() * local;
    Pose::from_parts(Vector::new(origin.x as f32, origin.y as f32, origin.z as f32), rotation)
}
