// A stream of bytes over packets that may be lost: both ends, which are the same for the stream to the display and for
// that of its events (docs/serial_protocol.md). No clocks and threads: times come from the caller.
//
// Bytes are counted from the beginning of a connection. The receiver says up to where it has them, in order, and up to
// where it takes more; the sender keeps what the receiver has not, and sends it again from there where the receiver
// tells of a gap, or nothing moves for a while. Positions are 32 bits on the line and wrap around.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace ocelli::serial {

using Time = std::chrono::steady_clock::time_point;

inline constexpr std::chrono::milliseconds kResendAfter{200};

/// What a receiver tells (kCredit, kHeard): u32 taken, u32 limit, u8 1 where a packet is missing.
struct Credit {
  uint64_t taken = 0;
  uint64_t limit = 0;
  bool gap = false;
};
std::vector<uint8_t> creditContent(const Credit& credit);

class SerialSender {
 public:
  /// Connections begin at position 0.
  explicit SerialSender(uint64_t begin = 0) : taken_(begin), next_(begin), sent_(begin), limit_(begin) {}

  void append(std::span<const uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  /// Forgets what was never sent.
  void dropUnsent() { bytes_.resize(static_cast<size_t>(sent_ - taken_)); }

  /// The content of the next packet, as kData and kEvents have it: u32 position, bytes. Nothing where none is due.
  std::optional<std::vector<uint8_t>> next(Time now);
  /// Takes the content of a kCredit or kHeard. False where it cannot be one.
  bool hear(std::span<const uint8_t> content, Time now);

  uint64_t taken() const { return taken_; }
  uint64_t end() const { return taken_ + bytes_.size(); }  ///< of all that was appended
  bool isIdle() const { return bytes_.empty(); }
  uint64_t resent() const { return resent_; }  ///< how often it began again

 private:
  std::deque<uint8_t> bytes_;  ///< from taken_ on
  uint64_t taken_;
  uint64_t next_;
  uint64_t sent_;  ///< the highest that next_ was
  uint64_t limit_;
  uint64_t resent_ = 0;
  Time moved_{};  ///< when something was sent, or heard of, that was new
};

class SerialReceiver {
 public:
  explicit SerialReceiver(size_t capacity, uint64_t begin = 0) : capacity_(capacity), taken_(begin) {}

  /// Takes the content of a kData or kEvents: what is new in it goes to the end of bytes(). False where it cannot be
  /// one.
  bool take(std::span<const uint8_t> content);
  const std::vector<uint8_t>& bytes() const { return bytes_; }
  /// So many of bytes() are used.
  void use(size_t count) { bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(count)); }

  /// What to tell the sender; whether something of it is new since the last time.
  bool hasNews() const { return gapNews_ || credit().taken != told_.taken || credit().limit != told_.limit; }
  Credit tell();

 private:
  Credit credit() const { return {taken_, taken_ - bytes_.size() + capacity_, false}; }

  size_t capacity_;
  std::vector<uint8_t> bytes_;
  uint64_t taken_;
  bool inGap_ = false;    ///< a later packet came, and none in order since
  bool gapNews_ = false;  ///< and that was not told
  Credit told_{};
};

}  // namespace ocelli::serial
