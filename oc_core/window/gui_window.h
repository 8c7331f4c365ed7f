// What the windows of commands have in common: an image of the window's size with panels of Dear ImGui over it, and the
// wishes to close the window and to fill the screen. It knows neither where events come from nor who shows the image:
// runGuiWindow() does that on a screen.
//
//   window.handle(event);             // as they come; a ResizeEvent first
//   window.update(secondsSinceLast);
//   if (window.needsDrawing()) {
//     window.draw();                  // to target()
//   }
//
// A window derives from it, and says what events do, what is drawn, and what its keys change: a struct that derives
// from GuiWindowState.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/base/input_event.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/screen_target.h"

namespace ocelli {

/// What the keys of any such window change.
struct GuiWindowState {
  bool hasHelp = false;
  bool wantsFullscreen = false;  ///< wishes, until they are done
  bool wantsClose = false;

  /// What Escape does.
  void closeHelpOrWindow() {
    wantsClose = !hasHelp;
    hasHelp = false;
  }
};

class GuiWindow {
 public:
  /// `context` must outlive it. Throws GlError.
  explicit GuiWindow(GlContext& context) : context_(context), gui_(context, 1), target_(context) {}
  virtual ~GuiWindow() = default;
  GuiWindow(const GuiWindow&) = delete;
  GuiWindow& operator=(const GuiWindow&) = delete;

  void handle(const InputEvent& event);
  /// Call it again and again: it moves what moves by itself.
  void update(double seconds);
  /// The window has lost the keyboard: no key is held any more.
  virtual void loseFocus() {}

  /// Whether something changed since the last draw(). Never while the window has no pixels.
  bool needsDrawing() const;
  /// Throws GlError, and what paint() throws. Draws nothing while the window has no pixels.
  void draw();
  /// What draw() has drawn last.
  const ScreenTarget& target() const { return target_; }
  Image<Rgb8> screenshot() const;

  bool wantsClose() const { return wantsClose_; }
  /// Once for each time that it is asked for.
  bool takeFullscreenWish();
  virtual GuiWindowState& state() = 0;

 protected:
  /// An event that the panels see with the next draw().
  virtual void take(const InputEvent& event) = 0;
  virtual void advance(double /*seconds*/) {}
  /// Draws to target(), which is cleared, what is below the panels. A GlScope is held, here and below.
  virtual void paint() {}
  /// With the functions of Dear ImGui, within a frame of it.
  virtual void drawPanels() = 0;
  /// Whether the user may close it. Where not, it says why.
  virtual bool mayClose() { return true; }

  void requestDrawing() { isChanged_ = true; }
  GlContext& context() const { return context_; }
  const GuiLayer& gui() const { return gui_; }
  /// Screen coordinates for a length of 1 at 96 dots an inch.
  float lengthScale() const { return static_cast<float>(gui_.lengthScale()); }
  /// Of the window, screen coordinates.
  glm::ivec2 size() const { return {window_.width, window_.height}; }
  /// Of its image, rounded.
  glm::ivec2 pixels() const;
  double pixelsPerUnit() const { return window_.pixelsPerUnit; }

 private:
  GlContext& context_;
  GuiLayer gui_;
  ScreenTarget target_;
  ResizeEvent window_;
  bool isChanged_ = true;
  bool wantsClose_ = false;
  double sinceDrawn_ = 0;  ///< seconds
};

}  // namespace ocelli
