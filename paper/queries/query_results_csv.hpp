// The answers to single queries as a table.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tamis/pair.hpp"

namespace tamis::lab {

struct QueryResult {
  std::string file;
  PairKind kind;
  PairResult result;
};

/// Writes the table atomically. Columns: file,kind,touches,toi_lower,toi_upper; kind is vf or ee, touches 0 or 1; times
/// are empty if the pair does not touch. Throws FileError.
void write_query_results_csv(const std::filesystem::path& path, const std::vector<QueryResult>& results);

}  // namespace tamis::lab
