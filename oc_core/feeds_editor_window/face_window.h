// The window of `ocelli feeds edit`: the plan of the place, in which near faces are drawn, beside the image that they
// give.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/feeds_editor_window/face_keys.h"
#include "oc_core/feeds_editor_window/face_plan.h"
#include "oc_core/feeds_editor_window/face_preview.h"
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

class FaceWindow final : public GuiWindow {
 public:
  /// Both must outlive it.
  FaceWindow(GlContext& context, FaceEditor& editor, FaceWindowOptions options);

  FaceWindowState& state() override { return state_; }
  /// Where a point of the plan, (x, z), is in the window: screen coordinates.
  glm::dvec2 windowFromPlan(const glm::dvec2& paper) const;
  /// The problem of what is drawn, or what else it says.
  const std::string& message() const { return message_; }

 private:
  void take(const InputEvent& event) override;
  void paint() override;
  void drawPanels() override;
  bool mayClose() override;
  void press(const KeyEvent& event);
  void pressButton(const PointerButtonEvent& event);
  void move(const PointerMoveEvent& event);
  void save();
  void layOut();
  double reach() const;
  void drawPlan();
  void drawSide();
  void drawImage(float width, float scale);
  void drawBar();
  void drawHelp();

  FaceEditor& editor_;
  FaceWindowOptions options_;
  FacePreview preview_;
  FaceWindowState state_;
  ImageTexture texture_;
  std::optional<PlanWindow> plan_;
  glm::ivec2 planSize_{0};  ///< screen coordinates; it begins at the top left
  glm::dvec2 pointer_{0};
  bool isPanning_ = false;
  bool hasShift_ = false;
  FeedSetup saved_;
  bool hasWarned_ = false;  ///< that what is drawn is not saved
  std::string message_;
};

/// On the screen, until the user closes it. Throws GlError where there is no display. `goesOn` is asked again and
/// again, where given: false closes it.
void runFaceWindow(FaceEditor& editor, const FaceWindowOptions& options, const std::function<bool()>& goesOn = {});

}  // namespace ocelli
