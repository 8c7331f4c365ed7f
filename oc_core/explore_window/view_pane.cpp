#include "oc_core/explore_window/view_pane.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "oc_core/explore_window/explore_colors.h"
#include "oc_core/explore_window/explore_gui_pieces.h"
#include "oc_core/explore_window/explore_image_fit.h"
#include "oc_core/explore_window/explore_tints.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {
namespace {

/// By what a drag over the width of the view turns.
constexpr float kDegreesPerWidth = 90;
/// A captured mouse, for each screen coordinate at 96 dots an inch.
constexpr float kDegreesPerUnit = 0.12f;
/// A press that moves less is a click.
constexpr float kClickUnits = 4;

class ViewPane : public ExplorePane {
 public:
  void ask(const ExplorePaneFrame& frame, WindowShape& shape) const override { shape.view = frame.pixels(); }

  void paint(const ExplorePaneFrame& frame, GlContext& context, const GlObject& framebuffer) override {
    if (frame.picture == nullptr) {
      return;
    }
    if (frame.isFresh || !image_) {
      image_.upload(context, frame.picture->view);
    }
    frame.copy(image_, context, framebuffer);
  }

  void draw(const ExplorePaneFrame& frame) override {
    if (frame.picture == nullptr) {
      return;
    }
    const WindowPicture& picture = *frame.picture;
    const ExploreImageFit fit = fitOf(frame);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (frame.state.borders) {
      drawTints(frame, fit, list);
    }
    if (frame.state.captured) {
      const glm::vec2 middle = fit.onScreen(glm::vec2(picture.view.width(), picture.view.height()) * 0.5f);
      list.AddCircle({middle.x, middle.y}, 6 * frame.scale, kGuiBackground.packed(200), 24, 4 * frame.scale);
      list.AddCircle({middle.x, middle.y}, 6 * frame.scale, kGuiText.packed(), 24, 2 * frame.scale);
    }
  }

  bool handlePointer(const ExplorePaneFrame& frame, const InputEvent& event, const glm::vec2& pointer) override {
    if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
      handleButton(frame, *button, pointer);
      return true;
    }
    if (std::holds_alternative<PointerMoveEvent>(event)) {
      if (frame.state.captured) {
        if (wasCaptured_) {  // the first move tells where the pointer is
          turn(frame, (pointer - last_) * (kDegreesPerUnit / frame.scale));
        }
      } else if (pressed_) {
        dragged_ = dragged_ || glm::distance(pointer, *pressed_) > kClickUnits * frame.scale;
        if (dragged_) {
          // What is seen follows the pointer: the eye turns the other way.
          turn(frame, (last_ - pointer) * (kDegreesPerWidth / frame.rect.width));
        }
      }
      last_ = pointer;
      wasCaptured_ = frame.state.captured;
      return frame.state.captured || pressed_.has_value();
    }
    return false;
  }

  void loseFocus() override {
    pressed_.reset();
    dragged_ = false;
  }

 private:
  static ExploreImageFit fitOf(const ExplorePaneFrame& frame) {
    return exploreImageFit(frame.rect, {frame.picture->view.width(), frame.picture->view.height()});
  }

  static void drawTints(const ExplorePaneFrame& frame, const ExploreImageFit& fit, ImDrawList& list) {
    std::vector<glm::vec2> points;
    for (const WindowTint& tint : frame.picture->tints) {
      if (showsTint(tint, fit.scale / frame.scale)) {
        points.clear();
        for (const glm::vec2& pixel : tint.outline) {
          points.push_back(fit.onScreen(pixel));
        }
        drawExploreOutline(list, points, exploreSeriesColor(tint.color), frame.scale);
      }
    }
    for (const WindowTint& tint : frame.picture->tints) {
      if (showsTint(tint, fit.scale / frame.scale)) {
        const TintExtent extent = extentOf(tint);
        const glm::vec2 at = fit.onScreen({(extent.lower.x + extent.upper.x) / 2, extent.lower.y});
        drawExploreBadge(list, {at.x, std::max(at.y, frame.rect.y) + 14 * frame.scale}, fmt::format("{}", tint.color),
                         exploreSeriesColor(tint.color), frame.scale);
      }
    }
  }

  void handleButton(const ExplorePaneFrame& frame, const PointerButtonEvent& button, const glm::vec2& pointer) {
    last_ = pointer;
    if (button.button == PointerButton::kRight) {
      frame.state.captured = frame.state.captured || button.pressed;
      return;
    }
    if (button.button != PointerButton::kLeft) {
      return;
    }
    if (frame.state.captured) {
      if (button.pressed) {
        pick(frame, std::nullopt);
      }
      pressed_.reset();
      return;
    }
    if (button.pressed) {
      pressed_ = pointer;
      dragged_ = false;
    } else if (pressed_) {
      if (!dragged_) {
        pick(frame, pointer);
      }
      pressed_.reset();
    }
  }

  /// Nothing: what is in the middle.
  static void pick(const ExplorePaneFrame& frame, const std::optional<glm::vec2>& pointer) {
    if (frame.picture == nullptr) {
      return;
    }
    const glm::vec2 size(frame.picture->view.width(), frame.picture->view.height());
    const glm::dvec2 pixel = pointer ? fitOf(frame).inImage(*pointer) : size * 0.5f;
    frame.work.tell([pixel](ExploreWindowModel& model) { return model.pick(pixel); });
  }

  static void turn(const ExplorePaneFrame& frame, const glm::vec2& degrees) {
    frame.state.turnedDegrees += glm::vec2(degrees.x, -degrees.y);
  }

  ImageTexture image_;
  std::optional<glm::vec2> pressed_;
  glm::vec2 last_{0};
  bool dragged_ = false;
  bool wasCaptured_ = false;
};

}  // namespace

std::unique_ptr<ExplorePane> makeViewPane() {
  return std::make_unique<ViewPane>();
}

}  // namespace ocelli
