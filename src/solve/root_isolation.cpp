#include "solve/root_isolation.hpp"

#include <utility>

namespace tamis {
namespace {

/// A part of the unit interval, and the polynomial with that part mapped to [0,1].
struct Part {
  IntegerPolynomial local;
  DyadicCell cell;
};

/// The root at the lower end of a cell is the cell's own, unless the left neighbour's parent has reported it.
bool owns_lower_end(const DyadicCell& cell) { return cell.k == 0 || cell.n.is_odd(); }

}  // namespace

std::vector<AlgebraicTime> roots_in_unit_interval(const IntegerPolynomial& p) {
  std::vector<AlgebraicTime> roots;
  // Bisection ends only if all roots are simple; one sign variation means one simple root already.
  const IntegerPolynomial polynomial = p.sign_variations() > 1 ? p.squarefree_part() : p;
  std::vector<Part> parts;
  parts.push_back({polynomial, {}});
  while (!parts.empty()) {
    const Part part = std::move(parts.back());
    parts.pop_back();
    if (part.local[0].sign() == 0 && owns_lower_end(part.cell)) roots.push_back(AlgebraicTime::exactly(part.cell));
    const int variations = part.local.sign_variations();
    if (variations == 1) roots.emplace_back(polynomial, part.cell);
    if (variations <= 1) continue;
    parts.push_back({part.local.right_half(), part.cell.right_half()});
    parts.push_back({part.local.left_half(), part.cell.left_half()});
  }
  const DyadicCell end{1, 0};
  if (polynomial.sign_at(end) == 0) roots.push_back(AlgebraicTime::exactly(end));
  return roots;
}

}  // namespace tamis
