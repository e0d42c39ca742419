// Options that several verbs share.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "tamis/options.hpp"

namespace tamis::cli {

inline constexpr const char* kDefaultBoundingVolume = "16-dop";

/// How to detect.
class DetectorArguments {
 public:
  void declare(CLI::App& app);
  /// Throws InvalidOptions.
  Options options() const;

 private:
  std::string method_ = "tamis";
  std::string guarantee_ = "conservative";
  std::string isa_ = "best";
  std::string bounding_volume_ = kDefaultBoundingVolume;
  int threads_ = 0;
  double min_separation_ = 0;
};

/// `--scale S`: how much of the way from START to END a step goes.
class ScaleArgument {
 public:
  void declare(CLI::App& app);
  /// Throws InvalidOptions.
  double value() const;

 private:
  double scale_ = 1;
};

void declare_json(CLI::App& app, bool& json);
void declare_repeat(CLI::App& app, int& repeat);
void declare_guarantee(CLI::App& app, std::string& guarantee);
void declare_bounding_volume(CLI::App& app, std::string& volume);
void declare_min_separation(CLI::App& app, double& distance);

/// Throws InvalidOptions unless the distance is finite and not negative.
void require_distance(double distance);

}  // namespace tamis::cli
