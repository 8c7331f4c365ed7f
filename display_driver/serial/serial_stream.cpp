#include "display_driver/serial/serial_stream.h"

#include <algorithm>

#include "display_driver/serial/serial_frame.h"

namespace ocelli::serial {
namespace {

constexpr size_t kPositionBytes = 4;
constexpr size_t kCreditBytes = 9;

/// The position nearest to `near` that has these 32 bits.
uint64_t unwrapped(uint32_t position, uint64_t near) {
  const auto ahead = static_cast<int32_t>(position - static_cast<uint32_t>(near));
  return near + static_cast<uint64_t>(static_cast<int64_t>(ahead));
}

}  // namespace

std::vector<uint8_t> creditContent(const Credit& credit) {
  std::vector<uint8_t> content;
  addNumber(content, credit.taken, kPositionBytes);
  addNumber(content, credit.limit, kPositionBytes);
  content.push_back(credit.gap ? 1 : 0);
  return content;
}

std::optional<std::vector<uint8_t>> SerialSender::next(Time now) {
  if (next_ > taken_ && now - moved_ >= kResendAfter) {
    next_ = taken_;
    ++resent_;
  }
  const uint64_t last = std::min(end(), limit_);
  if (next_ >= last) {
    return std::nullopt;
  }
  const auto first = static_cast<size_t>(next_ - taken_);
  const size_t count = std::min<size_t>(kMaxPacketBytes, static_cast<size_t>(last - next_));
  std::vector<uint8_t> content;
  addNumber(content, next_, kPositionBytes);
  const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(first);
  content.insert(content.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
  next_ += count;
  sent_ = std::max(sent_, next_);
  moved_ = now;
  return content;
}

bool SerialSender::hear(std::span<const uint8_t> content, Time now) {
  if (content.size() != kCreditBytes) {
    return false;
  }
  const uint64_t taken = unwrapped(static_cast<uint32_t>(numberAt(content, 0, 4)), taken_);
  const uint64_t limit = unwrapped(static_cast<uint32_t>(numberAt(content, 4, 4)), taken_);
  if (taken > sent_) {
    return false;
  }
  if (taken > taken_) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(taken - taken_));
    taken_ = taken;
    next_ = std::max(next_, taken_);
    moved_ = now;
  }
  if (taken == taken_) {  // an older one says nothing new
    limit_ = std::max(limit_, limit);
    if (content[8] != 0 && next_ > taken_) {
      next_ = taken_;
      ++resent_;
    }
  }
  return true;
}

bool SerialReceiver::take(std::span<const uint8_t> content) {
  if (content.size() <= kPositionBytes) {
    return false;
  }
  const uint64_t position = unwrapped(static_cast<uint32_t>(numberAt(content, 0, 4)), taken_);
  std::span<const uint8_t> bytes = content.subspan(kPositionBytes);
  if (position > taken_) {
    gapNews_ = gapNews_ || !inGap_;
    inGap_ = true;
    return true;
  }
  if (position + bytes.size() <= taken_) {
    told_.limit = 0;  // it has not heard: tell again
    return true;
  }
  bytes = bytes.subspan(static_cast<size_t>(taken_ - position));
  bytes = bytes.first(std::min(bytes.size(), capacity_ - std::min(capacity_, bytes_.size())));
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  taken_ += bytes.size();
  inGap_ = false;
  return true;
}

Credit SerialReceiver::tell() {
  told_ = credit();
  Credit credit = told_;
  credit.gap = gapNews_;
  gapNews_ = false;
  return credit;
}

}  // namespace ocelli::serial
