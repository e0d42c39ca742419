// The public research data with exact answers, which is not part of the project: ../shared/data beside it, or the
// folder in the environment variable TAMIS_DATA.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"

namespace tamis::test {

/// Empty if the data is not there: the test then says so with GTEST_SKIP.
std::filesystem::path data_folder();

inline constexpr const char* kNoData = "no test data: set TAMIS_DATA to the folder that holds frames/ and queries/";

struct Query {
  PairKind kind;
  oracle::Motion motion;
  bool touches;
  std::string origin;  ///< file and number, to name a failure
};

/// All queries below `folder`, in the order of file names. Throws std::runtime_error on anything but exact doubles.
std::vector<Query> read_queries(const std::filesystem::path& folder);

/// Number of repetitions: `in_ci`, or the environment variable `name` if it is set (long runs).
long repetitions(const char* name, long in_ci);

}  // namespace tamis::test
