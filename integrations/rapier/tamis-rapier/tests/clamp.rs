//! What the clamp does with bodies that rest, overlap, do not collide, come and go.
use rapier3d::prelude::*;
use tamis_rapier::{Clamp, ClampOptions, Error, Step};

/// A world without rapier's own CCD, which stops fast hulls before fixed bodies: only the clamp stops bodies.
fn world(gravity: f32) -> PhysicsWorld {
    let mut world = PhysicsWorld { gravity: Vector::new(0.0, 0.0, -gravity), ..PhysicsWorld::default() };
    world.integration_parameters.max_ccd_substeps = 0;
    world
}

fn clamp() -> Clamp {
    Clamp::new(ClampOptions::default(), 1).unwrap()
}

fn steps(clamp: &mut Clamp, world: &mut PhysicsWorld, count: usize) -> Vec<Step> {
    (0..count).map(|_| clamp.step(world).unwrap()).collect()
}

fn at(x: f32, y: f32, z: f32) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic().translation(Vector::new(x, y, z))
}

/// A step of a caller of rapier's pipeline, who does something between rapier's step and the clamp's.
fn step_with(
    clamp: &mut Clamp,
    world: &mut PhysicsWorld,
    change: impl FnOnce(&mut PhysicsWorld),
) -> Result<Step, Error> {
    clamp.before(&mut world.bodies, &world.colliders)?;
    world.step();
    change(world);
    let PhysicsWorld { integration_parameters, bodies, colliders, impulse_joints, multibody_joints, .. } = world;
    clamp.after(integration_parameters, bodies, colliders, impulse_joints, multibody_joints)
}

/// A box with a skin, so that rapier lets bodies rest apart, not a little in each other.
fn small_box() -> ColliderBuilder {
    ColliderBuilder::cuboid(0.1, 0.1, 0.1).contact_skin(0.001)
}

/// A box at 100 m/s, and a thin wall in its way.
fn shot(world: &mut PhysicsWorld) -> (RigidBodyHandle, ColliderHandle) {
    world.colliders.insert(ColliderBuilder::cuboid(2.0, 2.0, 0.001));
    world.insert(at(0.0, 0.0, 1.0).linvel(Vector::new(0.0, 0.0, -100.0)), small_box())
}

#[test]
fn a_box_comes_to_rest_on_a_floor_and_on_another() {
    let mut world = world(9.81);
    world.colliders.insert(ColliderBuilder::cuboid(5.0, 5.0, 0.1).contact_skin(0.001));
    let boxes: Vec<_> = (1..3).map(|i| world.insert(at(0.0, 0.0, 0.3 * i as f32), small_box()).0).collect();
    let all = steps(&mut clamp(), &mut world, 240);
    assert!(all.iter().any(|step| !step.held.is_empty()));
    assert!(all.iter().all(|step| step.overlapping == 0));
    for (i, &body) in boxes.iter().enumerate() {
        let height = world.bodies[body].translation().z - 0.2 * (i + 1) as f32;
        assert!((0.0..0.01).contains(&height), "box {i} is {height} above where it would touch");
        assert!(world.bodies[body].is_sleeping());
    }
}

#[test]
fn bodies_that_overlap_at_the_start_are_parted_by_rapier() {
    let mut world = world(0.0);
    world.insert(at(0.0, 0.0, 0.0), small_box());
    world.insert(at(0.15, 0.01, 0.02), small_box());
    let all = steps(&mut clamp(), &mut world, 120);
    assert_eq!(all[0].overlapping, 1);
    assert!(all[0].held.is_empty());
    assert!(all[119].overlapping == 0);
}

/// A plate at z=0 that rapier does not see: it takes the collider for a ball far away.
fn unseen_plate(world: &mut PhysicsWorld, clamp: &mut Clamp) {
    let plate = world.colliders.insert(ColliderBuilder::ball(0.001).translation(Vector::new(9.0, 9.0, 0.0)));
    clamp.set_mesh(plate, &[[-99.0, -20.0, 0.0], [99.0, -20.0, 0.0], [0.0, 99.0, 0.0]], &[[0, 1, 2]]);
}

/// Bug: bodies that had gone no part of their way were taken for fixed ones, and what overlaps was not looked for
/// between two fixed bodies: so overlapping bodies held each other back.
#[test]
fn bodies_that_overlap_are_parted_after_a_step_in_which_neither_could_move() {
    let mut world = world(0.0);
    let mut clamp = Clamp::new(ClampOptions { rounds: 0, ..ClampOptions::default() }, 1).unwrap();
    unseen_plate(&mut world, &mut clamp);
    let down = Vector::new(0.0, 0.0, -50.0);
    let boxes = [0.0, 0.15].map(|x| world.insert(at(x, 0.0, 0.3).linvel(down), small_box()).0);
    let first = clamp.step(&mut world).unwrap();
    assert_eq!(first.overlapping, 1);
    assert_eq!(first.held.iter().map(|&(_, fraction)| fraction).collect::<Vec<_>>(), [0.0; 2]);
    for body in boxes {
        world.bodies[body].set_linvel(Vector::new(0.0, 0.0, 1.0), true);
    }
    let all = steps(&mut clamp, &mut world, 120);
    assert_eq!(all[0].overlapping, 1);
    assert!(all.iter().all(|step| step.held.is_empty()));
    assert_eq!(all[119].overlapping, 0);
}

/// Bug: bodies whose step had failed went on with it in the next step, if they were put back to where they were.
#[test]
fn a_step_that_failed_leaves_nothing_behind() {
    let (mut world, mut clamp) = (world(0.0), clamp());
    let (plate, _) = world.insert(at(0.0, 0.0, 0.0), ColliderBuilder::cuboid(1.0, 1.0, 0.001));
    let (lost, _) = world.insert(at(0.0, 0.0, 50.0), small_box());
    world.bodies[plate].set_linvel(Vector::new(1000.0, 0.0, 0.0), true);
    let nowhere = Vector::new(f32::NAN, 0.0, 0.0);
    step_with(&mut clamp, &mut world, |world| world.bodies[lost].set_translation(nowhere, true)).unwrap_err();
    world.remove_body(lost);
    world.bodies[plate].set_position(Pose::IDENTITY, true);
    world.bodies[plate].set_linvel(Vector::ZERO, true);
    let (thrown, _) = world.insert(at(0.0, 0.0, 1.0).linvel(Vector::new(0.0, 0.0, -100.0)), small_box());
    clamp.step(&mut world).unwrap();
    assert!(world.bodies[thrown].translation().z > 0.1);
}

#[test]
fn a_body_that_meets_nobody_goes_as_without_the_clamp() {
    let thrown = || {
        let mut world = world(9.81);
        let (body, _) = world.insert(
            at(0.0, 0.0, 0.0).linvel(Vector::new(3.0, 0.0, 0.0)).angvel(Vector::new(5.0, 7.0, 1.0)),
            small_box(),
        );
        // The centre of mass is not in the origin.
        world.insert_collider(small_box().translation(Vector::new(0.3, 0.0, 0.0)), Some(body));
        world.insert(RigidBodyBuilder::fixed().translation(Vector::new(0.0, 0.0, 3.0)), small_box());
        (world, body)
    };
    let ((mut alone, body), (mut clamped, _)) = (thrown(), thrown());
    for step in steps(&mut clamp(), &mut clamped, 60) {
        assert_eq!(step, Step { questions: 1, ..Step::default() });
        alone.step();
    }
    assert_eq!(alone.bodies[body].position(), clamped.bodies[body].position());
}

#[test]
fn a_centre_of_mass_beside_the_origin_is_what_goes_straight() {
    let mut world = world(0.0);
    // The rod turns about its middle and misses the wall by 5 mm. If its end were to go straight in each step, it would
    // reach 6 mm further.
    let mut clamp = clamp();
    unseen_plate(&mut world, &mut clamp);
    let (body, _) = world.insert(
        at(0.0, 0.0, 0.4552).angvel(Vector::new(0.0, 20.0, 0.0)),
        ColliderBuilder::cuboid(0.45, 0.01, 0.01).translation(Vector::new(0.45, 0.0, 0.0)),
    );
    let all = steps(&mut clamp, &mut world, 200);
    assert!(all.iter().all(|step| step.held.is_empty()));
    assert!((world.bodies[body].center_of_mass().z - 0.4552).abs() < 1e-4);
    world.bodies[body].set_linvel(Vector::new(0.0, 0.0, -0.5), true);
    steps(&mut clamp, &mut world, 30);
    assert!(world.bodies[body].center_of_mass().z > 0.44, "it stays above the wall");
}

#[test]
fn what_does_not_collide_is_not_held_back() {
    let mut world = world(0.0);
    let (body, collider) = shot(&mut world);
    world.colliders[collider].set_collision_groups(InteractionGroups::none());
    let all = steps(&mut clamp(), &mut world, 3);
    assert!(all.iter().all(|step| step.held.is_empty()));
    assert!(world.bodies[body].translation().z < -1.0);
}

#[test]
fn joints_that_switch_contacts_off_count() {
    let mut world = world(0.0);
    let (first, _) = world.insert(RigidBodyBuilder::fixed(), small_box());
    let (second, _) = world.insert(at(0.3, 0.0, 0.0).linvel(Vector::new(-20.0, 0.0, 0.0)), small_box());
    let along = PrismaticJointBuilder::new(Vector::X).contacts_enabled(false);
    world.insert_impulse_joint(first, second, along);
    let all = steps(&mut clamp(), &mut world, 2);
    assert!(all.iter().all(|step| step.held.is_empty()));
    assert!(world.bodies[second].translation().x < 0.0);
}

#[test]
fn bodies_come_go_and_are_moved() {
    let mut world = world(0.0);
    let (body, _) = shot(&mut world);
    let mut clamp = clamp();
    assert_eq!(steps(&mut clamp, &mut world, 1)[0].held[0].0, body);
    world.remove_body(body);
    assert!(steps(&mut clamp, &mut world, 1)[0].held.is_empty());
    let (body, _) = shot(&mut world); // with a second wall, where the first one stands
    world.bodies[body].set_translation(Vector::new(0.0, 0.0, -1.0), true);
    let all = steps(&mut clamp, &mut world, 3);
    assert!(all.iter().all(|step| step.held.is_empty()), "below the wall there is nothing in its way");
    assert!(world.bodies[body].translation().z < -4.0);
}

/// Bug: the process was aborted, by a panic in a function that C calls.
#[test]
fn a_collider_that_is_removed_during_the_step_holds_nobody_back() {
    let mut world = world(0.0);
    let wall = world.colliders.insert(ColliderBuilder::cuboid(2.0, 2.0, 0.001));
    let (body, _) = world.insert(at(0.0, 0.0, 1.0).linvel(Vector::new(0.0, 0.0, -100.0)), small_box());
    let mut clamp = clamp();
    let step = step_with(&mut clamp, &mut world, |world| assert!(world.remove_collider(wall).is_some())).unwrap();
    assert!(step.held.is_empty());
    assert!(world.bodies[body].translation().z < 0.0);
}

#[test]
fn a_platform_that_moves_as_it_was_told_is_not_held_back() {
    let mut world = world(9.81);
    let lift = RigidBodyBuilder::kinematic_velocity_based().linvel(Vector::new(0.0, 0.0, 0.5));
    let (lift, _) = world.insert(lift, ColliderBuilder::cuboid(1.0, 1.0, 0.1));
    let (body, _) = world.insert(at(0.0, 0.0, 0.25), small_box());
    let all = steps(&mut clamp(), &mut world, 60);
    assert!(all.iter().all(|step| step.held.iter().all(|&(held, _)| held == body)));
    assert!((world.bodies[lift].translation().z - 0.5).abs() < 1e-3);
    assert!(world.bodies[body].translation().z > 0.6);
}

#[test]
fn a_shape_without_triangles_is_refused_before_anything_moves() {
    let mut world = world(9.81);
    let (body, ball) = world.insert(at(0.0, 0.0, 1.0), ColliderBuilder::ball(0.5));
    let mut clamp = clamp();
    let refusal = clamp.step(&mut world).unwrap_err();
    assert_eq!(refusal.message, "a collider is a Ball, which has no triangles: give it some by set_mesh");
    assert_eq!(world.bodies[body].translation().z, 1.0);
    let (points, faces) = ([[0.0, 0.0, 0.5], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0]], [[0, 1, 2]]);
    clamp.set_mesh(ball, &points, &faces);
    assert_eq!(clamp.step(&mut world).unwrap().questions, 1);
}

#[test]
fn options_out_of_range_are_refused() {
    let mut world = world(0.0);
    shot(&mut world);
    let mut clamp = Clamp::new(ClampOptions { gap: 0.0, ..ClampOptions::default() }, 1).unwrap();
    let refusal = clamp.step(&mut world).unwrap_err();
    assert!(refusal.message.contains("gap"), "{refusal}");
}
