// The clock that never jumps, as nanoseconds.
#pragma once

#include <chrono>
#include <cstdint>

namespace ocelli {

inline int64_t steadyNanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace ocelli
