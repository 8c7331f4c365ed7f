// What a simulated camera sees of a place with walkers: its background is drawn once, walkers for each frame.
#pragma once

#include <memory>
#include <vector>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_measure/walkers.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

/// Of a pixel: the walker that is seen there, plus 1; 0 is the place.
using WalkerMask = Image<uint8_t>;

/// A frame in linear light, before exposure and noise.
struct SimulatedFrame {
  Image<glm::vec3> colors;
  WalkerMask walkers;
};

class SimulatedFeed {
 public:
  /// `place` is the scene without walkers, in metres.
  SimulatedFeed(const Feed& feed, const Mesh& place);
  ~SimulatedFeed();
  SimulatedFeed(SimulatedFeed&&) noexcept;

  const Image<glm::vec3>& background() const;
  /// What it sees of walkers when its first row is taken at `seconds`, the others one after the other within
  /// `rollingSeconds`; 0 takes all at once. Rows within 2.5 ms are taken together.
  SimulatedFrame frame(const Walkers& walkers, double seconds, double rollingSeconds = 0) const;
  /// The masks alone.
  WalkerMask mask(const Walkers& walkers, double seconds, double rollingSeconds = 0) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
