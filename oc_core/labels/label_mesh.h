// Labels as geometry, so that every camera, display and effect sees them.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/labels/label_table.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// For labels that do not say it themselves.
struct LabelLook {
  double size = 0.03;         ///< height of a capital letter; positive
  glm::vec3 facing{0, 0, 1};  ///< not 0
};

/// Each label as flat letters, in the order of the list: the middle of the text, between the top of its capital letters
/// and its last baseline, is at its position. They are read from the side that the label faces, upright as far as that
/// goes: their upward direction is y in their plane. Of a label that lies flat it is -z where it is read from above,
/// and z from below. From behind they are mirrored. Letters are those of the figures' bold sans-serif.
///
/// Throws InputError naming `where` where no installed font draws a label, and for more than kMaxSceneTriangles.
Mesh meshOfLabels(const std::vector<SceneLabel>& labels, const LabelLook& look, const std::string& where);

}  // namespace ocelli
