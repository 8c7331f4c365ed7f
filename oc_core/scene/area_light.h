// A light that is a flat area: a rectangle, or the disc (an ellipse where the sides differ) in it. It shines to one
// side, evenly over its area.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "oc_core/scene/mesh.h"

namespace ocelli {

struct AreaLight {
  glm::vec3 center{0};
  glm::vec3 right{1, 0, 0};  ///< unit vectors along its sides, across each other
  glm::vec3 up{0, 0, -1};
  float width = 0;   ///< along `right`, world units; a light of size 0 is a point
  float height = 0;  ///< along `up`
  bool isDisc = false;

  /// Unit: whence it shines.
  glm::vec3 direction() const;
};

/// Turned so that it shines at `target`, with `right` level unless it shines straight up or down; then turned by
/// `turnDegrees` about its direction. Throws InputError naming `where` where centre and target coincide.
AreaLight areaLightTowards(const glm::vec3& center, const glm::vec3& target, float width, float height, bool isDisc,
                           double turnDegrees, const std::string& where);

/// The light that a flat panel of a scene is: the rectangle around it along its longest side, or the disc in that where
/// the panel has the area of the disc. It shines to the side that its triangles face. Throws InputError naming `where`
/// where the mesh is not flat, to a thousandth of its size.
AreaLight areaLightOfPanel(const Mesh& panel, const std::string& where);

/// Two triangles, or a fan, that face its direction; white.
Mesh panelOf(const AreaLight& light);

}  // namespace ocelli
