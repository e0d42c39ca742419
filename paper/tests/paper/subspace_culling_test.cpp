// Subspace certificates may leave out no contact, whatever the positions, and must prove what is plainly free.
#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "paper/detector.hpp"
#include "paper/reduced_scene.hpp"
#include "scenes/random.hpp"
#include "tamis/error.hpp"

namespace tamis::lab {
namespace {

Options subspace_options(std::shared_ptr<const ReducedModel> model) {
  Options options;
  options.method = Method::paper;
  options.paper.high_level = HighLevelCulling::subspace;
  options.paper.reduced_model = std::move(model);
  return options;
}

using Vertices = std::vector<std::pair<PairKind, std::array<Index, 4>>>;

Vertices vertices_of(std::span<const Contact> contacts) {
  Vertices result;
  for (const Contact& c : contacts) result.emplace_back(c.kind, c.vertices);
  return result;
}

struct Answer {
  std::size_t contacts;
  std::uint64_t triangles_in_free_patches;
};

/// Compares with brute force, and returns what was found.
Answer checked(const scenes::Scene& scene, std::shared_ptr<const ReducedModel> model) {
  Options brute;
  brute.method = Method::brute;
  TriangleCounts counts;
  Detector yardstick = make_detector(scene.mesh(), brute);
  Detector detector = make_detector(scene.mesh(), subspace_options(std::move(model)), &counts);
  const Vertices expected = vertices_of(yardstick.contacts(scene.step()));
  EXPECT_EQ(vertices_of(detector.contacts(scene.step())), expected);
  return {expected.size(), counts.in_free_patches};
}

constexpr Index kTriangles = 400;

// Bug: any bound that is too high. From lengths at which all is proven to lengths at which nothing is.
TEST(SubspaceCulling, LeavesOutNoContactAtAnyLength) {
  std::size_t contacts = 0, partly_free = 0;
  for (const double length : {1e-3, 0.1, 0.17, 0.2, 0.23, 0.3, 0.5, 0.6, 1.0, 3.0})
    for (std::uint64_t seed : {1U, 2U, 3U}) {
      const ReducedScene r = reduced_sheet(kTriangles, seed, length);
      const Answer answer = checked(r.scene, r.model);
      contacts += answer.contacts;
      const std::uint64_t free = answer.triangles_in_free_patches;
      partly_free += free > 0 && free < r.scene.faces.size() ? 1 : 0;
    }
  EXPECT_GT(contacts, 1000U);
  EXPECT_GT(partly_free, 0U) << "all or nothing: certificates of patches are not used";
}

TEST(SubspaceCulling, ProvesTheRestPoseAndItsSurroundingsFreeAsAWhole) {
  for (const double length : {0.0, 0.05}) {
    const ReducedScene r = reduced_sheet(kTriangles, 1, length);
    EXPECT_EQ(checked(r.scene, r.model).triangles_in_free_patches, r.scene.faces.size()) << length;
  }
}

// Bug: a certificate that forgets pairs between patches: the arms of the U are free within, and meet each other.
TEST(SubspaceCulling, SeesTheArmsMeetWhileEachIsFree) {
  ReducedScene r = reduced_sheet(kTriangles, 1, 0);
  constexpr Index kClose = 6;  // the axis z, times the cosine of the length: the arms' ends move against each other
  for (Index v = 0; v < r.scene.vertex_count(); ++v)
    r.scene.end[static_cast<std::size_t>(v)][2] += 0.2 * r.model->row(v, 2)[kClose];
  const Answer answer = checked(r.scene, r.model);
  EXPECT_GT(answer.contacts, 0U);
  EXPECT_GT(answer.triangles_in_free_patches, r.scene.faces.size() / 4);
}

// Bug: a factorisation that fails where columns depend on each other, or vanish.
TEST(SubspaceCulling, TakesABasisWithDependentAndZeroColumns) {
  for (const double length : {0.05, 0.3, 1.0}) {
    const ReducedScene r = reduced_sheet(kTriangles, 2, length);
    auto wide = std::make_shared<ReducedModel>();
    wide->rest = r.model->rest;
    wide->modes = r.model->modes + 3;
    for (Index v = 0; v < r.scene.vertex_count(); ++v)
      for (Index axis = 0; axis < 3; ++axis) {
        const double* row = r.model->row(v, axis);
        wide->basis.insert(wide->basis.end(), row, row + r.model->modes);
        wide->basis.insert(wide->basis.end(), {row[0] + 2 * row[1], 0.0, row[3]});
      }
    const Answer answer = checked(r.scene, wide);
    EXPECT_EQ(answer.triangles_in_free_patches == r.scene.faces.size(), length < 0.1);
  }
}

// Bug: q believed without looking at what the positions are.
TEST(SubspaceCulling, CullsNothingWherePositionsAreNotOfTheModel) {
  ReducedScene r = reduced_sheet(kTriangles, 3, 0.05);
  scenes::Random random(1);
  for (Point& p : r.scene.end) p[2] += random.between(-0.1, 0.1);
  const Answer answer = checked(r.scene, r.model);
  EXPECT_GT(answer.contacts, 0U);
  EXPECT_EQ(answer.triangles_in_free_patches, 0U);
}

// Bug: a bound of zero, or none, at rest taken for a proof.
TEST(SubspaceCulling, FindsTheContactsOfARestPoseThatTouchesItself) {
  ReducedScene r = reduced_sheet(kTriangles, 1, 0);
  auto flat = std::make_shared<ReducedModel>(*r.model);
  for (Point& p : flat->rest) p[2] = 0;
  r.scene.start = r.scene.end = flat->rest;
  EXPECT_GT(checked(r.scene, flat).contacts, 0U);
}

// Bug: bounds that hold near the origin and at size one only.
TEST(SubspaceCulling, WorksFarFromTheOriginAndAtAnySize) {
  for (const double size : {1e-9, 1e9})
    for (const double length : {0.05, 0.8}) {
      ReducedScene r = reduced_sheet(kTriangles, 4, length);
      auto model = std::make_shared<ReducedModel>(*r.model);
      const auto transform = [&](Point& p) { p = {size * (p[0] + 1000), size * (p[1] - 300), size * p[2]}; };
      for (auto* points : {&model->rest, &r.scene.start, &r.scene.end})
        for (Point& p : *points) transform(p);
      for (double& u : model->basis) u *= size;
      const Answer answer = checked(r.scene, model);
      EXPECT_EQ(answer.triangles_in_free_patches == r.scene.faces.size(), length < 0.1);
    }
}

TEST(SubspaceCulling, RefusesModelsThatDoNotFit) {
  const ReducedScene r = reduced_sheet(kTriangles, 1, 0.1);
  EXPECT_THROW(make_detector(r.scene.mesh(), subspace_options(nullptr)), InvalidOptions);
  const auto broken = [&](auto change) {
    auto model = std::make_shared<ReducedModel>(*r.model);
    change(*model);
    return subspace_options(std::move(model));
  };
  for (const Options& options :
       {broken([](ReducedModel& m) { m.rest.pop_back(); }), broken([](ReducedModel& m) { m.basis.pop_back(); }),
        broken([](ReducedModel& m) { m.modes = 0; }), broken([](ReducedModel& m) { m.basis[7] = std::nan(""); }),
        broken([](ReducedModel& m) { m.rest[3][1] = HUGE_VAL; })})
    EXPECT_THROW(make_detector(r.scene.mesh(), options), InvalidOptions);
}

}  // namespace
}  // namespace tamis::lab
