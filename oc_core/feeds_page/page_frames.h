// The latest image, for several threads that send it. For the .cpp files of this room.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "oc_core/feeds_page/feeds_page.h"

namespace ocelli {

class PageFrames {
 public:
  /// JPEG, or PNG where Ocelli was built without it.
  static const char* mediaType();

  void set(const Image<Rgb8>& image, const std::vector<PageFeed>& feeds);
  /// A file with the latest image, once that is another one than number `seen`, which it replaces; null once stop() was
  /// called. It is encoded by the first that asks for it.
  std::shared_ptr<const std::string> next(uint64_t& seen);
  std::vector<PageFeed> feeds() const;
  void stop();

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Image<Rgb8> image_;
  std::vector<PageFeed> feeds_;
  uint64_t number_ = 0;
  bool isStopped_ = false;
  std::mutex encoding_;
  std::shared_ptr<const std::string> file_;
  uint64_t fileNumber_ = 0;
};

}  // namespace ocelli
