// The window of `ocelli explore`: panes, the choice of cameras, states, options and help over something that explores.
// It takes input events and draws an image of a window; it knows neither windows nor scripts.
//
//   ExploreWindow window(context, options);
//   window.handle(event);             // as they come; a ResizeEvent first
//   window.update(secondsSinceLast);
//   window.draw();                    // to target()
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/explore_window/explore_gamepad.h"
#include "oc_core/explore_window/explore_layout.h"
#include "oc_core/explore_window/explore_pane.h"
#include "oc_core/gl/gl_context.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/screen_target.h"

namespace ocelli {

struct ExploreWindowOptions {
  ExploreWindowWork::Make make;
  ExploreWindowWork::Way way = ExploreWindowWork::Way::kThread;
  std::filesystem::path folder = ".";  ///< where images, cameras and videos are saved
  bool showTimes = true;               ///< figures that differ from run to run
  std::function<void()> woken{};       ///< as of ExploreWindowWork
};

class ExploreWindow {
 public:
  ExploreWindow(GlContext& context, ExploreWindowOptions options);
  ExploreWindow(const ExploreWindow&) = delete;
  ExploreWindow& operator=(const ExploreWindow&) = delete;

  void handle(const InputEvent& event);
  /// What it shows now; nothing where there is none.
  void handleGamepad(const std::optional<GamepadState>& state);
  /// Nothing is held any more, and the mouse is free: the window has lost the keyboard.
  void loseFocus();
  /// What is held besides keys, from now on: scripts walk so.
  void hold(const WindowMotion& motion) { heldByOthers_ = motion; }

  /// Takes over what has been drawn meanwhile. With kStepwise draws it. Throws what the scene could not be read for.
  void update(double seconds);
  /// Throws GlError.
  void draw();

  /// What draw() has drawn last.
  const ScreenTarget& target() const { return target_; }
  Image<Rgb8> screenshot() const;

  ExploreWindowState& state() { return state_; }
  const ExploreWindowState& state() const { return state_; }
  ExploreWindowWork& work() { return work_; }
  /// The newest; null until there is one.
  const WindowPicture* picture() const { return status_.picture.get(); }
  ExploreWindowLayout layout() const;

  /// Shows a message for a while; an error stays until Escape.
  void say(const std::string& text, bool isError);
  bool wantsClose() const { return wishes_.close; }
  /// What the window that shows this should do, once each.
  bool takeFullscreenWish() { return std::exchange(wishes_.fullscreen, false); }
  /// Begins or ends a recording.
  bool takeRecordWish() { return std::exchange(wishes_.record, false); }
  /// Whether another frame would look different.
  bool needsDrawing() const { return needsDrawing_; }
  /// Whether something moves, so that events and pictures come often.
  bool isLively() const;
  /// Whether events still wait for a frame of the panels.
  bool hasWaitingEvents() const { return gui_.hasWaitingEvents(); }

 private:
  void handleKey(const KeyEvent& event);
  /// Whether a pane has used it.
  bool handlePointer(const InputEvent& event);
  void press(const ExploreKeyAction& action);
  ExploreKeyTarget keyTarget();
  ExplorePaneFrame frameOf(const ExploreWindowLayout::Pane& pane);
  std::vector<size_t> shownKinds() const;
  WindowMotion motion() const;
  WindowShape shape();
  void takeStatus();
  void performWishes();
  void saveImage();
  void saveCamera();
  float lengthScale() const { return static_cast<float>(gui_.lengthScale()); }

  GlContext& context_;
  ExploreWindowOptions options_;
  ExploreWindowState state_;
  ExploreWindowWork work_;
  ExploreWindowStatus status_;
  ExploreWindowWishes wishes_;
  ExploreGamepad gamepad_;
  GuiLayer gui_;
  std::vector<std::unique_ptr<ExplorePane>> panes_;  ///< as explorePanes()
  ScreenTarget target_;
  ResizeEvent window_;
  glm::vec2 pointer_{-1};
  size_t pressedPane_ = 0;  ///< that a button was pressed in
  bool isPressed_ = false;
  std::array<bool, kKeyCount> held_{};
  bool shift_ = false;
  WindowMotion padMotion_;
  WindowMotion heldByOthers_;
  bool isFresh_ = false;
  bool needsDrawing_ = true;
  bool needsAnother_ = true;   ///< a frame after the next, which panels need that have just opened
  double seconds_ = 0;         ///< since the last frame was drawn
  double secondsOfFrame_ = 0;  ///< smoothed, between pictures
  double sincePicture_ = 0;
};

}  // namespace ocelli
