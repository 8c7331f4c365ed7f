// What a view showed lately: an image of a trial is asked for many times, by screens, simulated subjects and replays.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "study/task/trial_layout.h"

namespace ocelli {

class ShownCache {
 public:
  /// What was made for the same scene, objects and pinhole, or `make()`. Any thread may call it at any time; two that
  /// ask for the same at once may both make it.
  template <class Make>
  std::shared_ptr<const ShownContent> get(const TrialLayout& layout, const PinholeCamera& camera, const Make& make) {
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
    if (entries_.size() > kMaxEntries) {
      entries_.pop_back();
    }
    return shown;
  }

 private:
  static constexpr size_t kMaxEntries = 16;  // as many panes as a matrix may have, of one moment

  struct Key {
    uint64_t scene = 0;
    std::vector<glm::vec3> offsets;
    View view;
    int width = 0;
    int height = 0;

    bool operator==(const Key&) const = default;
  };
  struct Entry {
    Key key;
    std::shared_ptr<const ShownContent> shown;
  };

  std::mutex mutex_;
  std::deque<Entry> entries_;
};

}  // namespace ocelli
