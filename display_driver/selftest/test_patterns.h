// Patterns that show whether a swept-screen display is built and calibrated right, in the order in which to go through
// them: each takes for granted that those before it look right.
//
// Recipe for a new pattern:
//   1. display_driver/selftest/pattern_volumes.h: a function that paints its volume for any profile (pattern_canvas.h
//      helps);
//   2. display_driver/selftest/test_patterns.cpp: its name, what to look for, and what it means when it looks wrong;
//   3. tests/display_driver_selftest/pattern_volumes_test.cpp: which voxels it lights.
// `ocelli device selftest`, its checklist and the tests of every pattern find it there.
#pragma once

#include <string>
#include <vector>

#include "display_sim/frames/volume.h"

namespace ocelli {

/// Where those stand who look at a pattern.
enum class PatternView {
  kFront,
  kRaised,  ///< in front, 45 degrees up
  kRight,
  kAbove,
};

/// A way in which a pattern can look wrong.
struct WrongLook {
  std::string looks;
  std::string means;
  std::string adjust;
  Volume (*shown)(const Volume& sent) = nullptr;  ///< an example of it (misbuilt_displays.h), where there is one
  PatternView view = PatternView::kRaised;        ///< from where it shows best
};

struct TestPattern {
  std::string name;                  ///< lower case, as commands and files call it
  std::string title;                 ///< "Order and number of slices"
  std::string shows;                 ///< what is lit, in a sentence or two
  std::vector<std::string> lookFor;  ///< one box to tick each
  std::vector<WrongLook> wrong;
  Volume (*volume)(const DisplayProfile&);
  /// What to expect on this display, in numbers.
  std::vector<std::string> (*figures)(const DisplayProfile&);
};

const std::vector<TestPattern>& testPatterns();
/// Throws InputError that names those that there are.
const TestPattern& testPattern(const std::string& name);

}  // namespace ocelli
