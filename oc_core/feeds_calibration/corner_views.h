// The corners of a board in images.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/feeds_calibration/calibration_board.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// A corner between squares that an image shows.
struct BoardCorner {
  glm::dvec2 board{0};  ///< millimetres on the board
  glm::dvec2 pixel{0};  ///< from the top left corner of the image
};

using BoardView = std::vector<BoardCorner>;

/// Fewer corners tell nothing of a view: a homography has 8 unknowns, and some must be left to show errors.
inline constexpr size_t kMinViewCorners = 8;

/// Nothing where fewer than kMinViewCorners are seen, or all lie in a line. Of a chessboard all must be seen.
BoardView boardViewIn(const Image<Rgb8>& image, const CalibrationBoard& board);

}  // namespace ocelli
