// Lines of an eye tracker, CSV: device time, x, y, validity and, where there is one, the size of the pupil.
//
//   1042.5,0.31,0.72,1,3.4
//
// A line of names may come before others, and again at any time; it says what the columns are:
//
//   time,x_px,y_px,valid,pupil      pixels of the screen, from its left and upper edge
//   time,x_norm,y_norm,valid        shares of the screen's width and height
//
// Without one they stand in that order, in the unit that the input was opened with. docs/gaze.md
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "study/session/records.h"

namespace ocelli {

enum class GazeUnit { kPixels, kShares };

class GazeLines {
 public:
  /// A longer line is malformed.
  static constexpr size_t kMaxLineBytes = 1000;
  static constexpr size_t kMaxColumns = 32;

  /// Shares are of a screen of so many pixels.
  GazeLines(GazeUnit unit, int screenWidth, int screenHeight);

  /// The samples of whole lines that came at that time. The last one need not end. Lines that are wrong are counted;
  /// empty ones, and those that begin with "#", are passed over.
  std::vector<GazeRecord> read(std::string_view lines, int64_t nanoseconds);

  int64_t malformed() const { return malformed_; }

 private:
  bool readNames(std::string_view line);
  bool readSample(std::string_view line, GazeRecord& sample) const;

  static constexpr size_t kFields = 5;  ///< time, x, y, valid, pupil
  static constexpr size_t kNone = static_cast<size_t>(-1);

  double width_;
  double height_;
  GazeUnit unit_;
  std::array<size_t, kFields> columns_{0, 1, 2, 3, 4};  ///< of each field
  bool pupilMayLack_ = true;                            ///< no line of names has said that there is one
  int64_t malformed_ = 0;
};

}  // namespace ocelli
