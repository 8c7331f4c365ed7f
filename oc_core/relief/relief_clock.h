// Times of what is made and drawn. For .cpp files.
#pragma once

#include <chrono>

namespace ocelli {

inline double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace ocelli
