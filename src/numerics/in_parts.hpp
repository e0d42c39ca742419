// A parallel loop, if it is long enough.
#pragma once
#include <tbb/parallel_for.h>

namespace tamis {

/// Calls f(begin, end) for parts of 0 to `count`. A loop no longer than `grain` stays with this thread: handing it over
/// costs a tenth of a whole question about a mesh of a dozen triangles.
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
