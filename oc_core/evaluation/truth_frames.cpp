#include "oc_core/evaluation/truth_frames.h"

namespace ocelli {

TruthFrames::TruthFrames(const Mesh& scene, std::vector<PinholeCamera> cameras, size_t mostBytes)
    : scene_(scene), cameras_(std::move(cameras)), mostBytes_(mostBytes), frames_(cameras_.size()) {}

std::shared_ptr<const ViewFrame> TruthFrames::frame(size_t index) {
  if (frames_[index]) {
    return frames_[index];
  }
  auto frame = std::make_shared<const ViewFrame>(renderFrame(cameras_[index], scene_));
  const size_t bytes = frame->points.size() * (sizeof(glm::vec4) + sizeof(Rgb8));
  if (bytes_ + bytes <= mostBytes_) {
    bytes_ += bytes;
    ++kept_;
    frames_[index] = frame;
  }
  return frame;
}

}  // namespace ocelli
