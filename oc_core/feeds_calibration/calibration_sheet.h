// Boards and tags as PDF pages to print, with a ruler to check that the printer kept the size.
#pragma once

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

/// One page. Throws InputError where the board does not fit the paper.
std::string boardSheetPdf(const CalibrationBoard& board, const SheetPaper& paper);

/// As many tags on a page as fit, one below another and side by side, each with its id below. Throws InputError where
/// none fits, or an id is not in the family.
std::string tagSheetPdf(const std::vector<int>& ids, double tagMillimetres, const SheetPaper& paper);

}  // namespace ocelli
