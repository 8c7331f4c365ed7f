#include "oc_core/feeds_calibration/pose_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <opencv2/calib3d.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kFlatness = 1e-3;  ///< of the size of a set of points
/// A mirrored table fits this many times better when it is turned around, and badly by this many pixels as it is.
constexpr double kMirroredRatio = 5;
constexpr double kMirroredPixels = 3;

/// Sizes of a set of points along its main axes, the largest first.
std::array<double, 3> spreadOf(const std::vector<WorldPoint>& points) {
  cv::Mat rows(static_cast<int>(points.size()), 3, CV_64F);
  for (int i = 0; i < rows.rows; ++i) {
    for (int c = 0; c < 3; ++c) {
      rows.at<double>(i, c) = points[static_cast<size_t>(i)].point[c];
    }
  }
  const cv::PCA axes(rows, cv::noArray(), cv::PCA::DATA_AS_ROW);
  std::array<double, 3> spread{};
  for (int c = 0; c < axes.eigenvalues.rows; ++c) {
    spread[static_cast<size_t>(c)] = std::sqrt(std::max(0.0, axes.eigenvalues.at<double>(c)));
  }
  return spread;
}

void checkPoints(const std::vector<WorldPoint>& points, size_t min, const std::string& where) {
  if (points.size() < min) {
    throw InputError(fmt::format("{} points of known place are seen, and {} are needed", points.size(), min), where,
                     "show it more tags, or give more corners");
  }
  const auto spread = spreadOf(points);
  if (!(spread[1] > kFlatness * spread[0])) {
    throw InputError("all points of known place are in one line", where, "add some beside it");
  }
}

/// Of a camera whose axes are x right, y down and z ahead.
FeedPose poseOf(const cv::Mat& turn, const cv::Mat& move, double distance) {
  cv::Mat r;
  cv::Rodrigues(turn, r);
  const auto axis = [&](int row) {
    return glm::dvec3(r.at<double>(row, 0), r.at<double>(row, 1), r.at<double>(row, 2));
  };
  FeedPose pose;
  pose.eye = -(axis(0) * move.at<double>(0) + axis(1) * move.at<double>(1) + axis(2) * move.at<double>(2));
  pose.target = pose.eye + axis(2) * distance;
  pose.up = -axis(1);
  return pose;
}

SolvedPose judged(const std::vector<WorldPoint>& points, const FeedLens& lens, const FeedPose& pose) {
  SolvedPose result{pose, lens, 0, 0, 0};
  double sum = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const auto pixel = pixelOfPoint(lens, pose, points[i].point);
    const double error = pixel ? glm::distance(*pixel, points[i].pixel) : HUGE_VAL;
    sum += error * error;
    if (error > result.maxPixels) {
      result.maxPixels = error;
      result.worst = i;
    }
  }
  result.rmsPixels = std::sqrt(sum / static_cast<double>(points.size()));
  return result;
}

/// The best of what SQPnP and, for points in a plane, its two-fold solution lead to; an infinite error where none does.
SolvedPose bestPose(const std::vector<WorldPoint>& points, const FeedLens& lens) {
  std::vector<cv::Point3d> world;
  std::vector<cv::Point2d> pixels;
  glm::dvec3 middle(0);
  for (const WorldPoint& point : points) {
    world.emplace_back(point.point.x, point.point.y, point.point.z);
    pixels.emplace_back(point.pixel.x - 0.5, point.pixel.y - 0.5);  // OpenCV's: from the middle of the first pixel
    middle += point.point / static_cast<double>(points.size());
  }
  const cv::Matx33d camera(lens.focal.x, 0, lens.center.x - 0.5, 0, lens.focal.y, lens.center.y - 0.5, 0, 0, 1);
  const std::vector<double> distortion{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
  SolvedPose best;
  best.rmsPixels = HUGE_VAL;
  for (const int method : {cv::SOLVEPNP_SQPNP, cv::SOLVEPNP_IPPE}) {
    const auto spread = spreadOf(points);
    if (method == cv::SOLVEPNP_IPPE && spread[2] > kFlatness * spread[0]) {
      continue;
    }
    std::vector<cv::Mat> turns;
    std::vector<cv::Mat> moves;
    try {
      cv::solvePnPGeneric(world, pixels, camera, distortion, turns, moves, false,
                          static_cast<cv::SolvePnPMethod>(method));
      for (size_t i = 0; i < turns.size(); ++i) {
        cv::solvePnPRefineLM(world, pixels, camera, distortion, turns[i], moves[i]);
        const FeedPose there = poseOf(turns[i], moves[i], 1);
        const double distance = std::max(1e-3, glm::dot(middle - there.eye, there.forward()));
        const SolvedPose each = judged(points, lens, poseOf(turns[i], moves[i], distance));
        if (each.rmsPixels < best.rmsPixels) {
          best = each;
        }
      }
    } catch (const cv::Exception&) {
      continue;  // this method finds nothing: another may
    }
  }
  return best;
}

void checkSolved(const SolvedPose& solved, std::vector<WorldPoint> points, const FeedLens& lens,
                 const std::string& where) {
  if (!(solved.rmsPixels < kMirroredPixels)) {
    for (WorldPoint& point : points) {
      point.point.x = -point.point.x;
    }
    if (bestPose(points, lens).rmsPixels * kMirroredRatio < solved.rmsPixels) {
      throw InputError("the table of points is mirrored: it fits with x turned around", where,
                       "y is up, and z is towards somebody who sees x to the right");
    }
  }
  if (!std::isfinite(solved.rmsPixels)) {
    throw InputError("no pose of the camera shows these points at these pixels", where,
                     "check the table of places and the lens");
  }
}

}  // namespace

std::optional<glm::dvec2> pixelOfPoint(const FeedLens& lens, const FeedPose& pose, const glm::dvec3& point) {
  const glm::dvec3 away = point - pose.eye;
  const double depth = glm::dot(away, pose.forward());
  if (!(depth > 0)) {
    return std::nullopt;
  }
  return pixelOf(lens, glm::dvec2(glm::dot(away, pose.right()), glm::dot(away, pose.down())) / depth);
}

SolvedPose solvePose(const std::vector<WorldPoint>& points, const FeedLens& lens, const std::string& where) {
  checkPoints(points, kMinPosePoints, where);
  const SolvedPose solved = bestPose(points, lens);
  checkSolved(solved, points, lens, where);
  return solved;
}

SolvedPose solvePoseAndFocal(const std::vector<WorldPoint>& points, int width, int height, const std::string& where) {
  checkPoints(points, kMinPosePointsWithoutLens, where);
  const auto spread = spreadOf(points);
  if (!(spread[2] > 10 * kFlatness * spread[0])) {
    throw InputError("all points of known place are in one plane, which leaves the focal length open", where,
                     "add points before or behind it, or calibrate the lens");
  }
  const auto at = [&](double logFocal) {
    FeedLens lens;
    lens.focal = glm::dvec2(std::exp(logFocal) * width);
    lens.center = {width / 2.0, height / 2.0};
    return bestPose(points, lens);
  };
  // The error by the focal length has one valley: steps over the lenses that there are, then the golden section.
  constexpr double kShortest = -1.6;  // 0.2 widths: 136 degrees
  constexpr double kLongest = 2.4;    // 11 widths: 5 degrees
  constexpr double kStep = 0.1;
  double best = kShortest;
  double least = HUGE_VAL;
  for (double x = kShortest; x <= kLongest; x += kStep) {
    const double error = at(x).rmsPixels;
    if (error < least) {
      least = error;
      best = x;
    }
  }
  double low = best - kStep;
  double high = best + kStep;
  constexpr double kGolden = 0.6180339887498949;
  constexpr double kLogRounding = 1e-8;
  while (high - low > kLogRounding) {
    const double a = high - kGolden * (high - low);
    const double b = low + kGolden * (high - low);
    const bool isShorterBetter = at(a).rmsPixels < at(b).rmsPixels;
    (isShorterBetter ? high : low) = isShorterBetter ? b : a;
  }
  const SolvedPose solved = at((low + high) / 2);
  checkSolved(solved, points, solved.lens, where);
  return solved;
}

}  // namespace ocelli
