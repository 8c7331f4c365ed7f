// The images of instruction pages, drawn by the program itself: what the rows of the tasks have, and the keys.
#pragma once

#include <map>
#include <string>

#include "study/screen/scene_views.h"
#include "study/screen/study_canvas.h"
#include "study/task/controls.h"
#include "study/task/instruction_image.h"

namespace ocelli {

class InstructionImages {
 public:
  /// The context must outlive it.
  InstructionImages(GlContext& context, const Controls& controls) : context_(&context), controls_(controls) {}

  /// Nothing for an unknown name. Hold a GlScope. Throws GlError.
  void draw(StudyCanvas& canvas, const std::string& name, const PixelRect& place);

 private:
  struct View {
    GlObject texture;
    std::vector<glm::dvec2> marks;  ///< objects that are seen, pixels of the view
  };
  /// What is not text is not mirrored.
  void drawTaskImage(StudyCanvas& canvas, const std::string& name, const PixelRect& place);
  const View& viewOf(const InstructionImage& image, int width, int height);

  GlContext* context_;
  Controls controls_;
  std::map<std::string, View> views_;  ///< by name and size
};

}  // namespace ocelli
