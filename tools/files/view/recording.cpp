#include "files/view/recording.hpp"

#include "files/scale_step.hpp"

namespace tamis::io {

FirstStep::FirstStep(const Recording& recording)
    : start(recording.frames[0]), end(recording.frames[recording.steps.empty() ? 0 : 1]) {
  if (!recording.steps.empty()) scale_step(start, end, recording.scale);
}

}  // namespace tamis::io
