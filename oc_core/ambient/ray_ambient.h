// Ambient light by rays over the hemisphere: at the geometry it is the truth that others are compared with, at
// reference images what these know of it.
//
// Directions are a Hammersley set on the disc below the hemisphere, so that each counts by the cosine of its angle to
// the normal (Malley); it is shifted and turned by a number that is the pixel's own, so that neighbours err in
// different ways.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/ambient/ambient_options.h"
#include "oc_core/ambient/ambient_points.h"
#include "oc_core/render/ray_target.h"

namespace ocelli {

struct AmbientRays {
  static constexpr int kMaxRays = 4096;

  int count = 64;     ///< a point; at least 1
  uint64_t seed = 1;  ///< of the shifts
  /// Rays begin above the surface by so many footprints of the view's pixel: surfaces between samples lie off the
  /// true one by less than one.
  double liftFootprints = 0;
  /// And by so much, world units: more than single precision rounds.
  double lift = 1e-5;
};

/// The light of each point, 0 to 1. Throws InputError as validate() does, and for a number of rays out of range.
std::vector<float> ambientByRays(std::span<const AmbientPoint> points, const RayTarget& target,
                                 const AmbientOptions& options, const AmbientRays& rays);

/// Direction `i` of `count`, z along the normal; `shift` is from 0 to 1.
glm::vec3 hemisphereDirection(int i, int count, const glm::vec2& shift);

}  // namespace ocelli
