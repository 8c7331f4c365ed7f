// The light of rooms that are made by code, worked out once and multiplied into the colours of their surfaces: lamps of
// some area with soft shadows, and a sky of reflected light that corners and what stands near keep away (ambient
// occlusion). What casts shadows are boxes, as few as the shapes of the furniture need.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/scene/box.h"

namespace ocelli {

/// A rectangle that gives light on one side.
struct RoomLamp {
  glm::vec3 center{0};
  glm::vec3 halfU{0};
  glm::vec3 halfV{0};
  glm::vec3 normal{0, -1, 0};  ///< of length 1, into the room
  glm::vec3 power{1};          ///< linear; 1 lights what faces it closely with all of its colour
};

class IndoorLight {
 public:
  void addLamp(const RoomLamp& lamp) { lamps_.push_back(lamp); }
  /// A box of a size around the origin of its frame, at any turn.
  void addOccluder(const glm::vec3& size, const glm::mat4& worldFromBox);
  void setAmbient(const glm::vec3& ambient) { ambient_ = ambient; }

  /// What a colour at `point` of a surface with a normal of length 1 is multiplied with: over 0, and hardly over 1.
  glm::vec3 at(const glm::vec3& point, const glm::vec3& normal) const;

 private:
  struct Occluder {
    Box bounds;  ///< in the world
    glm::mat4 boxFromWorld{1};
    glm::vec3 half{0};
    bool isTurned = false;  ///< its faces are not across the axes of the world

    /// Where a ray enters the box, as a multiple of `along`; 0 from within, infinity where it misses. `inverse` is 1 /
    /// along.
    float entry(const glm::vec3& from, const glm::vec3& along, const glm::vec3& inverse) const;
  };

  /// Of the light of a lamp of power 1 for each unit of its area.
  float received(const RoomLamp& lamp, const glm::vec3& from, const glm::vec3& normal) const;
  float openness(const glm::vec3& point, const glm::vec3& normal) const;

  std::vector<RoomLamp> lamps_;
  std::vector<Occluder> occluders_;
  glm::vec3 ambient_{0.5f};
};

}  // namespace ocelli
