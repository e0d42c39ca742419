//! Tests of bodies whose colliders collide with different things, of colliders that get another shape, and of bodies
//! that turn too far.
use rapier3d::prelude::*;
use tamis_rapier::{Clamp, ClampOptions};

/// A world without gravity and without rapier's own CCD.
fn world() -> PhysicsWorld {
    let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
    world.integration_parameters.max_ccd_substeps = 0;
    world
}

fn clamp() -> Clamp {
    Clamp::new(ClampOptions::default(), 1).unwrap()
}

fn at(x: f32, y: f32, z: f32) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic().translation(Vector::new(x, y, z))
}

fn only(group: Group) -> InteractionGroups {
    InteractionGroups::new(group, group, InteractionTestMode::And)
}

/// The height of the body after three steps at 100 m/s downwards.
fn shot(world: &mut PhysicsWorld, clamp: &mut Clamp, body: RigidBodyHandle) -> f32 {
    world.bodies[body].set_linvel(Vector::new(0.0, 0.0, -100.0), true);
    for _ in 0..3 {
        clamp.step(world).unwrap();
    }
    world.bodies[body].translation().z
}

#[test]
fn a_collider_that_meets_nobody_hides_none_that_does() {
    let mut world = world();
    world.colliders.insert(ColliderBuilder::cuboid(2.0, 2.0, 0.001));
    let (body, _) = world.insert(at(0.0, 0.0, 1.0), ColliderBuilder::cuboid(0.1, 0.1, 0.1));
    // The box reaches through the wall: the bodies overlap there.
    world.insert_collider(
        ColliderBuilder::cuboid(1.0, 1.0, 1.5).collision_groups(InteractionGroups::none()),
        Some(body),
    );
    assert!(shot(&mut world, &mut clamp(), body) > 0.1);
}

#[test]
fn a_collider_that_rapier_lets_pass_holds_nobody_back() {
    let mut world = world();
    world.colliders.insert(ColliderBuilder::cuboid(2.0, 2.0, 0.001).collision_groups(only(Group::GROUP_1)));
    let passes = ColliderBuilder::cuboid(0.1, 0.1, 0.1).collision_groups(only(Group::GROUP_2));
    let (body, _) = world.insert(at(0.0, 0.0, 1.0), passes);
    let meets = ColliderBuilder::cuboid(0.1, 0.1, 0.1).translation(Vector::new(5.0, 0.0, 0.0));
    world.insert_collider(meets.collision_groups(only(Group::GROUP_1)), Some(body));
    assert!(shot(&mut world, &mut clamp(), body) < -1.0);
}

#[test]
fn a_given_mesh_serves_the_shape_that_it_was_given_for() {
    let triangle = |size: f64| [[size, 0.0, 0.0], [-size, size, 0.0], [-size, -size, 0.0]];
    for is_given_anew in [false, true] {
        let (mut world, mut clamp) = (world(), clamp());
        let fixed = world.colliders.insert(ColliderBuilder::ball(0.001));
        clamp.set_mesh(fixed, &triangle(0.01), &[[0, 1, 2]]);
        let (body, _) = world.insert(at(0.5, 0.0, 1.0), ColliderBuilder::cuboid(0.1, 0.1, 0.1));
        clamp.step(&mut world).unwrap();
        if is_given_anew {
            clamp.set_mesh(fixed, &triangle(9.0), &[[0, 1, 2]]);
        } else {
            world.colliders[fixed].set_shape(SharedShape::cuboid(2.0, 2.0, 0.001));
        }
        assert!(shot(&mut world, &mut clamp, body) > 0.1);
        world.colliders[fixed].set_shape(SharedShape::ball(1.0));
        assert!(clamp.step(&mut world).unwrap_err().message.contains("Ball"));
    }
}

#[test]
fn a_body_that_turns_by_more_than_half_a_turn_is_named() {
    for (speed, is_allowed, is_named) in [(600.0, true, true), (150.0, true, false), (600.0, false, false)] {
        let mut world = world();
        let spins = at(0.0, 0.0, 0.0).angvel(Vector::new(0.0, 0.0, speed)).allow_fast_rotation(is_allowed);
        let (body, _) = world.insert(spins, ColliderBuilder::cuboid(1.0, 0.01, 0.01));
        let step = clamp().step(&mut world).unwrap();
        assert_eq!(step.turned_too_far, if is_named { vec![body] } else { vec![] });
    }
}
