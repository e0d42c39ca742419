// The laboratory's options beyond the library's: the method, and the parts of the published method.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "paper/reduced_model.hpp"
#include "support/yardstick/library_options.hpp"

namespace tamis::lab {

/// How pairs are found and culled. Every method returns the same set of contacts: the library's decide() decides the
/// pairs that the method's filters leave.
enum class Method : std::uint8_t {
  tamis,  ///< the library
  paper,  ///< the published NCF pipeline, to the letter
  brute,  ///< every pair, no hierarchy: the tests' yardstick
};

/// Bounds of the nodes of the paper's hierarchy, over the whole step.
enum class BoundingVolume : std::uint8_t { sphere, aabb, obb, dop16, dop18, dop26 };

/// Names as on the command line, and back. Throw InvalidOptions, naming the choices, if there is no such name.
Method method_from_name(std::string_view name);
BoundingVolume bounding_volume_from_name(std::string_view name);
std::string_view name_of(Method);
std::string_view name_of(BoundingVolume);

/// How patches of surface are proven free of self-contact as a whole, before pairs of triangles are tested.
enum class HighLevelCulling : std::uint8_t {
  none,
  normal_cones,   ///< continuous normal cone, and a contour that does not meet itself
  star_contours,  ///< continuous normal cone, and a contour that is star-shaped
  subspace,       ///< x = X + U q: q is too short for a self-contact; needs PaperOptions::reduced_model
};

/// Of Method::paper. The defaults are the published system, other choices its competitors; all give the same contacts.
struct PaperOptions {
  BoundingVolume bounding_volume = BoundingVolume::dop16;
  /// Filters by name, in the order in which they are tried: see filter_names().
  std::vector<std::string> filters{"dnf", "ncf-published"};
  /// false: pairs of triangles that share a vertex are tested like all others.
  bool orphan_sets = true;
  /// false: a pair of features is tested in every pair of triangles that contains it.
  bool representative_triangles = true;
  /// If not `none`, the hierarchy follows the connectivity of the mesh. Has no effect with a minimum separation.
  HighLevelCulling high_level = HighLevelCulling::none;
  /// For `subspace`, which has no effect without orphan sets. Must not change while a detector uses it. Certificates
  /// are made at the first question.
  std::shared_ptr<const ReducedModel> reduced_model = nullptr;
};

/// What PaperOptions::filters may name.
std::vector<std::string_view> filter_names();

/// The library's options and the method, for make_detector (paper/detector.hpp).
struct Options : yardstick::LibraryOptions {
  using LibraryOptions::LibraryOptions;
  Method method = Method::tamis;
  PaperOptions paper;
};

/// Sets `method` and `paper` from one name: a method's, or "paper-" and a competitor's. Competitors: dnf, ncf (that
/// filter alone), dnf-ncf (the published system), sat, pfs, r-triangles (no filter), no-orphans, no-representatives,
/// normal-cones, star-contours (the published system after that high-level culling).
/// Throws InvalidOptions, naming the choices, if there is no such name.
void choose_method(Options& options, std::string_view name);
/// All names that choose_method understands.
std::vector<std::string_view> method_choices();

}  // namespace tamis::lab
