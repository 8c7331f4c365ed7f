// What a view showed lately: an image of a trial is asked for many times, by screens, simulated subjects and replays.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "study/task/trial_layout.h"

namespace ocelli {

class ShownCache {
 public:
  /// What was made for the same scene, objects and pinhole, or `make()`. It keeps what came last: of one moment, which
  /// has so many panes, at the least, and of more moments while they have few pixels. Any thread may call it at any
  /// time; two that ask for the same at once may both make it.
  template <class Make>
  std::shared_ptr<const ShownContent> get(const TrialLayout& layout, const PinholeCamera& camera, size_t panes,
                                          const Make& make) {
    const Key key{layout.scene->id(), layout.objectOffsets, camera.view(), camera.width(), camera.height()};
    {
      const std::lock_guard lock(mutex_);
      for (const Entry& entry : entries_) {
        if (entry.key == key) {
          return entry.shown;
        }
      }
    }
    std::shared_ptr<const ShownContent> shown = make();
    const std::lock_guard lock(mutex_);
    entries_.push_front({key, shown});
    pixels_ += key.pixels();
    while (entries_.size() > panes && pixels_ > kMaxPixels) {
      pixels_ -= entries_.back().key.pixels();
      entries_.pop_back();
    }
    return shown;
  }

 private:
  static constexpr int64_t kMaxPixels = int64_t{1} << 23;  // a mesh takes some 50 bytes a pixel

  struct Key {
    uint64_t scene = 0;
    std::vector<glm::vec3> offsets;
    View view;
    int width = 0;
    int height = 0;

    int64_t pixels() const { return int64_t{width} * height; }
    bool operator==(const Key&) const = default;
  };
  struct Entry {
    Key key;
    std::shared_ptr<const ShownContent> shown;
  };

  std::mutex mutex_;
  std::deque<Entry> entries_;
  int64_t pixels_ = 0;  ///< of all entries
};

}  // namespace ocelli
