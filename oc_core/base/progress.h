// How long work tells how far it is. Rooms call the function; the command line draws a bar on a terminal.
#pragma once

#include <functional>
#include <string_view>

namespace ocelli {

/// `fraction` runs from 0 to 1 within the named stage. May be empty: test it before calling, or use report().
using Progress = std::function<void(std::string_view stage, double fraction)>;

inline void report(const Progress& progress, std::string_view stage, double fraction) {
  if (progress) {
    progress(stage, fraction);
  }
}

}  // namespace ocelli
