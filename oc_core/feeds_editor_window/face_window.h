// The window of `ocelli feeds edit`: the plan of the place, in which near faces are drawn, beside the image that they
// give. It draws into a framebuffer, and knows neither where events come from nor who shows it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/feeds_editor_window/face_keys.h"
#include "oc_core/feeds_editor_window/face_plan.h"
#include "oc_core/feeds_editor_window/face_preview.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {

struct FaceWindowOptions {
  std::string title = "Ocelli";
  std::vector<PlanWall> walls;
  std::vector<Image<Rgb8>> frames;  ///< one for each feed; empty where there is none
  /// Writes the setup, and returns what to say of it. May throw an Error, which is shown.
  std::function<std::string(const FeedSetup& setup)> save;
  std::string message;  ///< what it says at the beginning
};

class FaceWindow {
 public:
  /// Both must outlive it.
  FaceWindow(GlContext& context, FaceEditor& editor, FaceWindowOptions options);
  ~FaceWindow();

  /// A ResizeEvent first.
  void handle(const InputEvent& event);
  /// Whether something changed since the last draw().
  bool needsDrawing() const { return isChanged_ || gui_.hasWaitingEvents(); }
  /// Throws GlError.
  void draw(double secondsSinceLast);

  bool wantsClose() const { return isClosed_; }
  /// Once for each time that it is asked for.
  bool takeFullscreenWish();

  const GlObject& framebuffer() const { return framebuffer_; }
  int pixelWidth() const { return pixels_.x; }
  int pixelHeight() const { return pixels_.y; }
  Image<Rgb8> screenshot() const;
  /// Where a point of the plan, (x, z), is in the window: screen coordinates.
  glm::dvec2 windowFromPlan(const glm::dvec2& paper) const;
  /// The problem of what is drawn, or what else it says.
  const std::string& message() const { return message_; }

 private:
  void press(const KeyEvent& event);
  void pressButton(const PointerButtonEvent& event);
  void move(const PointerMoveEvent& event);
  void save();
  void close();
  void layOut();
  double reach() const;
  void drawPlan();
  void drawSide();
  void drawImage(float width, float scale);
  void drawBar();
  void drawHelp();

  GlContext& context_;
  FaceEditor& editor_;
  FaceWindowOptions options_;
  FacePreview preview_;
  FaceWindowState state_;
  GuiLayer gui_;
  GlObject color_;
  GlObject framebuffer_;
  ImageTexture texture_;
  glm::ivec2 pixels_{0};
  glm::ivec2 drawn_{0};   ///< the size of the framebuffer
  glm::ivec2 window_{0};  ///< screen coordinates
  std::optional<PlanWindow> plan_;
  glm::ivec2 planSize_{0};  ///< screen coordinates; it begins at the top left
  glm::dvec2 pointer_{0};
  bool isPanning_ = false;
  bool hasShift_ = false;
  bool isChanged_ = true;
  bool isClosed_ = false;
  FeedSetup saved_;
  bool hasWarned_ = false;  ///< that what is drawn is not saved
  std::string message_;
};

/// On the screen, until the user closes it. Throws GlError where there is no display. `goesOn` is asked again and
/// again, where given: false closes it.
void runFaceWindow(FaceEditor& editor, const FaceWindowOptions& options, const std::function<bool()>& goesOn = {});

}  // namespace ocelli
