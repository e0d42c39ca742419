// From the times that each vertex may go to, to doubles: positions are rounded, and the straight way to them is another
// one than all together first and then each on its own. So it is asked, and what touches is pulled back.
#pragma once
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/step.hpp"

namespace tamis {

class Truncation {
 public:
  /// The positions of `step` must outlive it.
  Truncation(const Step& step, VertexSteps steps);

  Step way() const { return {step_.start, positions_}; }
  /// What touches on the way: vertices go back to where all may go together; if that does not help, all do, and go
  /// less and less far.
  void pull_back(const std::vector<Contact>& contacts);
  bool goes_on() const { return goes_on_; }
  TruncatedStep take() { return {std::move(positions_), is_free_}; }

 private:
  void place_all();

  Step step_;
  VertexSteps steps_;
  std::vector<Point> positions_;
  int rounds_ = 0;
  bool goes_on_ = true, is_free_ = false;
};

}  // namespace tamis
