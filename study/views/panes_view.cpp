// Several planar pinhole cameras side by side, each turned by an angle from where the task looks: what a panorama of
// screens, or mirrors, would show.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/json_fields.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

constexpr size_t kMaxPanes = 8;
/// Between panes, of the width of the place that they share.
constexpr double kPaneGap = 0.01;

class PanesView final : public SceneView {
 public:
  PanesView(std::vector<double> headings, std::optional<double> fovHorizontal)
      : headings_(std::move(headings)), fovHorizontal_(fovHorizontal) {}

  std::vector<TrialLayout::View> views(const Vantage& from) const override {
    std::vector<TrialLayout::View> views;
    for (const Vantage::Pane& pane : from.pinholes) {
      const auto count = static_cast<double>(headings_.size());
      const double gap = std::floor(kPaneGap * pane.place.width);
      const double width = std::floor((pane.place.width - (count - 1) * gap) / count);
      for (size_t i = 0; i < headings_.size(); ++i) {
        const PixelRect place{pane.place.left + static_cast<double>(i) * (width + gap), pane.place.top, width,
                              pane.place.height};
        views.emplace_back(place, turned(pane.camera, headings_[i], place));
      }
    }
    return views;
  }

 private:
  /// To the right, about the vertical.
  PinholeCamera turned(const PinholeCamera& camera, double degrees, const PixelRect& place) const {
    View view = camera.view();
    const double angle = radiansFromDegrees(degrees);
    const glm::dvec3 ahead = glm::dvec3(view.target - view.eye);
    view.target = view.eye + glm::vec3(glm::dvec3(std::cos(angle) * ahead.x - std::sin(angle) * ahead.z, ahead.y,
                                                  std::sin(angle) * ahead.x + std::cos(angle) * ahead.z));
    const double tangent = fovHorizontal_ ? std::tan(radiansFromDegrees(*fovHorizontal_) / 2)
                                          : camera.width() / 2.0 / static_cast<double>(camera.focalPixels());
    view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(tangent * place.height / place.width));
    return {view, static_cast<int>(place.width), static_cast<int>(place.height)};
  }

  std::vector<double> headings_;  ///< degrees to the right
  std::optional<double> fovHorizontal_;
};

std::shared_ptr<const SceneView> readPanesView(JsonFields& fields) {
  const nlohmann::json& list = fields.value("headings_degrees");
  if (!list.is_array() || list.empty() || list.size() > kMaxPanes) {
    fields.fail("headings_degrees", fmt::format("must be an array of 1 to {} angles, one a pane", kMaxPanes));
  }
  const std::vector<double> headings = fields.numbers("headings_degrees", list.size(), -180, 180);
  std::optional<double> fov;
  if (fields.has("fov_horizontal_degrees")) {
    fov = fields.number("fov_horizontal_degrees", 10, 150);
  }
  return std::make_shared<PanesView>(headings, fov);
}

}  // namespace

ViewKind panesViewKind() {
  return {"panes", "planar pinhole cameras side by side, each turned by an angle", readPanesView};
}

}  // namespace ocelli
