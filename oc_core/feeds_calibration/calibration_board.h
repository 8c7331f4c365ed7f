// The boards that lenses are calibrated with: a chessboard, or one whose white squares hold markers (ChArUco; Garrido-
// Jurado et al. 2014), of which a view may see a part.
//
// In the text form, lengths in millimetres: COLUMNSxROWS:SQUARE:MARKER:DICTIONARY counts squares ("8x5:32:24:4x4_100");
// COLUMNSxROWS:SQUARE is a chessboard and counts its inner corners ("9x6:25"), as OpenCV's calibration does.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace ocelli {

struct CalibrationBoard {
  int columns = 8;
  int rows = 5;
  double squareMillimetres = 32;
  double markerMillimetres = 24;       ///< of ChArUco: side of a marker, with its black border
  std::string dictionary = "4x4_100";  ///< empty: a plain chessboard

  bool hasMarkers() const { return !dictionary.empty(); }
  int squaresAcross() const { return hasMarkers() ? columns : columns + 1; }
  int squaresDown() const { return hasMarkers() ? rows : rows + 1; }
  bool operator==(const CalibrationBoard&) const = default;
};

/// The text of CalibrationBoard{}.
inline constexpr const char* kUsualBoard = "8x5:32:24:4x4_100";

/// Throws InputError where a text is no board: unknown dictionary, markers that do not fit or are more than it has.
CalibrationBoard boardFromText(const std::string& text);
std::string textOf(const CalibrationBoard& board);

/// The dictionaries by name, the smallest first.
std::vector<std::string> boardDictionaries();

/// A black square, millimetres from the top left corner of the board, y down.
struct BlackSquare {
  glm::dvec2 corner{0};
  double side = 0;
};

/// All that is black: squares, and cells of markers.
std::vector<BlackSquare> blackSquaresOf(const CalibrationBoard& board);

/// The same of tag `id` of AprilTag's family 36h11 with a side of `millimetres`, its black border included; from the
/// top left corner of that border. Throws InputError where the family has no such tag.
std::vector<BlackSquare> blackSquaresOfTag(int id, double millimetres);

}  // namespace ocelli
