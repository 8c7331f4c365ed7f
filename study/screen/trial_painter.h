// The layouts of a trial as images, without a window: for replays and for renderers of simulated subjects.
//
// The same context and the same layout give the same bytes; another renderer may differ at silhouettes and in the
// rounding of colours. The hashes that a session stores of its frames are pixelHashOf(renderViews()) (trial_image.h),
// so they compare within a renderer.
#pragma once

#include <memory>

#include "oc_core/gl/gl_context.h"
#include "oc_core/image/png_file.h"
#include "study/task/trial_layout.h"

namespace ocelli {

class TrialPainter {
 public:
  /// The context must outlive it. Throws GlError.
  TrialPainter(GlContext& context, const TrialScreen& screen);
  ~TrialPainter();
  TrialPainter(const TrialPainter&) = delete;
  TrialPainter& operator=(const TrialPainter&) = delete;

  /// The whole screen, as a subject sees it, without the patch of a photodiode. Throws GlError.
  Image<Rgb8> render(const TrialLayout& layout);
  /// The views alone, in their places, black elsewhere.
  Image<Rgb8> renderViews(const TrialLayout& layout);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One layout alone; a TrialPainter is faster for many.
Image<Rgb8> renderTrialImage(GlContext& context, const TrialLayout& layout, const TrialScreen& screen);

}  // namespace ocelli
