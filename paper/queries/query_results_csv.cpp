#include "paper/queries/query_results_csv.hpp"

#include <fmt/format.h>

#include "files/atomic_file.hpp"
#include "files/output/csv.hpp"

namespace tamis::lab {

void write_query_results_csv(const std::filesystem::path& path, const std::vector<QueryResult>& results) {
  io::AtomicFile file(path);
  file.append("file,kind,touches,toi_lower,toi_upper\n");
  for (const auto& [name, kind, result] : results) {
    const std::string_view kind_name = name_of(kind);
    file.append(result.touches
                    ? fmt::format("{},{},1,{},{}\n", io::csv_cell(name), kind_name, result.toi_lower, result.toi_upper)
                    : fmt::format("{},{},0,,\n", io::csv_cell(name), kind_name));
  }
  file.commit();
}

}  // namespace tamis::lab
