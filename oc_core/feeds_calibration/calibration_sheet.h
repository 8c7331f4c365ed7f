// Boards and tags as PDF pages to print, with a ruler to check that the printer kept the size.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/feeds_calibration/calibration_board.h"

namespace ocelli {

struct SheetPaper {
  double widthMillimetres = 297;
  double heightMillimetres = 210;
};

/// "a4", "a3", "a2", "a1", "a0", lying; or WIDTHxHEIGHT in millimetres. Throws InputError.
SheetPaper paperFromText(const std::string& text);

struct SheetContents {
  std::optional<CalibrationBoard> board;  ///< on a page of its own
  std::vector<int> tags;                  ///< their ids
  double tagMillimetres = 130;            ///< the side of the black square: one is on A4
};

/// The board, then as many tags on a page as fit, one below another and side by side, each with its id below. Throws
/// InputError where the board or a tag does not fit the paper, or an id is not in the family.
std::string calibrationSheetPdf(const SheetContents& contents, const SheetPaper& paper);

}  // namespace ocelli
