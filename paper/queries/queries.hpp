// Single vertex-face and edge-edge queries: straight motion in exact fractions, or features of two rigid bodies that
// turn and move.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::lab {

struct Query {
  PairKind kind;
  std::array<Point, 4> start;  ///< vertex-face: v f0 f1 f2; edge-edge: a0 a1 b0 b1
  std::array<Point, 4> end;
  std::optional<bool> touches;  ///< the exact answer, if the file gives it
};

/// The first feature belongs to the first body, the second to the other; rotation vector and position of each body are
/// linear in t.
struct RigidQuery {
  PairKind kind;
  std::array<Point, 4> points;  ///< in their bodies' frames; order as in Query
  std::array<RigidLink, 2> bodies;
  std::optional<bool> touches;

  RigidPath path() const;
};

using SingleQuery = std::variant<Query, RigidQuery>;

/// A file of queries, and the scene to which it belongs.
struct QueryFile {
  std::filesystem::path path;
  std::string name;              ///< relative to the given folder that holds it; as given if the file itself was
  std::string folder;            ///< name of the scene: the folder above vertex-face or edge-edge, or above a JSON file
  std::optional<PairKind> kind;  ///< of the queries of a CSV file; none for a JSON file, which holds its kind
};

/// Parses a CSV file. Each query has eight rows: its four points at t=0, then at t=1. Columns: numerator and
/// denominator of x, of y, of z, then the answer, 0 or 1, except in unlabelled files. Every coordinate must be exactly
/// a double. Throws FileError.
std::vector<Query> parse_queries(std::string_view bytes, PairKind kind, const std::string& name);

/// Parses the query of a JSON file: `type` fv or ee, and the features `face` and `vertex`, or `edge0` and `edge1`. Each
/// feature has its corners vertex0, vertex1, ... (a vertex: `vertex`) and its body's poses `pose_t0`, `pose_t1`, with
/// `position` and `rotation`, a rotation vector in radians. Throws FileError.
RigidQuery parse_rigid_query(std::string_view bytes, const std::string& name);

/// All queries of a file. The answer of a JSON file is looked for in a table truth.csv beside it or up to three folders
/// above, with the columns file (relative to the table), kind, touches. Throws FileError.
std::vector<SingleQuery> read_queries(const QueryFile& file);

/// The query files among `names`: CSV and JSON files, and folders, which are searched to any depth; in natural order.
/// The name of a folder above a CSV file, vertex-face or edge-edge (or vf, ee), tells its kind. Throws FileError.
std::vector<QueryFile> query_files(const std::vector<std::string>& names);

}  // namespace tamis::lab
