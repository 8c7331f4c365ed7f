// The window of `ocelli feeds run --window`: the graph camera's image as it is made, which feed shows what, and how old
// that is.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "oc_core/feeds_window/feeds_keys.h"
#include "oc_core/feeds_window/feeds_screen.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {

class FeedsWindow final : public GuiWindow {
 public:
  /// All must outlive it. Images are saved in `folder`.
  FeedsWindow(GlContext& context, const FeedGraph& graph, FeedsScreen& screen, std::filesystem::path folder);

  FeedsWindowState& state() override { return state_; }
  /// The image with what is drawn over it, without panels, as large as it is shown; empty before the first one.
  Image<Rgb8> picture();
  /// Where the image stands in the window, pixels; of the last draw().
  const glm::ivec2& imageCorner() const { return corner_; }
  const glm::ivec2& imageSize() const { return imageSize_; }
  /// "wrote feeds-001.png", and what else it says for some seconds.
  const std::string& message() const { return message_; }

 private:
  void take(const InputEvent& event) override;
  /// Takes the newest image, and does what keys have asked for.
  void advance(double seconds) override;
  void paint() override;
  void drawPanels() override;
  void save();
  void say(const std::string& message);
  void layOut(float barHeight);
  float barHeight() const;
  void drawBar(float height);
  void drawLabels();
  void drawOutlines();
  void drawHelp();

  const FeedGraph& graph_;
  FeedsScreen& screen_;
  std::filesystem::path folder_;
  FeedsWindowState state_;
  ImageTexture texture_;
  std::optional<ShownFeeds> shown_;
  glm::ivec2 corner_{0};
  glm::ivec2 imageSize_{0};
  bool isUploaded_ = false;
  bool isBare_ = false;  ///< the next draw() leaves the panels away
  bool wasEnded_ = false;
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
