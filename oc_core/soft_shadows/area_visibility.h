// How much of an area light points of surfaces see: what soft shadows are made of (section 3.5.3). The text replaces
// the pinhole of a shadow map by an occlusion camera, which holds what all points of the light see, and gives no
// algorithm. The ways to integrate over the light stand behind this interface.
//
// Visibility is the share of the light's area that no surface hides, 0 to 1; all parts of the light count alike. What
// lies below the plane of the receiver's own surface, its horizon, is hidden: it would shine at its back. So visibility
// is 0 for points that the light does not shine at: behind its plane, or turned away from all of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/soft_shadows/light_frame.h"

namespace ocelli {

/// A point that receives light. Nearly all ways are faster where neighbours follow each other.
struct ShadowReceiver {
  glm::vec3 position{0};  ///< world
  glm::vec3 normal{0};    ///< unit, of the surface, on the side that is seen
  /// Whether its own surface is one that images stand for.
  bool isSampled = false;
};

/// Receivers are moved off their surfaces by so much, so that these do not hide the light from themselves.
struct ReceiverLift {
  float least = 1e-4f;  ///< along the normal, world units: more than single precision rounds
  // Where the surface is one that images stand for, also by these shares of the distance from the plane of the light:
  // its samples are off by up to a footprint there.
  float perDistance = 0;   ///< along the normal, where that is more
  float towardsLight = 0;  ///< towards the centre of the light: squares of samples stand out along its rays
};

struct ShadowWork {
  uint64_t rays = 0;      ///< that were cast
  uint64_t elements = 0;  ///< edges, samples or texels that were looked at
};

struct LightVisibility {
  std::vector<float> share;  ///< of each receiver
  /// What the share is off by, as far as its way can tell; empty where it cannot.
  std::vector<float> estimatedError = {};
  ShadowWork work = {};
};

class AreaVisibility {
 public:
  virtual ~AreaVisibility() = default;
  /// Of each receiver. On all threads, with the same result for any number of them.
  virtual LightVisibility of(std::span<const ShadowReceiver> receivers) const = 0;
};

/// Where a receiver stands as the light sees it, lifted; nothing where the light does not shine at it: at or behind its
/// plane, or with the surface turned away from every point of the light.
struct LitReceiver {
  glm::vec3 position{0};  ///< in the frame of the light
  glm::vec3 normal{0};
  float horizon = 0;         ///< dot(normal, position) without the lift
  bool seesHorizon = false;  ///< whether some of the light lies below the plane of the surface

  /// Whether a point of the light lies over the plane of the surface.
  bool isAbove(const glm::vec3& onLight) const { return glm::dot(normal, onLight) > horizon; }
};
bool isLit(const ShadowReceiver& receiver, const LightFrame& frame, const ReceiverLift& lift, LitReceiver& lit);

}  // namespace ocelli
