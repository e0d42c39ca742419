// Random numbers that are the same with every standard library.
#pragma once
#include <LinearMath/btQuaternion.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tamis::bullet {

class Random {
 public:
  explicit Random(unsigned seed = 1) : engine_(seed) {}

  double between(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(engine_()) * 0x1p-32);
  }
  double normal() {
    return std::sqrt(-2 * std::log(between(0x1p-33, 1))) * std::cos(2 * std::numbers::pi * between(0, 1));
  }
  /// With each coordinate in [-size, size].
  btVector3 vector(double size) {
    btVector3 v;
    for (int i = 0; i < 3; ++i) v[i] = static_cast<btScalar>(between(-size, size));
    return v;
  }
  btQuaternion turn() {
    btQuaternion turn;
    for (int i = 0; i < 4; ++i) turn[i] = static_cast<btScalar>(normal());
    return turn.normalized();
  }

 private:
  std::mt19937 engine_;
};

}  // namespace tamis::bullet
