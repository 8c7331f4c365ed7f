// The window of `ocelli sea view`: what is seen from any place of a sea of images, and a map of the places. It draws
// into a framebuffer, and knows neither where events come from nor who shows it.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "oc_core/base/input_event.h"
#include "oc_core/sea/sea_visit.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {

class SeaWindow {
 public:
  /// Both must outlive it. `woken` is called on another thread when an image is there. `waits`: every picture is
  /// complete, whatever time it takes, as for pictures of the window.
  SeaWindow(GlContext& context, const SeaFile& sea, std::function<void()> woken = {}, bool waits = false);
  ~SeaWindow();

  SeaVisit& visit() { return visit_; }
  /// A ResizeEvent first.
  void handle(const InputEvent& event);
  /// Walks on while keys are held.
  void update(double seconds);
  /// Whether something changed since the last draw().
  bool needsDrawing() const { return isChanged_ || !visit_.isComplete() || gui_.hasWaitingEvents(); }
  /// Throws what decoding throws, and GlError.
  void draw();

  /// The window has lost the keyboard: no key is held any more.
  void loseFocus() { held_.clear(); }
  bool wantsClose() const { return wantsClose_; }
  /// Once for each time that it is asked for.
  bool takeFullscreenWish();
  void showHelp(bool shown) { help_ = shown; }

  const GlObject& framebuffer() const { return framebuffer_; }
  int pixelWidth() const { return pixels_.x; }
  int pixelHeight() const { return pixels_.y; }
  Image<Rgb8> screenshot() const;

 private:
  struct MapSight;

  void press(const KeyEvent& event);
  void drawPanels();
  void drawMap();
  void drawStatus();
  void drawHelp();

  GlContext& context_;
  const SeaFile& sea_;
  SeaVisit visit_;
  bool waits_;
  GuiLayer gui_;
  GlObject color_;
  GlObject framebuffer_;
  ImageTexture picture_;
  glm::ivec2 pixels_{0};
  glm::ivec2 drawn_{0};  ///< the size of the framebuffer
  glm::ivec2 size_{0};   ///< screen coordinates
  std::set<Key> held_;
  bool isFast_ = false;  ///< Shift is held
  glm::dvec2 pointer_{0};
  std::optional<glm::dvec2> dragged_;  ///< where the pointer was, while it turns the view
  bool help_ = false;
  bool map_ = true;
  bool isChanged_ = true;
  bool wantsClose_ = false;
  bool wantsFullscreen_ = false;
  double sinceDrawn_ = 0;
};

/// On the screen, until the user closes it. `goesOn` is asked again and again, where given: false closes it. Throws
/// GlError where there is no display, and what the images cannot be read for.
void runSeaWindow(const SeaFile& sea, const std::string& title, const std::function<bool()>& goesOn = {});

/// A picture of the window without a screen, from that place, looking there (radians).
Image<Rgb8> pictureOfSeaWindow(GlContext& context, const SeaFile& sea, const glm::ivec2& size,
                               const std::optional<glm::dvec3>& place, double yaw, bool help);

}  // namespace ocelli
