// The report of tamis-lab paper: our tables beside the paper's, and its claims one by one.
#include "command/report.hpp"

#include <fmt/format.h>

#include "files/atomic_file.hpp"
#include "paper/command/evaluation/figures.hpp"
#include "paper/command/evaluation/tables.hpp"

namespace tamis::lab {
namespace {

std::string published_cells(const SceneResult& r) {
  const PublishedRow* p = published_row(r);
  return p ? fmt::format("{} | {} | {}", p->milliseconds, p->over_sat, p->over_r_triangles) : "- | - | -";
}

std::string steps_of(const SceneResult& r) {
  return r.steps == r.all_steps ? std::to_string(r.steps) : fmt::format("{} of {}", r.steps, r.all_steps);
}

std::string table_1(Results results) {
  std::string text =
      "## Table 1: the published method, one thread\n\n"
      "| scene, step | triangles | steps | ms a frame | over SAT | over R-triangles | paper: ms | over SAT | over "
      "R-triangles | default method: ms | default over paper |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const SceneResult& r : results)
    text += fmt::format("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {} | {:.2f} | {:.2f} |\n", row_name(r),
                        cli::grouped(r.triangles), steps_of(r), r.milliseconds("paper"), ratio(r, "paper-sat", "paper"),
                        ratio(r, "paper-r-triangles", "paper"), published_cells(r), r.milliseconds("tamis"),
                        ratio(r, "paper", "tamis"));
  return text;
}

/// A table with a column for each method.
template <class Cell>
std::string table_by_method(Results results, const std::string& title, const Cell& cell) {
  std::string text = fmt::format("\n## {}\n\n| scene, step |", title);
  std::string rule = "\n|---|";
  for (const std::string& name : paper_methods()) {
    text += fmt::format(" {} |", name);
    rule += "--:|";
  }
  text += rule + "\n";
  for (const SceneResult& r : results) {
    text += fmt::format("| {} |", row_name(r));
    for (const MethodResult& m : r.methods) text += fmt::format(" {} |", cell(r, m));
    text += "\n";
  }
  return text;
}

std::string figure_5(Results results) {
  std::string text =
      "\n## Fig. 5: what NCF culls of the pairs that DNF leaves\n\n"
      "| scene, step | pairs after DNF | after NCF | culled | of vertex-face | of edge-edge | of those that are no "
      "contact |\n|---|--:|--:|--:|--:|--:|--:|\n";
  for (const SceneResult& r : results) {
    const MethodResult& m = r.method("paper");
    const auto rate = [&](Counted kind) { return kPercent * culled_between(m, "ncf-published", "newton", kind); };
    text +=
        fmt::format("| {} | {} | {} | {:.1f}% | {:.1f}% | {:.1f}% | {:.1f}% |\n", row_name(r),
                    cli::grouped(m.entering("ncf-published")), cli::grouped(m.elementary_tests()), rate(Counted::both),
                    rate(Counted::vf), rate(Counted::ee), kPercent * ncf_rate_of_false_pairs(r));
  }
  return text;
}

constexpr std::string_view kDiscussion = R"(
## Why the numbers differ

- **Other scenes.** The original sequences are not available. `tamis scene` simulates `airbag`, `cloth-ball`, `funnel` and `bunny`
  under the same titles. Folds, speeds and time steps differ, so no figure here contradicts the paper's own.
- **Another machine.** It is twenty years younger. Milliseconds do not compare, ratios may. Filters trade additions for
  elementary tests, so they gain less if that test is fast.
- **Contacts count.** A pair that touches must reach the elementary test whatever the filter does. Frames here are free of
  intersections. Yet the straight path between two frames touches often, and more so at 3x. So the culling rate is also given
  for the pairs without a contact.
- **3x** takes every third frame. For a folder of two frames the step is stretched to three times its length instead. This drives
  bodies through each other more than any simulation would. Such rows are marked "stretched".
- **Soundness costs.** Every filter here has error bounds in floating point, which the published filters did not have. Pairs that
  rounding cannot decide enter the next stage.

## How it was measured

One thread. Milliseconds are the mean over the steps, of processor time. They include bounds, refitting, and rebuilding where
refitting has made the hierarchy poor. A method runs its first step twice. The first run builds and does not count.
The methods take turns within every step. "Missed" counts contacts that any method reports and this one does not, step by step.
"Pairs left" enter the elementary test. Without representative triangles a pair may count more than once.
`table1.csv` and `stages.csv` have the sums behind every figure.
)";

}  // namespace

void write_paper_report(const std::filesystem::path& folder, Results results, const std::string& size) {
  std::string text = "# The paper's evaluation, on scenes of our own\n\nWritten by `tamis-lab paper`. " + size + "\n\n";
  text += table_1(results);
  text += table_by_method(
      results, "Milliseconds a frame, all methods",
      [](const SceneResult& r, const MethodResult& m) { return fmt::format("{:.2f}", r.milliseconds(m.method)); });
  text += table_by_method(results, "Fig. 4: elementary tests left, all steps",
                          [](const SceneResult&, const MethodResult& m) { return cli::grouped(m.elementary_tests()); });
  text += table_by_method(results, "False pairs left: elementary tests that find no contact",
                          [](const SceneResult&, const MethodResult& m) { return cli::grouped(m.false_pairs()); });
  text += table_by_method(results, "Contacts (missed)", [](const auto&, const MethodResult& m) {
    return fmt::format("{} ({})", cli::grouped(m.contacts), m.missed);
  });
  text += figure_5(results);
  text += paper_sieve(results);
  text += paper_claims(results);
  text += kDiscussion;
  text +=
      "\n## Pictures\n\nMade from the CSV files by `plot_paper.py`, which is installed with the command: table1.png, "
      "fig4.png, fig5.png.\n";
  io::AtomicFile file(folder / "report.md");
  file.append(text);
  file.commit();
}

}  // namespace tamis::lab
