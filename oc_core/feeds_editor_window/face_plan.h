// The plan of the place with cameras and near faces, as the window draws it. For the .cpp files of this room.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/feeds_editor/face_editor.h"
#include "oc_core/window/gui_style.h"

struct ImDrawList;

namespace ocelli {

/// A piece of a wall in the plan: (x, z).
using PlanWall = std::array<glm::vec2, 2>;

/// Around walls, cameras and faces, with a margin.
PlanWindow planAround(const FaceEditor& editor, const std::vector<PlanWall>& walls, const glm::ivec2& size);

/// The colour of a feed, by index.
GuiColor feedColor(size_t feed);

/// `corner` is where the plan begins in the window, screen coordinates; `scale` is the length of 1 at 96 dots an inch.
void drawFacePlan(ImDrawList& list, const PlanWindow& plan, const glm::vec2& corner, const FaceEditor& editor,
                  const std::vector<PlanWall>& walls, float scale);

}  // namespace ocelli
