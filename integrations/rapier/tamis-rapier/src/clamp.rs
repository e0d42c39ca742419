use crate::members::{contents_of, Content, Member, Owner, Part};
use crate::mesh::{double_pose, Mesh};
use crate::sleep::Stillness;
use crate::wanted::Wanted;
use crate::way::Way;
use glamx::{DPose3, DVec3};
use rapier3d::math::Pose;
use rapier3d::prelude::*;
use std::collections::{BTreeMap, HashMap};
use tamis::{BodyId, ClampOptions, Error, Shape, Velocity, World};

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
    pub(crate) world: World,
    pub(crate) options: ClampOptions,
    pub(crate) members: BTreeMap<BodyId, Member>,
    bodies_of: BTreeMap<Owner, BodyId>,
    given: HashMap<ColliderHandle, Given>,
    turns: BTreeMap<Owner, (RigidBodyHandle, f64)>,
    pub(crate) stillness: Stillness,
    /// Bodies that are to fall asleep in the next step, and the axes that are locked otherwise.
    pub(crate) dozing: BTreeMap<BodyId, LockedAxes>,
    pub(crate) steps: usize,
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
            stillness: Stillness::default(),
            dozing: BTreeMap::new(),
            steps: 0,
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
        self.before(&mut physics.bodies, &physics.colliders)?;
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
    pub fn before(&mut self, bodies: &mut RigidBodySet, colliders: &ColliderSet) -> Result<(), Error> {
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
            self.stillness.forget(id);
            self.world.remove(id)?;
        }
        while let Some((owner, (content, pose))) = present.pop_first() {
            match self.bodies_of.get(&owner) {
                Some(&id) => self.put(id, pose)?,
                None => self.join(owner, content, pose)?,
            }
        }
        for (id, locked) in &mut self.dozing {
            let Some(handle) = self.members.get(id).and_then(|member| member.owner.body()) else { continue };
            let Some(body) = bodies.get_mut(handle) else { continue };
            *locked = body.locked_axes();
            body.set_locked_axes(LockedAxes::all(), false);
            body.set_linvel(Vector::ZERO, false);
            body.set_angvel(Vector::ZERO, false);
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
        for (id, &locked) in &self.dozing {
            let Some(handle) = self.members.get(id).and_then(|member| member.owner.body()) else { continue };
            if let Some(body) = bodies.get_mut(handle) {
                body.set_locked_axes(locked, false);
            }
        }
        let mut ways = BTreeMap::new();
        for (id, handle) in self.members.iter().filter_map(|(&id, m)| Some((id, m.owner.body()?))).collect::<Vec<_>>() {
            let Some(body) = bodies.get(handle) else { continue };
            let (start, end, centre) = (self.members[&id].pose, *body.position(), self.members[&id].content.centre);
            if body.is_dynamic() && multibodies.rigid_body_link(handle).is_none() {
                if start != end || !body.is_sleeping() {
                    ways.insert(id, Way { start, end, centre });
                }
            } else {
                self.put(id, end)?;
            }
        }
        let moving: Vec<BodyId> = ways.keys().copied().collect();
        let seconds = f64::from(parameters.dt);
        let mut wanted = Wanted {
            moving: &moving,
            ways,
            members: &self.members,
            dozing: &self.dozing,
            bodies,
            colliders,
            joints,
            seconds,
        };
        let clamped = self.world.clamp(&mut wanted, &self.options)?;
        let ways = wanted.ways;
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
        for (&id, end) in moving.iter().zip(&clamped.ends) {
            let pose = ways[&id].at(end.fraction);
            self.rest(id, pose)?;
            let Some(handle) = self.members[&id].owner.body() else { continue };
            let is_held = end.fraction < 1.0 && !ways[&id].stays();
            if is_held || !self.dozing.contains_key(&id) {
                take(bodies, handle, pose, &end.velocity);
            }
            let radius = self.members[&id].radius as f32;
            self.stillness.note(id, &bodies[handle], &ways[&id].start, radius, parameters.dt);
            if is_held {
                step.held.push((handle, end.fraction));
            }
        }
        self.sleep(&step, bodies, joints)?;
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
        let member = Member { owner, shape: Shape::new(&points, &mesh.faces)?, content, radius, first_vertices, pose };
        let id = self.world.add(&member.shape, &member.motion()?)?;
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

/// Puts a body where it may be.
fn take(bodies: &mut RigidBodySet, handle: RigidBodyHandle, pose: Pose, velocity: &Velocity) {
    let (linear, angular, body) = (vector(velocity.linear), vector(velocity.angular), &bodies[handle]);
    if *body.position() == pose && (body.is_sleeping() || (body.linvel() == linear && body.angvel() == angular)) {
        return;
    }
    let body = &mut bodies[handle];
    body.set_position(pose, false);
    if !body.is_sleeping() {
        body.set_linvel(linear, false);
        body.set_angvel(angular, false);
    }
}

fn vector(v: [f64; 3]) -> Vector {
    Vector::new(v[0] as f32, v[1] as f32, v[2] as f32)
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
