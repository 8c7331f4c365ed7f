#include "oc_core/remote_measure/path_film.h"

#include <cstring>

#include "oc_core/base/check.h"

namespace ocelli {

PathFilm::PathFilm(const RemoteScene& scene, const RemotePath& path, const glm::ivec2& screen, int samples,
                   const Progress& progress)
    : screen_(screen), framesPerSecond_(path.framesPerSecond), file_(std::make_unique<UnnamedFile>()) {
  const auto count = static_cast<double>(path.views.size());
  for (const View& view : path.views) {
    report(progress, "drawing what should be seen", static_cast<double>(frames_) / count);
    const RemotePlan plan{PinholeCamera(view, screen.x, screen.y), {.regions = {}}};
    add(srgbFromLinear(scene.draw(plan, samples).color));
  }
  file_->map();
}

PathFilm::PathFilm(const std::vector<Image<Rgb8>>& frames, double framesPerSecond)
    : screen_(frames.at(0).width(), frames.at(0).height()),
      framesPerSecond_(framesPerSecond),
      file_(std::make_unique<UnnamedFile>()) {
  for (const Image<Rgb8>& frame : frames) {
    add(frame);
  }
  file_->map();
}

void PathFilm::add(const Image<Rgb8>& frame) {
  static_assert(sizeof(Rgb8) == 3);
  OC_CHECK(frame.width() == screen_.x && frame.height() == screen_.y, "all frames of a film have one size");
  file_->append(std::as_bytes(std::span(frame.data(), frame.size())));
  ++frames_;
}

Image<Rgb8> PathFilm::frame(size_t index) const {
  OC_CHECK(index < frames_, "a film has this frame");
  Image<Rgb8> image(screen_.x, screen_.y);
  const size_t bytes = image.size() * sizeof(Rgb8);
  std::memcpy(reinterpret_cast<std::byte*>(image.data()), file_->map().subspan(index * bytes, bytes).data(), bytes);
  return image;
}

}  // namespace ocelli
