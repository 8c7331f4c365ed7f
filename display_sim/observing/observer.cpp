#include "display_sim/observing/observer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/observing/ambient_light.h"
#include "display_sim/observing/exposure.h"
#include "display_sim/observing/eye_perspective.h"
#include "display_sim/observing/light_splat.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr int kMaxPixels = 1 << 26;

constexpr double kMinBoxPixels = 1e-3;

/// The default field of view is larger from any distance that a profile's viewer may have.
constexpr double kMinFovDegrees = 1e-6;

double exposureSeconds(const ObserverOptions& options, const DisplayProfile& profile) {
  return options.exposureSeconds > 0 ? options.exposureSeconds : 1 / profile.refreshHertz();
}

/// A short arc around the axis, in eye coordinates: unit vectors outwards and along the sweep at its middle, and where
/// the axis has moved to.
struct Arc {
  glm::dvec3 outward;
  glm::dvec3 along;
  glm::dvec3 moved;
  double radians;
};

/// An exposed arc cut into 1, 2, 4, ... equal parts, so that a voxel far from the axis can be drawn as several.
class ArcParts {
 public:
  static constexpr int kLevels = 6;

  ArcParts(const ExposedArc& arc, const EyePerspective& eye, const Wobble& wobble) {
    for (int level = 0; level < kLevels; ++level) {
      const int parts = 1 << level;
      const double radians = (arc.toRadians - arc.fromRadians) / parts;
      for (int k = 0; k < parts; ++k) {
        const double angle = arc.fromRadians + (k + 0.5) * radians;
        const double swing = arc.swingRadians + wobble.frequency * angle;
        levels_[static_cast<size_t>(level)].push_back({eye.direction({std::cos(angle), 0, std::sin(angle)}),
                                                       eye.direction({-std::sin(angle), 0, std::cos(angle)}),
                                                       eye.direction(wobble.displacement(swing)), radians});
      }
    }
  }

  /// Parts no longer than a pixel, if there are so many, for an arc of so many pixels.
  const std::vector<Arc>& forLength(double pixels) const {
    const auto parts =
        static_cast<unsigned>(std::clamp(std::ceil(pixels), 1.0, static_cast<double>(1 << (kLevels - 1))));
    return levels_[static_cast<size_t>(std::bit_width(parts - 1))];
  }

 private:
  std::array<std::vector<Arc>, kLevels> levels_;
};

class Collector {
 public:
  Collector(const Volume& volume, const ObserverOptions& options)
      : volume_(volume),
        options_(options),
        sweep_(volume.profile()),
        eye_(options),
        focus_(options.lens.focusRadii > 0 ? options.lens.focusRadii : eye_.distance),
        up_(eye_.direction({0, 1, 0})),
        axis_(eye_.point({0, 0, 0})) {
    const double refreshes = std::round(exposureSeconds(options, volume.profile()) * volume.profile().refreshHertz());
    scale_ = static_cast<double>(std::bit_ceil(static_cast<uint64_t>(std::max(refreshes, 1.0))));
  }

  /// By how much the light that it adds is scaled down, so that that of a voxel does not grow with the exposure: a
  /// power of two.
  double scale() const { return scale_; }

  void add(const ExposedArc& arc, LightImage& image) const {
    const ArcParts parts(arc, eye_, options_.wobble);
    const double radians = arc.toRadians - arc.fromRadians;
    const ArcLight light = arcLight(arc, options_.emission, sweep_.stepRadians());
    const glm::dvec3 channels(arc.channels & 1u, arc.channels >> 1 & 1u, arc.channels >> 2 & 1u);
    forEachLevel(volume_, arc.slice, [&](int column, int row, const Rgb8& levels) {
      const glm::dvec3 color = channels * glm::dvec3(levels) / static_cast<double>(volume_.fullLevel());
      const double r = sweep_.columnRadius(column);
      if (std::abs(r) < options_.deadZoneRadii || color == glm::dvec3(0)) {
        return;
      }
      const glm::dvec3 onAxis = axis_ + up_ * sweep_.rowCenterY(row);
      const double pixelsPerRadius = eye_.pixelsPerTangent / std::max(onAxis.z - std::abs(r), kNearestToEye);
      const std::vector<Arc>& arcs = parts.forLength(std::abs(r) * radians * pixelsPerRadius);
      const int columnParts = columnPartsFor(sweep_.columnWidth() * pixelsPerRadius);
      const double width = sweep_.columnWidth() / columnParts;
      const double share = 1 / (static_cast<double>(arcs.size()) * columnParts * scale_);
      const ArcLight partLight{light.ahead * share, light.behind * share};
      for (const Arc& part : arcs) {
        for (int k = 0; k < columnParts; ++k) {
          addPart(part, onAxis, r + (k - (columnParts - 1) / 2.0) * width, width, partLight, color, image);
        }
      }
    });
  }

 private:
  static int columnPartsFor(double pixels) { return static_cast<int>(std::clamp(pixels + 0.5, 1.0, 16.0)); }

  /// A part of a cell, about a pixel large where the number of parts allows that, is drawn as a box that has the same
  /// spread (variance) in both directions of the image as the part's image, whose sides run outwards, up and along the
  /// sweep. It is that image itself where they lie along rows and columns.
  /// A lens that blurs more than that makes it a disc, of which the same holds.
  void addPart(const Arc& arc, const glm::dvec3& onAxis, double r, double width, const ArcLight& light,
               const glm::dvec3& color, LightImage& image) const {
    const glm::dvec3 p = onAxis + arc.moved + arc.outward * r;
    if (p.z < kNearestToEye) {
      return;
    }
    const glm::dvec2 at = eye_.pixel(p);
    const double scale = eye_.pixelsPerTangent / p.z;
    const glm::dvec2 slope(p.x / p.z, p.y / p.z);
    const auto projected = [&](const glm::dvec3& side, double length) {
      return glm::dvec2(side.x - slope.x * side.z, side.y - slope.y * side.z) * (length * scale);
    };
    const glm::dvec2 outward = projected(arc.outward, width);
    const glm::dvec2 up = projected(up_, sweep_.rowHeight());
    const glm::dvec2 along = projected(arc.along, std::abs(r) * arc.radians);
    const glm::dvec2 squares = outward * outward + up * up + along * along;
    const double nearer = eye_.distance / p.z;
    const double sent = lightTowardsEye(light, options_.emission.model, arc.along, p) * nearer * nearer;
    const double blur = circleOfConfusion(options_.lens.apertureRadii, focus_, p.z, eye_.pixelsPerTangent);
    // The variance of a box is side^2 / 12, that of a disc diameter^2 / 16.
    if (blur * blur > std::max(squares.x, squares.y)) {
      const glm::dvec2 disc = glm::sqrt(squares * (16.0 / 12) + blur * blur);
      image.addEllipse(at.x, at.y, disc.x, disc.y, sent, color);
    } else {
      // Seen along its plane a part at the axis has no extent in one direction.
      const glm::dvec2 box = glm::max(glm::sqrt(squares + blur * blur * (12.0 / 16)), kMinBoxPixels);
      image.addBox(at.x, at.y, box.x, box.y, sent, color);
    }
  }

  const Volume& volume_;
  const ObserverOptions& options_;
  SweepGeometry sweep_;
  EyePerspective eye_;
  double focus_;
  glm::dvec3 up_;
  glm::dvec3 axis_;
  double scale_ = 1;
};

/// More passes than this would take too long to sort by the phase of the wobble.
constexpr double kMaxWobblingRefreshes = 100000;

}  // namespace

bool isInDisplay(const glm::vec3& eye, const DisplayProfile& profile) {
  const bool within = std::hypot(eye.x, eye.z) <= 1 && std::abs(eye.y) <= profile.halfHeightRadii;
  return within || glm::length(eye) <= 1.001f;
}

void checkObserverOptions(const ObserverOptions& options, const DisplayProfile& profile) {
  const auto fail = [](const std::string& what, const std::string& next) { throw InputError(what, "observer", next); };
  const glm::vec3& eye = options.eye;
  if (!std::isfinite(eye.x) || !std::isfinite(eye.y) || !std::isfinite(eye.z)) {
    fail("the eye has a coordinate that is not a finite number", "give three finite numbers");
  }
  if (isInDisplay(eye, profile)) {
    fail("the eye is inside of the display", "move it more than one display radius away from the centre");
  }
  if (options.width < 1 || options.height < 1 || options.width > kMaxPixels / options.height) {
    fail("the image must have at least one and at most 2^26 pixels", "change its size");
  }
  const double fov = options.fovVerticalDegrees;
  if (fov != 0 && !(fov >= kMinFovDegrees && fov < 179)) {
    fail("the vertical field of view must lie between 0.000001 and 179 degrees",
         "change it, or give 0 to just hold the display");
  }
  if (!(options.exposureSeconds >= 0 && options.exposureSeconds <= 3600)) {
    fail("the exposure must lie between 0 and 3600 seconds", "change it");
  }
  if (!std::isfinite(options.missingSectorStartDegrees) || std::abs(options.missingSectorStartDegrees) > 360) {
    fail("the start of the missing sector must lie between -360 and 360 degrees", "change it");
  }
  if (options.startDegrees && !(std::abs(*options.startDegrees) <= 360)) {
    fail("the exposure's start must lie between -360 and 360 degrees", "change it");
  }
  if (!(options.emission.transmission >= 0 && options.emission.transmission <= 1000)) {
    fail("the light of the screen's back must lie between 0 and 1000 times that of its front", "change it");
  }
  checkWobble(options.wobble);
  if (options.wobble.amplitudeRadii > 0 &&
      exposureSeconds(options, profile) * profile.refreshHertz() > kMaxWobblingRefreshes) {
    fail("an exposure of a display that wobbles must hold at most 100000 refreshes", "shorten it");
  }
  if (!(options.lens.apertureRadii >= 0 && options.lens.apertureRadii <= 1)) {
    fail("the lens must be at most as wide as the display's radius", "give a smaller aperture");
  }
  if (!(options.lens.focusRadii == 0 || (options.lens.focusRadii > 0.01 && options.lens.focusRadii <= 1e6))) {
    fail("the distance in focus must lie between 0.01 and a million radii of the display", "change it");
  }
  if (!(options.deadZoneRadii >= 0 && options.deadZoneRadii < 1)) {
    fail("the dead zone must be smaller than the display", "change it");
  }
  if (!(options.ambient >= 0 && options.ambient <= 1000)) {
    fail("the light of the room must lie between 0 and 1000 times that of the screen", "change it");
  }
  const Tone& tone = options.tone;
  if (!(tone.gain >= 0 && tone.gain <= 1e9) || !(tone.gamma >= 0.1 && tone.gamma <= 10)) {
    fail("the gain must lie between 0 and 1e9, gamma between 0.1 and 10", "change them");
  }
}

Sweep exposedSweep(const ObserverOptions& options, const DisplayProfile& profile) {
  const double seconds = exposureSeconds(options, profile);
  return options.startDegrees ? sweepStartingAt(profile, seconds, *options.startDegrees)
                              : sweepEndingAt(profile, seconds, options.missingSectorStartDegrees);
}

Image<glm::vec3> collectLight(const Volume& volume, const ObserverOptions& options) {
  checkObserverOptions(options, volume.profile());
  const std::vector<ExposedArc> arcs =
      exposedArcs(volume.profile(), exposedSweep(options, volume.profile()), options.wobble);
  const Collector collector(volume, options);
  // Each part has an image of its own; whole numbers make their sum independent of who drew what.
  const size_t parts = lightImageCount(options.width, options.height, threadCount());
  std::vector<LightImage> images(parts, LightImage(options.width, options.height));
  parallelChunks(parts, parts, [&](size_t part, size_t, size_t) {
    for (size_t i = part; i < arcs.size(); i += parts) {
      collector.add(arcs[i], images[part]);
    }
  });
  Image<glm::vec3> light(options.width, options.height);
  parallelFor(light.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      FixedLight sum{};
      for (const LightImage& image : images) {
        addLight(sum, image.pixels()[i]);
      }
      light[i] = glm::vec3(glm::dvec3(sum[0], sum[1], sum[2]) * (collector.scale() / kLightUnit));
    }
  });
  if (options.ambient > 0) {
    addAmbientLight(light, volume.profile(), options);
  }
  return light;
}

Image<glm::vec3> observe(const Volume& volume, const ObserverOptions& options) {
  Image<glm::vec3> image = collectLight(volume, options);
  Tone tone = options.tone;
  tone.gain = tone.gain > 0 ? tone.gain : automaticGain(image);
  applyTone(image, tone);
  return image;
}

}  // namespace ocelli
