// Reads queries with exact answers from the public research data.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "support/data_folder.hpp"

namespace tamis::test {

struct Query {
  PairKind kind;
  oracle::Motion motion;
  bool touches;
  std::string origin;  ///< file and number, to name a failure
};

/// All queries below `folder`, in the order of file names. Throws std::runtime_error if a coordinate is no exact
/// double.
std::vector<Query> read_queries(const std::filesystem::path& folder);

/// Number of repetitions: `in_ci`, or the environment variable `name` if it is set (long runs).
long repetitions(const char* name, long in_ci);

}  // namespace tamis::test
