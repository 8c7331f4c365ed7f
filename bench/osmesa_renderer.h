// Renders a mesh with OpenGL through OSMesa (llvmpipe): the peer of our own rasteriser. Its vertices and triangles lie
// in buffer objects from the start; a frame is drawn and its colours and depths are read back.
#pragma once

#include <memory>
#include <string>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class OsMesaRenderer {
 public:
  /// Throws WorkError where no context can be made. One at a time on a thread.
  OsMesaRenderer(const PinholeCamera& camera, const Mesh& mesh);
  ~OsMesaRenderer();
  OsMesaRenderer(const OsMesaRenderer&) = delete;
  OsMesaRenderer& operator=(const OsMesaRenderer&) = delete;

  /// What OpenGL calls itself.
  std::string name() const;
  void drawFrame();
  /// z of each pixel of the last frame, 0 where nothing is seen.
  Image<float> depths() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
