//! rapier's step as the clamp asks about it.
use crate::members::{Member, Part};
use crate::mesh::double;
use crate::way::{pose_of, Way};
use rapier3d::prelude::*;
use std::collections::BTreeMap;
use tamis::{BodyId, Inertia, Shape, Velocity, WantedStep};

const NOWHERE: tamis::Pose = tamis::Pose { position: [f64::NAN; 3], rotation: [f64::NAN; 3] };

pub struct Wanted<'a> {
    pub moving: &'a [BodyId],
    pub ways: BTreeMap<BodyId, Way>,
    pub members: &'a BTreeMap<BodyId, Member>,
    pub dozing: &'a BTreeMap<BodyId, LockedAxes>,
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub joints: &'a ImpulseJointSet,
    pub seconds: f64,
}

impl Wanted<'_> {
    fn body(&self, body: BodyId) -> Option<&RigidBody> {
        self.bodies.get(self.members[&body].owner.body()?)
    }

    fn meet(&self, a: &Part, b: &Part) -> bool {
        // A collider that was removed since `before` meets nothing.
        let (Some(a), Some(b)) = (self.colliders.get(a.collider), self.colliders.get(b.collider)) else { return false };
        a.collision_groups().test(b.collision_groups()) && a.solver_groups().test(b.solver_groups())
    }
}

impl WantedStep for Wanted<'_> {
    fn moving(&self) -> &[BodyId] {
        self.moving
    }

    fn pose(&self, body: BodyId, fraction: f64) -> tamis::Pose {
        let Some(way) = self.ways.get(&body) else {
            let Member { pose, content, .. } = &self.members[&body];
            return pose_of(pose, content.centre).unwrap_or(NOWHERE);
        };
        // The question refuses numbers that are not finite.
        pose_of(&way.at(fraction), way.centre).unwrap_or(NOWHERE)
    }

    fn radius(&self, body: BodyId) -> f64 {
        self.members[&body].radius
    }

    fn collides(&self, first: BodyId, second: BodyId) -> bool {
        let (first, second) = (&self.members[&first], &self.members[&second]);
        if let (Some(a), Some(b)) = (first.owner.body(), second.owner.body()) {
            if self.joints.joints_between(a, b).any(|(_, joint)| !joint.data.contacts_enabled) {
                return false;
            }
        }
        first.content.parts.iter().any(|a| second.content.parts.iter().any(|b| self.meet(a, b)))
    }

    fn collides_at(&self, first: (BodyId, i32), second: (BodyId, i32)) -> bool {
        self.meet(self.members[&first.0].part_of(first.1), self.members[&second.0].part_of(second.1))
    }

    fn seconds(&self) -> f64 {
        self.seconds
    }

    fn carried_at(&self) -> f64 {
        0.5
    }

    fn shape(&self, body: BodyId) -> &Shape {
        &self.members[&body].shape
    }

    fn inertia(&self, body: BodyId) -> Inertia {
        let Some(body) = self.body(body) else { return Inertia::default() };
        let properties = &body.mass_properties();
        let mut inverse_inertia = [0.0; 9];
        for (row, axis) in inverse_inertia.chunks_mut(3).zip([Vector::X, Vector::Y, Vector::Z]) {
            row.copy_from_slice(&double(properties.effective_world_inv_inertia * axis).to_array());
        }
        Inertia { inverse_mass: double(properties.effective_inv_mass).to_array(), inverse_inertia }
    }

    /// Of bodies with several colliders that of the roughest two.
    fn friction(&self, first: BodyId, second: BodyId) -> f64 {
        let of = |id| self.members[&id].content.parts.iter().filter_map(|part| self.colliders.get(part.collider));
        let all = of(first).flat_map(|a| of(second).map(move |b| combined_friction(a, b)));
        f64::from(all.fold(0.0, f32::max))
    }

    /// Kinematic bodies are at the ends of their ways already.
    fn velocity(&self, body: BodyId) -> Velocity {
        match self.body(body).filter(|_| self.ways.contains_key(&body)) {
            Some(body) => {
                Velocity { linear: double(body.linvel()).to_array(), angular: double(body.angvel()).to_array() }
            }
            None => Velocity::default(),
        }
    }

    fn way(&self, body: BodyId) -> Velocity {
        self.ways[&body].velocity(self.seconds)
    }

    fn set_way(&mut self, body: BodyId, way: &Velocity) {
        if self.dozing.contains_key(&body) {
            return;
        }
        if let Some(known) = self.ways.get_mut(&body) {
            *known = Way::by(way, known.start, known.centre, self.seconds);
        }
    }
}

fn combined_friction(a: &Collider, b: &Collider) -> f32 {
    CoefficientCombineRule::combine(a.friction(), b.friction(), a.friction_combine_rule(), b.friction_combine_rule())
}
