// After Bullet's solver: what it has left of the speed with which bodies come down on those that carry them.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "adapters/bullet/near_contacts.hpp"

namespace tamis::bullet {

/// A body is carried by those near it that are fewer bodies away from what stands; where nothing stands, from the
/// heaviest of its group. From there upwards each is pushed as if what carries it could not give way (where nothing
/// stands it does, and their momentum stays). So a pile comes to rest however high it is: a solver that shares each
/// impulse between two bodies needs as many rounds as the square of the height, and what it has not solved would be
/// held back at ever smaller distances.
class Carriers {
 public:
  Carriers(std::span<const NearContact> near, btScalar gap, btScalar seconds);

  /// No body comes nearer than `gap` to what carries it, in the first order.
  void take_speed();
  /// Calls `go` while bodies that are nearer than that have a speed by which they part, and only then: it is no speed
  /// of theirs.
  void part(const std::function<void()>& go);

 private:
  struct Contact {
    btRigidBody* body;
    btRigidBody* other;        ///< none: what has no speed
    std::size_t other_at;      ///< among bodies_
    btVector3 arm, other_arm;  ///< from the origins
    btVector3 up;              ///< from the other to the body
    btScalar above_gap;        ///< the distance, less the gap
    btScalar allowed = 0;      ///< how fast the body may come nearer
    btScalar impulse = 0;
    bool other_gives = false;  ///< where nothing stands

    void push();
  };
  struct Body {
    btCollisionObject* object;
    std::vector<Contact> contacts;
    int level = -1;  ///< how many bodies away from what stands
  };

  void find_levels();
  template <class Allowed>
  void push(const Allowed& allowed);

  btScalar seconds_;
  std::vector<Body> bodies_;
  std::vector<std::size_t> order_;  ///< those that are carried, from below
};

}  // namespace tamis::bullet
