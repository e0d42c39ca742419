// Options that several verbs share.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/command_line/option_list.hpp"
#include "tamis/detector.hpp"

namespace tamis::cli {

inline constexpr NumberRange<int> kThreadCounts{0, 1024};
inline constexpr NumberRange<int> kRunCounts{1, 1'000'000};
inline constexpr NumberRange<int> kRings{1, 1'000'000};

/// The options of a detector.
class DetectorArguments {
 public:
  void declare(OptionList& options);
  /// For a world, whose bodies have no radii.
  void declare_for_bodies(OptionList& options);
  /// Only the options that a question about one pose has, too: no radius, no separation.
  void declare_means(OptionList& options);
  /// `meaning`: what a radius means for the question.
  void declare_radius(OptionList& options, const std::string& meaning);
  /// For a check before any file is read. Throws InvalidOptions.
  void check() const { chosen(); }
  /// The chosen options where no one has the whole mesh. Throws InvalidOptions, also if objects have radii of their
  /// own.
  Options options() const;
  /// The chosen options for `mesh`. Throws InvalidOptions.
  Options options_for(const Mesh& mesh) const;
  /// Asks about `mesh` as the options say. Throws InvalidOptions.
  Detector detector(Mesh mesh) const;

 private:
  /// All options but radii.
  Options chosen() const;

  std::string isa_ = "best";
  int threads_ = 0;
  double min_separation_ = 0;
  int rings_ = 1;
  std::vector<double> radii_;  ///< one radius for all objects, or one for each; empty: none
};

/// `--at-start report|ignore|fail`: what becomes of pairs that touch at the start of a step.
class AtStartArgument {
 public:
  void declare(OptionList& options);
  /// Throws InvalidOptions if there is no such way.
  QueryOptions own() const { return {.at_start = at_start_from_name(name_)}; }

 private:
  std::string name_ = "report";
};

/// `--scale S`: how much of the way from START to END a step goes.
class ScaleArgument {
 public:
  void declare(OptionList& options);
  double value() const { return scale_; }

 private:
  double scale_ = 1;
};

/// `--keep F`: the part of its distance that every pair keeps.
class KeepArgument {
 public:
  void declare(OptionList& options);
  double part() const { return keep_; }

 private:
  double keep_ = 0.1;
};

/// `--weld`, `--weld DISTANCE`: joins vertices that lie at one place in every frame.
class WeldArgument {
 public:
  void declare(OptionList& options);
  /// None unless the option is given; 0: exactly at one place.
  std::optional<double> distance() const { return option_.is_given() ? std::optional(distance_) : std::nullopt; }

 private:
  Option option_;
  double distance_ = 0;
};

void declare_json(OptionList& options, bool& json);
void declare_repeat(
    OptionList& options, int& repeat,
    const std::string& help = "run the query N times, report the median time of the runs after the first; default 1");
/// `of` says what the seed is of.
Option declare_seed(OptionList& options, std::uint64_t& seed, const std::string& of);
void declare_min_separation(OptionList& options, double& distance);

}  // namespace tamis::cli
