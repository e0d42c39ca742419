// Tamis itself, the published pipeline, and the decision of one pair.
#include <fmt/format.h>

#include <span>

#include "benchmarks/contenders/contender.hpp"
#include "paper/detector.hpp"
#include "scenes/point_math.hpp"
#include "tamis/pair.hpp"

namespace tamis::bench {
namespace {

Pair pair_of(const Contact& contact) { return {contact.kind, contact.vertices}; }

/// A contender that asks a detector. It makes the detector anew in every run (new), or keeps and refits it (kept). A
/// kept one is first asked about other positions, so that no list of pairs helps.
class Asked : public Contender {
 public:
  Asked(std::string method, bool is_kept) : method_(std::move(method)), is_kept_(is_kept) {}
  std::string name() const override { return method_ + (is_kept_ ? ", kept" : ", new"); }

 protected:
  Detector& detector(const Task& task) {
    if (!detector_ || !is_kept_ || threads_ != task.threads) {
      lab::Options options;
      choose_method(options, method_);
      options.threads = threads_ = task.threads;
      detector_ = std::make_unique<Detector>(lab::make_detector(task.mesh, options));
    }
    if (is_kept_) {
      const std::vector<Point> start = scenes::exchanged(task.start), end = scenes::exchanged(task.end);
      ask({start, end});
    }
    return *detector_;
  }
  const Statistics& statistics() const { return detector_->statistics(); }

 private:
  void ask(const Step& step) {
    if (field() == Field::largest_step)
      (void)detector_->earliest(step);
    else
      (void)detector_->contacts(step);
  }

  std::string method_;
  bool is_kept_;
  int threads_ = 0;
  std::unique_ptr<Detector> detector_;
};

class AllContacts final : public Asked {
 public:
  using Asked::Asked;
  Field field() const override { return Field::all_contacts; }
  Cost run(const Task& task) override {
    Detector& asked = detector(task);
    const Stopwatch watch;
    contacts_ = asked.contacts({task.start, task.end});
    return watch.cost();
  }
  Answer answer(const Task& task) override {
    std::vector<Pair> pairs;
    for (const Contact& contact : contacts_) pairs.push_back(pair_of(contact));
    return compare(task, pairs, true, true);
  }

 private:
  std::span<const Contact> contacts_;
};

class LargestStep final : public Asked {
 public:
  using Asked::Asked;
  Field field() const override { return Field::largest_step; }
  Cost run(const Task& task) override {
    Detector& asked = detector(task);
    const Stopwatch watch;
    first_ = asked.earliest({task.start, task.end});
    return watch.cost();
  }
  Answer answer(const Task&) override { return {0, 0, 0, 0, fmt::format("step {:.10g}", first_.toi_lower)}; }

 private:
  EarliestContact first_;
};

/// Boxes, build and search of a question for all contacts: the part of Tamis that corresponds to a broad phase. Its
/// boxes move, so it finds fewer pairs than swept boxes do. Compares the contacts to see that no pair is missed.
class BroadPhase final : public Asked {
 public:
  using Asked::Asked;
  std::string name() const override { return Asked::name() + ": boxes, build, search"; }
  Field field() const override { return Field::broad_phase; }
  Cost run(const Task& task) override {
    Detector& asked = detector(task);
    const Stopwatch watch;
    contacts_ = asked.contacts({task.start, task.end}).size();
    const Cost whole = watch.cost();
    const Seconds& seconds = statistics().seconds;
    const double part = seconds.bounds + seconds.build + seconds.traverse;
    return {part, whole.cpu * part / seconds.total};
  }
  Answer answer(const Task& task) override {
    const StageCount& boxes = statistics().stages.front();
    return {boxes.vf, boxes.ee, task.contacts.size() > contacts_ ? task.contacts.size() - contacts_ : 0, 0,
            "moving boxes: a subset"};
  }

 private:
  std::size_t contacts_ = 0;
};

/// Decides candidates of one kind alone, to compare with contenders that know only this kind.
class OnePair final : public Contender {
 public:
  explicit OnePair(PairKind kind) : kind_(kind) {}
  std::string name() const override { return is_vf() ? "tamis::vertex_face" : "tamis::edge_edge"; }
  Field field() const override { return Field::one_pair; }
  Cost run(const Task& task) override {
    const Stopwatch watch;
    touching_.clear();
    for (const Pair& pair : task.candidates) {
      if (pair.kind != kind_) continue;
      std::array<Point, 4> start, end;
      for (std::size_t i = 0; i < 4; ++i) {
        start[i] = task.start[static_cast<std::size_t>(pair.vertices[i])];
        end[i] = task.end[static_cast<std::size_t>(pair.vertices[i])];
      }
      if ((is_vf() ? vertex_face(start, end) : edge_edge(start, end)).touches) touching_.push_back(pair);
    }
    return watch.cost();
  }
  Answer answer(const Task& task) override { return compare(task, touching_, is_vf(), !is_vf()); }

 private:
  bool is_vf() const { return kind_ == PairKind::vertex_face; }

  PairKind kind_;
  std::vector<Pair> touching_;
};

}  // namespace

void add_tamis(Contenders& list) {
  for (const bool is_kept : {false, true}) {
    list.push_back(std::make_unique<BroadPhase>("tamis", is_kept));
    list.push_back(std::make_unique<AllContacts>("tamis", is_kept));
    list.push_back(std::make_unique<AllContacts>("paper", is_kept));
    list.push_back(std::make_unique<LargestStep>("tamis", is_kept));
  }
  list.push_back(std::make_unique<OnePair>(PairKind::vertex_face));
  list.push_back(std::make_unique<OnePair>(PairKind::edge_edge));
}

}  // namespace tamis::bench
