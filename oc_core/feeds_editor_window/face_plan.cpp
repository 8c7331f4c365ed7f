#include "oc_core/feeds_editor_window/face_plan.h"

#include <fmt/format.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include "oc_core/feeds_editor/feed_footprint.h"

namespace ocelli {
namespace {

constexpr float kFaceWidth = 3;  ///< screen coordinates at 96 dots an inch, here and below
constexpr float kHandleRadius = 5;
constexpr float kCameraSize = 9;
constexpr float kAheadLength = 14;  ///< of the arrow that shows where a frustum is

ImVec2 planPoint(const glm::vec2& p) {
  return {p.x, p.y};
}

}  // namespace

PlanWindow planAround(const FaceEditor& editor, const std::vector<PlanWall>& walls, const glm::ivec2& size) {
  Box box;
  for (const PlanWall& wall : walls) {
    for (const glm::vec2& p : wall) {
      box.add({p.x, 0, p.y});
    }
  }
  for (const Feed& feed : editor.setup().feeds) {
    box.add(glm::vec3(feed.pose.eye));
  }
  for (const PlanFace& face : editor.faces()) {
    box.add({static_cast<float>(face.from.x), 0, static_cast<float>(face.from.y)});
    box.add({static_cast<float>(face.to.x), 0, static_cast<float>(face.to.y)});
  }
  constexpr float kLeast = 1;  // metres: of a single camera
  box.add(box.lower - kLeast);
  box.add(box.upper + kLeast);
  return PlanWindow::around(PlanSide::kTop, box, size);
}

GuiColor feedColor(size_t feed) {
  return kGuiSeries[feed % kGuiSeries.size()];
}

void drawFacePlan(ImDrawList& list, const PlanWindow& plan, const glm::vec2& corner, const FaceEditor& editor,
                  const std::vector<PlanWall>& walls, float scale) {
  const auto at = [&](const glm::dvec2& paper) { return corner + glm::vec2(plan.pixelFromPaper(paper)); };
  for (const PlanWall& wall : walls) {
    list.AddLine(planPoint(at(wall[0])), planPoint(at(wall[1])), kGuiText.packed(), 1.5f * scale);
  }
  const FeedSetup& setup = editor.setup();
  for (size_t i = 0; i < setup.feeds.size(); ++i) {
    const Feed& feed = setup.feeds[i];
    const bool isSelected = feed.name == editor.selected();
    const std::vector<glm::dvec2> footprint = footprintOf(setup, i);
    for (size_t k = 0; k < footprint.size(); ++k) {
      list.AddLine(planPoint(at(footprint[k])), planPoint(at(footprint[(k + 1) % footprint.size()])),
                   feedColor(i).packed(isSelected ? 200 : 70), scale);
    }
    const glm::vec2 eye = at({feed.pose.eye.x, feed.pose.eye.z});
    const glm::dvec3 forward = feed.pose.forward();
    const glm::vec2 level(forward.x, forward.z);
    const glm::vec2 ahead = glm::length(level) > 0 ? glm::normalize(level) : glm::vec2(0, -1);
    const glm::vec2 side(-ahead.y, ahead.x);
    const float size = kCameraSize * scale;
    list.AddTriangleFilled(planPoint(eye), planPoint(eye + (ahead + 0.6f * side) * size),
                           planPoint(eye + (ahead - 0.6f * side) * size), feedColor(i).packed());
    list.AddCircleFilled(planPoint(eye), 0.4f * size, feedColor(i).packed());
    list.AddText(planPoint(eye - ahead * size - glm::vec2(0, ImGui::GetTextLineHeight())), feedColor(i).packed(),
                 feed.name.c_str());
  }
  for (const PlanFace& face : editor.faces()) {
    const auto index = static_cast<size_t>(setup.feedIndex(face.feed));
    const bool isSelected = face.feed == editor.selected();
    const glm::vec2 from = at(face.from);
    const glm::vec2 to = at(face.to);
    const glm::vec2 middle = (from + to) * 0.5f;
    list.AddLine(planPoint(from), planPoint(to), kOkabeItoBlack.packed(), (kFaceWidth + 2) * scale);
    list.AddLine(planPoint(from), planPoint(to), feedColor(index).packed(),
                 (isSelected ? kFaceWidth + 1 : kFaceWidth) * scale);
    // Towards the frustum: away from its camera.
    const glm::dvec3& eye = setup.feeds[index].pose.eye;
    const glm::vec2 along = to - from;
    glm::vec2 beyond = glm::length(along) > 0 ? glm::normalize(glm::vec2(-along.y, along.x)) : glm::vec2(0);
    beyond *= glm::dot(beyond, middle - at({eye.x, eye.z})) < 0 ? -1.0f : 1.0f;
    list.AddLine(planPoint(middle), planPoint(middle + beyond * kAheadLength * scale), feedColor(index).packed(),
                 2 * scale);
    for (const glm::vec2& end : {from, to}) {
      list.AddCircleFilled(planPoint(end), kHandleRadius * scale, feedColor(index).packed());
      list.AddCircle(planPoint(end), kHandleRadius * scale, isSelected ? kGuiText.packed() : kOkabeItoBlack.packed(), 0,
                     1.5f * scale);
    }
    const float half = 0.7f * kHandleRadius * scale;
    list.AddRectFilled(planPoint(middle - half), planPoint(middle + half), feedColor(index).packed());
    if (isSelected) {
      list.AddText(planPoint(middle + beyond * (kAheadLength + 6) * scale), feedColor(index).packed(),
                   fmt::format("{}, from {}", face.feed, face.parent).c_str());
    }
  }
  if (editor.snap()) {
    const glm::vec2 snap = at(editor.snap()->at);
    list.AddCircle(planPoint(snap), 2 * kHandleRadius * scale, kOkabeItoYellow.packed(), 0, 2 * scale);
    list.AddText(planPoint(snap + 2 * kHandleRadius * scale), kOkabeItoYellow.packed(), editor.snap()->what.c_str());
  }
}

}  // namespace ocelli
