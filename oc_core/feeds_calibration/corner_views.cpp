#include "oc_core/feeds_calibration/corner_views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "oc_core/feeds_calibration/corner_refinement.h"
#include "oc_core/feeds_calibration/opencv_board.h"

namespace ocelli {
namespace {

constexpr double kCrossReach = 0.7;   ///< of the distance between corners
constexpr double kMaxCrossWidth = 3;  ///< pixels
constexpr int kMinHalfWindow = 2;
constexpr int kRefineHalfWindow = 5;  ///< pixels, around a corner of a chessboard

cv::Mat grayOf(const Image<Rgb8>& image) {
  const cv::Mat colors(image.height(), image.width(), CV_8UC3, const_cast<Rgb8*>(image.data()));
  cv::Mat gray;
  cv::cvtColor(colors, gray, cv::COLOR_RGB2GRAY);
  return gray;
}

glm::dvec2 pixelFrom(const cv::Point2f& p) {
  return glm::dvec2(p.x, p.y) + 0.5;  // OpenCV measures from the middle of the first pixel
}

/// The least distance between neighbouring corners, pixels.
double cornerSpacing(const std::vector<cv::Point2f>& corners) {
  double least = HUGE_VAL;
  for (size_t i = 0; i < corners.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      least = std::min(least, cv::norm(corners[i] - corners[j]));
    }
  }
  return least;
}

/// Where the edges that meet at a corner go, by the homography from the board.
glm::dvec2 edgeDirection(const cv::Mat& pixelFromBoard, const cv::Point2f& board, const cv::Point2f& along) {
  std::vector<cv::Point2f> ends;
  cv::perspectiveTransform(std::vector<cv::Point2f>{board - along, board + along}, ends, pixelFromBoard);
  return glm::normalize(glm::dvec2(ends[1].x, ends[1].y) - glm::dvec2(ends[0].x, ends[0].y));
}

/// OpenCV's corners between markers are half a pixel further to the right and down than cornerSubPix() would have them
/// (4.6). Each is refined by that in a window that no marker reaches into, then along its edges.
void refineCorners(const cv::Mat& gray, const CalibrationBoard& board, const std::vector<cv::Point2f>& onBoard,
                   std::vector<cv::Point2f>& corners) {
  if (corners.size() < kMinViewCorners) {
    return;
  }
  const double spacing = cornerSpacing(corners);
  const double gap = (1 - board.markerMillimetres / board.squareMillimetres) / 2 * spacing;
  const int half = std::clamp(static_cast<int>(std::floor(gap)), kMinHalfWindow, kRefineHalfWindow);
  cv::cornerSubPix(gray, corners, {half, half}, {-1, -1}, {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 30, 1e-3});
  const cv::Mat pixelFromBoard = cv::findHomography(onBoard, corners);
  if (pixelFromBoard.empty()) {
    return;
  }
  Image<float> levels(gray.cols, gray.rows);
  gray.convertTo(cv::Mat(gray.rows, gray.cols, CV_32F, levels.data()), CV_32F);
  const auto side = static_cast<float>(board.squareMillimetres / 4);
  for (size_t i = 0; i < corners.size(); ++i) {
    CornerCross cross;
    cross.corner = {corners[i].x, corners[i].y};
    cross.alongRows = edgeDirection(pixelFromBoard, onBoard[i], {side, 0});
    cross.alongColumns = edgeDirection(pixelFromBoard, onBoard[i], {0, side});
    cross.reach = kCrossReach * spacing;
    cross.halfWidth = std::clamp(gap - 1, 1.5, kMaxCrossWidth);
    const glm::dvec2 refined = refinedCorner(levels, cross);
    corners[i] = {static_cast<float>(refined.x), static_cast<float>(refined.y)};
  }
}

BoardView charucoView(const cv::Mat& gray, const CalibrationBoard& board) {
  const auto openCv = openCvBoard(board);
  std::vector<std::vector<cv::Point2f>> markers;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, openCv->dictionary, markers, ids);
  BoardView view;
  if (ids.empty()) {
    return view;
  }
  std::vector<cv::Point2f> corners;
  std::vector<int> cornerIds;
  cv::aruco::interpolateCornersCharuco(markers, ids, gray, openCv, corners, cornerIds);
  std::vector<cv::Point2f> onBoard;
  for (const int id : cornerIds) {
    const cv::Point3f& at = openCv->chessboardCorners[static_cast<size_t>(id)];
    onBoard.emplace_back(at.x, at.y);
  }
  refineCorners(gray, board, onBoard, corners);
  for (size_t i = 0; i < corners.size(); ++i) {
    view.push_back({{onBoard[i].x, onBoard[i].y}, pixelFrom(corners[i])});
  }
  return view;
}

BoardView chessboardView(const cv::Mat& gray, const CalibrationBoard& board) {
  std::vector<cv::Point2f> corners;
  BoardView view;
  if (!cv::findChessboardCorners(gray, {board.columns, board.rows}, corners)) {
    return view;
  }
  cv::cornerSubPix(gray, corners, {kRefineHalfWindow, kRefineHalfWindow}, {-1, -1},
                   {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 30, 1e-3});
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto columns = static_cast<size_t>(board.columns);
    view.push_back({glm::dvec2(i % columns + 1, i / columns + 1) * board.squareMillimetres, pixelFrom(corners[i])});
  }
  return view;
}

}  // namespace

BoardView boardViewIn(const Image<Rgb8>& image, const CalibrationBoard& board) {
  const cv::Mat gray = grayOf(image);
  BoardView view = board.hasMarkers() ? charucoView(gray, board) : chessboardView(gray, board);
  std::set<int> columns;
  std::set<int> rows;
  for (const BoardCorner& corner : view) {
    columns.insert(static_cast<int>(corner.board.x));
    rows.insert(static_cast<int>(corner.board.y));
  }
  if (view.size() < kMinViewCorners || columns.size() < 2 || rows.size() < 2) {
    view.clear();
  }
  return view;
}

}  // namespace ocelli
