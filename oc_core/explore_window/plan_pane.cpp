#include "oc_core/explore_window/plan_pane.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "oc_core/explore_window/explore_colors.h"
#include "oc_core/explore_window/explore_gui_pieces.h"
#include "oc_core/explore_window/explore_plan_sight.h"
#include "oc_core/explore_window/explore_tints.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {
namespace {

constexpr float kPlanZoomPerStep = 1.25f;
constexpr float kFirstPlanWidth = 110;  // metres, that show at first of a larger scene
constexpr float kMaxScaleBar = 110;     // screen coordinates at 96 dots an inch

ImVec2 planPoint(const glm::vec2& p) {
  return {p.x, p.y};
}

/// What a plan covers before there is a picture of it: everything that is in it.
struct PlanExtent {
  glm::vec2 lower{0};
  glm::vec2 upper{0};
};
PlanExtent extentOfPlan(const WindowPicture& picture) {
  if (picture.ground) {
    return {picture.ground->lower, picture.ground->upper};
  }
  PlanExtent extent{picture.plan.walker - 10.0f, picture.plan.walker + 10.0f};
  const auto add = [&](const std::vector<glm::vec2>& points) {
    for (const glm::vec2& point : points) {
      extent.lower = glm::min(extent.lower, point);
      extent.upper = glm::max(extent.upper, point);
    }
  };
  if (picture.plan.cells) {
    for (const WindowPlan::Cell& cell : *picture.plan.cells) {
      add(cell.outline);
    }
  }
  add(picture.plan.picked);
  return extent;
}

class PlanPane : public ExplorePane {
 public:
  void ask(const ExplorePaneFrame&, WindowShape& shape) const override { shape.ground = true; }

  void paint(const ExplorePaneFrame& frame, GlContext& context, const GlObject&) override {
    if (frame.picture != nullptr && frame.picture->ground != ground_) {
      ground_ = frame.picture->ground;
      if (ground_) {
        texture_.upload(context, ground_->image);
      }
    }
  }

  void draw(const ExplorePaneFrame& frame) override {
    if (frame.picture == nullptr) {
      return;
    }
    const WindowPlan& plan = frame.picture->plan;
    if (!hasZoom_ && ground_) {
      hasZoom_ = true;
      const glm::vec2 size = ground_->upper - ground_->lower;
      frame.state.planZoom = frame.picture->lengthUnit.empty()
                                 ? 1
                                 : std::clamp(std::max(size.x, size.y) / kFirstPlanWidth, 1.0f, kMaxPlanZoom);
    }
    const ExplorePlanSight sight = sightOf(frame);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (ground_) {
      list.AddImage(GuiLayer::imageOf(texture_.texture()), planPoint(sight.onScreen(ground_->lower)),
                    planPoint(sight.onScreen(ground_->upper)));
    }
    drawCells(plan, sight, list, frame.scale);
    drawFrusta(frame, sight, list);
    drawPath(plan, sight, list, frame.scale);
    drawOpenings(plan, sight, list, frame.scale);
    drawPicked(plan, sight, list, frame.scale);
    drawWalker(plan, sight, list, frame.scale);
    drawScaleBar(frame, sight, list);
  }

  bool handlePointer(const ExplorePaneFrame& frame, const InputEvent& event, const glm::vec2& pointer) override {
    if (const auto* scroll = std::get_if<ScrollEvent>(&event)) {
      frame.state.planZoom = std::clamp(
          frame.state.planZoom * std::pow(kPlanZoomPerStep, static_cast<float>(scroll->up)), 1.0f, kMaxPlanZoom);
      return true;
    }
    const auto* button = std::get_if<PointerButtonEvent>(&event);
    if (button == nullptr || frame.picture == nullptr) {
      return false;
    }
    if (button->button == PointerButton::kLeft && button->pressed) {
      const glm::vec2 to = sightOf(frame).inPlan(pointer);
      frame.work.tell([to](ExploreWindowModel& model) {
        model.goTo(to);
        return std::string();
      });
    }
    return true;
  }

 private:
  static ExplorePlanSight sightOf(const ExplorePaneFrame& frame) {
    const PlanExtent extent = extentOfPlan(*frame.picture);
    return explorePlanSight(frame.rect, extent.lower, extent.upper, frame.picture->plan.walker, frame.state.planZoom);
  }

  void onScreen(const std::vector<glm::vec2>& points, const ExplorePlanSight& sight) {
    points_.clear();
    for (const glm::vec2& point : points) {
      points_.push_back(planPoint(sight.onScreen(point)));
    }
  }
  int count() const { return static_cast<int>(points_.size()); }

  void drawCells(const WindowPlan& plan, const ExplorePlanSight& sight, ImDrawList& list, float scale) {
    if (!plan.cells) {
      return;
    }
    for (const WindowPlan::Cell& cell : *plan.cells) {
      onScreen(cell.outline, sight);
      list.AddPolyline(points_.data(), count(), kGuiText.packed(cell.isTunnel ? 90 : 150), ImDrawFlags_Closed, scale);
    }
  }

  /// Those whose bends are marked in the view stand out; what straight rays see is one light.
  void drawFrusta(const ExplorePaneFrame& frame, const ExplorePlanSight& sight, ImDrawList& list) {
    const WindowPicture& picture = *frame.picture;
    std::set<int> marked;
    for (const WindowTint& tint : picture.tints) {
      if (showsTint(tint, 1 / frame.scale)) {
        marked.insert(tint.color);
      }
    }
    const auto straight = std::ranges::count(picture.plan.frusta, 0, &WindowPlan::Frustum::color);
    for (const WindowPlan::Frustum& frustum : picture.plan.frusta) {
      if (frustum.outline.size() < 3) {
        continue;
      }
      const GuiColor color = exploreSeriesColor(frustum.color);
      onScreen(frustum.outline, sight);
      const bool isMarked = marked.contains(frustum.color);
      list.AddConvexPolyFilled(points_.data(), count(), color.packed(isMarked ? 72 : 24));
      if (isMarked || (frustum.color == 0 && straight == 1)) {
        list.AddPolyline(points_.data(), count(), color.packed(235), ImDrawFlags_Closed, 1.5f * frame.scale);
      }
    }
    for (const WindowPlan::Frustum& frustum : picture.plan.frusta) {
      if (marked.contains(frustum.color) && frustum.outline.size() >= 3) {
        drawExploreBadge(list, badgePlace(frame, sight, frustum), fmt::format("{}", frustum.color),
                         exploreSeriesColor(frustum.color), frame.scale);
      }
    }
  }

  /// In the middle of a frustum, or so far towards the walker that it is in the pane.
  static glm::vec2 badgePlace(const ExplorePaneFrame& frame, const ExplorePlanSight& sight,
                              const WindowPlan::Frustum& frustum) {
    const glm::vec2 walker = frame.picture->plan.walker;
    glm::vec2 middle(0);
    glm::vec2 nearest = frustum.outline.front();
    for (const glm::vec2& point : frustum.outline) {
      middle += point / static_cast<float>(frustum.outline.size());
      nearest = glm::distance(point, walker) < glm::distance(nearest, walker) ? point : nearest;
    }
    const float border = 16 * frame.scale;
    const ExplorePaneRect inner{frame.rect.x + border, frame.rect.y + border, frame.rect.width - 2 * border,
                                frame.rect.height - 2 * border};
    glm::vec2 place = sight.onScreen(middle);
    for (float share = 0.9f; share > 0 && !inner.contains(place); share -= 0.1f) {
      place = sight.onScreen(glm::mix(nearest, middle, share));
    }
    return place;
  }

  void drawPath(const WindowPlan& plan, const ExplorePlanSight& sight, ImDrawList& list, float scale) {
    if (plan.path && plan.path->size() >= 2) {
      onScreen(*plan.path, sight);
      list.AddPolyline(points_.data(), count(), kGuiText.packed(220), 0, 1.5f * scale);
    }
  }

  void drawOpenings(const WindowPlan& plan, const ExplorePlanSight& sight, ImDrawList& list, float scale) {
    if (!plan.openings) {
      return;
    }
    for (const WindowPlan::Opening& opening : *plan.openings) {
      const ImVec2 from = planPoint(sight.onScreen(opening[0]));
      const ImVec2 to = planPoint(sight.onScreen(opening[1]));
      list.AddLine(from, to, kGuiBackground.packed(180), 4 * scale);
      list.AddLine(from, to, kGuiAccent.packed(), 2 * scale);
    }
  }

  void drawPicked(const WindowPlan& plan, const ExplorePlanSight& sight, ImDrawList& list, float scale) {
    if (plan.picked.size() < 2) {
      return;
    }
    onScreen(plan.picked, sight);
    list.AddPolyline(points_.data(), count(), kGuiBackground.packed(200), ImDrawFlags_Closed, 6 * scale);
    list.AddPolyline(points_.data(), count(), kExplorePicked.packed(), ImDrawFlags_Closed, 3 * scale);
    float top = points_.front().y;
    float middle = 0;
    for (const ImVec2& point : points_) {
      top = std::min(top, point.y);
      middle += point.x / static_cast<float>(points_.size());
    }
    drawExploreBadge(list, {middle, top - 12 * scale}, "picked", kExplorePicked, scale);
  }

  static void drawWalker(const WindowPlan& plan, const ExplorePlanSight& sight, ImDrawList& list, float scale) {
    const glm::vec2 at = sight.onScreen(plan.walker);
    const glm::vec2 ahead = plan.heading;
    const glm::vec2 right(-ahead.y, ahead.x);
    const auto corner = [&](float forward, float sideways) {
      return planPoint(at + (ahead * forward + right * sideways) * scale);
    };
    const std::array arrow{corner(11, 0), corner(-7, 7), corner(-3, 0), corner(-7, -7)};
    list.AddTriangleFilled(arrow[0], arrow[1], arrow[2], kGuiText.packed());
    list.AddTriangleFilled(arrow[0], arrow[2], arrow[3], kGuiText.packed());
    list.AddPolyline(arrow.data(), static_cast<int>(arrow.size()), kGuiBackground.packed(), ImDrawFlags_Closed,
                     1.5f * scale);
  }

  static void drawScaleBar(const ExplorePaneFrame& frame, const ExplorePlanSight& sight, ImDrawList& list) {
    const float scale = frame.scale;
    const float length = roundExploreLength(kMaxScaleBar * scale / sight.scale);
    const glm::vec2 left(frame.rect.x + 12 * scale, frame.rect.bottom() - 12 * scale);
    const glm::vec2 right(left.x + length * sight.scale, left.y);
    const std::string& unit = frame.picture->lengthUnit;
    const std::string text = fmt::format("{:g}{}{}", length, unit.empty() ? "" : " ", unit);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float across = std::max(right.x - left.x, size.x);
    list.AddRectFilled({left.x - 6 * scale, left.y - size.y - 8 * scale},
                       {left.x + across + 6 * scale, left.y + 5 * scale}, kGuiBackground.packed(190), 4 * scale);
    list.AddLine(planPoint(left), planPoint(right), kGuiText.packed(), 2 * scale);
    list.AddText({left.x, left.y - size.y - 4 * scale}, kGuiText.packed(), text.c_str());
  }

  std::shared_ptr<const WindowGround> ground_;
  ImageTexture texture_;
  bool hasZoom_ = false;
  std::vector<ImVec2> points_;
};

}  // namespace

std::unique_ptr<ExplorePane> makePlanPane() {
  return std::make_unique<PlanPane>();
}

}  // namespace ocelli
