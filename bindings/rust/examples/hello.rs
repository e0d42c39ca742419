//! The README's example: two triangles; the second one's corner falls onto the first.
use tamis::{Motion, PathOptions, Pose, Shape, World};

fn main() -> Result<(), tamis::Error> {
    let first = Shape::new(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]])?;
    let start = vec![[0.25, 0.25, 1.0], [1.0, 0.5, 2.0], [0.5, 1.0, 2.0]];
    let second = Shape::new(&start, &[[0, 1, 2]])?;
    let mut end = start.clone();
    end[0] = [0.25, 0.25, -1.0];

    let mut world = World::new(1)?;
    world.add(&first, &Motion::at(Pose::default()))?;
    world.add(&second, &Motion::Deforming { start, end })?;
    for contact in world.contacts(&PathOptions::default())? {
        let (vertex, body) = (contact.vertices[0], contact.bodies[0]);
        let (lower, upper) = (contact.toi_lower, contact.toi_upper);
        println!("vertex {vertex} of body {body} meets the face in [{lower:.6}, {upper:.6}]");
    }
    Ok(())
}
