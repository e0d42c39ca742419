// Single vertex-face and edge-edge queries in exact fractions.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tamis/contact.hpp"

namespace tamis::io {

struct Query {
  PairKind kind;
  std::array<Point, 4> start;  ///< vertex-face: v f0 f1 f2; edge-edge: a0 a1 b0 b1
  std::array<Point, 4> end;
  std::optional<bool> touches;  ///< the exact answer, where the file gives it
};

/// Files of queries, in natural order, that belong to one scene.
struct QueryFile {
  std::filesystem::path path;
  PairKind kind;
  std::string folder;  ///< name of the scene: the folder above vertex-face or edge-edge
};

/// Eight rows a query, the four points at t=0, then at t=1; columns: numerator and denominator of x, of y, of z, then
/// the answer, 0 or 1, which all files but unlabelled ones have. Every coordinate must be exactly a double. Throws
/// FileError.
std::vector<Query> parse_queries(std::string_view bytes, PairKind kind, const std::string& name);

/// CSV files, and folders searched to any depth. A file's kind is told by a folder named vertex-face or edge-edge (or
/// vf, ee) above it. Throws FileError.
std::vector<QueryFile> query_files(const std::vector<std::string>& names);

}  // namespace tamis::io
