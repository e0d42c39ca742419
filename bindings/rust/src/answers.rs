use crate::world::BodyId;

/// Two features that touch during the step. Vertices are those of the bodies' own meshes.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Contact {
    /// 0: a vertex and a face, 1: two edges, 2: a vertex and an edge, 3: two vertices.
    pub kind: i32,
    /// 0: proven to touch; 1: arithmetic could not decide; kept, because a contact must never be missed.
    pub certainty: i32,
    /// The vertices of the first feature, then those of the second; -1 where the kind has fewer.
    pub vertices: [i32; 4],
    /// A fraction of the step in [0, 1]: the pair is apart before this time.
    pub toi_lower: f64,
    /// A pair that is proven to touch does so at this time or before.
    pub toi_upper: f64,
    /// The first contact weight (`tamis_contact` of the C interface).
    pub u: f64,
    /// The second weight.
    pub v: f64,
    /// Unit vector: the direction in which the first feature must go, or against which the second must go, so that they
    /// part.
    pub normal: [f64; 3],
    /// The first feature's body and the second's.
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
    /// The distance between them.
    pub distance: f64,
    /// The first weight of the closest points.
    pub u: f64,
    /// The second weight.
    pub v: f64,
    /// Unit vector from the second feature's closest point to the first's.
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
    /// The first common point along the edge has a parameter in [`s_lower`, `s_upper`].
    pub s_lower: f64,
    /// See `s_lower`.
    pub s_upper: f64,
    /// The first weight of that point on the face: (1-u-v) f0 + u f1 + v f2.
    pub u: f64,
    /// The second weight.
    pub v: f64,
    /// The edge's body and the face's.
    pub bodies: [BodyId; 2],
}

/// How far all bodies may go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Earliest {
    /// A fraction of the step: nothing touches before; 1 if nothing touches at all.
    pub toi_lower: f64,
    /// A contact that is proven happens at this time or before; 1 if there is none.
    pub toi_upper: f64,
    /// The first contact; `None` if nothing touches.
    pub contact: Option<Contact>,
}
