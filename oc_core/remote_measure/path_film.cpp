#include "oc_core/remote_measure/path_film.h"

#include <algorithm>
#include <cstring>

#include "oc_core/base/check.h"

namespace ocelli {

PathFilm::PathFilm(const glm::ivec2& screen, double framesPerSecond, size_t frames)
    : screen_(screen), framesPerSecond_(framesPerSecond), drawn_(frames), file_(std::make_unique<UnnamedFile>()) {
  file_->resize(frames * frameBytes());
  file_->map();
}

PathFilm::PathFilm(const RemoteScene& scene, const RemotePath& path, const glm::ivec2& screen, int samples)
    : PathFilm(screen, path.framesPerSecond, path.views.size()) {
  scene_ = &scene;
  views_ = path.views;
  samples_ = samples;
}

PathFilm::PathFilm(const std::vector<Image<Rgb8>>& frames, double framesPerSecond)
    : PathFilm({frames.at(0).width(), frames.at(0).height()}, framesPerSecond, frames.size()) {
  for (size_t i = 0; i < frames.size(); ++i) {
    store(i, frames[i]);
  }
}

size_t PathFilm::frameBytes() const {
  static_assert(sizeof(Rgb8) == 3);
  return static_cast<size_t>(screen_.x) * static_cast<size_t>(screen_.y) * sizeof(Rgb8);
}

void PathFilm::draw(size_t index) const {
  const RemotePlan plan{PinholeCamera(views_[index], screen_.x, screen_.y), {.regions = {}}};
  store(index, srgbFromLinear(scene_->draw(plan, samples_).color));
}

void PathFilm::store(size_t index, const Image<Rgb8>& frame) const {
  OC_CHECK(frame.width() == screen_.x && frame.height() == screen_.y, "all frames of a film have one size");
  file_->writeAt(index * frameBytes(), std::as_bytes(std::span(frame.data(), frame.size())));
  drawn_[index] = 1;
}

Image<Rgb8> PathFilm::frame(size_t index) const {
  OC_CHECK(index < drawn_.size(), "a film has this frame");
  if (drawn_[index] == 0) {
    draw(index);
  }
  Image<Rgb8> image(screen_.x, screen_.y);
  std::memcpy(reinterpret_cast<std::byte*>(image.data()),
              file_->map().subspan(index * frameBytes(), frameBytes()).data(), frameBytes());
  return image;
}

void PathFilm::complete(const Progress& progress) const {
  for (size_t i = 0; i < drawn_.size(); ++i) {
    report(progress, "drawing all frames", static_cast<double>(i) / static_cast<double>(drawn_.size()));
    if (drawn_[i] == 0) {
      draw(i);
    }
  }
}

std::string PathFilm::rawPath() const {
  OC_CHECK(std::find(drawn_.begin(), drawn_.end(), uint8_t{0}) == drawn_.end(), "all frames of the film are there");
  return file_->path();
}

}  // namespace ocelli
