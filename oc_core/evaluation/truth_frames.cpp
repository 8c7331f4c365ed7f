#include "oc_core/evaluation/truth_frames.h"

namespace ocelli {

TruthFrames::TruthFrames(const Mesh& scene, std::vector<PinholeCamera> cameras, size_t maxBytes)
    : TruthFrames([&scene](const PinholeCamera& camera) { return renderFrame(camera, scene); }, std::move(cameras),
                  maxBytes) {}

TruthFrames::TruthFrames(RenderFrame render, std::vector<PinholeCamera> cameras, size_t maxBytes)
    : render_(std::move(render)), cameras_(std::move(cameras)), maxBytes_(maxBytes), frames_(cameras_.size()) {}

std::shared_ptr<const ViewFrame> TruthFrames::frame(size_t index) {
  {
    const std::scoped_lock lock(mutex_);
    if (frames_[index]) {
      return frames_[index];
    }
  }
  // Without the lock: a thread that waits for its part of an image may be given another viewpoint meanwhile.
  auto frame = std::make_shared<const ViewFrame>(render_(cameras_[index]));
  const size_t bytes = frame->points.size() * (sizeof(glm::vec4) + sizeof(Rgb8));
  const std::scoped_lock lock(mutex_);
  if (!frames_[index] && bytes_ + bytes <= maxBytes_) {
    bytes_ += bytes;
    ++kept_;
    frames_[index] = frame;
  }
  return frame;
}

}  // namespace ocelli
