use crate::world::BodyId;

/// Two features that touch during the step. Vertices are those of the bodies' own meshes.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Contact {
    /// 0: a vertex and a face, 1: two edges, 2: a vertex and an edge, 3: two vertices.
    pub kind: i32,
    /// 0: proven to touch; 1: arithmetic could not tell, kept so that no contact is missed.
    pub certainty: i32,
    /// Those of the first feature, then of the second; -1 where the kind has fewer.
    pub vertices: [i32; 4],
    /// A part of the step: the pair is apart before.
    pub toi_lower: f64,
    /// It touches at this time or before, if that is proven.
    pub toi_upper: f64,
    /// Where on the features (`tamis_contact` of the C interface).
    pub u: f64,
    /// The second weight.
    pub v: f64,
    /// Of unit length, from the second feature to the first.
    pub normal: [f64; 3],
    /// Whose the first feature is, and the second.
    pub bodies: [BodyId; 2],
}

/// Two features that are near each other at t=0.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct NearPair {
    /// As of a contact.
    pub kind: i32,
    /// As of a contact.
    pub vertices: [i32; 4],
    /// How far they are apart.
    pub distance: f64,
    /// Weights of the closest points.
    pub u: f64,
    /// The second weight.
    pub v: f64,
    /// From the second feature's closest point to the first's.
    pub direction: [f64; 3],
    /// As of a contact.
    pub bodies: [BodyId; 2],
}

/// An edge that passes through a triangle, or touches it, at t=0.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Intersection {
    /// Vertices of the edge.
    pub edge: [i32; 2],
    /// Vertices of the face.
    pub face: [i32; 3],
    /// The first common point lies between this and `s_upper` on the edge.
    pub s_lower: f64,
    /// See `s_lower`.
    pub s_upper: f64,
    /// Weights on the face: (1-u-v) f0 + u f1 + v f2.
    pub u: f64,
    /// The second weight.
    pub v: f64,
    /// Whose the edge is, and the face.
    pub bodies: [BodyId; 2],
}

/// How far all bodies may go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Earliest {
    /// A part of the step: nothing touches before; 1 if nothing does at all.
    pub lower: f64,
    /// The first contact is at this time or before.
    pub upper: f64,
    /// The first one.
    pub contact: Option<Contact>,
}
