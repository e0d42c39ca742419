// Prints what each way of simulating does with a scene, one line a way.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "integrations/bullet/throws/bodies.hpp"
#include "integrations/bullet/throws/scenes.hpp"

namespace tamis::bullet {

/// A column of the table of `report_bodies`.
struct Measure {
  std::string_view title;
  double (*of)(const BodyRun& run);
  bool is_largest = false;  ///< of several scenes: the largest; otherwise their sum
};

// `out`: a folder for the frames of the first throw or scene as PLY files; none where it is empty.

/// For each method: how many throws it lets through, how many are not proven free, and the cost of a step.
void report_throws(std::string_view title, const Scene& scene, int samples, const std::string& out);
/// Bullet and the clamp: the measures, the steps that are not proven free, questions and the cost of a step.
void report_bodies(std::string_view title, std::span<const BodyScene> scenes, std::span<const Measure> measures,
                   int steps, const std::string& out);
/// Bullet and TruncatedWorld: the steps in which a cloth touches itself, and the cost of a step.
void report_cloth(int side, int steps, const std::string& out);

}  // namespace tamis::bullet
