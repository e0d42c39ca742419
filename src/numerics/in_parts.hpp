// A loop shared out among threads, where it is long enough.
#pragma once
#include <tbb/parallel_for.h>

namespace tamis {

/// f(begin, end) of parts that make up 0 to `count`; what is no longer than `grain` is one, and stays with this thread:
/// handing it over costs as much as a tenth of all that a mesh of a dozen triangles asks for.
template <class Count, class F>
void in_parts(Count count, Count grain, const F& f) {
  if (count <= grain) {
    if (count > 0) f(Count{0}, count);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<Count>(0, count, static_cast<std::size_t>(grain)),
                    [&](const tbb::blocked_range<Count>& part) { f(part.begin(), part.end()); });
}

}  // namespace tamis
