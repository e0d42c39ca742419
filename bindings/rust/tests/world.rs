//! Asks every question and meets every refusal once; the expected answers are like those of the C++ tests.
use tamis::{AtStart, BodyId, Error, Motion, PathOptions, Pose, Shape, World, TAMIS_INVALID_MESH};

const INVALID_STEP: i32 = 3;
const INVALID_OPTIONS: i32 = 4;

fn triangle() -> Shape {
    Shape::new(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]]).unwrap()
}

fn at(z: f64) -> Pose {
    Pose { position: [0.0, 0.0, z], rotation: [0.0; 3] }
}

/// One triangle at z = 0, and one that falls onto it from z = 1 to z = -1.
fn falling() -> (World, BodyId) {
    let (mut world, shape) = (World::new(1).unwrap(), triangle());
    world.add(&shape, &Motion::at(at(0.0))).unwrap();
    let body = world.add(&shape, &Motion::interpolated(at(1.0), at(-1.0))).unwrap();
    (world, body)
}

#[test]
fn what_falls_touches_half_way() {
    let (mut world, body) = falling();
    let earliest = world.earliest(&PathOptions::default()).unwrap();
    assert!((earliest.toi_lower - 0.5).abs() < 1e-9 && (earliest.toi_upper - 0.5).abs() < 1e-9);
    let contacts = world.contacts(&PathOptions::default()).unwrap();
    assert!(contacts.contains(&earliest.contact.unwrap()));
    assert_eq!(world.first_contacts(&PathOptions::default()).unwrap(), [earliest.contact.unwrap()]);
    assert!(contacts.iter().all(|c| c.bodies.contains(&body) && c.certainty == 0));
    assert!(!world.is_free(&PathOptions::default()).unwrap());
    let near = PathOptions { min_separation: Some(0.5), ..PathOptions::default() };
    assert!((world.earliest(&near).unwrap().toi_lower - 0.25).abs() < 1e-9);
}

#[test]
fn vertices_are_where_the_motion_takes_them() {
    let (mut world, body) = falling();
    assert_eq!(world.points_at(0, 0.5).unwrap(), (vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], 0.0));
    let (points, error) = world.points_at(body, 0.75).unwrap();
    assert!((points[1][2] + 0.5).abs() <= error && error < 1e-14);
    assert_eq!(world.points_at(body, 1.5).unwrap_err().status, INVALID_OPTIONS);
    assert_eq!(world.points_at(7, 0.5).unwrap_err().status, INVALID_OPTIONS);
}

#[test]
fn a_radius_is_half_of_a_thickness() {
    let (mut world, body) = falling();
    world.set_radius(body, 0.3).unwrap();
    world.set_radius(0, 0.2).unwrap();
    assert!((world.earliest(&PathOptions::default()).unwrap().toi_lower - 0.25).abs() < 1e-9);
    assert!(world.set_radius(body, -1.0).is_err());
}

#[test]
fn many_motions_are_answered_as_each_alone() {
    let (mut world, body) = falling();
    let motions: Vec<_> = [-1.0, 0.5, -3.0].map(|end| vec![Motion::interpolated(at(1.0), at(end))]).into();
    let many = world.earliest_many(&[body], &motions, &PathOptions::default()).unwrap();
    assert!(many[1].contact.is_none() && many[1].toi_lower == 1.0);
    for (motion, earliest) in motions.iter().zip(&many) {
        world.move_body(body, &motion[0]).unwrap();
        assert_eq!(*earliest, world.earliest(&PathOptions::default()).unwrap());
    }
    assert!(world.earliest_many(&[body], &[], &PathOptions::default()).unwrap().is_empty());
    let refusal =
        |world: &mut World, motion| world.earliest_many(&[body], &[motion], &PathOptions::default()).unwrap_err();
    assert_eq!(refusal(&mut world, vec![]).message, "a motion has 0 chains: give one for each of 1 bodies");
    let stays = refusal(&mut world, vec![Motion::at(at(0.0))]);
    assert_eq!(stays.message, "a body is to stay or to deform: give each a chain of links");
    let of_nobody = world.earliest_many(&[], &[vec![], vec![]], &PathOptions::default()).unwrap_err();
    assert_eq!(of_nobody.status, INVALID_OPTIONS);
    assert_eq!(of_nobody.message, "no body is named: name those that move");
    let other = vec![Motion::between(&at(1.0), &at(0.5), [0.0; 3]).unwrap()];
    let uneven = world.earliest_many(&[body], &[motions[0].clone(), other], &PathOptions::default()).unwrap_err();
    assert_eq!(uneven.message, "a chain has 2 links, the first 1: give each as many");
}

#[test]
fn bodies_are_moved_switched_off_and_removed() {
    let (mut world, body) = falling();
    world.move_body(body, &Motion::turned(&at(1.0), [0.0, 0.0, 7.0], [0.0, 0.0, 0.5], [0.0; 3]).unwrap()).unwrap();
    assert!(world.is_free(&PathOptions::default()).unwrap());
    world.move_body(body, &Motion::between(&at(1.0), &at(-1.0), [0.0; 3]).unwrap()).unwrap();
    assert!(!world.is_free(&PathOptions::default()).unwrap());
    world.set_enabled(body, false).unwrap();
    assert!(world.is_free(&PathOptions::default()).unwrap());
    world.set_enabled(body, true).unwrap();
    world.set_may_touch(0, body, false).unwrap();
    assert!(world.is_free(&PathOptions::default()).unwrap());
    world.remove(body).unwrap();
    let refusal = world.remove(body).unwrap_err();
    assert_eq!(refusal.status, INVALID_OPTIONS);
    assert_eq!(refusal.to_string(), "body 1 has been removed: name one that is still there");
}

#[test]
fn what_deforms_touches_and_is_near_and_passes_through() {
    let (mut world, shape) = (World::new(1).unwrap(), triangle());
    world.add(&shape, &Motion::at(at(0.0))).unwrap();
    let start = vec![[0.2, 0.2, -0.1], [0.3, 0.2, 1.0], [0.2, 0.3, 1.0]];
    let mut end = start.clone();
    end[0][2] = 0.1;
    let body = world.add(&shape, &Motion::Deforming { start: start.clone(), end }).unwrap();
    let through = world.intersections(false).unwrap();
    assert!(!through.is_empty() && through.iter().all(|i| i.bodies == [body, 0]));
    assert!(world.has_intersection(false).unwrap());
    assert!(world.has_overlap(false).unwrap());
    assert!(!world.is_closed(body).unwrap());
    let near = world.pairs_within(0.11, false).unwrap();
    assert!(near.iter().any(|n| n.kind == 0 && n.bodies == [body, 0] && (n.distance - 0.1).abs() < 1e-12));
    assert!((world.earliest(&PathOptions::default()).unwrap().toi_lower - 0.5).abs() < 1e-9);
    let short = Motion::Deforming { start, end: vec![] };
    let refusal = world.move_body(body, &short).unwrap_err();
    assert_eq!(refusal.status, INVALID_STEP);
    assert_eq!(refusal.message, "a body has 3 vertices, start 3 points and end 0: give one a vertex");
}

#[test]
fn what_touches_at_the_start_is_reported_ignored_or_refused() {
    let (mut world, body) = falling();
    world.move_body(body, &Motion::interpolated(at(0.0), at(1.0))).unwrap();
    let ask = |at_start| PathOptions { at_start, ..PathOptions::default() };
    assert!(!world.is_free(&ask(AtStart::Report)).unwrap());
    assert!(world.is_free(&ask(AtStart::Ignore)).unwrap());
    assert_eq!(world.is_free(&ask(AtStart::Fail)).unwrap_err().status, INVALID_STEP);
}

#[test]
fn refusals_have_the_sentence_of_the_library() {
    let mesh = |points: &[[f64; 3]], faces: &[[i32; 3]]| Shape::new(points, faces).err().map(|e: Error| e.status);
    assert_eq!(mesh(&[[0.0; 3]; 3], &[[0, 1, 3]]), Some(TAMIS_INVALID_MESH));
    assert_eq!(mesh(&[[f64::NAN; 3]; 3], &[[0, 1, 2]]), Some(TAMIS_INVALID_MESH));
    assert_eq!(mesh(&[], &[]), Some(TAMIS_INVALID_MESH));
    let (mut world, _) = falling();
    let refusal = world.move_body(7, &Motion::at(at(0.0))).unwrap_err();
    assert!(refusal.status == INVALID_OPTIONS && refusal.message.contains("body 7"), "{refusal}");
    assert!(world.add(&triangle(), &Motion::at(at(f64::INFINITY))).is_err());
    assert!(Motion::between(&at(0.0), &at(f64::NAN), [0.0; 3]).is_err());
    assert!(Pose::of_quaternion([1.1, 0.0, 0.0, 0.0], [0.0; 3]).is_err());
    assert_eq!(Pose::of_quaternion([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 2.0]).unwrap(), at(2.0));
    assert_eq!(World::new(-1).err().map(|e| e.status), Some(INVALID_OPTIONS));
    assert!(tamis::version().starts_with("0."));
}
