// Random numbers with the same bits on every machine: the standard fixes the engine, but not its distributions.
#pragma once
#include <cmath>
#include <cstdint>
#include <random>

#include "tamis/step.hpp"

namespace tamis::scenes {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// In [0, count).
  Index below(Index count) { return static_cast<Index>(engine_() % static_cast<std::uint64_t>(count)); }
  bool coin() { return (engine_() >> 63) != 0; }

  Point point_between(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return {x, y, z};
  }
  /// A multiple of `unit` within [-steps, steps] units: exact if `unit` is a power of two.
  double on_lattice(Index steps, double unit) { return (below(2 * steps + 1) - steps) * unit; }
  Point point_on_lattice(Index steps, double unit) {
    const double x = on_lattice(steps, unit), y = on_lattice(steps, unit), z = on_lattice(steps, unit);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

/// A random function of space, smooth, in [-1, 1], of wavelength about 2: value noise, cubic between lattice points.
class SmoothNoise {
 public:
  explicit SmoothNoise(std::uint64_t seed) : seed_(seed) {}

  double operator()(double x, double y, double z = 0) const {
    const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const double wx = smooth(x - fx), wy = smooth(y - fy), wz = smooth(z - fz);
    const auto along_x = [&](double j, double k) {
      return mix(value(fx, fy + j, fz + k), value(fx + 1, fy + j, fz + k), wx);
    };
    return mix(mix(along_x(0, 0), along_x(1, 0), wy), mix(along_x(0, 1), along_x(1, 1), wy), wz);
  }

 private:
  static double smooth(double t) { return t * t * (3 - 2 * t); }
  static double mix(double a, double b, double t) { return a + (b - a) * t; }

  double value(double i, double j, double k) const {
    std::uint64_t hash = seed_;
    for (double lattice : {i, j, k})
      hash = scrambled(hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(lattice)));
    return static_cast<double>(hash >> 11) * 0x1p-52 - 1;
  }
  /// One step of SplitMix64 (Steele, Lea, Flood 2014).
  static std::uint64_t scrambled(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t seed_;
};

}  // namespace tamis::scenes
