// The pictures of a path: what should be seen at each of its frames. Each is drawn when it is first asked for, and kept
// in a file without a name, from which the peers encode them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/image/png_file.h"
#include "oc_core/remote/remote_scene.h"
#include "oc_core/remote_measure/remote_path.h"
#include "oc_core/remote_measure/unnamed_file.h"

namespace ocelli {

class PathFilm {
 public:
  /// Each pixel is the mean of `samples` x `samples` rays. Takes 3 bytes a pixel and frame on disk. The scene must
  /// outlive it.
  PathFilm(const RemoteScene& scene, const RemotePath& path, const glm::ivec2& screen, int samples);
  /// Of frames that are there already: for tests.
  PathFilm(const std::vector<Image<Rgb8>>& frames, double framesPerSecond);

  size_t frames() const { return drawn_.size(); }
  const glm::ivec2& screen() const { return screen_; }
  double framesPerSecond() const { return framesPerSecond_; }
  Image<Rgb8> frame(size_t index) const;
  /// Draws all that were not asked for yet.
  void complete(const Progress& progress) const;
  /// All of them as raw RGB, for other programs. OC_CHECKs that it is complete.
  std::string rawPath() const;

 private:
  PathFilm(const glm::ivec2& screen, double framesPerSecond, size_t frames);
  size_t frameBytes() const;
  void draw(size_t index) const;
  void store(size_t index, const Image<Rgb8>& frame) const;

  glm::ivec2 screen_;
  double framesPerSecond_;
  mutable std::vector<uint8_t> drawn_;  ///< whether each frame is in the file
  std::unique_ptr<UnnamedFile> file_;
  const RemoteScene* scene_ = nullptr;
  std::vector<View> views_;
  int samples_ = 1;
};

}  // namespace ocelli
