// How far a picture of secondary rays is from the traced one, and what it took.
//
// The yardstick is the footprint of the reference view: z / focal length in pixels at the place of a hit, z along the
// reference view's direction from its eye (as for disocclusion errors, coverage.h), whatever camera made the images;
// beside and behind that eye its distance. Of
// the rays whose traced first hit is on an object that depth images stand for
//   lost      are those whose first hit is missing, or further than 1.5 footprints from the traced one along the ray;
//   missing   are those that meet no sample at all.
// A hit is false where a sample is met before the traced first hit, by more than 1.5 footprints: of all rays. Some of
// these are lost too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/shade/shaded_picture.h"

namespace ocelli {

/// What footprints are measured by: the reference view of each object that sends rays, and of each mirror that sends
/// them on.
struct Yardsticks {
  std::vector<PinholeCamera> senders;
  std::vector<PinholeCamera> mirrors = {};  ///< empty where those are the senders

  const PinholeCamera& ofMirror(uint32_t mirror) const { return mirrors.empty() ? senders[mirror] : mirrors[mirror]; }
};

/// What became of the first hit of a ray.
enum class HitState : uint8_t { kElsewhere, kRight, kOff, kMissing, kFalse };

struct ShadeFigures {
  std::string name;
  size_t rays = 0;
  size_t castRays = 0;  ///< whose traced first hit is on an object that depth images stand for
  bool hasDepth = true;
  size_t lost = 0;
  size_t missing = 0;
  size_t falseHits = 0;
  /// Rays whose traced second-order ray meets an object that depth images stand for, where those are followed; and
  /// those of them whose second-order ray meets nothing of it, or meets it more than 1.5 footprints away from there, in
  /// space.
  size_t secondRays = 0;
  size_t secondLost = 0;
  /// Mean angle between the rays of the way and the traced ones, where those are others.
  std::optional<double> exitDegrees = {};
  double footprint = 0;     ///< mean at the traced first hits of `castRays`, world units
  double psnrDecibels = 0;  ///< over the pixels of the rays; infinite where they are equal
  RayCost cost = {};
  uint32_t maxSteps = 0;  ///< of a ray
  size_t samples = 0;
  size_t triangles = 0;
  double buildMilliseconds = 0;
  double structureMilliseconds = 0;
  double shadeMilliseconds = 0;
  std::optional<size_t> deviceDiffering = {};  ///< rays that a device casts otherwise than the CPU

  double lostRatio() const { return ratio(lost, castRays); }
  double missingRatio() const { return ratio(missing, castRays); }
  double falseRatio() const { return ratio(falseHits, rays); }
  double deviceDifferingRatio() const { return ratio(deviceDiffering.value_or(0), rays); }
  double secondLostRatio() const { return ratio(secondLost, secondRays); }
  double stepsPerRay() const { return ratio(cost.steps(), rays); }
  double boxesPerRay() const { return ratio(cost.boxes, rays); }
  double trianglesPerRay() const { return ratio(cost.triangles, rays); }

 private:
  static double ratio(size_t part, size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
  }
};

/// The state of each ray.
std::vector<HitState> compareHits(const SecondaryRays& rays, const ShadedPicture& truth, const ShadedPicture& picture,
                                  const Yardsticks& yardsticks);

ShadeFigures figuresOf(const BuiltProxy& built, const SecondaryRays& rays, const ShadedPicture& truth,
                       const ShadedPicture& picture, const Yardsticks& yardsticks);

/// Rays of two pictures by the same proxies that first meet something else, or at another distance, or see another
/// colour in the end.
size_t differingRays(const SecondaryRays& rays, const ShadedPicture& a, const ShadedPicture& b);

/// The traced picture, dimmed, with the pixels of rays in the colours of what went wrong (error_image.h).
Image<Rgb8> hitErrorImage(const SecondaryRays& rays, const ShadedPicture& truth, const std::vector<HitState>& states);
/// Grey without rays; from dark blue over red to white at `brightest` steps.
Image<Rgb8> stepImage(const SecondaryRays& rays, const ShadedPicture& picture, uint32_t brightest);

}  // namespace ocelli
