//! The triangles of colliders.
use glamx::{DPose3, DVec3};
use rapier3d::math::{Pose, Vector};
use rapier3d::parry::shape::{Shape, TypedShape};
use tamis::{Error, TAMIS_INVALID_MESH};

#[derive(Debug, Clone, Default)]
pub struct Mesh {
    pub points: Vec<DVec3>,
    pub faces: Vec<[i32; 3]>,
}

impl Mesh {
    pub fn append(&mut self, points: impl IntoIterator<Item = DVec3>, faces: &[[i32; 3]], at: &DPose3) {
        let first = self.points.len() as i32;
        self.points.extend(points.into_iter().map(|p| at.transform_point(p)));
        self.faces.extend(faces.iter().map(|f| f.map(|corner| first + corner)));
    }

    /// Refuses shapes that have no triangles.
    pub fn append_shape(&mut self, shape: &dyn Shape, at: &DPose3) -> Result<(), Error> {
        let (points, faces) = match shape.as_typed_shape() {
            TypedShape::Cuboid(cuboid) => cuboid.to_trimesh(),
            TypedShape::ConvexPolyhedron(hull) => hull.to_trimesh(),
            TypedShape::HeightField(field) => field.to_trimesh(),
            TypedShape::TriMesh(mesh) => (mesh.vertices().to_vec(), mesh.indices().to_vec()),
            TypedShape::Triangle(triangle) => (triangle.vertices().to_vec(), vec![[0, 1, 2]]),
            TypedShape::Compound(compound) => {
                return compound
                    .shapes()
                    .iter()
                    .try_for_each(|(place, part)| self.append_shape(&*part.0, &(*at * double_pose(place))));
            }
            _ => {
                let message = format!(
                    "a collider is a {:?}, which has no triangles: give it some by set_mesh",
                    shape.shape_type()
                );
                return Err(Error { status: TAMIS_INVALID_MESH, message });
            }
        };
        let faces: Vec<_> = faces.iter().map(|f| f.map(|corner| corner as i32)).collect();
        self.append(points.into_iter().map(double), &faces, at);
        Ok(())
    }
}

pub fn double(p: Vector) -> DVec3 {
    DVec3::new(f64::from(p.x), f64::from(p.y), f64::from(p.z))
}

/// The pose in doubles, its quaternion normalized.
pub fn double_pose(pose: &Pose) -> DPose3 {
    DPose3::from_parts(double(pose.translation), pose.rotation.as_dquat().normalize())
}
