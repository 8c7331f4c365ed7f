// The images of a sea that someone who walks through it needs, decoded on a thread of their own and kept for a while.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "oc_core/sea/sea_file.h"

namespace ocelli {

class SeaCache {
 public:
  /// `sea` must outlive it. `woken` is called on the thread that decodes, when an image is there; it may be empty.
  explicit SeaCache(const SeaFile& sea, std::function<void()> woken = {});
  ~SeaCache();
  SeaCache(const SeaCache&) = delete;
  SeaCache& operator=(const SeaCache&) = delete;

  /// These, the first ones first, and no others that were wanted before.
  void want(const std::vector<uint32_t>& images);
  /// Nothing where it is not there yet.
  std::shared_ptr<const WarpReference> find(uint32_t image);
  /// Decodes it now, where it is not there. Throws as SeaFile::image().
  std::shared_ptr<const WarpReference> get(uint32_t image);
  /// Throws what decoding has thrown, once.
  void rethrow();

 private:
  struct Kept {
    std::shared_ptr<const WarpReference> image;
    uint64_t lastUse = 0;
  };

  void work();
  void keep(uint32_t image, std::shared_ptr<const WarpReference> decoded);

  const SeaFile& sea_;
  std::function<void()> woken_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<uint32_t> wanted_;
  std::map<uint32_t, Kept> kept_;
  std::exception_ptr failed_;
  uint64_t uses_ = 0;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace ocelli
