#include "support/test_data.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "oracle/exact_numbers.hpp"

namespace tamis::test {

namespace fs = std::filesystem;

namespace {

double exact_double(const std::string& numerator, const std::string& denominator) {
  const oracle::Rational value{oracle::Integer(numerator), oracle::Integer(denominator)};
  const auto result = static_cast<double>(value);
  if (value != result) throw std::runtime_error(numerator + "/" + denominator + " is not a double");
  return result;
}

/// Seven columns: numerator and denominator of x, y, z, and the answer.
Point read_row(const std::string& line, bool& answer) {
  std::istringstream columns(line);
  Point point{};
  std::string numerator, denominator, last;
  for (double& x : point) {
    std::getline(columns, numerator, ',');
    std::getline(columns, denominator, ',');
    x = exact_double(numerator, denominator);
  }
  std::getline(columns, last);
  answer = last[0] == '1';
  return point;
}

void read_file(const fs::path& file, std::vector<Query>& queries) {
  std::ifstream in(file);
  const bool is_ee = file.parent_path().filename() == "edge-edge";
  std::vector<Point> rows;
  bool answer = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    rows.push_back(read_row(line, answer));
    if (rows.size() < 8) continue;
    Query query{is_ee ? PairKind::edge_edge : PairKind::vertex_face,
                {},
                answer,
                file.string() + " query " + std::to_string(number++)};
    std::copy_n(rows.begin(), 4, query.motion.start.begin());
    std::copy_n(rows.begin() + 4, 4, query.motion.end.begin());
    queries.push_back(query);
    rows.clear();
  }
  if (!rows.empty()) throw std::runtime_error(file.string() + " ends within a query");
}

}  // namespace

std::vector<Query> read_queries(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Query> queries;
  for (const fs::path& file : files) read_file(file, queries);
  return queries;
}

long repetitions(const char* name, long in_ci) {
  const char* set = std::getenv(name);
  return set != nullptr ? std::atol(set) : in_ci;
}

}  // namespace tamis::test
