#include "paper/command/evaluation/earlier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "files/error.hpp"
#include "files/text.hpp"

namespace tamis::lab {
namespace {

/// The cells of one line, taken in order. Throws FileError for a cell that this program would not write.
class Cells {
 public:
  Cells(const std::string& file, const io::Lines& lines) : file_(file), number_(lines.number()), rest_(lines.line()) {}

  std::string_view text() {
    const std::string_view cell = io::take_until(rest_, ',');
    if (cell.empty()) fail();
    return cell;
  }
  template <class Integer>
  Integer integer() {
    return value(io::to_integer<Integer>(text()));
  }
  double real() { return value(io::to_double(text())); }
  /// "3x".
  int factor() {
    const std::string_view cell = text();
    if (cell.back() != 'x') fail();
    return value(io::to_integer<int>(cell.substr(0, cell.size() - 1)));
  }

 private:
  template <class T>
  T value(const std::optional<T>& parsed) {
    if (!parsed) fail();
    return *parsed;
  }
  [[noreturn]] void fail() const {
    throw io::FileError(file_, fmt::format("line {}", number_),
                        "no row of this version's tables: remove the file, or run without --resume");
  }

  const std::string& file_;
  std::size_t number_;
  std::string_view rest_;
};

/// Calls read(cells) for each line after the first.
template <class Read>
void for_each_row(const std::filesystem::path& file, std::string_view bytes, const Read& read) {
  const std::string name = file.string();
  io::Lines lines(bytes);
  lines.next();
  while (lines.next()) {
    Cells cells(name, lines);
    read(cells);
  }
}

MethodResult& method_of(SceneResult& result, std::string_view name) {
  if (name == result.sieve.method) return result.sieve;
  const auto is_it = [&](const MethodResult& m) { return m.method == name; };
  const auto there = std::find_if(result.methods.begin(), result.methods.end(), is_it);
  if (there != result.methods.end()) return *there;
  return result.methods.emplace_back(MethodResult{.method = std::string(name), .stages = {}});
}

}  // namespace

EarlierResults::EarlierResults(const std::filesystem::path& folder) {
  const auto table = folder / "table1.csv", stages = folder / "stages.csv";
  if (!std::filesystem::exists(table)) return;
  files_.reserve(2);
  read_table(table);
  read_stages(stages);
}

const SceneResult* EarlierResults::find(std::string_view scene, int factor) const {
  for (const SceneResult& r : results_)
    if (r.scene == scene && r.factor == factor) return &r;
  return nullptr;
}

void EarlierResults::append_rest(std::vector<SceneResult>& results) const {
  for (const SceneResult& r : results_) {
    const auto is_it = [&](const SceneResult& other) { return other.scene == r.scene && other.factor == r.factor; };
    if (std::none_of(results.begin(), results.end(), is_it)) results.push_back(r);
  }
}

SceneResult& EarlierResults::row(std::string_view scene, int factor) {
  for (SceneResult& r : results_)
    if (r.scene == scene && r.factor == factor) return r;
  return results_.emplace_back(SceneResult{.scene = std::string(scene),
                                           .factor = factor,
                                           .extrapolated = false,
                                           .triangles = 0,
                                           .steps = 0,
                                           .all_steps = 0,
                                           .methods = {},
                                           .sieve = {.method = "sieve", .stages = {}}});
}

void EarlierResults::read_table(const std::filesystem::path& file) {
  for_each_row(file, files_.emplace_back(file).view(), [&](Cells& cells) {
    const std::string_view scene = cells.text();
    SceneResult& r = row(scene, cells.factor());
    r.extrapolated = cells.integer<int>() != 0;
    r.triangles = cells.integer<std::size_t>();
    r.steps = cells.integer<std::size_t>();
    r.all_steps = cells.integer<std::size_t>();
    MethodResult& m = method_of(r, cells.text());
    constexpr double kSecondsPerMillisecond = 1e-3;
    m.seconds = kSecondsPerMillisecond * cells.real() * static_cast<double>(r.steps);
    cells.text();  // elementary tests and false pairs follow from the stages
    cells.text();
    m.contacts = cells.integer<std::uint64_t>();
    m.missed = cells.integer<std::uint64_t>();
  });
}

void EarlierResults::read_stages(const std::filesystem::path& file) {
  for_each_row(file, files_.emplace_back(file).view(), [&](Cells& cells) {
    const std::string_view scene = cells.text();
    const int factor = cells.factor();
    const std::string_view method = cells.text();
    StageCount stage{cells.text()};
    stage.vf = cells.integer<std::uint64_t>();
    stage.ee = cells.integer<std::uint64_t>();
    // Stages are written before the table. If the table lacks their scene, an interrupted run left them.
    if (find(scene, factor)) method_of(row(scene, factor), method).stages.push_back(stage);
  });
}

}  // namespace tamis::lab
