// What eyes before a display see of scenes, kept: each image is made once, however often it is asked for.
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "study/views/display_light.h"
#include "study/views/kept_image.h"

namespace ocelli {

/// Of one scene from one place, from all poses of the eye. Any thread may call it at any time.
class PoseImages {
 public:
  /// `options` must outlive it.
  PoseImages(const DisplayViewOptions& options, const PinholeCamera& camera)
      : options_(options), camera_(camera), images_(options.head.poseCount()) {}

  /// Made of the layout where it is not there yet: always of the same scene, with its objects at the same places.
  const KeptImage& at(size_t pose, const TrialLayout& layout);
  size_t bytes() const { return bytes_; }
  /// Frees what only images that were not made yet need; they take longer then. Nothing where an image is being made.
  void forgetVolumes();

 private:
  const DisplayViewOptions& options_;
  PinholeCamera camera_;
  std::atomic<size_t> bytes_ = 0;
  std::mutex mutex_;
  std::unique_ptr<DisplayLight> light_;  ///< guarded, as all below
  std::optional<double> gain_{};
  std::vector<std::unique_ptr<KeptImage>> images_;  ///< by pose; empty until made
};

class ImageStore {
 public:
  /// Images take that much memory at most, but for those of the scene that is asked for.
  static constexpr size_t kMaxBytes = size_t{1} << 30;

  /// Those of the scene and objects of the layout, from a pinhole with the size of the images. Scenes of the same maze
  /// and objects are the same. Any thread may call it at any time.
  std::shared_ptr<PoseImages> get(const DisplayViewOptions& options, const TrialLayout& layout,
                                  const PinholeCamera& camera);
  size_t bytes() const;

 private:
  static constexpr size_t kMaxWithVolumes = 3;

  struct Key {
    Maze maze;
    size_t vertices = 0;  ///< an entrance may be closed or open
    std::vector<glm::vec3> offsets;
    View view;
    int width = 0;
    int height = 0;

    bool operator==(const Key&) const = default;
  };
  struct Entry {
    Key key;
    std::shared_ptr<PoseImages> images;
  };

  mutable std::mutex mutex_;
  std::deque<Entry> entries_;  ///< what was asked for last comes first
};

}  // namespace ocelli
