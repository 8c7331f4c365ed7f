#include "display_driver/wire/message_reader.h"

#include <algorithm>

namespace ocelli::wire {

MessageReader::MessageReader(size_t maxPayloadBytes) : maxPayloadBytes_(maxPayloadBytes) {}

void MessageReader::begin(uint32_t session) {
  session_ = session;
  sequence_ = 0;
  lost_ = false;
  haveHeader_ = false;
  checked_ = false;
  buffer_.clear();
}

size_t MessageReader::fill(std::span<const uint8_t> bytes, size_t wanted) {
  const size_t count = std::min(bytes.size(), wanted - buffer_.size());
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

void MessageReader::lose(ErrorCode code, uint32_t frame, const Handler& handler) {
  sequence_.reset();
  if (!lost_) {
    lost_ = true;
    handler.problem(code, frame);
  }
}

bool MessageReader::deliver(const Handler& handler) {
  if (header_.session != session_) {
    return true;  // of an earlier session: it is over
  }
  if (!checked_) {
    if (crc32c(buffer_) != header_.payloadChecksum) {
      handler.problem(ErrorCode::kChecksum, header_.frame);
      // What it said is not known, so the next one is the first that counts.
      sequence_ = header_.sequence + 1;
      return true;
    }
    if (sequence_ && header_.sequence != *sequence_) {
      handler.problem(ErrorCode::kSequence, 0);
    }
    sequence_ = header_.sequence + 1;
    checked_ = true;
  }
  if (!isKnown(header_.type)) {
    handler.problem(ErrorCode::kUnknownType, header_.frame);
    return true;
  }
  return handler.message({header_, buffer_});
}

size_t MessageReader::read(std::span<const uint8_t> bytes, const Handler& handler) {
  size_t taken = 0;
  while (true) {
    if (!haveHeader_) {
      taken += fill(bytes.subspan(taken), kHeaderBytes);
      if (buffer_.size() < kHeaderBytes) {
        return taken;
      }
      const std::optional<MessageHeader> header = headerFrom(buffer_);
      if (!header || header->payloadBytes > maxPayloadBytes_) {
        lose(header ? ErrorCode::kLength : ErrorCode::kChecksum, header ? header->frame : 0, handler);
        // On to the next place where a header may begin.
        const auto next = std::find(buffer_.begin() + 1, buffer_.end(), kMessageMark.front());
        buffer_.erase(buffer_.begin(), next);
        continue;
      }
      lost_ = false;
      haveHeader_ = true;
      checked_ = false;
      header_ = *header;
      buffer_.clear();
      buffer_.reserve(header_.payloadBytes);
    }
    taken += fill(bytes.subspan(taken), header_.payloadBytes);
    if (buffer_.size() < header_.payloadBytes || !deliver(handler)) {
      return taken;
    }
    haveHeader_ = false;
    buffer_.clear();
  }
}

}  // namespace ocelli::wire
