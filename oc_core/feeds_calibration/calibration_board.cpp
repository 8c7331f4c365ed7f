#include "oc_core/feeds_calibration/calibration_board.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/feeds_calibration/opencv_board.h"

namespace ocelli {
namespace {

constexpr int kMaxSquares = 64;  ///< a side
constexpr double kMaxMillimetres = 5000;

struct DictionaryRow {
  const char* name;
  int openCv;
  int markers;
};

constexpr std::array kDictionaries{
    DictionaryRow{"4x4_50", cv::aruco::DICT_4X4_50, 50},    DictionaryRow{"4x4_100", cv::aruco::DICT_4X4_100, 100},
    DictionaryRow{"4x4_250", cv::aruco::DICT_4X4_250, 250}, DictionaryRow{"4x4_1000", cv::aruco::DICT_4X4_1000, 1000},
    DictionaryRow{"5x5_50", cv::aruco::DICT_5X5_50, 50},    DictionaryRow{"5x5_100", cv::aruco::DICT_5X5_100, 100},
    DictionaryRow{"5x5_250", cv::aruco::DICT_5X5_250, 250}, DictionaryRow{"5x5_1000", cv::aruco::DICT_5X5_1000, 1000},
    DictionaryRow{"6x6_250", cv::aruco::DICT_6X6_250, 250}, DictionaryRow{"6x6_1000", cv::aruco::DICT_6X6_1000, 1000},
};

[[noreturn]] void failBoard(const std::string& what, const std::string& text) {
  throw InputError(what, "board \"" + text + "\"",
                   "write COLUMNSxROWS:SQUARE:MARKER:DICTIONARY in millimetres, as 8x5:32:24:4x4_100, or "
                   "COLUMNSxROWS:SQUARE for a chessboard of so many inner corners");
}

std::vector<std::string> splitAt(const std::string& text, char mark) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == mark) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double lengthFrom(const std::string& part, const char* what, const std::string& text) {
  const auto value = numberFromText<double>(part);
  if (!value || !(*value >= 0.1) || !(*value <= kMaxMillimetres)) {
    failBoard(fmt::format("the {} is \"{}\", which is no length from 0.1 to {} mm", what, part, kMaxMillimetres), text);
  }
  return *value;
}

const DictionaryRow* dictionaryOf(const std::string& name) {
  const auto row = std::ranges::find(kDictionaries, name, &DictionaryRow::name);
  return row == kDictionaries.end() ? nullptr : &*row;
}

}  // namespace

CalibrationBoard boardFromText(const std::string& text) {
  const std::vector<std::string> parts = splitAt(text, ':');
  const std::vector<std::string> counts = splitAt(parts[0], 'x');
  if ((parts.size() != 2 && parts.size() != 4) || counts.size() != 2) {
    failBoard("this is no board", text);
  }
  const auto columns = numberFromText<int>(counts[0]);
  const auto rows = numberFromText<int>(counts[1]);
  if (!columns || !rows || *columns < 3 || *rows < 3 || *columns > kMaxSquares || *rows > kMaxSquares) {
    failBoard(fmt::format("\"{}\" is no number of columns and rows from 3 to {}", parts[0], kMaxSquares), text);
  }
  CalibrationBoard board{*columns, *rows, lengthFrom(parts[1], "square", text), 0, ""};
  if (parts.size() == 2) {
    return board;
  }
  board.markerMillimetres = lengthFrom(parts[2], "marker", text);
  board.dictionary = parts[3];
  const DictionaryRow* row = dictionaryOf(board.dictionary);
  if (row == nullptr) {
    failBoard(fmt::format("the dictionary \"{}\" is unknown; there are {}", board.dictionary,
                          fmt::join(boardDictionaries(), ", ")),
              text);
  }
  if (!(board.markerMillimetres < 0.95 * board.squareMillimetres)) {
    failBoard("a marker must be smaller than 0.95 of a square", text);
  }
  if (board.columns * board.rows / 2 > row->markers) {
    failBoard(fmt::format("it has {} markers, and the dictionary {}", board.columns * board.rows / 2, row->markers),
              text);
  }
  return board;
}

std::string textOf(const CalibrationBoard& board) {
  const std::string chess = fmt::format("{}x{}:{}", board.columns, board.rows, board.squareMillimetres);
  return board.hasMarkers() ? fmt::format("{}:{}:{}", chess, board.markerMillimetres, board.dictionary) : chess;
}

std::vector<std::string> boardDictionaries() {
  std::vector<std::string> names;
  for (const DictionaryRow& row : kDictionaries) {
    names.emplace_back(row.name);
  }
  return names;
}

cv::Ptr<cv::aruco::CharucoBoard> openCvBoard(const CalibrationBoard& board) {
  return cv::aruco::CharucoBoard::create(board.columns, board.rows, static_cast<float>(board.squareMillimetres),
                                         static_cast<float>(board.markerMillimetres),
                                         cv::aruco::getPredefinedDictionary(dictionaryOf(board.dictionary)->openCv));
}

std::vector<BlackSquare> blackSquaresOf(const CalibrationBoard& board) {
  const double side = board.squareMillimetres;
  std::vector<BlackSquare> black;
  std::set<std::pair<int, int>> white;
  if (board.hasMarkers()) {
    // Where OpenCV expects its markers: all other squares are black.
    const auto openCv = openCvBoard(board);
    for (size_t i = 0; i < openCv->ids.size(); ++i) {
      const cv::Point3f& first = openCv->objPoints[i][0];  // top left
      const glm::dvec2 corner(first.x, first.y);
      white.emplace(static_cast<int>(corner.x / side), static_cast<int>(corner.y / side));
      const int cells = openCv->dictionary->markerSize + 2;
      cv::Mat bits;
      openCv->dictionary->drawMarker(openCv->ids[i], cells, bits, 1);
      const double cell = board.markerMillimetres / cells;
      for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
          if (bits.at<uint8_t>(y, x) == 0) {
            black.push_back({corner + glm::dvec2(x, y) * cell, cell});
          }
        }
      }
    }
  }
  for (int y = 0; y < board.squaresDown(); ++y) {
    for (int x = 0; x < board.squaresAcross(); ++x) {
      if (board.hasMarkers() ? !white.contains({x, y}) : (x + y) % 2 == 0) {
        black.push_back({glm::dvec2(x, y) * side, side});
      }
    }
  }
  return black;
}

std::vector<BlackSquare> blackSquaresOfTag(int id, double millimetres) {
  const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family(tag36h11_create(), tag36h11_destroy);
  if (id < 0 || id >= static_cast<int>(family->ncodes)) {
    throw InputError(fmt::format("there is no tag {}", id), "AprilTag's family 36h11",
                     fmt::format("take ids from 0 to {}", family->ncodes - 1));
  }
  // Bits of a code, the highest first, are white; all else within the border is black.
  std::set<std::pair<uint32_t, uint32_t>> white;
  for (uint32_t bit = 0; bit < family->nbits; ++bit) {
    if ((family->codes[id] >> (family->nbits - 1 - bit) & 1U) != 0) {
      white.emplace(family->bit_x[bit], family->bit_y[bit]);
    }
  }
  const auto cells = static_cast<uint32_t>(family->width_at_border);
  const double cell = millimetres / cells;
  std::vector<BlackSquare> black;
  for (uint32_t y = 0; y < cells; ++y) {
    for (uint32_t x = 0; x < cells; ++x) {
      if (!white.contains({x, y})) {
        black.push_back({glm::dvec2(x, y) * cell, cell});
      }
    }
  }
  return black;
}

}  // namespace ocelli
