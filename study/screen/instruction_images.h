// The images of instruction pages, drawn by the program itself: trials of the block, what the rows of the tasks have,
// and the keys.
#pragma once

#include <map>
#include <string>

#include "study/screen/scene_views.h"
#include "study/screen/study_canvas.h"
#include "study/session/session_screen.h"
#include "study/task/controls.h"
#include "study/task/instruction_image.h"

namespace ocelli {

class InstructionImages {
 public:
  /// For trials on a screen of that size. The context must outlive it.
  InstructionImages(GlContext& context, const TrialScreen& screen, const Controls& controls)
      : context_(&context), screen_(screen), controls_(controls) {}

  /// The example or the image of the page, objects ringed. Nothing for an unknown name. Hold a GlScope. Throws GlError.
  void draw(StudyCanvas& canvas, const PageScreen& page, const PixelRect& place);

 private:
  struct View {
    GlObject texture;
    std::vector<glm::dvec2> marks;  ///< objects that are seen, pixels of the view
  };
  struct Example {
    PixelRect place{};  ///< that it was made for
    GlObject texture;
    PixelRect image{};  ///< in the middle of that place, with the shape of the trial's screen
    std::vector<std::pair<glm::dvec2, double>> marks;  ///< middles and radii, pixels of the image
  };
  /// What is not text is not mirrored.
  void drawTaskImage(StudyCanvas& canvas, const std::string& name, const PixelRect& place);
  const View& viewOf(const InstructionImage& image, int width, int height);
  const Example& exampleOf(const std::shared_ptr<const PageExample>& example, const PixelRect& place);
  void drawExample(StudyCanvas& canvas, const std::shared_ptr<const PageExample>& example, const PixelRect& place);

  GlContext* context_;
  TrialScreen screen_;
  Controls controls_;
  std::map<std::string, View> views_;  ///< by name and size
  std::map<std::shared_ptr<const PageExample>, Example> examples_;
};

}  // namespace ocelli
