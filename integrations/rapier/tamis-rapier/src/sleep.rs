//! Sleep. rapier takes a body that is put back for one that its caller moves, and lets none in its group sleep.
use crate::clamp::{Clamp, Step};
use rapier3d::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use tamis::{BodyId, Error, NearPair};

/// In steps.
const SLEEP_EVERY: usize = 8;

/// In gaps: bodies that are this near lie on each other.
const NEAR: f64 = 4.0;

/// For how long bodies have been still, in seconds.
#[derive(Default)]
pub struct Stillness(BTreeMap<BodyId, f32>);

impl Stillness {
    /// A body went from `from` to where it is, in so many seconds; none of its points is farther than `radius` from
    /// its origin. As in rapier, it is still if no point goes faster than twice the threshold.
    pub fn note(&mut self, id: BodyId, body: &RigidBody, from: &Pose, radius: f32, seconds: f32) {
        let threshold = body.activation().normalized_linear_threshold;
        let turn = (from.rotation.inverse() * body.rotation()).to_scaled_axis().length();
        let way = (body.translation() - from.translation).length() + radius * turn;
        let speed = body.linvel().length() + radius * body.angvel().length();
        let is_still = way < 2.0 * threshold * seconds && speed < SPEED.max(threshold);
        let time = self.0.entry(id).or_default();
        *time = if is_still { *time + seconds } else { 0.0 };
    }

    pub fn forget(&mut self, id: BodyId) {
        self.0.remove(&id);
    }

    pub fn is_enough(&self, id: BodyId, body: &RigidBody) -> bool {
        body.is_sleeping() || self.0.get(&id).is_some_and(|&time| time >= body.activation().time_until_sleep)
    }
}

/// In metres a second: gravity gives a body that is held half of this in a step.
const SPEED: f32 = 0.33;

/// The groups of bodies that are joined by pairs.
pub fn groups(bodies: &[BodyId], pairs: &[NearPair]) -> Vec<Vec<BodyId>> {
    let mut group_of: BTreeMap<BodyId, BodyId> = bodies.iter().map(|&id| (id, id)).collect();
    let root = |of: &BTreeMap<BodyId, BodyId>, mut id: BodyId| {
        while of[&id] != id {
            id = of[&id];
        }
        id
    };
    for [a, b] in pairs.iter().map(|pair| pair.bodies) {
        if group_of.contains_key(&a) && group_of.contains_key(&b) {
            let (a, b) = (root(&group_of, a), root(&group_of, b));
            group_of.insert(a.max(b), a.min(b));
        }
    }
    let mut groups: BTreeMap<BodyId, Vec<BodyId>> = BTreeMap::new();
    for &id in bodies {
        groups.entry(root(&group_of, id)).or_default().push(id);
    }
    groups.into_values().collect()
}

impl Clamp {
    /// Lets groups of near bodies doze in the next step once all of a group have been still for long enough, and sleep
    /// after a step in which they dozed and went nowhere.
    pub(crate) fn sleep(
        &mut self,
        step: &Step,
        bodies: &mut RigidBodySet,
        joints: &ImpulseJointSet,
    ) -> Result<(), Error> {
        self.steps += 1;
        let dozed = std::mem::take(&mut self.dozing);
        let dynamic = self.dynamic(bodies);
        let is_still = |(id, handle): &(BodyId, RigidBodyHandle)| {
            self.stillness.is_enough(*id, &bodies[*handle]) && joints.attached_joints(*handle).next().is_none()
        };
        let is_asleep = |(_, handle): &(BodyId, RigidBodyHandle)| bodies[*handle].is_sleeping();
        let has_dozed = |both: &(BodyId, RigidBodyHandle)| {
            is_asleep(both) || dozed.contains_key(&both.0) && step.held.iter().all(|(held, _)| *held != both.1)
        };
        let is_time = self.steps % SLEEP_EVERY == 0 || !dozed.is_empty();
        if !is_time || !dynamic.iter().any(|both| is_still(both) && !is_asleep(both)) {
            return Ok(());
        }
        let ids: Vec<BodyId> = dynamic.iter().map(|(id, _)| *id).collect();
        let pairs = self.world.pairs_within(NEAR * self.options.gap, false)?;
        let on_the_way = |pair: &&NearPair| pair.bodies.iter().any(|&id| self.is_moved(id, bodies));
        let carried: BTreeSet<BodyId> = pairs.iter().filter(on_the_way).flat_map(|pair| pair.bodies).collect();
        let handle_of: BTreeMap<_, _> = dynamic.iter().copied().collect();
        let mut tired = vec![];
        for group in groups(&ids, &pairs) {
            let group: Vec<_> = group.into_iter().map(|id| (id, handle_of[&id])).collect();
            if !group.iter().all(is_still) || group.iter().any(|(id, _)| carried.contains(id)) {
                continue;
            }
            if group.iter().all(is_asleep) {
                continue;
            }
            if group.iter().all(has_dozed) {
                tired.extend(group.into_iter().map(|(_, handle)| handle));
            } else {
                self.dozing.extend(group.into_iter().map(|(id, _)| (id, LockedAxes::empty())));
            }
        }
        for handle in tired {
            bodies[handle].sleep();
        }
        Ok(())
    }

    /// Is it a kinematic body on its way?
    fn is_moved(&self, id: BodyId, bodies: &RigidBodySet) -> bool {
        let body = self.members.get(&id).and_then(|member| bodies.get(member.owner.body()?));
        body.is_some_and(|b| b.is_kinematic() && (b.linvel() != Vector::ZERO || b.angvel() != Vector::ZERO))
    }

    /// The members that rapier moves.
    fn dynamic(&self, bodies: &RigidBodySet) -> Vec<(BodyId, RigidBodyHandle)> {
        let all = self.members.iter().filter_map(|(&id, member)| Some((id, member.owner.body()?)));
        all.filter(|(_, handle)| bodies.get(*handle).is_some_and(RigidBody::is_dynamic)).collect()
    }
}
