use crate::members::{contents_of, Content, Member, Owner, Part};
use crate::mesh::{double_pose, Mesh};
use crate::way::{pose_of, Way};
use glamx::{DPose3, DVec3};
use rapier3d::math::Pose;
use rapier3d::prelude::*;
use std::collections::{BTreeMap, HashMap};
use tamis::{BodyId, ClampOptions, Error, Shape, WantedStep, World};

/// What the clamp did in one step.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Step {
    /// Bodies that were held back, and the fraction of its way that each went.
    pub held: Vec<(RigidBodyHandle, f64)>,
    /// How many questions were asked; 1 if no body was held back.
    pub questions: i32,
    /// The number of pairs of bodies that overlapped when the step began. They are not held back because of each other:
    /// rapier parts them as it always does.
    pub overlapping: usize,
    /// Bodies that began or ended the step with a speed of more than half a turn a step (`allow_fast_rotation`). Their
    /// two poses do not show so large a turn: the proof is about the shorter way.
    pub turned_too_far: Vec<RigidBodyHandle>,
}

/// Holds back the bodies that rapier moves, so that none passes through another. Serves one world: it keeps the
/// triangles of that world's colliders, and notices what is added, removed, moved or changed between two steps.
pub struct Clamp {
    world: World,
    options: ClampOptions,
    members: BTreeMap<BodyId, Member>,
    bodies_of: BTreeMap<Owner, BodyId>,
    given: HashMap<ColliderHandle, Given>,
    turns: BTreeMap<Owner, (RigidBodyHandle, f64)>,
}

/// A mesh given by `set_mesh`. It is for the shape that the collider has when a step first sees it, and for no other.
struct Given {
    mesh: Mesh,
    shape: Option<SharedShape>,
}

impl Clamp {
    /// `threads`: how many threads answer questions; 0: as many as there are.
    pub fn new(options: ClampOptions, threads: i32) -> Result<Clamp, Error> {
        Ok(Clamp {
            world: World::new(threads)?,
            options,
            members: BTreeMap::new(),
            bodies_of: BTreeMap::new(),
            given: HashMap::new(),
            turns: BTreeMap::new(),
        })
    }

    /// Gives triangles, in the collider's frame, to a collider whose shape has none, such as a ball. They are used as
    /// long as the collider has the shape that it has in the next step; after a change of shape give new ones.
    pub fn set_mesh(&mut self, collider: ColliderHandle, points: &[[f64; 3]], faces: &[[i32; 3]]) {
        let points = points.iter().map(|&p| DVec3::from_array(p)).collect();
        self.given.insert(collider, Given { mesh: Mesh { points, faces: faces.to_vec() }, shape: None });
    }

    /// Makes one step of rapier in which no body passes through another. Refuses colliders without triangles, before
    /// anything has moved.
    pub fn step(&mut self, physics: &mut PhysicsWorld) -> Result<Step, Error> {
        self.before(&physics.bodies, &physics.colliders)?;
        physics.step();
        self.after(
            &physics.integration_parameters,
            &mut physics.bodies,
            &mut physics.colliders,
            &physics.impulse_joints,
            &physics.multibody_joints,
        )
    }

    /// For callers of rapier's pipeline, before its step: reads which bodies there are, and where.
    pub fn before(&mut self, bodies: &RigidBodySet, colliders: &ColliderSet) -> Result<(), Error> {
        let mut present = contents_of(bodies, colliders);
        self.turns = fast_turns(bodies);
        self.given.retain(|&collider, _| colliders.contains(collider));
        let is_new = |part: &Part| self.given.get(&part.collider).is_some_and(|given| given.shape.is_none());
        let stale: Vec<BodyId> = (self.members.iter())
            .filter(|(_, member)| present.get(&member.owner).is_none_or(|(content, _)| *content != member.content))
            .chain(self.members.iter().filter(|(_, member)| member.content.parts.iter().any(is_new)))
            .map(|(&id, _)| id)
            .collect();
        for id in stale {
            let Some(member) = self.members.remove(&id) else { continue };
            self.bodies_of.remove(&member.owner);
            self.world.remove(id)?;
        }
        while let Some((owner, (content, pose))) = present.pop_first() {
            match self.bodies_of.get(&owner) {
                Some(&id) => self.put(id, pose)?,
                None => self.join(owner, content, pose)?,
            }
        }
        Ok(())
    }

    /// For callers of rapier's pipeline, after its step: holds bodies back.
    pub fn after(
        &mut self,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &mut ColliderSet,
        joints: &ImpulseJointSet,
        multibodies: &MultibodyJointSet,
    ) -> Result<Step, Error> {
        let mut ways = BTreeMap::new();
        for (id, handle) in self.members.iter().filter_map(|(&id, m)| Some((id, m.owner.body()?))).collect::<Vec<_>>() {
            let Some(body) = bodies.get(handle) else { continue };
            let (start, end, centre) = (self.members[&id].pose, *body.position(), self.members[&id].content.centre);
            if body.is_dynamic() && multibodies.rigid_body_link(handle).is_none() {
                if start != end {
                    ways.insert(id, Way { start, end, centre });
                }
            } else {
                self.put(id, end)?;
            }
        }
        let moving: Vec<BodyId> = ways.keys().copied().collect();
        let wanted = Wanted { moving: &moving, ways: &ways, members: &self.members, colliders, joints };
        let clamped = self.world.clamp(&wanted, &self.options)?;
        for (owner, (handle, now)) in fast_turns(bodies) {
            let fastest = &mut self.turns.entry(owner).or_insert((handle, now)).1;
            *fastest = fastest.max(now);
        }
        let is_too_far = |turn: f64| turn * f64::from(parameters.dt) > MOST_TURN;
        let mut step = Step {
            held: vec![],
            questions: clamped.questions,
            overlapping: clamped.overlapping,
            turned_too_far: self.turns.values().filter(|(_, turn)| is_too_far(*turn)).map(|(body, _)| *body).collect(),
        };
        for (&id, &fraction) in moving.iter().zip(&clamped.fractions) {
            let pose = ways[&id].at(fraction);
            self.rest(id, pose)?;
            let Some(handle) = self.members[&id].owner.body().filter(|_| fraction < 1.0) else { continue };
            bodies[handle].set_position(pose, true);
            step.held.push((handle, fraction));
        }
        bodies.propagate_modified_body_positions_to_colliders(colliders);
        Ok(step)
    }

    fn join(&mut self, owner: Owner, content: Content, pose: Pose) -> Result<(), Error> {
        let (mut mesh, mut first_vertices) = (Mesh::default(), vec![]);
        for part in &content.parts {
            first_vertices.push(mesh.points.len() as i32);
            let at = DPose3::from_translation(-content.centre) * double_pose(&part.at);
            match self.given.get_mut(&part.collider).and_then(|given| given.mesh_for(&part.shape)) {
                Some(given) => mesh.append(given.points.iter().copied(), &given.faces, &at),
                None => mesh.append_shape(&*part.shape.0, &at)?,
            }
        }
        let points: Vec<[f64; 3]> = mesh.points.iter().map(|p| p.to_array()).collect();
        let radius = mesh.points.iter().map(|p| p.length()).fold(0.0, f64::max);
        let member = Member { owner, content, radius, first_vertices, pose };
        let id = self.world.add(&Shape::new(&points, &mesh.faces)?, &member.motion()?)?;
        self.members.insert(id, member);
        self.bodies_of.insert(owner, id);
        Ok(())
    }

    /// Tells the world that the body is at rest at this pose, unless it is at rest there already.
    fn put(&mut self, id: BodyId, pose: Pose) -> Result<(), Error> {
        if self.members.get(&id).is_none_or(|member| member.pose == pose) {
            return Ok(());
        }
        self.rest(id, pose)
    }

    /// The same, whatever motion the world has been told, as by a clamp.
    fn rest(&mut self, id: BodyId, pose: Pose) -> Result<(), Error> {
        let Some(member) = self.members.get_mut(&id) else { return Ok(()) };
        member.pose = pose;
        self.world.move_body(id, &member.motion()?)
    }
}

/// The turning speed, in radians a second, of each body that may turn by more than pi/4 in a step.
fn fast_turns(bodies: &RigidBodySet) -> BTreeMap<Owner, (RigidBodyHandle, f64)> {
    let turns = |(handle, body): (RigidBodyHandle, &RigidBody)| {
        let (index, generation) = handle.into_raw_parts();
        (Owner::Body(index, generation), (handle, f64::from(body.angvel().length())))
    };
    bodies.iter().filter(|(_, body)| body.is_dynamic() && body.is_fast_rotation_allowed()).map(turns).collect()
}

/// In radians: half a turn less a hundredth, as the speed changes during a step.
const MOST_TURN: f64 = 0.99 * std::f64::consts::PI;

impl Given {
    fn mesh_for(&mut self, shape: &SharedShape) -> Option<&Mesh> {
        let known = self.shape.get_or_insert_with(|| shape.clone());
        std::sync::Arc::ptr_eq(&known.0, &shape.0).then_some(&self.mesh)
    }
}

const NOWHERE: tamis::Pose = tamis::Pose { position: [f64::NAN; 3], rotation: [f64::NAN; 3] };

struct Wanted<'a> {
    moving: &'a [BodyId],
    ways: &'a BTreeMap<BodyId, Way>,
    members: &'a BTreeMap<BodyId, Member>,
    colliders: &'a ColliderSet,
    joints: &'a ImpulseJointSet,
}

impl Wanted<'_> {
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
        let way = &self.ways[&body];
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
}
