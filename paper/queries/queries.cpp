#include "paper/queries/queries.hpp"

#include <algorithm>

#include "files/error.hpp"
#include "files/text.hpp"
#include "paper/queries/exact_double.hpp"

namespace tamis::lab {
namespace {

constexpr std::size_t kRows = 8;

struct Row {
  Point point;
  std::optional<bool> touches;
};

class QueryParser {
 public:
  QueryParser(std::string_view bytes, PairKind kind, const std::string& name)
      : lines_(bytes), kind_(kind), name_(name) {}

  std::vector<Query> parse() {
    std::size_t row = 0;
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (std::all_of(line.begin(), line.end(), io::is_blank)) continue;
      add(parse_row(line), row++ % kRows);
    }
    if (row == 0) throw io::FileError(name_, "", "no query in it: write the file again");
    if (row % kRows != 0)
      fail(fmt::format("the last query has {} of its 8 rows: the file was cut short, write it again", row % kRows));
    return std::move(queries_);
  }

 private:
  void add(const Row& row, std::size_t place) {
    if (place == 0) queries_.push_back({kind_, {}, {}, row.touches});
    Query& query = queries_.back();
    if (query.touches != row.touches) fail("the answer differs within one query: give its 8 rows one answer");
    (place < 4 ? query.start : query.end)[place % 4] = row.point;
  }

  Row parse_row(std::string_view line) const {
    std::array<std::string_view, 7> cells;
    const std::size_t count = split(line, cells);
    if (count != 6 && count != 7)
      fail(fmt::format("{} columns: give 6 (numerator and denominator of x, y, z) or 7 (and the answer)", count));
    Row row{};
    for (std::size_t axis = 0; axis < 3; ++axis) row.point[axis] = coordinate(cells[2 * axis], cells[2 * axis + 1]);
    if (count == 7) {
      if (cells[6] != "0" && cells[6] != "1")
        fail(fmt::format("the answer is {}: give 0 or 1", io::in_quotes(cells[6])));
      row.touches = cells[6] == "1";
    }
    return row;
  }

  /// Returns the number of cells in the line, and sets `cells` to the first seven, without blanks around them.
  static std::size_t split(std::string_view line, std::array<std::string_view, 7>& cells) {
    const auto count = 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    for (std::size_t i = 0; i < std::min(count, cells.size()); ++i) {
      std::string_view cell = io::take_until(line, ',');
      cells[i] = io::take_word(cell);
    }
    return count;
  }

  double coordinate(std::string_view numerator, std::string_view denominator) const {
    const auto value = exact_double(numerator, denominator);
    if (!value)
      fail(fmt::format("{} / {} is not exactly a double: give coordinates that are doubles, as fractions of integers",
                       io::in_quotes(numerator), io::in_quotes(denominator)));
    return *value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw io::FileError(name_, fmt::format("line {}", lines_.number()), what);
  }

  io::Lines lines_;
  PairKind kind_;
  const std::string& name_;
  std::vector<Query> queries_;
};

}  // namespace

std::vector<Query> parse_queries(std::string_view bytes, PairKind kind, const std::string& name) {
  return QueryParser(bytes, kind, name).parse();
}

}  // namespace tamis::lab
