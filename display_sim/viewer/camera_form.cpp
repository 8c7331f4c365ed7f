#include "display_sim/viewer/camera_form.h"

#include <imgui.h>

#include <array>
#include <glm/geometric.hpp>

#include "display_sim/viewer/viewer_state.h"

namespace ocelli {
namespace {

using Model = CameraChoice::Model;

bool takesCell(Model model) {
  switch (model) {
    case Model::kWideDepthImage:
    case Model::kCornerDepthImages:
    case Model::kDdoc:
    case Model::kEoc:
    case Model::kCrossedEocs:
    case Model::kCrossedEocsDdoc:
    case Model::kCell:
      return true;
    case Model::kDepthImage:
    case Model::kLayeredDepthImage:
    case Model::kReversePinhole:
    case Model::kSpoc:
    case Model::kSpocUnion:
    case Model::kSimplified:
    case Model::kSimplifiedSloppy:
    case Model::kGeometry:
      return false;
  }
  return false;
}

bool drawCellSide(CameraChoice& camera) {
  const double inches = camera.cellSideRadii * kReferenceDisplayRadiusMetres / kInchMetres;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%%.2f radii (%.1f in)", inches);
  float side = camera.cellSideRadii;
  if (!ImGui::SliderFloat("view cell", &side, 0.1f, 4.0f, text.data(), ImGuiSliderFlags_AlwaysClamp)) {
    return false;
  }
  camera.cellSideRadii = camera.ddoc.cellSideRadii = camera.cell.cell.sideRadii = side;
  return true;
}

bool drawSegment(CameraChoice& camera) {
  glm::vec3 direction = camera.segmentDirection;
  const bool changed = ImGui::SliderFloat3("segment", &direction.x, -1, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::TextDisabled("to the right, up, backward");
  if (!changed || glm::length(direction) < 0.05f) {  // one without a direction is none
    return false;
  }
  camera.segmentDirection = direction;
  return true;
}

bool drawDdoc(DdocOptions& options) {
  bool changed = false;
  int radius = options.radius == DdocOptions::Radius::kConstant ? 1 : 0;
  if (ImGui::Combo("radius", &radius, "from the view cell\0constant\0")) {
    options.radius = radius == 1 ? DdocOptions::Radius::kConstant : DdocOptions::Radius::kViewCell;
    changed = true;
  }
  const auto slider = [&](const char* label, float& value, float least, float most, const char* format) {
    changed |= ImGui::SliderFloat(label, &value, least, most, format, ImGuiSliderFlags_AlwaysClamp);
  };
  if (options.radius == DdocOptions::Radius::kConstant) {
    slider("pixels", options.constantRadiusPixels, 0, 60, "%.0f");
  } else {
    slider("most hidden", options.mostHiddenPixels, 0, 150, "%.0f pixels");
  }
  if (!ImGui::TreeNodeEx("more", ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
    return changed;
  }
  slider("safety", options.safetyFactor, 0.1f, 3, "%.2f");
  slider("room", options.roomPerHidden, 0.05f, 3, "%.2f per hidden");
  slider("smoothing", options.smoothingSigmaPixels, 0, 8, "%.1f pixels");
  changed |= ImGui::SliderInt("feedback", &options.feedbackRounds, 0, 8, "%d rounds", ImGuiSliderFlags_AlwaysClamp);
  return changed;
}

bool drawCell(CellOptions& options) {
  bool changed =
      ImGui::SliderFloat("samples", &options.mostSamples, 1, 4, "at most %.2f x", ImGuiSliderFlags_AlwaysClamp);
  changed |= ImGui::SliderInt("satellites", &options.mostSatellites, 0, 64, "at most %d", ImGuiSliderFlags_AlwaysClamp);
  return changed;
}

}  // namespace

bool drawCameraForm(CameraChoice& camera, float valueWidth) {
  ImGui::PushItemWidth(valueWidth);
  bool changed = takesCell(camera.model) && drawCellSide(camera);
  if (camera.model == Model::kEoc) {
    changed |= drawSegment(camera);
  }
  if (camera.model == Model::kDdoc) {
    changed |= drawDdoc(camera.ddoc);
  }
  if (camera.model == Model::kCell) {
    changed |= drawCell(camera.cell);
  }
  ImGui::PopItemWidth();
  return changed;
}

}  // namespace ocelli
