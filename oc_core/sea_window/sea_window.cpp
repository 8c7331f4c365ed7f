#include "oc_core/sea_window/sea_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/window/gui_help.h"
#include "oc_core/window/gui_window_run.h"

namespace ocelli {
namespace {

/// Pictures are drawn on the CPU: not more pixels than that many.
constexpr double kMaxPicturePixels = 640.0 * 400.0;
constexpr double kTurnPerWindow = radiansFromDegrees(90);  ///< of a drag across its height
constexpr double kFast = 4;                                ///< with Shift
constexpr float kMapSide = 240;                            ///< screen coordinates at 96 dots an inch
constexpr float kMapRim = 12;

ImVec2 mapPoint(const glm::vec2& p) {
  return {p.x, p.y};
}

}  // namespace

/// Where the places stand in the window: x to the right, z downwards.
struct SeaWindow::MapSight {
  MapSight(const std::vector<glm::dvec3>& positions, const glm::vec2& corner, float side) {
    glm::dvec2 lower(positions[0].x, positions[0].z);
    glm::dvec2 upper = lower;
    for (const glm::dvec3& position : positions) {
      lower = glm::min(lower, glm::dvec2(position.x, position.z));
      upper = glm::max(upper, glm::dvec2(position.x, position.z));
    }
    const glm::dvec2 extent = upper - lower;
    perMetre = (side - 2 * kMapRim) / std::max({extent.x, extent.y, 1e-9});
    middle = (lower + upper) * 0.5;
    center = glm::dvec2(corner) + static_cast<double>(side) / 2;
  }

  glm::vec2 at(const glm::dvec3& place) const {
    return glm::vec2(center + (glm::dvec2(place.x, place.z) - middle) * perMetre);
  }
  glm::dvec3 placeAt(const glm::dvec2& point, double height) const {
    const glm::dvec2 place = (point - center) / perMetre + middle;
    return {place.x, height, place.y};
  }

  glm::dvec2 middle{0};
  glm::dvec2 center{0};
  double perMetre = 1;
};

SeaWindow::SeaWindow(GlContext& context, const SeaFile& sea, std::function<void()> woken, bool waits)
    : GuiWindow(context), sea_(sea), visit_(sea, std::move(woken)), waits_(waits) {}

void SeaWindow::press(const KeyEvent& event) {
  if (!event.pressed) {
    held_.erase(event.key);
    return;
  }
  for (const SeaHeldKey& row : seaHeldKeys()) {
    if (std::ranges::find(row.keys, event.key) != row.keys.end()) {
      held_.insert(event.key);
    }
  }
  for (const SeaKeyAction& row : seaKeyActions()) {
    if (std::ranges::find(row.keys, event.key) != row.keys.end()) {
      row.act(visit_, state_);
    }
  }
}

void SeaWindow::take(const InputEvent& event) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    isFast_ = key->modifiers.shift;
    press(*key);
  } else if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    if (button->button == PointerButton::kLeft && !button->pressed) {
      dragged_.reset();
    } else if (button->button == PointerButton::kLeft && !gui().wantsPointer()) {
      dragged_ = pointer_;
    }
  } else if (const auto* moved = std::get_if<PointerMoveEvent>(&event)) {
    pointer_ = {moved->x, moved->y};
    if (dragged_) {
      const glm::dvec2 way = (pointer_ - *dragged_) / static_cast<double>(std::max(1, size().y));
      visit_.turn(way.x * kTurnPerWindow, way.y * kTurnPerWindow);
      dragged_ = pointer_;
    }
  } else if (const auto* scrolled = std::get_if<ScrollEvent>(&event)) {
    visit_.zoom(scrolled->up);
  }
}

void SeaWindow::advance(double seconds) {
  const double amount = seconds * (isFast_ ? kFast : 1);
  for (const SeaHeldKey& row : seaHeldKeys()) {
    if (std::ranges::any_of(row.keys, [&](Key key) { return held_.contains(key); })) {
      row.move(visit_, amount);
    }
  }
  // Once more where it has just become complete: Dear ImGui sizes the line of status by the frame before.
  if (!std::exchange(wasComplete_, visit_.isComplete()) || !visit_.isComplete()) {
    requestDrawing();
  }
}

void SeaWindow::paint() {
  const glm::dvec2 all(pixels());
  const double share = std::min(1.0, std::sqrt(kMaxPicturePixels / (all.x * all.y)));
  const auto side = [&](double of) { return std::max(16, static_cast<int>(std::lround(of * share))); };
  picture_.upload(context(), visit_.picture(side(all.x), side(all.y), waits_));
  picture_.copyTo(context(), target().framebuffer(), {0, 0}, pixels());
}

void SeaWindow::drawPanels() {
  if (state_.hasMap) {
    drawMap();
  }
  drawStatus();
  if (state_.hasHelp) {
    drawHelp();
  }
}

void SeaWindow::drawMap() {
  const float scale = lengthScale();
  const float side = kMapSide * scale;
  const glm::vec2 corner(static_cast<float>(size().x) - side - kMapRim * scale, kMapRim * scale);
  ImGui::SetNextWindowPos(mapPoint(corner));
  ImGui::SetNextWindowSize({side, side});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::Begin("map", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  const MapSight sight(visit_.positions(), corner, side);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float dot = std::clamp(static_cast<float>(0.3 * visit_.spacing() * sight.perMetre), 0.5f * scale, 2.5f * scale);
  for (const glm::dvec3& position : visit_.positions()) {
    const glm::vec2 at = sight.at(position);
    list.AddRectFilled(mapPoint(at - dot), mapPoint(at + dot), kGuiTextDim.packed(160));
  }
  for (const SeaNeighbor& neighbor : visit_.neighbors()) {
    const glm::vec2 at = sight.at(visit_.positions()[neighbor.image]);
    list.AddRect(mapPoint(at - 4.0f * scale), mapPoint(at + 4.0f * scale), kOkabeItoOrange.packed(), 0, 0,
                 1.5f * scale);
  }
  const glm::vec2 here = sight.at(visit_.place());
  const double half = 0.5 * visit_.fovVertical() * size().x / std::max(1, size().y);
  const auto edge = [&](double turn) {
    const double angle = visit_.yaw() + turn;
    return here + glm::vec2(-std::sin(angle), -std::cos(angle)) * (34 * scale);
  };
  list.AddTriangleFilled(mapPoint(here), mapPoint(edge(half)), mapPoint(edge(-half)), kGuiAccent.packed(110));
  list.AddCircleFilled(mapPoint(here), 4 * scale, kGuiText.packed());
  if (ImGui::IsWindowHovered() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    const ImVec2 mouse = ImGui::GetMousePos();
    visit_.goTo(sight.placeAt({mouse.x, mouse.y}, visit_.place().y));
    requestDrawing();
  }
  ImGui::End();
}

void SeaWindow::drawStatus() {
  const float scale = lengthScale();
  ImGui::SetNextWindowPos({kMapRim * scale, static_cast<float>(size().y) - kMapRim * scale}, 0, {0, 1});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::Begin("status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
  const glm::dvec3& place = visit_.place();
  ImGui::TextUnformatted(fmt::format("image {} of {}   {:.2f}, {:.2f}, {:.2f}   H: help{}", visit_.nearest() + 1,
                                     sea_.count(), place.x, place.y, place.z,
                                     visit_.isComplete() ? "" : "   decoding ...")
                             .c_str());
  ImGui::End();
}

void SeaWindow::drawHelp() {
  GuiHelp help(size(), lengthScale(), 520, 150, "A sea of images: walk between them");
  help.rows(seaPointerLines(), seaHeldKeys(), seaKeyActions());
  ImGui::PushStyleColor(ImGuiCol_Text, kGuiTextDim.packed());
  ImGui::TextWrapped(
      "On the map a disc is where you are, its wedge what you see, and squares are the images that are blended.");
  ImGui::PopStyleColor();
}

void runSeaWindow(const SeaFile& sea, const std::string& title, const std::function<bool()>& goesOn) {
  GlWindow window({.title = title, .width = 1280, .height = 800});
  SeaWindow shown(window.context(), sea, [] { GlWindow::wake(); });
  runGuiWindow(window, shown, goesOn);
}

Image<Rgb8> pictureOfSeaWindow(GlContext& context, const SeaFile& sea, const glm::ivec2& size,
                               const std::optional<glm::dvec3>& place, double yaw, bool help) {
  SeaWindow window(context, sea, {}, true);
  window.handle(ResizeEvent{size.x, size.y, 1, 1});
  if (place) {
    window.visit().goTo(*place);
  }
  window.visit().turn(yaw - window.visit().yaw(), 0);
  window.state().hasHelp = help;
  window.draw();
  window.draw();  // Dear ImGui knows the sizes of its windows from the frame before
  return window.screenshot();
}

}  // namespace ocelli
