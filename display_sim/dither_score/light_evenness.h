// How even the light of surfaces is against the distance from the axis: white test surfaces of known area are sliced,
// and the light of their voxels is added up (even_light.h says what to expect).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "display_sim/dither/slice_options.h"
#include "display_sim/frames/display_profile.h"

namespace ocelli {

enum class TestSurface {
  kFloor,     ///< across the axis
  kCylinder,  ///< around it
  kWall,      ///< beside it, at a fifth of the radius
  kFin,       ///< from the axis outwards
};

inline constexpr TestSurface kTestSurfaces[] = {TestSurface::kFloor, TestSurface::kCylinder, TestSurface::kWall,
                                                TestSurface::kFin};
std::string_view nameOf(TestSurface surface);

struct LightSample {
  TestSurface surface = TestSurface::kFloor;
  double radius = 0;  ///< display radii
  /// In units of the light that even light to radius 1 aims at: of fully lit surfaces at radius 1 around the axis and
  /// across it, the darker one's.
  double lightPerArea = 0;
  double expected = 0;  ///< the same by even_light.h
};

/// Of each test surface at some 24 radii; a mean over the channels of a white surface of this grey.
std::vector<LightSample> measureEvenness(const DisplayProfile& profile, const SliceOptions& options, float grey = 1);

struct EvennessScore {
  double largestOverLeast = 1;   ///< of the light for its area
  double relativeDeviation = 0;  ///< standard deviation over mean
  double mean = 0;               ///< light for its area, all samples alike
};

/// Of the samples within a radius.
EvennessScore scoreEvenness(std::span<const LightSample> samples, double radius = 1);

}  // namespace ocelli
