#include "worlds/expect_agreement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>

namespace tamis::test {
namespace {

using ContactsByPair = std::map<NamedPair, Contact>;

bool turns(const TestWorld& world, BodyId id) {
  const auto* rigid = std::get_if<Rigid>(&world.bodies[place(id)].motion);
  return rigid &&
         std::ranges::any_of(rigid->chain, [](const RigidLink& l) { return l.start.rotation != l.end.rotation; });
}

/// Of the detector: on curves where one of the two bodies turns, else on the step.
ContactsByPair expected_contacts(const TestWorld& world, OneMesh& mesh, const PathOptions& options) {
  ContactsByPair expected;
  const auto add = [&](std::span<const Contact> contacts, bool of_curves) {
    for (const Contact& c : contacts) {
      const NamedPair name = named(c, mesh);
      const BodyId a = name.vertices[0][0], b = name.vertices[c.kind == PairKind::edge_edge ? 2 : 1][0];
      if ((turns(world, a) || turns(world, b)) == of_curves) expected.emplace(name, c);
    }
  };
  add(mesh.detector.contacts(mesh.step(), {options.min_separation, options.at_start}), false);
  add(mesh.detector.contacts(mesh.path, options), true);
  return expected;
}

}  // namespace

std::size_t expect_same_contacts(TestWorld& world, const PathOptions& options) {
  OneMesh mesh(world);
  const ContactsByPair expected = expected_contacts(world, mesh, options);
  const std::vector<BodyContact> found = world.world.contacts(options);
  EXPECT_EQ(found.size(), expected.size());
  auto each = expected.begin();
  for (const BodyContact& c : found) {
    if (each == expected.end()) break;
    const auto& [name, contact] = *each++;
    EXPECT_EQ(named(c), name);  // which says that they come in this order
    EXPECT_EQ(c.certainty, contact.certainty);
    EXPECT_NEAR(c.toi_lower, contact.toi_lower, 2e-9);
    EXPECT_NEAR(c.toi_upper, contact.toi_upper, 2e-9);
    if (turns(world, c.bodies[0]) || turns(world, c.bodies[1])) continue;
    EXPECT_NEAR(c.toi_lower, contact.toi_lower, 1e-14);
    EXPECT_NEAR(c.u, contact.u, 1e-10);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(c.normal[k], contact.normal[k], 1e-10);
  }
  return found.size();
}

void expect_same_first(TestWorld& world, const PathOptions& options) {
  double first = 1;
  for (const BodyContact& c : world.world.contacts(options)) first = std::min(first, c.toi_lower);
  const EarliestBodyContact earliest = world.world.earliest(options);
  EXPECT_NEAR(earliest.toi_lower, first, 2e-9);
  EXPECT_EQ(earliest.contact.has_value(), first < 1);
  EXPECT_EQ(world.world.is_free(options), !earliest.contact);
}

}  // namespace tamis::test
