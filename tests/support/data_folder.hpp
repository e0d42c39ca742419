// The public research data with exact answers, which is not part of the project: ../shared/data beside it, or the
// folder in the environment variable TAMIS_DATA.
#pragma once
#include <filesystem>

namespace tamis::test {

/// Empty if the data is missing; the test then skips with kNoData.
std::filesystem::path data_folder();

inline constexpr const char* kNoData = "no test data: set TAMIS_DATA to the folder that holds frames/ and queries/";

}  // namespace tamis::test
