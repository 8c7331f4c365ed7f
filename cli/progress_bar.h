// A progress bar on standard error: "slice  [#####.....]  52%".
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace ocelli {

class ProgressBar {
 public:
  /// True where standard error is a terminal that can redraw a line.
  static bool possible();

  /// Draws at most 10 times a second in a stage. A `fraction` that is NaN stands for one that nobody knows: the stage
  /// alone is drawn. May be called from several threads.
  void show(std::string_view stage, double fraction);
  /// Removes the bar from the terminal.
  void clear();

 private:
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point drawnAt_;
  bool drawn_ = false;
};

}  // namespace ocelli
