// Bad input is refused here, before any work is done.
#pragma once
#include <string_view>

#include "pair/motion/separations.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/step.hpp"
#include "tamis/stored_type.hpp"

namespace tamis {

/// Throws InvalidOptions: a negative or not finite separation, negative threads, groups or radii that do not fit the
/// mesh.
void validate(const Options& options, const Mesh& mesh);

/// Throws InvalidStep: positions that do not fit the mesh, or a used vertex that is not finite.
void validate(const Step& step, const Mesh& mesh);
/// The same for one pose, which `what` names, as in "the start of the step".
void validate(const Positions& positions, const Mesh& mesh, const char* what);

/// Throws InvalidStep unless both ends have as many rows, and the three numbers of a row stand side by side.
void validate_layout(const Step& step);

/// Throws InvalidOptions unless the separation is finite and >= 0 and `at_start` has a name.
void validate(const QueryOptions& options);
/// The same for a path: throws unless the tolerance is in (0, 1], too.
void validate(const PathOptions& options);
/// Throws InvalidStep if the start of a used vertex is not a number of kind `stored`, or if its end, rounded to such
/// numbers, is infinite.
void validate_stored(const Step& step, const Mesh& mesh, StoredType stored);

/// Throws InvalidOptions unless each option lies in its range.
void validate(const PairOptions& options);

/// `what`: as in "the minimum separation". Throws InvalidOptions unless finite and >= 0.
void validate_distance(double distance, std::string_view what);

/// Throws InvalidOptions unless the separation of every pair, both radii included, is finite.
void validate(const Separations& separations);

/// Throws InvalidOptions unless in [0, 1); of `truncate` in (0, 1).
void validate_kept(double keep);
void validate_kept_of_truncate(double keep);

}  // namespace tamis
