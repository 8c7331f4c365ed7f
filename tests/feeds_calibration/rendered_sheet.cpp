#include "tests/feeds_calibration/rendered_sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "oc_core/feeds_calibration/pose_solver.h"

namespace ocelli::test {
namespace {

constexpr int kSide = 3;
constexpr double kBlack = 30;
constexpr double kWhite = 220;
constexpr double kWall = 120;

/// The level at the place where a ray meets the sheet; nothing beside it.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  double level = kWall;
};

void meet(const RenderedSheet& sheet, const glm::dvec3& eye, const glm::dvec3& ray, Hit& hit) {
  const glm::dvec3 normal = glm::cross(sheet.right, sheet.down);
  const double t = glm::dot(normal, sheet.corner - eye) / glm::dot(normal, ray);
  if (!(t > 0) || t >= hit.distance) {
    return;
  }
  const glm::dvec3 at = eye + ray * t - sheet.corner;
  const double x = glm::dot(at, sheet.right);
  const double y = glm::dot(at, sheet.down);
  const double m = sheet.marginMetres;
  if (x < -m || y < -m || x > sheet.across * sheet.cellMetres + m || y > sheet.below * sheet.cellMetres + m) {
    return;
  }
  const int column = static_cast<int>(std::floor(x / sheet.cellMetres));
  const int row = static_cast<int>(std::floor(y / sheet.cellMetres));
  const bool isInside = column >= 0 && row >= 0 && column < sheet.across && row < sheet.below;
  hit = {t, isInside && sheet.black[static_cast<size_t>(row * sheet.across + column)] ? kBlack : kWhite};
}

void blurRows(std::vector<double>& levels, int width, int height, double sigma, bool isAcross) {
  const int reach = static_cast<int>(std::ceil(4 * sigma));
  std::vector<double> blurred(levels.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      double weights = 0;
      for (int d = -reach; d <= reach; ++d) {
        const int px = isAcross ? std::clamp(x + d, 0, width - 1) : x;
        const int py = isAcross ? y : std::clamp(y + d, 0, height - 1);
        const double w = std::exp(-d * d / (2 * sigma * sigma));
        sum += w * levels[static_cast<size_t>(py * width + px)];
        weights += w;
      }
      blurred[static_cast<size_t>(y * width + x)] = sum / weights;
    }
  }
  levels = std::move(blurred);
}

}  // namespace

RenderedSheet sheetOf(const std::vector<BlackSquare>& squares, double cellMillimetres) {
  RenderedSheet sheet;
  const auto cells = [&](double length) { return static_cast<int>(std::lround(length / cellMillimetres)); };
  for (const BlackSquare& square : squares) {
    sheet.across = std::max(sheet.across, cells(square.corner.x + square.side));
    sheet.below = std::max(sheet.below, cells(square.corner.y + square.side));
  }
  sheet.cellMetres = cellMillimetres / 1000;
  sheet.black.assign(static_cast<size_t>(sheet.across * sheet.below), false);
  for (const BlackSquare& square : squares) {
    for (int y = 0; y < cells(square.side); ++y) {
      for (int x = 0; x < cells(square.side); ++x) {
        sheet.black[static_cast<size_t>((cells(square.corner.y) + y) * sheet.across + cells(square.corner.x) + x)] =
            true;
      }
    }
  }
  return sheet;
}

SheetCamera::SheetCamera(const FeedLens& lens, int width, int height) : lens_(lens), width_(width), height_(height) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int i = 0; i < kSide * kSide; ++i) {
        const auto direction = directionOf(lens, {x + (i % kSide + 0.5) / kSide, y + (i / kSide + 0.5) / kSide});
        if (!direction) {
          throw std::runtime_error("the lens does not reach all of its image");
        }
        directions_.push_back(*direction);
      }
    }
  }
}

Image<Rgb8> SheetCamera::picture(const FeedPose& pose, const std::vector<RenderedSheet>& sheets,
                                 const PictureNoise& noise, RandomNumbers& random) const {
  const glm::dvec3 forward = pose.forward();
  const glm::dvec3 right = pose.right();
  const glm::dvec3 down = pose.down();
  std::vector<double> levels(static_cast<size_t>(width_ * height_));
  for (size_t i = 0; i < levels.size(); ++i) {
    for (size_t s = 0; s < kSide * kSide; ++s) {
      const glm::dvec2& d = directions_[i * kSide * kSide + s];
      Hit hit;
      for (const RenderedSheet& sheet : sheets) {
        meet(sheet, pose.eye, forward + right * d.x + down * d.y, hit);
      }
      levels[i] += hit.level / (kSide * kSide);
    }
  }
  if (noise.blurPixels > 0) {
    blurRows(levels, width_, height_, noise.blurPixels, true);
    blurRows(levels, width_, height_, noise.blurPixels, false);
  }
  Image<Rgb8> image(width_, height_);
  for (size_t i = 0; i < levels.size(); ++i) {
    const double level = levels[i] + noise.noiseLevels * random.normal();
    image[i] = Rgb8(static_cast<uint8_t>(std::clamp(std::lround(level), 0L, 255L)));
  }
  return image;
}

}  // namespace ocelli::test
