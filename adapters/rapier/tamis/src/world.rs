use crate::answers::{Contact, Earliest, Intersection, NearPair};
use crate::error::{check, text, Error};
use crate::motion::{Link, Motion};
use crate::shape::Shape;
use crate::sys;
use std::ffi::c_int;
use std::ptr::null_mut;

/// Names a body of one world: 0, 1, 2, ... in the order in which they are added; never given twice.
pub type BodyId = i32;

/// What becomes of pairs that touch at t=0.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum AtStart {
    /// They are contacts.
    #[default]
    Report = 0,
    /// They count once they have come apart.
    Ignore = 1,
    /// The question ends with an error, which names the first of them.
    Fail = 2,
}

/// Of one question.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Query {
    /// What becomes of pairs that touch at t=0.
    pub at_start: AtStart,
    /// Where a body turns: the widest bracket of a contact, a part of the step in (0, 1]; 0: 1e-9.
    pub tolerance: f64,
    /// Pairs that come as near as this are contacts; `None`: those that touch.
    pub min_separation: Option<f64>,
}

/// Bodies, each with its own mesh and its own way of moving during t from 0 to 1, as it was told last.
pub struct World {
    pub(crate) handle: *mut sys::tamis_world,
    /// Of each body that was added, by its number.
    vertex_counts: Vec<usize>,
}

// SAFETY: no thread owns what a world has.
unsafe impl Send for World {}

impl World {
    /// A world without bodies, whose questions are answered by so many threads; 0: as many as there are.
    pub fn new(threads: i32) -> Result<World, Error> {
        let options = sys::tamis_world_options {
            size: size_of::<sys::tamis_world_options>(),
            threads,
            ..sys::tamis_world_options::default()
        };
        let mut world = World { handle: null_mut(), vertex_counts: Vec::new() };
        // SAFETY: the options are read before the call returns.
        let status = unsafe { sys::tamis_world_create(&options, &mut world.handle) };
        world.checked(status)?;
        Ok(world)
    }

    /// Refuses numbers that are not finite, other than one point a vertex, and a body that turns by more than 4096
    /// radians.
    pub fn add(&mut self, shape: &Shape, motion: &Motion) -> Result<BodyId, Error> {
        let mut body = -1;
        // SAFETY: what `motions_of` points to is in `motion`; a body is one number.
        let status = unsafe {
            sys::tamis_world_add(self.handle, shape.handle, &motions_of(motion, shape.vertex_count)?, &mut body)
        };
        self.checked(status)?;
        self.vertex_counts.push(shape.vertex_count);
        Ok(body)
    }

    /// How a body moves from now on; it may begin to move in another way. Refuses a body that is not there, and as
    /// `add`.
    pub fn move_body(&mut self, body: BodyId, motion: &Motion) -> Result<(), Error> {
        // SAFETY: as in `add`.
        let status = unsafe { sys::tamis_world_move(self.handle, &body, &motions_of(motion, self.vertices_of(body))?) };
        self.checked(status)
    }

    /// Where the vertices of a body are at a time in [0, 1] of its motion, on the curves that questions are about, and by
    /// how much a coordinate is off at most: 0 where these are the very points.
    pub fn points_at(&mut self, body: BodyId, time: f64) -> Result<(Vec<[f64; 3]>, f64), Error> {
        let vertices = self.vertices_of(body);
        let (mut points, mut error) = (vec![[0.0; 3]; vertices], 0.0);
        // SAFETY: three numbers a vertex, and one.
        let status = unsafe {
            sys::tamis_world_points_at(self.handle, body, time, vertices as i32, points.as_mut_ptr().cast(), &mut error)
        };
        self.checked(status)?;
        Ok((points, error))
    }

    /// Takes a body out; its number is not given again.
    pub fn remove(&mut self, body: BodyId) -> Result<(), Error> {
        // SAFETY: one number.
        let status = unsafe { sys::tamis_world_remove(self.handle, &body, 1) };
        self.checked(status)
    }

    /// A body that is switched off takes no part in any question.
    pub fn set_enabled(&mut self, body: BodyId, is_enabled: bool) -> Result<(), Error> {
        // SAFETY: one number.
        let status = unsafe { sys::tamis_world_set_enabled(self.handle, &body, 1, c_int::from(is_enabled)) };
        self.checked(status)
    }

    /// Half of a body's thickness, >= 0, at first 0: contact means a distance of at most the minimum separation plus both
    /// radii.
    pub fn set_radius(&mut self, body: BodyId, radius: f64) -> Result<(), Error> {
        // SAFETY: one number.
        let status = unsafe { sys::tamis_world_set_radius(self.handle, &body, 1, radius) };
        self.checked(status)
    }

    /// May two bodies, or a deforming one with itself, touch at all? At first all may.
    pub fn set_may_touch(&mut self, a: BodyId, b: BodyId, may_touch: bool) -> Result<(), Error> {
        // SAFETY: one pair.
        let status = unsafe { sys::tamis_world_set_may_touch(self.handle, [a, b].as_ptr(), 1, c_int::from(may_touch)) };
        self.checked(status)
    }

    /// Every pair of features that touches during the step, by kind, then bodies and vertices.
    pub fn contacts(&mut self, query: &Query) -> Result<Vec<Contact>, Error> {
        let mut count = 0;
        // SAFETY: pointers to locals.
        let status = unsafe { sys::tamis_world_contacts(self.handle, &options_of(query), &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_contacts)
    }

    /// The first of them: how far all may go.
    pub fn earliest(&mut self, query: &Query) -> Result<Earliest, Error> {
        let (mut lower, mut upper, mut count) = (0.0, 0.0, 0);
        // SAFETY: pointers to locals.
        let status =
            unsafe { sys::tamis_world_earliest(self.handle, &options_of(query), &mut lower, &mut upper, &mut count) };
        self.checked(status)?;
        let contact = self.copied(count, sys::tamis_world_copy_contacts)?.first().copied();
        Ok(Earliest { lower, upper, contact })
    }

    /// As of a planner: the first contact of each of many motions of some bodies, each named once, while all others move
    /// as they were told. A motion has one chain for each of `bodies`, in their order; all chains have as many links.
    /// Threads share the motions; each answer has the bits that it has alone. The bodies themselves go on moving as they
    /// were told.
    pub fn earliest_many(
        &mut self,
        bodies: &[BodyId],
        motions: &[Vec<Motion>],
        query: &Query,
    ) -> Result<Vec<Earliest>, Error> {
        let (links, links_of_each) = chains_of(bodies, motions)?;
        let given = sys::tamis_motions {
            size: size_of::<sys::tamis_motions>(),
            count: bodies.len() * motions.len(),
            links: links.as_ptr(),
            links_of_each,
            ..sys::tamis_motions::default()
        };
        let mut answers = vec![sys::tamis_earliest::default(); motions.len()];
        // SAFETY: `bodies.len()` numbers, `given.count` chains of so many links, room for an answer a motion.
        let status = unsafe {
            sys::tamis_world_earliest_many(
                self.handle,
                bodies.as_ptr(),
                bodies.len(),
                &given,
                &options_of(query),
                answers.as_mut_ptr(),
                size_of::<sys::tamis_earliest>(),
            )
        };
        self.checked(status)?;
        let earliest_of = |answer: sys::tamis_earliest| Earliest {
            lower: answer.toi_lower,
            upper: answer.toi_upper,
            contact: (answer.has_contact != 0).then_some(answer.contact),
        };
        Ok(answers.into_iter().map(earliest_of).collect())
    }

    /// Is there none? Then that is proven.
    pub fn is_free(&mut self, query: &Query) -> Result<bool, Error> {
        let mut is_free = 0;
        // SAFETY: pointers to locals.
        let status = unsafe { sys::tamis_world_is_free(self.handle, &options_of(query), &mut is_free) };
        self.checked(status)?;
        Ok(is_free != 0)
    }

    /// Pairs of features within `distance` of each other at t=0.
    pub fn pairs_within(&mut self, distance: f64) -> Result<Vec<NearPair>, Error> {
        let mut count = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_pairs_within(self.handle, distance, &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_pairs_within)
    }

    /// Edges that pass through triangles at t=0.
    pub fn intersections(&mut self) -> Result<Vec<Intersection>, Error> {
        let mut count = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_intersections(self.handle, &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_intersections)
    }

    /// Are there any? Ends at the first.
    pub fn has_intersection(&mut self) -> Result<bool, Error> {
        let mut has_one = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_has_intersection(self.handle, &mut has_one) };
        self.checked(status)?;
        Ok(has_one != 0)
    }

    /// 0 of a body that was never added.
    fn vertices_of(&self, body: BodyId) -> usize {
        usize::try_from(body).ok().and_then(|i| self.vertex_counts.get(i)).copied().unwrap_or(0)
    }

    pub(crate) fn checked(&self, status: c_int) -> Result<(), Error> {
        // SAFETY: the sentence is of the call just made.
        check(status, || text(unsafe { sys::tamis_world_message(self.handle) }))
    }

    /// The rows of the last answer, by the function that hands them out.
    pub(crate) fn copied<Row: Clone + Default>(
        &mut self,
        count: usize,
        copy: unsafe extern "C" fn(*mut sys::tamis_world, usize, usize, *mut Row, usize) -> c_int,
    ) -> Result<Vec<Row>, Error> {
        let mut rows = vec![Row::default(); count];
        // SAFETY: room for `count` rows of the size given.
        let status = unsafe { copy(self.handle, 0, count, rows.as_mut_ptr(), size_of::<Row>()) };
        self.checked(status)?;
        Ok(rows)
    }
}

impl Drop for World {
    fn drop(&mut self) {
        // SAFETY: made by the library, freed once.
        unsafe { sys::tamis_world_free(self.handle) }
    }
}

fn options_of(query: &Query) -> sys::tamis_query_options {
    sys::tamis_query_options::new(query.min_separation.as_ref(), query.at_start as i32, query.tolerance)
}

/// Of one body of so many vertices.
fn motions_of(motion: &Motion, vertices: usize) -> Result<sys::tamis_motions, Error> {
    let mut motions =
        sys::tamis_motions { size: size_of::<sys::tamis_motions>(), count: 1, ..sys::tamis_motions::default() };
    match motion {
        Motion::At(pose) => motions.poses = pose,
        Motion::Along(links) => (motions.links, motions.links_of_each) = (links.as_ptr(), links.len()),
        Motion::Deforming { start, end } => {
            let (starts, ends) = (start.len(), end.len());
            check(c_int::from(starts != vertices || ends != vertices) * INVALID_STEP, || {
                format!("a body has {vertices} vertices, start {starts} points and end {ends}: give one a vertex")
            })?;
            motions.start = start.as_ptr().cast();
            motions.end = end.as_ptr().cast();
            motions.vertex_count = vertices as i32;
        }
    }
    Ok(motions)
}

/// The links of all chains, one after the other, and how many each has.
fn chains_of(bodies: &[BodyId], motions: &[Vec<Motion>]) -> Result<(Vec<Link>, usize), Error> {
    let refuse = |message| Err(Error { status: INVALID_STEP, message });
    let (mut links, mut of_each) = (Vec::new(), None);
    for motion in motions {
        if motion.len() != bodies.len() {
            return refuse(format!(
                "a motion has {} chains: give one for each of {} bodies",
                motion.len(),
                bodies.len()
            ));
        }
        for chain in motion {
            let Motion::Along(chain) = chain else {
                return refuse("a body is to stay or to deform: give each a chain of links".to_owned());
            };
            let expected = *of_each.get_or_insert(chain.len());
            if chain.len() != expected {
                return refuse(format!("a chain has {} links, the first {expected}: give each as many", chain.len()));
            }
            links.extend_from_slice(chain);
        }
    }
    Ok((links, of_each.unwrap_or(0)))
}

/// `TAMIS_INVALID_STEP`.
const INVALID_STEP: c_int = 3;
