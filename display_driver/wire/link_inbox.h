// What a link's thread tells, kept for the thread that works with the link.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "display_driver/wire/link.h"
#include "display_driver/wire/wire_format.h"

namespace ocelli {

class LinkInbox {
 public:
  struct Sent {
    size_t tag = 0;
    wire::LinkStatus status = wire::LinkStatus::kDone;
    size_t bytes = 0;
  };
  struct News {
    std::vector<Sent> sent;
    std::vector<wire::Event> events;
    std::optional<wire::LinkStatus> lost;
  };

  /// `arrived` is called on the link's thread after each piece of news.
  wire::LinkListener listener(std::function<void()> arrived);

  /// All news since the last call.
  News take();
  bool empty() const;
  /// Of a new link: forgets everything.
  void clear();

 private:
  void addBytes(std::span<const uint8_t> bytes);

  mutable std::mutex mutex_;
  News news_;
  std::vector<uint8_t> bytes_;  ///< of an event that has not come whole
};

}  // namespace ocelli
