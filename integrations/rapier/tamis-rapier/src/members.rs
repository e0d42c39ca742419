//! The members of the world of Tamis: bodies and colliders that take part in contacts, each of which moves as a whole.
use crate::mesh::double;
use crate::way::pose_of;
use glamx::DVec3;
use rapier3d::math::Pose;
use rapier3d::prelude::*;
use std::collections::BTreeMap;
use tamis::{Error, Motion, RigidLink};

/// Names what moves as a whole by the parts of its handle: a body, or a collider without a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Owner {
    Body(u32, u32),
    Collider(u32, u32),
}

impl Owner {
    pub fn body(self) -> Option<RigidBodyHandle> {
        match self {
            Owner::Body(index, generation) => Some(RigidBodyHandle::from_raw_parts(index, generation)),
            Owner::Collider(..) => None,
        }
    }
}

/// A collider of a member. It holds the shape, so that rapier cannot change the shape in place.
pub struct Part {
    pub collider: ColliderHandle,
    pub shape: SharedShape,
    pub at: Pose,
}

impl PartialEq for Part {
    fn eq(&self, other: &Part) -> bool {
        self.collider == other.collider && std::sync::Arc::ptr_eq(&self.shape.0, &other.shape.0) && self.at == other.at
    }
}

/// The colliders of a member, and how it moves.
#[derive(PartialEq)]
pub struct Content {
    pub parts: Vec<Part>,
    pub centre: DVec3,
    pub is_fixed: bool,
}

pub struct Member {
    pub owner: Owner,
    pub shape: tamis::Shape,
    pub content: Content,
    pub radius: f64,
    /// For each part, the number of its first vertex.
    pub first_vertices: Vec<i32>,
    /// The pose that the world of Tamis has.
    pub pose: Pose,
}

impl Member {
    pub fn part_of(&self, vertex: i32) -> &Part {
        &self.content.parts[self.first_vertices.partition_point(|&first| first <= vertex) - 1]
    }

    pub fn motion(&self) -> Result<Motion, Error> {
        let pose = pose_of(&self.pose, self.content.centre)?;
        // Questions leave out two bodies that are `At`: a body that may move gets a chain that stays.
        Ok(if self.content.is_fixed {
            Motion::At(pose)
        } else {
            Motion::Along(vec![RigidLink { start: pose, end: pose }])
        })
    }
}

/// All owners that take part in contacts, each with its content and its pose.
pub fn contents_of(bodies: &RigidBodySet, colliders: &ColliderSet) -> BTreeMap<Owner, (Content, Pose)> {
    let mut all = BTreeMap::new();
    for (handle, collider) in colliders.iter().filter(|(_, c)| c.is_enabled() && !c.is_sensor()) {
        let shape = collider.shared_shape().clone();
        let Some(parent) = collider.parent() else {
            let (index, generation) = handle.into_raw_parts();
            let part = Part { collider: handle, shape, at: Pose::IDENTITY };
            let content = Content { parts: vec![part], centre: DVec3::ZERO, is_fixed: true };
            all.insert(Owner::Collider(index, generation), (content, *collider.position()));
            continue;
        };
        let Some(body) = bodies.get(parent).filter(|body| body.is_enabled()) else { continue };
        let (index, generation) = parent.into_raw_parts();
        let at = collider.position_wrt_parent().copied().unwrap_or(Pose::IDENTITY);
        let (content, _) = all.entry(Owner::Body(index, generation)).or_insert_with(|| {
            let centre = double(body.local_center_of_mass());
            (Content { parts: vec![], centre, is_fixed: body.is_fixed() }, *body.position())
        });
        content.parts.push(Part { collider: handle, shape, at });
    }
    all
}
