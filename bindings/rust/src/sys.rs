//! The parts of `tamis/tamis.h` and `integrations/rapier/clamp/clamp.h` that the crate uses.
#![allow(non_camel_case_types)]
use crate::answers::{Contact, Intersection, NearPair};
use crate::motion::{Pose, RigidLink};
use std::ffi::{c_char, c_int, c_void};

#[repr(C)]
pub struct tamis_mesh {
    _private: [u8; 0],
}
#[repr(C)]
pub struct tamis_shape {
    _private: [u8; 0],
}
#[repr(C)]
pub struct tamis_world {
    _private: [u8; 0],
}

/// Makes all fields of a struct for C zero by default.
macro_rules! zeroed {
    ($name:ident) => {
        impl Default for $name {
            fn default() -> Self {
                // SAFETY: numbers, pointers that may be NULL, and functions that may be none.
                unsafe { std::mem::zeroed() }
            }
        }
    };
}

#[repr(C)]
pub struct tamis_mesh_input {
    pub size: usize,
    pub vertex_count: i32,
    pub faces: *const i32,
    pub face_count: usize,
    pub loose_edges: *const i32,
    pub loose_edge_count: usize,
    pub loose_points: *const i32,
    pub loose_point_count: usize,
}
zeroed!(tamis_mesh_input);

#[repr(C)]
pub struct tamis_shape_options {
    pub size: usize,
    pub isa: *const c_char,
}

#[repr(C)]
pub struct tamis_world_options {
    pub size: usize,
    pub isa: *const c_char,
    pub threads: i32,
    pub rings: i32,
    pub min_separation: f64,
    pub is_cancelled: Option<extern "C" fn(*mut c_void) -> c_int>,
    pub user: *mut c_void,
}
zeroed!(tamis_world_options);

#[repr(C)]
pub struct tamis_motions {
    pub size: usize,
    pub count: usize,
    pub poses: *const Pose,
    pub links: *const RigidLink,
    pub links_of_each: usize,
    pub start: *const f64,
    pub end: *const f64,
    pub vertex_count: i32,
}
zeroed!(tamis_motions);

#[repr(C)]
pub struct tamis_path_options {
    pub size: usize,
    pub tolerance: f64,
    pub min_separation: *const f64,
    pub is_cancelled: Option<extern "C" fn(*mut c_void) -> c_int>,
    pub user: *mut c_void,
    pub at_start: i32,
}
zeroed!(tamis_path_options);

/// The first contact of one of many motions.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct tamis_earliest {
    pub toi_lower: f64,
    pub toi_upper: f64,
    pub has_contact: i32,
    pub contact: Contact,
}

extern "C" {
    pub fn tamis_version() -> *const c_char;

    pub fn tamis_mesh_create(input: *const tamis_mesh_input, mesh: *mut *mut tamis_mesh) -> c_int;
    pub fn tamis_mesh_free(mesh: *mut tamis_mesh);
    pub fn tamis_mesh_message(mesh: *const tamis_mesh) -> *const c_char;
    pub fn tamis_shape_create(
        mesh: *const tamis_mesh,
        points: *const f64,
        options: *const tamis_shape_options,
        shape: *mut *mut tamis_shape,
    ) -> c_int;
    pub fn tamis_shape_free(shape: *mut tamis_shape);
    pub fn tamis_shape_message(shape: *const tamis_shape) -> *const c_char;
    pub fn tamis_chain_between(
        start: *const Pose,
        end: *const Pose,
        center: *const f64,
        links: *mut RigidLink,
    ) -> c_int;
    pub fn tamis_pose_at(links: *const RigidLink, count: usize, time: f64, pose: *mut Pose) -> c_int;
    pub fn tamis_pose_of_quaternion(quaternion: *const f64, position: *const f64, pose: *mut Pose) -> c_int;
    pub fn tamis_turned_chain(
        start: *const Pose,
        turn: *const f64,
        end_position: *const f64,
        center: *const f64,
        links: *mut RigidLink,
    ) -> c_int;

    pub fn tamis_world_create(options: *const tamis_world_options, world: *mut *mut tamis_world) -> c_int;
    pub fn tamis_world_free(world: *mut tamis_world);
    pub fn tamis_world_message(world: *const tamis_world) -> *const c_char;
    pub fn tamis_world_add(
        world: *mut tamis_world,
        shape: *const tamis_shape,
        motions: *const tamis_motions,
        bodies: *mut i32,
    ) -> c_int;
    pub fn tamis_world_move(world: *mut tamis_world, bodies: *const i32, motions: *const tamis_motions) -> c_int;
    pub fn tamis_world_points_at(
        world: *mut tamis_world,
        body: i32,
        time: f64,
        vertex_count: i32,
        points: *mut f64,
        error: *mut f64,
    ) -> c_int;
    pub fn tamis_world_remove(world: *mut tamis_world, bodies: *const i32, count: usize) -> c_int;
    pub fn tamis_world_set_enabled(world: *mut tamis_world, bodies: *const i32, count: usize, on: c_int) -> c_int;
    pub fn tamis_world_set_radius(world: *mut tamis_world, bodies: *const i32, count: usize, radius: f64) -> c_int;
    pub fn tamis_world_set_may_touch(world: *mut tamis_world, bodies: *const i32, count: usize, may: c_int) -> c_int;

    pub fn tamis_world_contacts(
        world: *mut tamis_world,
        options: *const tamis_path_options,
        count: *mut usize,
    ) -> c_int;
    pub fn tamis_world_first_contacts(
        world: *mut tamis_world,
        options: *const tamis_path_options,
        count: *mut usize,
    ) -> c_int;
    pub fn tamis_world_earliest(
        world: *mut tamis_world,
        options: *const tamis_path_options,
        lower: *mut f64,
        upper: *mut f64,
        count: *mut usize,
    ) -> c_int;
    pub fn tamis_world_earliest_many(
        world: *mut tamis_world,
        bodies: *const i32,
        body_count: usize,
        motions: *const tamis_motions,
        options: *const tamis_path_options,
        answers: *mut tamis_earliest,
        answer_size: usize,
    ) -> c_int;
    pub fn tamis_world_is_free(
        world: *mut tamis_world,
        options: *const tamis_path_options,
        is_free: *mut c_int,
    ) -> c_int;
    pub fn tamis_world_pairs_within(
        world: *mut tamis_world,
        distance: f64,
        include_static: c_int,
        count: *mut usize,
    ) -> c_int;
    pub fn tamis_world_intersections(world: *mut tamis_world, include_static: c_int, count: *mut usize) -> c_int;
    pub fn tamis_world_has_intersection(
        world: *mut tamis_world,
        include_static: c_int,
        has_intersection: *mut c_int,
    ) -> c_int;
    pub fn tamis_world_copy_contacts(
        world: *mut tamis_world,
        first: usize,
        count: usize,
        contacts: *mut Contact,
        size: usize,
    ) -> c_int;
    pub fn tamis_world_copy_pairs_within(
        world: *mut tamis_world,
        first: usize,
        count: usize,
        pairs: *mut NearPair,
        size: usize,
    ) -> c_int;
    pub fn tamis_world_copy_intersections(
        world: *mut tamis_world,
        first: usize,
        count: usize,
        intersections: *mut Intersection,
        size: usize,
    ) -> c_int;
}

#[cfg(feature = "clamp")]
pub use clamp::*;

#[cfg(feature = "clamp")]
mod clamp {
    use super::*;

    use crate::clamp::{End, Inertia, Velocity};

    #[repr(C)]
    pub struct tamis_wanted_step {
        pub size: usize,
        pub user: *mut c_void,
        pub moving: *const i32,
        pub moving_count: usize,
        pub pose: Option<unsafe extern "C" fn(*mut c_void, i32, f64, *mut Pose)>,
        pub radius: Option<unsafe extern "C" fn(*mut c_void, i32) -> f64>,
        pub collides: Option<unsafe extern "C" fn(*mut c_void, i32, i32) -> c_int>,
        pub gap: f64,
        pub rounds: i32,
        pub collides_at: Option<unsafe extern "C" fn(*mut c_void, i32, i32, i32, i32) -> c_int>,
        pub seconds: f64,
        pub carried_at: f64,
        pub shape: Option<unsafe extern "C" fn(*mut c_void, i32) -> *const tamis_shape>,
        pub inertia: Option<unsafe extern "C" fn(*mut c_void, i32, *mut Inertia)>,
        pub friction: Option<unsafe extern "C" fn(*mut c_void, i32, i32) -> f64>,
        pub velocity: Option<unsafe extern "C" fn(*mut c_void, i32, *mut Velocity)>,
        pub way: Option<unsafe extern "C" fn(*mut c_void, i32, *mut Velocity)>,
        pub set_way: Option<unsafe extern "C" fn(*mut c_void, i32, *const Velocity)>,
    }

    #[repr(C)]
    #[derive(Default)]
    pub struct tamis_clamped {
        pub questions: i32,
        pub overlapping: usize,
    }

    extern "C" {
        pub fn tamis_world_clamp(
            world: *mut tamis_world,
            step: *const tamis_wanted_step,
            ends: *mut End,
            contact_count: *mut usize,
            clamped: *mut tamis_clamped,
        ) -> c_int;
    }
}
