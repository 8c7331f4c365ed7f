#include "oc_core/feeds_calibration/lens_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <opencv2/calib3d.hpp>
#include <set>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kMinViewChange = 0.03;  ///< of the width
/// Parallel views say nothing of the focal length (Zhang 2000, section 4.1: it needs two orientations).
constexpr double kMinTiltDegrees = 10;
constexpr double kFewTiltDegrees = 25;
constexpr double kFewCovered = 0.5;
constexpr double kMaxFocalSpread = 0.01;
constexpr double kOutlier = 4;  ///< times the median error of views, or of corners
constexpr int kCornerPasses = 3;
constexpr int kGridAcross = 8;
constexpr int kGridDown = 6;

struct Solution {
  cv::Mat camera;
  cv::Mat distortion;
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> moves;
  std::vector<double> viewErrors;
  double rms = 0;
  double focalDeviation = 0;
};

Solution solve(const std::vector<BoardView>& views, int width, int height) {
  std::vector<std::vector<cv::Point3f>> points;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const BoardView& view : views) {
    points.emplace_back();
    pixels.emplace_back();
    for (const BoardCorner& corner : view) {
      points.back().emplace_back(static_cast<float>(corner.board.x), static_cast<float>(corner.board.y), 0.0f);
      pixels.back().emplace_back(static_cast<float>(corner.pixel.x - 0.5), static_cast<float>(corner.pixel.y - 0.5));
    }
  }
  Solution result;
  cv::Mat deviations;
  cv::Mat viewDeviations;
  cv::Mat errors;
  result.rms = cv::calibrateCamera(points, pixels, {width, height}, result.camera, result.distortion, result.rotations,
                                   result.moves, deviations, viewDeviations, errors);
  result.focalDeviation = std::max(deviations.at<double>(0), deviations.at<double>(1));
  result.viewErrors.assign(errors.begin<double>(), errors.end<double>());
  return result;
}

double tiltBetween(const cv::Mat& a, const cv::Mat& b) {
  const auto normal = [](const cv::Mat& turn) {
    cv::Mat matrix;
    cv::Rodrigues(turn, matrix);
    return glm::dvec3(matrix.at<double>(0, 2), matrix.at<double>(1, 2), matrix.at<double>(2, 2));
  };
  return degreesFromRadians(std::acos(std::clamp(glm::dot(normal(a), normal(b)), -1.0, 1.0)));
}

double coveredShareOf(const std::vector<BoardView>& views, int width, int height) {
  std::set<std::pair<int, int>> cells;
  for (const BoardView& view : views) {
    for (const BoardCorner& corner : view) {
      cells.emplace(static_cast<int>(corner.pixel.x / width * kGridAcross),
                    static_cast<int>(corner.pixel.y / height * kGridDown));
    }
  }
  return static_cast<double>(cells.size()) / (kGridAcross * kGridDown);
}

/// Views whose error is far above the median have corners that were taken for others.
std::vector<BoardView> usualViews(const std::vector<BoardView>& views, const std::vector<double>& errors) {
  std::vector<double> sorted = errors;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double limit = kOutlier * sorted[sorted.size() / 2];
  std::vector<BoardView> usual;
  for (size_t i = 0; i < views.size(); ++i) {
    if (errors[i] <= limit) {
      usual.push_back(views[i]);
    }
  }
  return usual;
}

/// How far each corner of a view is from where a solution has it, pixels.
std::vector<double> cornerErrors(const BoardView& view, const Solution& solution, size_t index) {
  std::vector<cv::Point3d> points;
  for (const BoardCorner& corner : view) {
    points.emplace_back(corner.board.x, corner.board.y, 0);
  }
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, solution.rotations[index], solution.moves[index], solution.camera, solution.distortion,
                    pixels);
  std::vector<double> errors;
  for (size_t i = 0; i < view.size(); ++i) {
    errors.push_back(glm::distance(view[i].pixel - 0.5, glm::dvec2(pixels[i].x, pixels[i].y)));
  }
  return errors;
}

/// Without corners whose error is far above the median of all: something else was taken for them. A view that keeps
/// too few is left out, too.
std::vector<BoardView> usualCorners(const std::vector<BoardView>& views, const Solution& solution) {
  std::vector<std::vector<double>> errors;
  std::vector<double> sorted;
  for (size_t i = 0; i < views.size(); ++i) {
    errors.push_back(cornerErrors(views[i], solution, i));
    sorted.insert(sorted.end(), errors.back().begin(), errors.back().end());
  }
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double limit = kOutlier * sorted[sorted.size() / 2];
  std::vector<BoardView> usual;
  for (size_t i = 0; i < views.size(); ++i) {
    BoardView kept;
    for (size_t c = 0; c < views[i].size(); ++c) {
      if (errors[i][c] <= limit) {
        kept.push_back(views[i][c]);
      }
    }
    if (kept.size() >= kMinViewCorners) {
      usual.push_back(std::move(kept));
    }
  }
  return usual;
}

size_t countCorners(const std::vector<BoardView>& views) {
  size_t count = 0;
  for (const BoardView& view : views) {
    count += view.size();
  }
  return count;
}

std::vector<std::string> warningsOf(const LensCalibration& result) {
  std::vector<std::string> warnings;
  if (result.coveredShare < kFewCovered) {
    warnings.push_back(fmt::format("corners cover {:.0f} % of the image: move the board to its edges and corners, too",
                                   100 * result.coveredShare));
  }
  if (result.maxTiltDegrees < kFewTiltDegrees) {
    warnings.push_back(fmt::format("views differ by {:.0f} degrees at most: tilt the board by 30 degrees and more",
                                   result.maxTiltDegrees));
  }
  if (result.focalSpread > kMaxFocalSpread) {
    warnings.push_back(fmt::format("the focal length is uncertain by {:.1f} %: add views that are near and tilted",
                                   100 * result.focalSpread));
  }
  return warnings;
}

}  // namespace

std::vector<BoardView> differentViews(const std::vector<BoardView>& views, int width) {
  const auto change = [](const BoardView& a, const BoardView& b) {
    double sum = 0;
    size_t count = 0;
    for (const BoardCorner& corner : a) {
      const auto same = std::ranges::find(b, corner.board, &BoardCorner::board);
      if (same != b.end()) {
        sum += glm::distance(corner.pixel, same->pixel);
        ++count;
      }
    }
    return count == 0 ? HUGE_VAL : sum / static_cast<double>(count);
  };
  std::vector<BoardView> different;
  for (const BoardView& view : views) {
    if (std::ranges::all_of(different, [&](const BoardView& o) { return change(view, o) >= kMinViewChange * width; })) {
      different.push_back(view);
    }
  }
  if (different.size() <= kMaxLensViews) {
    return different;
  }
  std::vector<BoardView> thinned;
  for (size_t i = 0; i < kMaxLensViews; ++i) {
    thinned.push_back(different[i * different.size() / kMaxLensViews]);
  }
  return thinned;
}

LensCalibration calibrateLens(const std::vector<BoardView>& views, int width, int height, const std::string& where) {
  const auto checkCount = [&](size_t count) {
    if (count < kMinLensViews) {
      throw InputError(fmt::format("{} views show the board, and a lens takes {}", count, kMinLensViews), where,
                       "take 20 views of it, tilted, near and far, also at the edges of the image; check that --board "
                       "is what is printed below it");
    }
  };
  checkCount(views.size());
  try {
    Solution solution = solve(views, width, height);
    std::vector<BoardView> usual = usualViews(views, solution.viewErrors);
    if (usual.size() < views.size()) {
      checkCount(usual.size());
      solution = solve(usual, width, height);
    }
    // Wrong corners pull a solution to themselves: without the worst, others show.
    for (int pass = 0; pass < kCornerPasses; ++pass) {
      std::vector<BoardView> kept = usualCorners(usual, solution);
      if (countCorners(kept) == countCorners(usual)) {
        break;
      }
      checkCount(kept.size());
      usual = std::move(kept);
      solution = solve(usual, width, height);
    }
    LensCalibration result;
    result.width = width;
    result.height = height;
    const auto& k = solution.camera;
    const auto& d = solution.distortion;
    result.lens = {{k.at<double>(0, 0), k.at<double>(1, 1)},
                   {k.at<double>(0, 2) + 0.5, k.at<double>(1, 2) + 0.5},
                   d.at<double>(0),
                   d.at<double>(1),
                   d.at<double>(2),
                   d.at<double>(3),
                   d.at<double>(4)};
    result.rmsPixels = solution.rms;
    result.focalSpread = solution.focalDeviation / result.lens.focal.x;
    result.views = usual.size();
    result.viewsLeftOut = views.size() - usual.size();
    result.coveredShare = coveredShareOf(usual, width, height);
    for (size_t i = 0; i < solution.rotations.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        result.maxTiltDegrees =
            std::max(result.maxTiltDegrees, tiltBetween(solution.rotations[i], solution.rotations[j]));
      }
    }
    if (result.maxTiltDegrees < kMinTiltDegrees) {
      throw InputError(fmt::format("all views are from one angle, to within {:.1f} degrees", result.maxTiltDegrees),
                       where, "tilt the board by 30 degrees and more, to all sides");
    }
    if (!std::isfinite(result.rmsPixels) || !pixelOf(result.lens, {0, 0})) {
      throw InputError("what comes out of the views is no lens", where, "take other views, tilted and all in focus");
    }
    result.warnings = warningsOf(result);
    return result;
  } catch (const cv::Exception& error) {
    throw InputError("the views do not determine a lens (" + error.err + ")", where,
                     "take other views, tilted, near and far");
  }
}

}  // namespace ocelli
