// After Bullet's solver: takes the speed that it leaves between bodies and the bodies that carry them.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "adapters/bullet/near_contacts.hpp"

namespace tamis::bullet {

/// The level of a body is how many bodies it is away from an object that stands; in a group without one, from its
/// heaviest body. A body is carried by the bodies near it of lower levels. From the lowest level upwards, each body is
/// pushed as if its carriers could not give way; in a group where nothing stands they do, which keeps its momentum. So
/// a pile comes to rest however high it is. A solver that shares each impulse between two bodies needs as many rounds
/// as the square of the height; the clamp would hold back what it leaves at ever smaller distances.
class Carriers {
 public:
  /// Keeps references to the contacts.
  Carriers(std::span<const NearContact> near, btScalar gap, btScalar seconds);

  /// Takes the speed by which bodies would come nearer than `gap` to their carriers, to first order.
  void take_speed();
  /// Calls `go` while bodies nearer than `gap` to their carriers have an additional speed by which they part; a body
  /// between two carriers with less than two gaps of room goes to the middle. Afterwards all bodies have their speeds
  /// of before.
  void part(const std::function<void()>& go);

 private:
  /// How a body answers an impulse of 1 along a direction, at a point.
  struct Answer {
    btRigidBody* body = nullptr;  ///< NULL if it has no speed
    btVector3 direction, about;   ///< speed along the direction = linear * direction + angular * about
    btVector3 linear, angular;    ///< what the impulse adds to the body's speeds

    Answer() = default;
    Answer(const NearSide& side, const btVector3& direction);
    btScalar give() const { return linear.dot(direction) + angular.dot(about); }
    btScalar speed() const;
    void push(btScalar impulse) const;
  };
  struct Contact {
    const NearContact* near;
    std::size_t side;              ///< the body's
    std::size_t other_at;          ///< among bodies_
    Answer body = {}, other = {};  ///< along the unit vector from the other to the body; once levels are known
    btScalar above_gap = 0;        ///< the distance, less the gap
    btScalar give = 0;             ///< the speed by which both part if an impulse of 1 acts
    btScalar allowed = 0;          ///< how fast the body may come nearer
    btScalar softness = 0;         ///< the speed towards the other that an impulse of 1 leaves; 0: none
    btScalar impulse = 0;
    bool other_gives = false;  ///< where nothing stands

    /// Returns by how much this changes the speed.
    btScalar push();
  };
  struct Body {
    btCollisionObject* object;
    std::vector<Contact> contacts;  ///< once levels are known, those with its carriers
    int level = -1;                 ///< -1 until it is known
  };

  void find_levels();
  void keep_carriers(Body& body);
  /// `is_soft`: contacts nearer than the gap give way to each other.
  template <class Allowed>
  void push(const Allowed& allowed, bool is_soft);

  btScalar gap_, seconds_;
  std::vector<Body> bodies_;
  std::vector<std::size_t> order_;  ///< bodies that are carried; in each group by ascending level
};

}  // namespace tamis::bullet
