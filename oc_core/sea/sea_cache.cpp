#include "oc_core/sea/sea_cache.h"

#include <algorithm>
#include <utility>

namespace ocelli {
namespace {

constexpr size_t kMaxCached = 64;  ///< 3 MB each for a million pixels

}  // namespace

SeaCache::SeaCache(const SeaFile& sea, std::function<void()> woken)
    : sea_(sea), woken_(std::move(woken)), thread_([this] { work(); }) {}

SeaCache::~SeaCache() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void SeaCache::want(const std::vector<uint32_t>& images) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = images;
  }
  changed_.notify_all();
}

std::shared_ptr<const WarpReference> SeaCache::find(uint32_t image) {
  const std::lock_guard lock(mutex_);
  const auto found = kept_.find(image);
  if (found == kept_.end()) {
    return nullptr;
  }
  found->second.lastUse = ++uses_;
  return found->second.image;
}

std::shared_ptr<const WarpReference> SeaCache::get(uint32_t image) {
  if (std::shared_ptr<const WarpReference> there = find(image)) {
    return there;
  }
  auto decoded = std::make_shared<const WarpReference>(sea_.image(image), sea_.settings().projection);
  const std::lock_guard lock(mutex_);
  keep(image, decoded);
  return decoded;
}

void SeaCache::rethrow() {
  std::exception_ptr failed;
  {
    const std::lock_guard lock(mutex_);
    failed = std::exchange(failed_, nullptr);
  }
  if (failed) {
    std::rethrow_exception(failed);
  }
}

void SeaCache::keep(uint32_t image, std::shared_ptr<const WarpReference> decoded) {
  kept_[image] = {std::move(decoded), ++uses_};
  if (kept_.size() > kMaxCached) {
    kept_.erase(std::min_element(kept_.begin(), kept_.end(),
                                 [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; }));
  }
}

void SeaCache::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    const auto next =
        std::find_if(wanted_.begin(), wanted_.end(), [&](uint32_t image) { return !kept_.contains(image); });
    if (ends_) {
      return;
    }
    if (next == wanted_.end()) {
      changed_.wait(lock);
      continue;
    }
    const uint32_t image = *next;
    lock.unlock();
    std::shared_ptr<const WarpReference> decoded;
    std::exception_ptr failed;
    try {
      decoded = std::make_shared<const WarpReference>(sea_.image(image), sea_.settings().projection);
    } catch (...) {
      failed = std::current_exception();
    }
    lock.lock();
    if (failed) {
      failed_ = failed;
      wanted_.clear();  // it would fail again and again
    } else {
      keep(image, std::move(decoded));
    }
    lock.unlock();
    if (woken_) {
      woken_();
    }
    lock.lock();
  }
}

}  // namespace ocelli
