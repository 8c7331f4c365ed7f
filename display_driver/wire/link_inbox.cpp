#include "display_driver/wire/link_inbox.h"

#include <utility>

namespace ocelli {

wire::LinkListener LinkInbox::listener(std::function<void()> arrived) {
  return {.sent =
              [this, arrived](size_t tag, wire::LinkStatus status, size_t bytes) {
                {
                  const std::lock_guard lock(mutex_);
                  news_.sent.push_back({tag, status, bytes});
                }
                arrived();
              },
          .received =
              [this, arrived](std::span<const uint8_t> bytes) {
                {
                  const std::lock_guard lock(mutex_);
                  addBytes(bytes);
                }
                arrived();
              },
          .lost =
              [this, arrived](wire::LinkStatus status) {
                {
                  const std::lock_guard lock(mutex_);
                  news_.lost = status;
                }
                arrived();
              }};
}

/// Looks for the next whole event where one is damaged.
void LinkInbox::addBytes(std::span<const uint8_t> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  size_t at = 0;
  while (bytes_.size() - at >= wire::kEventBytes) {
    const auto event = wire::eventFrom(std::span(bytes_).subspan(at, wire::kEventBytes));
    if (event) {
      news_.events.push_back(*event);
    }
    at += event ? wire::kEventBytes : 1;
  }
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
}

LinkInbox::News LinkInbox::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

bool LinkInbox::empty() const {
  const std::lock_guard lock(mutex_);
  return news_.sent.empty() && news_.events.empty() && !news_.lost;
}

void LinkInbox::clear() {
  const std::lock_guard lock(mutex_);
  news_ = {};
  bytes_.clear();
}

}  // namespace ocelli
