#include "integrations/bullet/throws/scenes.hpp"

#include <array>
#include <cmath>

#include "integrations/bullet/throws/random.hpp"

namespace tamis::bullet {
namespace {

/// The angle by which the body turns about z, added up over the steps.
double turned_by(const Flight& flight) {
  double turned = 0;
  for (std::size_t step = 0; step + 1 < flight.places.size(); ++step) {
    const btQuaternion turn = flight.places[step + 1].getRotation() * flight.places[step].getRotation().inverse();
    turned += 2 * std::atan2(turn.z() * (turn.w() < 0 ? -1 : 1), std::abs(turn.w()));
  }
  return turned;
}

}  // namespace

Scene spinning_plates(int count) {
  Scene scene;
  scene.arenas.push_back(std::make_unique<Arena>(wall(8, 1), box({0.15, 0.1, 0.02}), 0.02));
  Random random;
  for (int i = 0; i < count; ++i) {
    const Point position{0.013, 0.007, random.between(0.6, 3)}, velocity{0, 0, -random.between(20, 120)};
    const double spin = std::array<double, 3>{0, 30, 100}[static_cast<std::size_t>(random.between(0, 3))];
    scene.trials.push_back(
        {scene.arenas.back().get(),
         {position, velocity, {spin * random.normal(), spin * random.normal(), spin * random.normal()}, 30, 1.0 / 60},
         [](const Flight& flight) { return flight.places.back().getOrigin().z() < -0.3; }});
  }
  return scene;
}

Scene spinning_rods(int count) {
  constexpr double kSpin = 180, kSeconds = 1.0 / 60;
  Scene scene;
  Random random;
  for (int i = 0; i < count; ++i) {
    const double angle = random.between(0.15, kSpin * kSeconds - 0.1), c = std::cos(angle), s = std::sin(angle);
    const std::vector<Point> corners{
        {0.4 * c, 0.4 * s, -0.3}, {0.8 * c, 0.8 * s, -0.3}, {0.8 * c, 0.8 * s, 0.3}, {0.4 * c, 0.4 * s, 0.3}};
    scene.arenas.push_back(
        std::make_unique<Arena>(Triangles{corners, {{0, 1, 2}, {0, 2, 3}}}, box({1, 0.01, 0.01}), 0.01));
    scene.trials.push_back({scene.arenas.back().get(),
                            {{0, 0, 0}, {0, 0, 0}, {0, 0, kSpin}, 4, kSeconds / 4, true},
                            [angle](const Flight& flight) { return turned_by(flight) > angle + 0.02; }});
  }
  return scene;
}

}  // namespace tamis::bullet
