#include "oc_core/feeds_calibration/corner_views.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "oc_core/feeds_calibration/opencv_board.h"

namespace ocelli {
namespace {

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
  for (size_t i = 0; i < corners.size(); ++i) {
    const cv::Point3f& at = openCv->chessboardCorners[static_cast<size_t>(cornerIds[i])];
    view.push_back({{at.x, at.y}, pixelFrom(corners[i])});
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
