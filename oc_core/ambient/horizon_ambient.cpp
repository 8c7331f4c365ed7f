#include "oc_core/ambient/horizon_ambient.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "oc_core/ambient/horizon_slice.h"
#include "oc_core/ambient/surface_frame.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// A point in the image of the frustum that holds it.
struct SeenPoint {
  HorizonPoint point;
  glm::dvec2 place{0};   ///< pixels
  glm::dvec3 across{0};  ///< with `along`, unit vectors across the ray
  glm::dvec3 along{0};
  glm::dmat2 pixelsPerWorld{0};  ///< how the place moves with the point along these two

  SeenPoint(const AmbientPoint& ambient, const GraphCamera::Frustum& frustum) {
    point.position = glm::dvec3(ambient.position);
    point.normal = glm::dvec3(ambient.normal);
    point.towards = glm::normalize(frustum.viewpoint - point.position);
    const SurfaceFrame frame{glm::vec3(point.towards)};
    across = glm::normalize(glm::cross(glm::dvec3(frame.along), point.towards));
    along = glm::cross(point.towards, across);
    const glm::dvec4 image = frustum.pixelFromWorld * glm::dvec4(point.position, 1);
    place = glm::dvec2(image) / image.w;
    const auto moved = [&](const glm::dvec3& direction) {
      const glm::dvec4 change = frustum.pixelFromWorld * glm::dvec4(direction, 0);
      return (glm::dvec2(change) - place * change.w) / image.w;
    };
    pixelsPerWorld = glm::dmat2(moved(across), moved(along));
  }
  glm::dvec3 side(double azimuth) const { return across * std::cos(azimuth) + along * std::sin(azimuth); }
};

std::optional<SeenPoint> seenPoint(const AmbientPoint& point, const GraphCamera& camera) {
  const int frustum = camera.frustumOf(glm::dvec3(point.position));
  if (frustum < 0) {
    return std::nullopt;
  }
  const SeenPoint seen(point, camera.frusta()[static_cast<size_t>(frustum)]);
  const bool within =
      seen.place.x >= 0 && seen.place.y >= 0 && seen.place.x < camera.width() && seen.place.y < camera.height();
  return within ? std::optional(seen) : std::nullopt;
}

/// `hiddenAt(point, seen)` for each that the image holds.
template <class HiddenAt>
HorizonLight lightOf(std::span<const AmbientPoint> points, const GraphCamera& camera, const AmbientOptions& options,
                     const HiddenAt& hiddenAt) {
  validate(options);
  HorizonLight result{std::vector<float>(points.size(), 1)};
  std::atomic<size_t> notHeld = 0;
  parallelFor(points.size(), 256, [&](size_t begin, size_t end) {
    size_t missing = 0;
    for (size_t i = begin; i < end; ++i) {
      const std::optional<SeenPoint> seen = seenPoint(points[i], camera);
      missing += seen ? 0 : 1;
      if (seen && options.radius > 0) {
        result.light[i] = static_cast<float>(std::clamp(1 - hiddenAt(points[i], *seen), 0.0, 1.0));
      }
    }
    notHeld += missing;
  });
  result.notHeld = notHeld;
  return result;
}

void checkCount(int count, const char* what) {
  if (count < 1 || count > 4096) {
    throw InputError(std::string("ambient light by horizons takes 1 to 4096 ") + what,
                     std::to_string(count) + " " + what, "choose another number");
  }
}

constexpr double kTurn = 2 * std::numbers::pi;

double walkedHidden(const AmbientPoint& point, const SeenPoint& seen, const HorizonImage& image,
                    const AmbientOptions& options, const HorizonWalk& walk) {
  const double first = static_cast<double>(unitHash(point.pixel, walk.seed));
  const glm::ivec2 own(seen.place);
  double hidden = 0;
  for (int k = 0; k < walk.directions; ++k) {
    const double azimuth = kTurn * (k + first) / walk.directions;
    const glm::dvec2 perWorld = seen.pixelsPerWorld * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
    const double pixels = glm::length(perWorld);
    if (!(pixels > 0) || !std::isfinite(pixels)) {
      continue;
    }
    HorizonSlice slice(seen.point, seen.side(azimuth), options);
    const double end = options.radius * pixels;
    double reached = 0;
    for (int step = 1; step <= walk.steps; ++step) {
      const double share = static_cast<double>(step) / walk.steps;
      reached = std::max(reached + 1, end * share * share);
      const glm::dvec2 place = seen.place + perWorld * (reached / pixels);
      const bool within =
          place.x >= 0 && place.y >= 0 && place.x < image.camera().width() && place.y < image.camera().height();
      if (!within || reached > end + 1) {
        break;
      }
      const glm::ivec2 pixel(place);
      if (image.holds(pixel.x, pixel.y) && pixel != own) {
        slice.add(glm::dvec3(image.position(pixel.x, pixel.y)));
      }
    }
    hidden += slice.hidden() * kTurn / walk.directions;
  }
  return hidden;
}

double slowlyHidden(const SeenPoint& seen, const HorizonImage& image, const AmbientOptions& options, int directions) {
  struct Sample {
    double pixels;
    glm::dvec3 position;
  };
  std::vector<std::vector<Sample>> sectors(static_cast<size_t>(directions));
  const glm::dmat2 worldFromPixels = glm::inverse(seen.pixelsPerWorld);
  const glm::ivec2 own(seen.place);
  for (int y = 0; y < image.camera().height(); ++y) {
    for (int x = 0; x < image.camera().width(); ++x) {
      const glm::dvec3 position(image.position(x, y));
      if (!image.holds(x, y) || own == glm::ivec2(x, y) ||
          glm::distance(position, seen.point.position) >= options.radius) {
        continue;
      }
      const glm::dvec2 offset = glm::dvec2(x + 0.5, y + 0.5) - seen.place;
      const glm::dvec2 aside = worldFromPixels * offset;
      const double azimuth = std::atan2(aside.y, aside.x);
      const auto sector = static_cast<size_t>(std::floor((azimuth / kTurn + 1) * directions));
      sectors[sector % sectors.size()].push_back({glm::length(offset), position});
    }
  }
  double hidden = 0;
  for (size_t k = 0; k < sectors.size(); ++k) {
    std::stable_sort(sectors[k].begin(), sectors[k].end(),
                     [](const Sample& a, const Sample& b) { return a.pixels < b.pixels; });
    HorizonSlice slice(seen.point, seen.side(kTurn * (static_cast<double>(k) + 0.5) / directions), options);
    for (const Sample& sample : sectors[k]) {
      slice.add(sample.position);
    }
    hidden += slice.hidden() * kTurn / directions;
  }
  return hidden;
}

}  // namespace

HorizonImage::HorizonImage(const GraphCamera& camera, const FragmentImage& fragments, const Mesh& mesh)
    : camera_(camera), held_(fragments.width(), fragments.height()), positions_(fragments.width(), fragments.height()) {
  OC_CHECK(fragments.width() == camera.width() && fragments.height() == camera.height(), "an image of another size");
  for (size_t i = 0; i < fragments.size(); ++i) {
    if (fragments[i].covered()) {
      held_[i] = 1;
      positions_[i] = positionOf(fragments[i], mesh);
    }
  }
}

bool isHeld(const AmbientPoint& point, const GraphCamera& camera) {
  return seenPoint(point, camera).has_value();
}

HorizonLight ambientByHorizon(std::span<const AmbientPoint> points, const HorizonImage& image,
                              const AmbientOptions& options, const HorizonWalk& walk) {
  checkCount(walk.directions, "directions");
  checkCount(walk.steps, "steps");
  return lightOf(points, image.camera(), options, [&](const AmbientPoint& point, const SeenPoint& seen) {
    return walkedHidden(point, seen, image, options, walk);
  });
}

HorizonLight ambientByHorizonSlowly(std::span<const AmbientPoint> points, const HorizonImage& image,
                                    const AmbientOptions& options, int directions) {
  checkCount(directions, "directions");
  return lightOf(points, image.camera(), options, [&](const AmbientPoint&, const SeenPoint& seen) {
    return slowlyHidden(seen, image, options, directions);
  });
}

}  // namespace ocelli
