// A plain shadow map: depths from the centre of an area light, along its direction, and the least depth of each square
// of 2^k texels. What percentage-closer soft shadows and back-projection look things up in.
#pragma once

#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/soft_shadows/light_frame.h"

namespace ocelli {

class LightShadowMap {
 public:
  static constexpr float kNothing = 1e30f;  ///< the depth of a texel that shows nothing

  /// `image` is a depth image whose view lies at the light's centre and looks along its direction, with the light's
  /// `up` as its own.
  LightShadowMap(const ReferenceImage& image, const LightFrame& frame);

  int width() const { return levels_.front().width(); }
  int height() const { return levels_.front().height(); }
  size_t samples() const { return samples_; }
  /// Distance from the plane of the light; kNothing.
  float depth(int x, int y) const { return levels_.front()(x, y); }
  int levels() const { return static_cast<int>(levels_.size()); }
  const Image<float>& leastDepths(int level) const { return levels_[static_cast<size_t>(level)]; }
  float leastDepth() const { return levels_.back()(0, 0); }

  /// Where a point (in the frame of the light) over its distance from the light's plane lies on the map, pixels.
  glm::vec2 texel(const glm::vec2& slope) const { return center_ + slope * perSlope_; }
  glm::vec2 slope(const glm::vec2& texel) const { return (texel - center_) / perSlope_; }
  /// What a texel covers at distance 1.
  float footprint() const { return 1 / std::abs(perSlope_.x); }
  const glm::vec2& perSlope() const { return perSlope_; }

 private:
  glm::vec2 center_;
  glm::vec2 perSlope_;  ///< signed: the image may run against the light's axes
  std::vector<Image<float>> levels_;
  size_t samples_ = 0;
};

/// The view from a light's centre along its direction that holds `cast` as far as a field of view can: what shadow maps
/// and reference images are made for. Throws InputError naming `where` where nothing of it lies in front of the light.
View lightView(const AreaLight& light, const Mesh& cast, int width, int height, const std::string& where);

}  // namespace ocelli
