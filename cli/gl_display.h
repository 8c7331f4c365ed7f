// `--method gl` of the commands that slice and observe.
#pragma once

#include <memory>
#include <string>

#include "display_sim/observing/observe_series.h"
#include "display_sim/slicing/exact_slicer.h"

namespace ocelli {

class GlDisplay {
 public:
  /// `provider` is what --gl says. Throws InputError where this program was built without OpenGL, GlError where no
  /// context can be opened.
  explicit GlDisplay(const std::string& provider);
  ~GlDisplay();
  GlDisplay(const GlDisplay&) = delete;
  GlDisplay& operator=(const GlDisplay&) = delete;

  /// As the slice() of the CPU. Throws InputError for what the GPU does not do and GlError where it has
  /// no room, here and below.
  Volume slice(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options);
  /// As collectLight() of this volume, which is copied to the GPU now. Must not outlive this display.
  CollectLight observerOf(const Volume& volume);
  /// "OpenGL on llvmpipe, through EGL".
  std::string description() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
