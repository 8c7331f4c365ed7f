// Finds the messages in the bulk stream: bytes as they come, in pieces of any size, to whole messages whose checksums
// are right. After other bytes it looks for the next header, byte by byte.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "display_driver/wire/wire_format.h"

namespace ocelli::wire {

struct Message {
  MessageHeader header;
  std::span<const uint8_t> payload;  ///< valid during the call
};

class MessageReader {
 public:
  struct Handler {
    /// False: not now. The reader keeps the message, takes no more bytes, and tries again with the next read().
    std::function<bool(const Message&)> message;
    /// `frame` is that of the message that was wrong, 0 where that is not known. Comes once for each loss of place.
    std::function<void(ErrorCode, uint32_t frame)> problem;
  };

  /// Refuses payloads of more bytes. Takes no more memory than one payload.
  explicit MessageReader(size_t maxPayloadBytes);

  /// Forgets what came. Messages of other sessions are left out from now on.
  void begin(uint32_t session);
  /// Expects another sequence number than is due: for tests and emulated faults.
  void skipSequence() { sequence_ = sequence_.value_or(0) + 1; }

  /// Takes bytes, and says how many.
  size_t read(std::span<const uint8_t> bytes, const Handler& handler);

 private:
  size_t fill(std::span<const uint8_t> bytes, size_t wanted);
  void lose(ErrorCode code, uint32_t frame, const Handler& handler);
  bool deliver(const Handler& handler);

  size_t maxPayloadBytes_;
  uint32_t session_ = 0;
  std::optional<uint32_t> sequence_ = 0;  ///< of the next message; nullopt: after a loss of place, whatever comes
  bool lost_ = false;                     ///< looking for a header
  bool haveHeader_ = false;
  bool checked_ = false;  ///< the message's checksum and sequence have been looked at
  MessageHeader header_;
  std::vector<uint8_t> buffer_;  ///< of a header, or of the payload after one
};

}  // namespace ocelli::wire
