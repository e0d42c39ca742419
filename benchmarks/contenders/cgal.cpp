// CGAL, box_intersection_d: streamed segment tree over swept boxes; one thread. GPL: this program only, never the
// library.
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include "benchmarks/contenders/swept_boxes.hpp"

namespace tamis::bench {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<float, 3, std::uint32_t>;

std::vector<Box> boxes_of(std::vector<SweptBox>& swept) {
  std::vector<Box> boxes;
  boxes.reserve(swept.size());
  for (std::size_t i = 0; i < swept.size(); ++i)
    boxes.emplace_back(swept[i].low, swept[i].high, static_cast<std::uint32_t>(i));
  return boxes;
}

class Cgal final : public Contender {
 public:
  std::string name() const override { return "CGAL box_intersection_d"; }
  Field field() const override { return Field::broad_phase; }
  bool uses_threads() const override { return false; }
  Cost run(const Task& task) override {
    const Stopwatch watch;
    counter_ = std::make_unique<PairCounter>(task);
    swept_.compute(task);
    auto points = boxes_of(swept_.points), edges = boxes_of(swept_.edges), faces = boxes_of(swept_.faces);
    PairCounter::Batch vf, ee;
    CGAL::box_intersection_d(points.begin(), points.end(), faces.begin(), faces.end(),
                             [&](const Box& p, const Box& f) { counter_->add_vf(p.info(), f.info(), vf); });
    CGAL::box_self_intersection_d(edges.begin(), edges.end(),
                                  [&](const Box& a, const Box& b) { counter_->add_ee(a.info(), b.info(), ee); });
    counter_->commit(PairKind::vertex_face, vf);
    counter_->commit(PairKind::edge_edge, ee);
    return watch.cost();
  }
  Answer answer(const Task& task) override { return counter_->answer(task); }

 private:
  SweptBoxes swept_;
  std::unique_ptr<PairCounter> counter_;
};

}  // namespace

void add_cgal(Contenders& list) { list.push_back(std::make_unique<Cgal>()); }

}  // namespace tamis::bench
