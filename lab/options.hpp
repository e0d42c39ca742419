// What the laboratory lets a caller choose beyond the library's options: the method, and the parts of the published
// one.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lab/reduced_model.hpp"
#include "tamis/options.hpp"

namespace tamis::lab {

/// How pairs are found and culled. Every method returns the same set of contacts: all decide what their filters leave
/// by the library's own decide().
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

/// Patches of surface that are proven free of self-contact as a whole, before any pair of triangles.
enum class HighLevelCulling : std::uint8_t {
  none,
  normal_cones,   ///< continuous normal cone, and a contour that does not meet itself
  star_contours,  ///< continuous normal cone, and a contour that is star-shaped
  subspace,       ///< x = X + U q: q is too short for a self-contact; needs PaperOptions::reduced_model
};

/// Of Method::paper: the published system by default, its competitors by choice. The contacts are the same for every
/// choice.
struct PaperOptions {
  BoundingVolume bounding_volume = BoundingVolume::dop16;
  /// Filters by name, in the order in which they are tried: see filter_names().
  std::vector<std::string> filters{"dnf", "ncf-published"};
  /// false: pairs of triangles that share a vertex are tested like all others.
  bool orphan_sets = true;
  /// false: a pair of features is tested in every pair of triangles that contains it.
  bool representative_triangles = true;
  /// Not `none`: the hierarchy follows the connectivity of the mesh. Has no effect with a minimum separation.
  HighLevelCulling high_level = HighLevelCulling::none;
  /// For `subspace`, which has no effect without orphan sets; not changed while a detector uses it. Certificates are
  /// made at the first question.
  std::shared_ptr<const ReducedModel> reduced_model = nullptr;
};

/// What PaperOptions::filters may name.
std::vector<std::string_view> filter_names();

/// The library's options and the method. No tamis::Options itself, or a Detector made of it would silently be one of
/// the method `tamis`: make_detector (lab/detector.hpp) makes the right one.
class Options : private tamis::Options {
 public:
  Options() = default;
  Options(tamis::Options given) : tamis::Options(std::move(given)) {}  // NOLINT(google-explicit-constructor)

  using tamis::Options::filter;
  using tamis::Options::is_cancelled;
  using tamis::Options::isa;  ///< paper and brute look for contacts in baseline
  using tamis::Options::min_separation;
  using tamis::Options::radii;
  using tamis::Options::threads;
  Method method = Method::tamis;
  PaperOptions paper;

  const tamis::Options& of_library() const { return *this; }
};

/// Sets `method` and `paper` from one name: that of a method, or "paper-" and that of a competitor: dnf, ncf (one
/// alone), dnf-ncf (the published system), sat, pfs, r-triangles (no filter), no-orphans, no-representatives,
/// normal-cones, star-contours (the published system below high-level culling).
/// Throws InvalidOptions, naming the choices, if there is no such name.
void choose_method(Options& options, std::string_view name);
/// All names that choose_method understands.
std::vector<std::string_view> method_choices();

}  // namespace tamis::lab
