// How Python asks: one question at a time, other threads run meanwhile, callables of Python answer, Ctrl-C stops it.
#pragma once
#include <type_traits>

#include "numbers/busy_guard.hpp"
#include "python/src/options.hpp"
#include "python/src/signals.hpp"
#include "python/src/truth.hpp"

namespace tamis::python {

/// A second question is refused, from another thread or from the filter.
class Asker {
 public:
  explicit Asker(const Asking& asking) : accepts_(asking.accepts), signals_(asking.is_cancelled) {}
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;

  /// The library copies its options, so that these refer to what is kept here.
  Options with_callbacks(Options options) {
    options.is_cancelled = [this] { return signals_.ask(); };
    if (!accepts_.is_none())
      options.filter.accepts = [this](PairKind kind, const std::array<Index, 4>& vertices) {
        const nb::gil_scoped_acquire lock;
        return accepts(kind, vertices);
      };
    return options;
  }

  /// For questions of another kind, asked by ask() all the same.
  bool should_stop() { return signals_.ask(); }
  /// What Python raised, if that is why a question ended that keeps to itself what ended it. Call with the lock held.
  void rethrow() { signals_.rethrow(); }

  template <class Work>
  void ask(const Work& work) {
    const BusyGuard guard(is_asked_);
    signals_.during(work);
  }
  /// The same; returns the answer.
  template <class Question>
  auto answer(const Question& question) {
    std::decay_t<std::invoke_result_t<Question>> found{};
    ask([&] { found = question(); });
    return found;
  }
  /// For what is read between questions.
  BusyGuard guard() { return BusyGuard(is_asked_); }

  /// What Python's garbage collector must know: a callable may refer back to its detector.
  int traverse(visitproc visit, void* arg) const {
    Py_VISIT(accepts_.ptr());
    Py_VISIT(signals_.is_cancelled().ptr());
    return 0;
  }
  void clear() {
    accepts_ = nb::none();
    signals_.clear();
  }

 private:
  bool accepts(PairKind kind, const std::array<Index, 4>& v) const {
    const nb::tuple pair = nb::make_tuple(v[0], v[1], v[2], v[3]);
    return truth_of(accepts_(static_cast<int>(kind), pair),
                    [&] { return "filter, asked about the pair " + nb::cast<std::string>(nb::repr(pair)) + ","; });
  }

  nb::object accepts_;
  Signals signals_;
  std::atomic_flag is_asked_;
};

}  // namespace tamis::python
