// The window of `ocelli feeds run --window`: the graph camera's image as it is made, which feed shows what, and how old
// that is. It draws into a framebuffer, and knows neither where events come from nor who shows it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "oc_core/base/input_event.h"
#include "oc_core/feeds_window/feeds_keys.h"
#include "oc_core/feeds_window/feeds_screen.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {

class FeedsWindow {
 public:
  /// All must outlive it. Images are saved in `folder`.
  FeedsWindow(GlContext& context, const FeedGraph& graph, FeedsScreen& screen, std::filesystem::path folder);
  ~FeedsWindow();

  /// A ResizeEvent first.
  void handle(const InputEvent& event);
  /// Takes the newest image, and does what keys have asked for. Call it again and again.
  void update(double seconds);
  /// Whether something changed since the last draw().
  bool needsDrawing() const { return isChanged_ || gui_.hasWaitingEvents(); }
  /// Throws GlError.
  void draw();

  bool wantsClose() const { return state_.wantsClose; }
  /// Once for each time that it is asked for.
  bool takeFullscreenWish();
  FeedsWindowState& state() { return state_; }

  const GlObject& framebuffer() const { return framebuffer_; }
  int pixelWidth() const { return pixels_.x; }
  int pixelHeight() const { return pixels_.y; }
  Image<Rgb8> screenshot() const;
  /// The image with what is drawn over it, without panels, as large as it is shown; empty before the first one.
  Image<Rgb8> picture();
  /// Where the image stands in the window, pixels; of the last draw().
  const glm::ivec2& imageCorner() const { return corner_; }
  const glm::ivec2& imageSize() const { return size_; }
  /// "wrote feeds-001.png", and what else it says for some seconds.
  const std::string& message() const { return message_; }

 private:
  void press(const KeyEvent& event);
  void save();
  void say(const std::string& message);
  void layOut(float barHeight);
  void drawFrame(bool hasPanels);
  float barHeight() const;
  void drawBar(float height);
  void drawLabels();
  void drawOutlines();
  void drawHelp();

  GlContext& context_;
  const FeedGraph& graph_;
  FeedsScreen& screen_;
  std::filesystem::path folder_;
  FeedsWindowState state_;
  GuiLayer gui_;
  GlObject color_;
  GlObject framebuffer_;
  ImageTexture texture_;
  std::optional<ShownFeeds> shown_;
  glm::ivec2 pixels_{0};
  glm::ivec2 drawn_{0};   ///< the size of the framebuffer
  glm::ivec2 window_{0};  ///< screen coordinates
  glm::ivec2 corner_{0};
  glm::ivec2 size_{0};
  double pixelsPerUnit_ = 1;
  bool isChanged_ = true;
  bool isUploaded_ = false;
  bool wasEnded_ = false;
  double sinceDrawn_ = 0;
  double sinceImage_ = 0;
  double imageSeconds_ = 0;  ///< from one image to the next, smoothed; 0: not known
  std::string message_;
  double messageLeft_ = 0;
};

struct FeedsWindowOptions {
  std::string title = "Ocelli";
  std::filesystem::path folder = ".";  ///< for saved images
  bool isLive = false;
  bool hasRedErased = false;  ///< at the beginning, as the next one
  bool hasLabels = true;
  /// Asked again and again, where given: false closes the window.
  std::function<bool()> goesOn = {};
};

/// On the screen, until the user closes it. `run` is called on a thread of its own and gives its images to the screen;
/// it ends soon after the screen is closed. Where it throws, the window is closed, and that is thrown. Throws GlError
/// where there is no display, before `run` is called.
void runFeedsWindow(const FeedGraph& graph, const FeedsWindowOptions& options,
                    const std::function<void(FeedsScreen& screen)>& run);

}  // namespace ocelli
