// What the scene shows from many viewpoints: rendered when first asked for, and kept as long as there is room.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "oc_core/evaluation/frame_errors.h"

namespace ocelli {

class TruthFrames {
 public:
  /// Frames that would take more memory than this together are rendered anew each time.
  static constexpr size_t kMaxBytes = size_t{1} << 30;

  using RenderFrame = std::function<ViewFrame(const PinholeCamera& camera)>;

  /// `scene` must outlive it.
  TruthFrames(const Mesh& scene, std::vector<PinholeCamera> cameras, size_t maxBytes = kMaxBytes);
  /// `render` is called from several threads.
  TruthFrames(RenderFrame render, std::vector<PinholeCamera> cameras, size_t maxBytes = kMaxBytes);

  size_t count() const { return cameras_.size(); }
  const PinholeCamera& camera(size_t index) const { return cameras_[index]; }
  /// May be called from several threads.
  std::shared_ptr<const ViewFrame> frame(size_t index);
  size_t keptFrames() const { return kept_; }

 private:
  RenderFrame render_;
  std::vector<PinholeCamera> cameras_;
  size_t maxBytes_;
  std::mutex mutex_;  ///< guards what follows
  size_t bytes_ = 0;
  size_t kept_ = 0;
  std::vector<std::shared_ptr<const ViewFrame>> frames_;
};

}  // namespace ocelli
