// Makes the hidden samples of an I-node: of the points that an occlusion camera chooses on the proxy
// (section 3.5.4.4.3), those that the I-node does not see and images that hang on it do.
//
// A point stands for its surface around there: what the ray of a pixel next to it meets at about its distance is a
// sample. Its colour comes from the nearest image that sees it over the proxy, as warps have it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "oc_core/sea/hidden_samples.h"

namespace ocelli {

/// World points on a proxy that an image at `pose` should know of, for images that are at most `reach` away. It may
/// give points that the image sees.
using HiddenPoints = std::function<std::vector<glm::vec3>(const Mesh& proxy, const SeaPose& pose, double reach)>;

/// The images that hang on an I-node, the nearest one first.
struct HiddenViews {
  std::vector<SeaPose> poses;
  /// One of them. It has the projection of the I-node.
  std::function<Image<Rgb8>(size_t view)> image;
  /// Samples that fewer of the views see are left out: residuals say those in fewer bytes.
  size_t fewest = 1;
};

/// On the calling thread alone.
HiddenSamples gatherHiddenSamples(const SeaProxy& proxy, const SeaCamera& inner, std::span<const glm::vec3> points,
                                  const HiddenViews& views);

}  // namespace ocelli
