// After an engine's solver: takes the speed that it leaves between bodies and the bodies that carry them.
#pragma once
#include <span>
#include <unordered_map>
#include <vector>

#include "integrations/near_contacts.hpp"

namespace tamis::adapters {

using Velocities = std::unordered_map<BodyId, Velocity>;

/// The level of a body is how many bodies it is away from an object that stands; in a group without one, from its
/// heaviest body. A body is carried by the bodies near it of lower levels. Bodies are processed by ascending level. A
/// carrier is treated as immovable, except in a group where nothing stands: there both move, so momentum is kept. So a
/// pile comes to rest however high it is. A solver that shares each impulse between two bodies needs as many rounds as
/// the square of the height; the clamp would hold back what it leaves at ever smaller distances.
class Carriers {
 public:
  Carriers(const Near& near, const WantedStep& step, double gap);

  /// Takes the speed by which bodies would come nearer than `gap` to their carriers, to first order, and the speed at
  /// which they slide there, as far as friction does. `velocities`: of
  /// all bodies of moving(); the others stand.
  void take_speed(Velocities& velocities);
  /// Gives bodies nearer than `gap` to their carriers a speed by which they part; a body between two carriers with less
  /// than two gaps of room goes to the middle.
  void part(Velocities& ways);
  /// Takes the speed with which two bodies come nearer to each other at a contact, and shares the impulse between them.
  static void stop(const NearContact& contact, const WantedStep& step, Velocities& velocities);

 private:
  /// How a body answers an impulse of 1 along a direction, at a point.
  struct Answer {
    Velocity* velocity = nullptr;
    Point direction{}, about{};  ///< speed along the direction = linear . direction + angular . about
    Point linear{}, angular{};   ///< what the impulse adds to the body's velocity

    double give() const { return dot(linear, direction) + dot(angular, about); }
    double speed() const;
    void push(double impulse) const;
  };
  struct Contact {
    const NearContact* near;
    std::size_t side;              ///< the body's
    std::size_t other_at;          ///< among bodies_
    Answer body = {}, other = {};  ///< along the unit vector from the other to the body; once levels are known
    double above_gap = 0;          ///< the distance, less the gap
    double give = 0;               ///< the speed by which both part if an impulse of 1 acts
    double allowed = 0;            ///< how fast the body may come nearer
    double softness = 0;           ///< the speed towards the other that an impulse of 1 leaves; 0: none
    double impulse = 0;
    double friction = 0;       ///< its coefficient
    double rubbed = 0;         ///< the sum of the impulses against sliding
    bool other_gives = false;  ///< where nothing stands

    /// Returns by how much this changes the speed.
    double push();
  };
  struct Body {
    BodyId id;
    bool moves;
    Inertia inertia = {};
    Point centre = {};
    Velocity velocity = {};
    std::vector<Contact> contacts = {};  ///< once levels are known, those with its carriers
    int level = -1;                      ///< -1 until it is known
  };

  static Answer answer(const Inertia& inertia, const Point& centre, Velocity& velocity, const Point& at,
                       const Point& direction);
  /// Takes the speed at which the body slides on the other, as far as friction does.
  static void rub(Body& body, Body& other, Contact& contact);
  void find_levels();
  void keep_carriers(Body& body);
  /// `is_soft`: contacts nearer than the gap give way to each other, and none rubs.
  template <class Allowed>
  void push(Velocities& velocities, const Allowed& allowed, bool is_soft);

  double gap_, seconds_;
  std::vector<Body> bodies_;
  std::vector<std::size_t> order_;  ///< bodies that are carried; in each group by ascending level
};

}  // namespace tamis::adapters
