// The screen of a run of the study, as the run stored it when it began.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"

namespace ocelli {

/// What is not known is empty.
struct RunScreen {
  bool simulated = false;  ///< there was no screen
  std::string monitor{};   ///< as the monitor calls itself
  std::optional<double> widthPixels{};
  std::optional<double> heightPixels{};
  std::optional<double> widthMillimeters{};  ///< as the monitor says
  std::optional<double> heightMillimeters{};
  std::optional<double> refreshHertz{};  ///< as the monitor says
  std::string graphics{};                ///< the renderer
  bool softwareRendered = false;
  std::optional<double> pacedHertz{};  ///< frames were held back by the program, not by the screen
  std::vector<std::string> notMeasured{};

  // The check of the timing before the session.
  std::string verdict{};                  ///< "good", "refused", "simulated_clock"
  std::optional<double> measuredHertz{};  ///< frames a second
  std::optional<double> jitterShare{};    ///< standard deviation of the intervals, of their mean
  std::optional<double> lateShare{};      ///< of the frames
};

/// Text that is no JSON, or has other fields, gives what it has: never an error.
RunScreen screenOf(const Run& run);

}  // namespace ocelli
