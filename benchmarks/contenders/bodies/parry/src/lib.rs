//! parry's cast of two moving shapes, for C. A panic is no answer.
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{cast_shapes_nonlinear, NonlinearRigidMotion};
use parry3d_f64::shape::{SharedShape, TriMesh};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::slice::from_raw_parts;

const NO_ANSWER: f64 = -1.0;
const NEVER: f64 = 2.0;

/// # Safety
/// `points` has three numbers a point, `faces` three a face.
#[no_mangle]
pub unsafe extern "C" fn parry_shape(
    points: *const f64,
    point_count: usize,
    faces: *const i32,
    face_count: usize,
    is_convex: bool,
) -> *mut SharedShape {
    let points: Vec<Vector> = from_raw_parts(points, 3 * point_count)
        .chunks(3)
        .map(|p| Vector::new(p[0], p[1], p[2]))
        .collect();
    let faces: Vec<[u32; 3]> = from_raw_parts(faces, 3 * face_count)
        .chunks(3)
        .map(|f| [f[0] as u32, f[1] as u32, f[2] as u32])
        .collect();
    let shape = if is_convex {
        SharedShape::convex_hull(&points)
    } else {
        TriMesh::new(points, faces).ok().map(SharedShape::new)
    };
    shape.map_or(std::ptr::null_mut(), |shape| Box::into_raw(Box::new(shape)))
}

/// # Safety
/// `shape` is of `parry_shape`, and not used again.
#[no_mangle]
pub unsafe extern "C" fn parry_free(shape: *mut SharedShape) {
    drop(Box::from_raw(shape));
}

/// `numbers`: where it starts, how far it goes, its turn.
unsafe fn motion(numbers: *const f64) -> NonlinearRigidMotion {
    let n = from_raw_parts(numbers, 9);
    NonlinearRigidMotion::new(
        Pose::from_translation(Vector::new(n[0], n[1], n[2])),
        Vector::ZERO,
        Vector::new(n[3], n[4], n[5]),
        Vector::new(n[6], n[7], n[8]),
    )
}

/// # Safety
/// Shapes of `parry_shape`, motions of nine numbers.
#[no_mangle]
pub unsafe extern "C" fn parry_first_contact(
    first: *const SharedShape,
    first_motion: *const f64,
    second: *const SharedShape,
    second_motion: *const f64,
) -> f64 {
    let (first_motion, second_motion) = (motion(first_motion), motion(second_motion));
    let (first, second) = (&**first, &**second);
    let cast = || cast_shapes_nonlinear(&first_motion, first, &second_motion, second, 0.0, 1.0, true);
    match catch_unwind(AssertUnwindSafe(cast)) {
        Ok(Ok(Some(hit))) => hit.time_of_impact,
        Ok(Ok(None)) => NEVER,
        _ => NO_ANSWER,
    }
}
