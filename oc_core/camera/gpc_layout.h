// Where a general pinhole camera samples more densely: its regions as data, in shares of the image, so that they fit
// every size; their JSON form, and what makes them valid.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/gpc_profile.h"

namespace ocelli {

class JsonFields;

/// A rectangle of the camera's own image that shows `zoom` times the detail.
struct GpcRegion {
  static constexpr double kMinZoom = 0.1;
  static constexpr double kMaxZoom = 64;
  static constexpr double kMinExtent = 1e-3;
  static constexpr double kMinTransition = 0.01;
  static constexpr double kMaxTransition = 100;

  glm::vec2 center{0.5f};     ///< shares of the image's width and height, from the top left
  glm::vec2 extent{0.5f};     ///< its width and height, the same shares
  float zoom = 2;             ///< sampling rate in it
  float transitionWidth = 1;  ///< from its edge to the outer edge of the transition, as a share of half its extent

  /// Of the transition: where the image is that of the pinhole again, half extents from the centre.
  double outer() const { return 1 + static_cast<double>(transitionWidth); }
  bool operator==(const GpcRegion&) const = default;
};

struct GpcLayout {
  static constexpr size_t kMaxRegions = 256;

  const GpcSampling* sampling = findGpcSampling("cubic");
  std::vector<GpcRegion> regions{GpcRegion{}};

  bool operator==(const GpcLayout&) const = default;
};

/// Throws InputError, naming the region, where a number is out of its range or not finite, a region with its transition
/// is not within the image, two of them overlap, or the transition is too narrow for a zoom below 1: where samples
/// would fold (gpc_profile.h).
void validate(const GpcLayout& layout, const std::string& where);

/// The fields "sampling" and "regions"; what is missing stays as it is. Throws as validate(), and for wrong fields.
void readGpcLayout(JsonFields& fields, GpcLayout& layout);
/// {"sampling": ..., "regions": [...]}
std::string jsonText(const GpcLayout& layout);
/// The values of the two fields, as JSON.
std::string gpcSamplingText(const GpcLayout& layout);
std::string gpcRegionsText(const GpcLayout& layout);
/// What a JSON Schema says of them: types, ranges and defaults.
std::string gpcSamplingSchema();
std::string gpcRegionsSchema();

}  // namespace ocelli
