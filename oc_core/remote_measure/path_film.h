// The pictures of a path: what should be seen at each of its frames. They are drawn once, kept in a file without a name,
// and encoded from there by the peers.
#pragma once

#include <memory>

#include "oc_core/base/progress.h"
#include "oc_core/image/png_file.h"
#include "oc_core/remote/remote_scene.h"
#include "oc_core/remote_measure/remote_path.h"
#include "oc_core/remote_measure/unnamed_file.h"

namespace ocelli {

class PathFilm {
 public:
  /// Each pixel is the mean of `samples` x `samples` rays, as in the images that a server sends. Takes 3 bytes a pixel
  /// and frame on disk.
  PathFilm(const RemoteScene& scene, const RemotePath& path, const glm::ivec2& screen, int samples,
           const Progress& progress = {});
  /// From frames that are there already: for tests.
  PathFilm(const std::vector<Image<Rgb8>>& frames, double framesPerSecond);

  size_t frames() const { return frames_; }
  const glm::ivec2& screen() const { return screen_; }
  double framesPerSecond() const { return framesPerSecond_; }
  Image<Rgb8> frame(size_t index) const;
  /// All of them as raw RGB, for other programs.
  std::string rawPath() const { return file_->path(); }

 private:
  void add(const Image<Rgb8>& frame);

  glm::ivec2 screen_;
  double framesPerSecond_;
  size_t frames_ = 0;
  std::unique_ptr<UnnamedFile> file_;
};

}  // namespace ocelli
