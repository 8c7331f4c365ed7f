#include "display_sim/viewer/camera_form.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "display_sim/viewer/viewer_state.h"
#include "oc_core/ocri/representation_kind.h"

namespace ocelli {
namespace {

/// A format for ImGui with the unit behind the number, and the view cell's side in inches as well.
std::string formatOf(const CameraOption& option, double value) {
  if (&option == &kCellSide) {
    return fmt::format("%.2f radii ({:.1f} in)", value * kReferenceDisplayRadiusMetres / kInchMetres);
  }
  const char* number = isInteger(option) ? "%d" : option.formMax - option.formMin > 20 ? "%.0f" : "%.2f";
  return *option.unit == '\0' ? number : fmt::format("{} {}", number, option.unit);
}

void explain(const CameraOption& option) {
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", option.meaning);
  }
}

bool drawDirection(const CameraOption& option, CameraChoice& camera) {
  glm::vec3 direction = directionOf(option, camera);
  const bool changed = ImGui::SliderFloat3(option.label, &direction.x, static_cast<float>(option.formMin),
                                           static_cast<float>(option.formMax), "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::TextDisabled("to the right, up, backward");
  if (!changed || glm::length(direction) < 0.05f) {  // one without a direction is none
    return false;
  }
  setDirection(option, camera, direction);
  return true;
}

bool drawNumber(const CameraOption& option, CameraChoice& camera) {
  const double value = numberOf(option, camera);
  const std::string format = formatOf(option, value);
  if (isBoolean(option)) {
    bool on = value != 0;
    if (!ImGui::Checkbox(option.label, &on)) {
      return false;
    }
    setNumber(option, camera, on ? 1 : 0);
    return true;
  }
  if (isInteger(option)) {
    int number = static_cast<int>(value);
    if (!ImGui::SliderInt(option.label, &number, static_cast<int>(option.formMin), static_cast<int>(option.formMax),
                          format.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
      return false;
    }
    setNumber(option, camera, number);
    return true;
  }
  auto number = static_cast<float>(value);
  if (!ImGui::SliderFloat(option.label, &number, static_cast<float>(option.formMin), static_cast<float>(option.formMax),
                          format.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
    return false;
  }
  setNumber(option, camera, static_cast<double>(number));
  return true;
}

bool drawOption(const CameraOption& option, CameraChoice& camera) {
  bool changed = false;
  if (option.onOff.isOn != nullptr) {
    bool on = option.onOff.isOn(camera);
    if (ImGui::Checkbox(option.label, &on)) {
      option.onOff.turn(camera, on);
      changed = true;
    }
    explain(option);
    if (!on) {
      return changed;
    }
    ImGui::PushID("value");
  }
  changed |= isDirection(option) ? drawDirection(option, camera) : drawNumber(option, camera);
  explain(option);
  if (option.onOff.isOn != nullptr) {
    ImGui::PopID();
  }
  return changed;
}

}  // namespace

bool drawCameraForm(CameraChoice& camera, float valueWidth) {
  const std::vector<const CameraOption*>& options = camera.kind->options;
  bool changed = false;
  bool hasDetails = false;
  ImGui::PushItemWidth(valueWidth);
  for (const CameraOption* option : options) {
    hasDetails = hasDetails || option->isDetail;
    changed |= !option->isDetail && drawOption(*option, camera);
  }
  if (hasDetails && ImGui::TreeNodeEx("more", ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
    for (const CameraOption* option : options) {
      changed |= option->isDetail && drawOption(*option, camera);
    }
  }
  ImGui::PopItemWidth();
  return changed;
}

}  // namespace ocelli
