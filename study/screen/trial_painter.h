// The pictures of a trial as images, without a window: for replays, and for whoever wants to see them.
//
// The same context and the same picture give the same bytes; another renderer may differ at silhouettes and in the
// rounding of colours. Hashes of images therefore compare within a renderer.
#pragma once

#include <cstdint>
#include <memory>

#include "oc_core/base/png_file.h"
#include "oc_core/gl/gl_context.h"
#include "study/task/trial_picture.h"

namespace ocelli {

class TrialPainter {
 public:
  /// The context must outlive it. Throws GlError.
  TrialPainter(GlContext& context, const TrialScreen& screen);
  ~TrialPainter();
  TrialPainter(const TrialPainter&) = delete;
  TrialPainter& operator=(const TrialPainter&) = delete;

  /// The whole screen, as a subject sees it, without the patch of a photodiode. Throws GlError.
  Image<Rgb8> render(const TrialPicture& picture);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One picture alone; a TrialPainter is faster for many.
Image<Rgb8> renderTrialPicture(GlContext& context, const TrialPicture& picture, const TrialScreen& screen);

/// The first 64 bits of the SHA-256 of its bytes.
uint64_t pixelHashOf(const Image<Rgb8>& image);

}  // namespace ocelli
