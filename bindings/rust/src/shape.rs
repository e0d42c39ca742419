use crate::error::{check, check_version, text, Error};
use crate::sys;
use std::ptr::{null, null_mut};

/// A mesh with its points at rest, in the body's own frame, and the hierarchy over them: made once, for any number of
/// bodies.
pub struct Shape {
    pub(crate) handle: *mut sys::tamis_shape,
    pub(crate) vertex_count: usize,
}

// SAFETY: a shape never changes after it is made.
unsafe impl Send for Shape {}
unsafe impl Sync for Shape {}

struct Mesh(*mut sys::tamis_mesh);

impl Drop for Mesh {
    fn drop(&mut self) {
        // SAFETY: made by the library, freed once.
        unsafe { sys::tamis_mesh_free(self.0) }
    }
}

impl Shape {
    /// `faces`: triangles by the numbers of their corners in `points`. Refuses numbers out of range, and points that
    /// are not finite, and an installed library of another minor version.
    pub fn new(points: &[[f64; 3]], faces: &[[i32; 3]]) -> Result<Shape, Error> {
        check_version()?;
        let input = sys::tamis_mesh_input {
            size: size_of::<sys::tamis_mesh_input>(),
            vertex_count: points.len() as i32,
            faces: faces.as_ptr().cast(),
            face_count: faces.len(),
            ..sys::tamis_mesh_input::default()
        };
        let mut mesh = Mesh(null_mut());
        // SAFETY: the arrays live until the call returns; they are copied.
        check(unsafe { sys::tamis_mesh_create(&input, &mut mesh.0) }, || {
            text(unsafe { sys::tamis_mesh_message(mesh.0) })
        })?;
        let mut shape = Shape { handle: null_mut(), vertex_count: points.len() };
        // SAFETY: there are as many points as the mesh has vertices; the call copies them.
        check(unsafe { sys::tamis_shape_create(mesh.0, points.as_ptr().cast(), null(), &mut shape.handle) }, || {
            text(unsafe { sys::tamis_shape_message(shape.handle) })
        })?;
        Ok(shape)
    }
}

impl Drop for Shape {
    fn drop(&mut self) {
        // SAFETY: made by the library, freed once; bodies keep what they need of it.
        unsafe { sys::tamis_shape_free(self.handle) }
    }
}
