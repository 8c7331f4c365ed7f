// The window of `ocelli sea view`: what is seen from any place of a sea of images, and a map of the places.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "oc_core/sea_window/sea_keys.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {

class SeaWindow final : public GuiWindow {
 public:
  /// Both must outlive it. `woken` is called on another thread when an image is there. `waits`: every picture is
  /// complete, whatever time it takes, as for pictures of the window.
  SeaWindow(GlContext& context, const SeaFile& sea, std::function<void()> woken = {}, bool waits = false);

  SeaVisit& visit() { return visit_; }
  SeaWindowState& state() override { return state_; }
  void loseFocus() override { held_.clear(); }

 private:
  struct MapSight;

  void take(const InputEvent& event) override;
  /// Walks on while keys are held.
  void advance(double seconds) override;
  /// Throws what decoding throws, and GlError.
  void paint() override;
  void drawPanels() override;
  void press(const KeyEvent& event);
  void drawMap();
  void drawStatus();
  void drawHelp();

  const SeaFile& sea_;
  SeaVisit visit_;
  bool waits_;
  SeaWindowState state_;
  ImageTexture picture_;
  std::set<Key> held_;
  bool isFast_ = false;  ///< Shift is held
  bool wasComplete_ = false;
  glm::dvec2 pointer_{0};
  std::optional<glm::dvec2> dragged_;  ///< where the pointer was, while it turns the view
};

/// On the screen, until the user closes it. `goesOn` is asked again and again, where given: false closes it. Throws
/// GlError where there is no display, and what the images cannot be read for.
void runSeaWindow(const SeaFile& sea, const std::string& title, const std::function<bool()>& goesOn = {});

/// A picture of the window without a screen, from that place, looking there (radians).
Image<Rgb8> pictureOfSeaWindow(GlContext& context, const SeaFile& sea, const glm::ivec2& size,
                               const std::optional<glm::dvec3>& place, double yaw, bool help);

}  // namespace ocelli
