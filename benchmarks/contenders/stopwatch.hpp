// Measures wall-clock and processor time.
#pragma once
#include <chrono>
#include <ctime>

namespace tamis::bench {

struct Cost {
  double seconds = 0;
  double cpu = 0;  ///< processor seconds of all threads: steadier than the wall clock on a machine in use
};

class Stopwatch {
 public:
  Cost cost() const {
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(),
            static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC};
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
};

}  // namespace tamis::bench
