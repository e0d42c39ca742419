// Reads queries, and looks up the answers of JSON files in tables truth.csv.
#include "files/error.hpp"
#include "files/file_bytes.hpp"
#include "files/text.hpp"
#include "paper/queries/queries.hpp"

namespace tamis::lab {
namespace {

namespace fs = std::filesystem;

/// The answer for `file` in the table, whose rows are `file,kind,touches,...`; none if the table has no row for it.
std::optional<bool> answer_in(const fs::path& table, const std::string& file) {
  const io::FileBytes bytes(table);
  io::Lines lines(bytes.view());
  if (!lines.next() || lines.line().substr(0, 17) != "file,kind,touches") return std::nullopt;
  while (lines.next()) {
    std::string_view row = lines.line();
    if (io::take_until(row, ',') != file) continue;
    io::take_until(row, ',');
    const std::string_view touches = io::take_until(row, ',');
    if (touches != "0" && touches != "1")
      throw io::FileError(table.string(), fmt::format("line {}", lines.number()),
                          fmt::format("the answer is {}: give 0 or 1", io::in_quotes(touches)));
    return touches == "1";
  }
  return std::nullopt;
}

std::optional<bool> answer_beside(const fs::path& query) {
  constexpr int kMostFolders = 4;
  std::error_code error;
  const fs::path file = fs::absolute(query, error).lexically_normal();
  fs::path folder = file.parent_path();
  for (int i = 0; i < kMostFolders && folder.has_relative_path(); ++i, folder = folder.parent_path()) {
    if (!fs::is_regular_file(folder / "truth.csv", error)) continue;
    if (const auto answer = answer_in(folder / "truth.csv", file.lexically_relative(folder).string())) return answer;
  }
  return std::nullopt;
}

}  // namespace

std::vector<SingleQuery> read_queries(const QueryFile& file) {
  const io::FileBytes bytes(file.path);
  std::vector<SingleQuery> queries;
  if (file.kind) {
    for (Query& query : parse_queries(bytes.view(), *file.kind, file.path.string())) queries.emplace_back(query);
    return queries;
  }
  RigidQuery query = parse_rigid_query(bytes.view(), file.path.string());
  query.touches = answer_beside(file.path);
  return {query};
}

}  // namespace tamis::lab
