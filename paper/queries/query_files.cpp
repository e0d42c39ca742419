#include <algorithm>

#include "files/error.hpp"
#include "files/mesh/frames.hpp"
#include "paper/queries/queries.hpp"

namespace tamis::lab {
namespace {

namespace fs = std::filesystem;

std::optional<PairKind> kind_of(const std::string& folder) {
  if (folder == "vertex-face" || folder == "vf") return PairKind::vertex_face;
  if (folder == "edge-edge" || folder == "ee") return PairKind::edge_edge;
  return std::nullopt;
}

/// None if it is not JSON file, nor a CSV file whose kind a folder above tells. The nearest such folder counts.
std::optional<QueryFile> query_file(const fs::path& path, const std::string& name) {
  std::error_code error;
  fs::path folder = fs::absolute(path, error).lexically_normal().parent_path();
  if (path.extension() == ".json") return QueryFile{path, name, folder.filename().string(), std::nullopt};
  if (path.extension() != ".csv") return std::nullopt;
  for (; folder.has_relative_path(); folder = folder.parent_path())
    if (const auto kind = kind_of(folder.filename().string()))
      return QueryFile{path, name, folder.parent_path().filename().string(), kind};
  return std::nullopt;
}

void add_folder(const fs::path& folder, std::vector<QueryFile>& files) {
  const std::size_t before = files.size();
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->is_directory()) continue;
    if (const auto file = query_file(it->path(), it->path().lexically_relative(folder).string()))
      files.push_back(*file);
  }
  if (error) throw io::FileError(folder.string(), "", "the folder cannot be read: check its permissions");
  if (files.size() == before)
    throw io::FileError(folder.string(), "",
                        "no query in this folder: give one that holds vertex-face/*.csv, edge-edge/*.csv or *.json");
}

void add_file(const fs::path& path, std::vector<QueryFile>& files) {
  const auto file = query_file(path, path.string());
  if (!file)
    throw io::FileError(
        path.string(), "",
        "no folder above it tells its kind: put a table into one named vertex-face or edge-edge, or give a "
        "JSON file");
  files.push_back(*file);
}

}  // namespace

std::vector<QueryFile> query_files(const std::vector<std::string>& names) {
  std::vector<QueryFile> files;
  std::error_code error;
  for (const std::string& name : names)
    for (const fs::path& path : io::paths_named(name)) {
      if (fs::is_directory(path, error))
        add_folder(path, files);
      else
        add_file(path, files);
    }
  std::stable_sort(files.begin(), files.end(), [](const QueryFile& a, const QueryFile& b) {
    return io::natural_less(a.path.string(), b.path.string());
  });
  return files;
}

}  // namespace tamis::lab
