use crate::answers::{Contact, Earliest, Intersection, NearPair};
use crate::error::{check, check_version, text, Error};
use crate::motion::{Motion, RigidLink};
use crate::shape::Shape;
use crate::sys;
use std::ffi::c_int;
use std::ptr::{null, null_mut};

/// The number of a body in its world: 0, 1, 2, ... in the order in which bodies are added; never given twice.
pub type BodyId = i32;

/// What becomes of pairs that touch at t=0.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum AtStart {
    /// They are contacts.
    #[default]
    Report = sys::TAMIS_REPORT as isize,
    /// A pair is a contact only when it touches again, after a time at which it does not touch.
    Ignore = sys::TAMIS_IGNORE as isize,
    /// The question ends with an error, which names the first such pair.
    Fail = sys::TAMIS_FAIL as isize,
}

/// Options of one question.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PathOptions {
    /// What becomes of pairs that touch at t=0.
    pub at_start: AtStart,
    /// If a body turns: the widest bracket of a contact, a fraction of the step in (0, 1]; 0: 1e-9.
    pub tolerance: f64,
    /// The minimum separation: pairs that come as near as this are contacts. `None`: pairs that touch are.
    pub min_separation: Option<f64>,
}

/// Bodies, each with its own mesh and motion. During t in [0, 1] each body moves as it was told last.
pub struct World {
    pub(crate) handle: *mut sys::tamis_world,
    /// Entry i belongs to the body with the number i.
    vertex_counts: Vec<usize>,
}

// SAFETY: nothing in a world belongs to one thread.
unsafe impl Send for World {}

impl World {
    /// A world without bodies. `threads`: how many threads answer its questions; 0: as many as there are.
    /// Refuses an installed library of another minor version.
    pub fn new(threads: i32) -> Result<World, Error> {
        check_version()?;
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

    /// Adds a body and returns its number. Refuses numbers that are not finite, a number of points that is not the
    /// shape's, and a body that turns by more than 4096 radians.
    pub fn add(&mut self, shape: &Shape, motion: &Motion) -> Result<BodyId, Error> {
        let mut body = -1;
        // SAFETY: `motions_of` points into `motion`, which outlives the call; `body` is one number.
        let status = unsafe {
            sys::tamis_world_add(self.handle, shape.handle, &motions_of(motion, shape.vertex_count)?, &mut body)
        };
        self.checked(status)?;
        self.vertex_counts.push(shape.vertex_count);
        Ok(body)
    }

    /// Tells a body its motion from now on, of the same kind or another. Refuses what `add` refuses, and a body that
    /// does not exist.
    pub fn move_body(&mut self, body: BodyId, motion: &Motion) -> Result<(), Error> {
        // SAFETY: as in `add`.
        let status = unsafe { sys::tamis_world_move(self.handle, &body, &motions_of(motion, self.vertices_of(body))?) };
        self.checked(status)
    }

    /// Where the vertices of a body are at a time in [0, 1] of its motion, on the curves that questions are about. The
    /// number bounds how far a coordinate is off: if it is 0 these are the very points.
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

    /// Removes a body; its number is not given again.
    pub fn remove(&mut self, body: BodyId) -> Result<(), Error> {
        // SAFETY: one number.
        let status = unsafe { sys::tamis_world_remove(self.handle, &body, 1) };
        self.checked(status)
    }

    /// A body that is switched off takes no part in any question until it is switched on again. Bodies begin switched
    /// on.
    pub fn set_enabled(&mut self, body: BodyId, is_enabled: bool) -> Result<(), Error> {
        // SAFETY: one number.
        let status = unsafe { sys::tamis_world_set_enabled(self.handle, &body, 1, c_int::from(is_enabled)) };
        self.checked(status)
    }

    /// Half of a body's thickness, >= 0; 0 at first. Two bodies are in contact where their distance is at most the
    /// minimum separation plus both radii.
    pub fn set_radius(&mut self, body: BodyId, radius: f64) -> Result<(), Error> {
        // SAFETY: one number.
        let status = unsafe { sys::tamis_world_set_radius(self.handle, &body, 1, radius) };
        self.checked(status)
    }

    /// Sets whether two bodies, or a deforming body with itself, may touch. At first all may.
    pub fn set_may_touch(&mut self, a: BodyId, b: BodyId, may_touch: bool) -> Result<(), Error> {
        // SAFETY: one pair.
        let status = unsafe { sys::tamis_world_set_may_touch(self.handle, [a, b].as_ptr(), 1, c_int::from(may_touch)) };
        self.checked(status)
    }

    /// All contacts, sorted by kind, then bodies and vertices.
    pub fn contacts(&mut self, options: &PathOptions) -> Result<Vec<Contact>, Error> {
        let mut count = 0;
        // SAFETY: pointers to locals.
        let status = unsafe { sys::tamis_world_contacts(self.handle, &options_of(options), &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_contacts)
    }

    /// The first contact of each pair of bodies that touches, and of each deforming body with itself, sorted by the
    /// smaller body, then the greater one.
    pub fn first_contacts(&mut self, options: &PathOptions) -> Result<Vec<Contact>, Error> {
        let mut count = 0;
        // SAFETY: pointers to locals.
        let status = unsafe { sys::tamis_world_first_contacts(self.handle, &options_of(options), &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_contacts)
    }

    /// The first contact: how far all bodies may go.
    pub fn earliest(&mut self, options: &PathOptions) -> Result<Earliest, Error> {
        let (mut toi_lower, mut toi_upper, mut count) = (0.0, 0.0, 0);
        // SAFETY: pointers to locals.
        let status = unsafe {
            sys::tamis_world_earliest(self.handle, &options_of(options), &mut toi_lower, &mut toi_upper, &mut count)
        };
        self.checked(status)?;
        let contact = self.copied(count, sys::tamis_world_copy_contacts)?.first().copied();
        Ok(Earliest { toi_lower, toi_upper, contact })
    }

    /// For planners: the first contact of each of many motions of some bodies, each named once, while all others move
    /// as they were told. A motion has one chain for each of `bodies`, in their order; all chains have as many links.
    /// Threads share the motions; each answer has the bits that it has alone. Afterwards the bodies have the motions of
    /// before.
    pub fn earliest_many(
        &mut self,
        bodies: &[BodyId],
        motions: &[Vec<Motion>],
        options: &PathOptions,
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
                &options_of(options),
                answers.as_mut_ptr(),
                size_of::<sys::tamis_earliest>(),
            )
        };
        self.checked(status)?;
        let earliest_of = |answer: sys::tamis_earliest| Earliest {
            toi_lower: answer.toi_lower,
            toi_upper: answer.toi_upper,
            contact: (answer.has_contact != 0).then_some(answer.contact),
        };
        Ok(answers.into_iter().map(earliest_of).collect())
    }

    /// Is the whole step free of contacts? True is proven.
    pub fn is_free(&mut self, options: &PathOptions) -> Result<bool, Error> {
        let mut is_free = 0;
        // SAFETY: pointers to locals.
        let status = unsafe { sys::tamis_world_is_free(self.handle, &options_of(options), &mut is_free) };
        self.checked(status)?;
        Ok(is_free != 0)
    }

    /// Pairs of features within `distance` of each other at t=0. `include_static`: also of two bodies that stay at a
    /// pose.
    pub fn pairs_within(&mut self, distance: f64, include_static: bool) -> Result<Vec<NearPair>, Error> {
        let mut count = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_pairs_within(self.handle, distance, include_static.into(), &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_pairs_within)
    }

    /// Edges that pass through triangles at t=0. `include_static`: also of two bodies that stay at a pose.
    pub fn intersections(&mut self, include_static: bool) -> Result<Vec<Intersection>, Error> {
        let mut count = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_intersections(self.handle, include_static.into(), &mut count) };
        self.checked(status)?;
        self.copied(count, sys::tamis_world_copy_intersections)
    }

    /// Is there any intersection? Ends at the first one. `include_static`: also of two bodies that stay at a pose.
    pub fn has_intersection(&mut self, include_static: bool) -> Result<bool, Error> {
        let mut has_one = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_has_intersection(self.handle, include_static.into(), &mut has_one) };
        self.checked(status)?;
        Ok(has_one != 0)
    }

    /// Do two bodies overlap at t=0: do they intersect, or is a vertex of one inside another? `include_static`: also
    /// of two bodies that stay at a pose.
    pub fn has_overlap(&mut self, include_static: bool) -> Result<bool, Error> {
        let mut has_one = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_has_overlap(self.handle, include_static.into(), &mut has_one) };
        self.checked(status)?;
        Ok(has_one != 0)
    }

    /// Is the whole surface of a body closed? Open parts contain nothing in `has_overlap`.
    pub fn is_closed(&mut self, body: BodyId) -> Result<bool, Error> {
        let mut is_closed = 0;
        // SAFETY: a pointer to a local.
        let status = unsafe { sys::tamis_world_is_closed(self.handle, body, &mut is_closed) };
        self.checked(status)?;
        Ok(is_closed != 0)
    }

    /// The number of vertices of a body; 0 for one that was never added.
    fn vertices_of(&self, body: BodyId) -> usize {
        usize::try_from(body).ok().and_then(|i| self.vertex_counts.get(i)).copied().unwrap_or(0)
    }

    pub(crate) fn checked(&self, status: c_int) -> Result<(), Error> {
        // SAFETY: the message is that of the call just made.
        check(status, || text(unsafe { sys::tamis_world_message(self.handle) }))
    }

    /// The rows of the last answer; `copy` is the function that copies them.
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

/// Points into `options`.
fn options_of(options: &PathOptions) -> sys::tamis_path_options {
    sys::tamis_path_options {
        size: size_of::<sys::tamis_path_options>(),
        tolerance: options.tolerance,
        min_separation: options.min_separation.as_ref().map_or(null(), |x| x),
        at_start: options.at_start as i32,
        ..sys::tamis_path_options::default()
    }
}

/// The motion of one body with this number of vertices.
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

/// The links of all chains, one chain after the other, and how many links each chain has.
fn chains_of(bodies: &[BodyId], motions: &[Vec<Motion>]) -> Result<(Vec<RigidLink>, usize), Error> {
    let refuse = |message| Err(Error { status: INVALID_STEP, message });
    if bodies.is_empty() && !motions.is_empty() {
        return Err(Error { status: INVALID_OPTIONS, message: "no body is named: name those that move".to_owned() });
    }
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

/// `TAMIS_INVALID_STEP` and `TAMIS_INVALID_OPTIONS`.
const INVALID_STEP: c_int = 3;
const INVALID_OPTIONS: c_int = 4;
