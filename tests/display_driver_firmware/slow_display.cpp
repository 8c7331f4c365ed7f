#include "tests/display_driver_firmware/slow_display.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace ocelli::test {
namespace {

constexpr size_t kHeaderLength = 32;

bool isHeader(ByteSpan bytes) {
  return bytes[0] == 'O' && bytes[1] == 'C' && bytes[2] == 'L' && bytes[3] == 'M' && isWholeRecord(bytes.first(32));
}

std::optional<Bytes> expandRunLength(ByteSpan payload, size_t length) {
  Bytes content;
  size_t at = 0;
  const auto count = [&]() -> std::optional<uint64_t> {
    uint64_t value = 0;
    for (unsigned shift = 0; shift < 35 && at < payload.size(); shift += 7) {
      const uint8_t byte = payload[at++];
      value |= static_cast<uint64_t>(byte & 127) << shift;
      if (byte < 128) {
        return value;
      }
    }
    return std::nullopt;
  };
  while (at < payload.size()) {
    const auto zeros = count();
    const auto others = count();
    if (!zeros || !others || (*zeros == 0 && *others == 0) || *zeros > length || *others > payload.size() - at) {
      return std::nullopt;
    }
    content.resize(content.size() + *zeros);
    append(content, payload.subspan(at, *others));
    at += *others;
    if (content.size() > length) {
      return std::nullopt;
    }
  }
  return content;
}

/// Of frames as zstdPayload() writes them: exactly those.
std::optional<Bytes> expandZstd(ByteSpan payload) {
  Bytes content;
  for (size_t at = 9; at + 4 <= payload.size();) {
    const uint64_t block = number(payload, at, 3);
    const size_t size = block >> 3;
    const bool repeats = (block & 2) != 0;
    if (size > 4096 || (!repeats && size > payload.size() - at - 3)) {
      return std::nullopt;
    }
    if (repeats) {
      content.resize(content.size() + size, payload[at + 3]);
    } else {
      append(content, payload.subspan(at + 3, size));
    }
    at += 3 + (repeats ? 1 : size);
  }
  return std::ranges::equal(zstdPayload(content), payload) ? std::optional(content) : std::nullopt;
}

}  // namespace

SlowDisplay::SlowDisplay(const SlowOptions& options)
    : options_(options), frontSlices_(dark()), now_{.slices = dark(), .parts = {{0, 0}}} {}

Slices SlowDisplay::dark() const {
  return Slices(options_.slices, Bytes(options_.sliceBytes()));
}

void SlowDisplay::arm(uint32_t session) {
  session_ = session;
  bytes_.clear();
  lost_ = held_ = false;
  sequence_ = 0;
  newestWhole_ = lastLost_ = receiving_ = 0;
  frontInOldBuffer_ = frontInOldBuffer_ || front_ != 0;
  front_ = 0;
  frames_.clear();
  events_.clear();
}

void SlowDisplay::reset() {
  arm(0);
  arrived = shown = dropped = 0;
  lastError = 0;
  frontInOldBuffer_ = true;
  frontSlices_ = dark();
  now_.slices[phase_.slice] = dark()[phase_.slice];
  if (frontName_ != 0) {
    frontName_ = 0;
    changeParts();
  }
}

std::vector<SeenEvent> SlowDisplay::takeEvents() {
  return std::exchange(events_, {});
}
std::map<uint32_t, Slices> SlowDisplay::takeArrived() {
  return std::exchange(arrivals_, {});
}

void SlowDisplay::event(uint8_t type, uint32_t frame, uint16_t code, uint8_t flags) {
  events_.push_back({.type = type,
                     .flags = flags,
                     .code = code,
                     .session = session_,
                     .frame = frame,
                     .refresh = static_cast<uint32_t>(phase_.refresh)});
}

void SlowDisplay::error(uint16_t code, uint32_t frame) {
  const uint32_t lost = receiving_ != 0 ? receiving_ : frame;
  if (receiving_ != 0) {
    frames_.erase(receiving_);
    receiving_ = 0;
    freeBases();
  }
  lastLost_ = lost;
  lastError = code;
  event(kError, lost, code);
}

void SlowDisplay::take(ByteSpan bytes) {
  append(bytes_, bytes);
  held_ = false;
  size_t at = 0;
  while (!held_ && bytes_.size() - at >= kHeaderLength) {
    const ByteSpan rest = ByteSpan(bytes_).subspan(at);
    if (!isHeader(rest)) {
      if (!lost_ && session_ != 0) {
        error(1, 0);
      }
      lost_ = true;
      sequence_.reset();
      ++at;
      continue;
    }
    const uint32_t length = u32(rest, 20);
    const Header header{.type = rest[4],
                        .coding = rest[5],
                        .slice = u16(rest, 6),
                        .session = u32(rest, 8),
                        .sequence = u32(rest, 12),
                        .frame = u32(rest, 16)};
    if (length > options_.maxPayload) {
      if (!lost_ && session_ != 0) {
        error(4, header.frame);
      }
      lost_ = true;
      sequence_.reset();
      ++at;
      continue;
    }
    lost_ = false;
    if (rest.size() - kHeaderLength < length) {
      break;
    }
    if (header.session != session_ || session_ == 0) {
      at += kHeaderLength + length;
      continue;
    }
    const ByteSpan payload = rest.subspan(kHeaderLength, length);
    if (checksum(payload) != u32(rest, 24)) {
      error(1, header.frame);
    } else {
      if (sequence_ && header.sequence != *sequence_) {
        error(2, 0);
      }
      sequence_ = header.sequence;  // not again, where the message has to wait
      if (!message(header, payload)) {
        held_ = true;
        break;
      }
    }
    sequence_ = header.sequence + 1;
    at += kHeaderLength + length;
  }
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
}

bool SlowDisplay::message(const Header& header, ByteSpan payload) {
  switch (header.type) {
    case kFrameBegin:
      return begin(header, payload);
    case kSlice:
      slice(header, payload);
      return true;
    case kFrameEnd:
      end(header, payload);
      return true;
    case kPresent:
      present(header, payload);
      return true;
    default:
      error(3, header.frame);
      return true;
  }
}

bool SlowDisplay::begin(const Header& header, ByteSpan payload) {
  if (receiving_ != 0) {
    error(10, receiving_);
  }
  const size_t slices = options_.slices;
  Frame frame{.number = header.frame, .due = std::vector<bool>(slices)};
  size_t count = 0;
  bool right = payload.size() == 8 + (slices + 7) / 8 && u16(payload, 4) == slices;
  for (size_t i = 0; right && i < 8 * (payload.size() - 8); ++i) {
    if ((payload[8 + i / 8] >> (i % 8) & 1) != 0) {
      right = i < slices;
      ++count;
      if (right) {
        frame.due[i] = true;
      }
    }
  }
  if (!right || u16(payload, 6) != count) {
    error(4, header.frame);
    return true;
  }
  if (header.frame <= newestWhole_) {
    error(9, header.frame);
    return true;
  }
  frame.base = u32(payload, 0);
  const auto base = frames_.find(frame.base);
  if (frame.base != 0 && base == frames_.end()) {
    error(8, header.frame);
    return true;
  }
  if (frames_.size() + (frontInOldBuffer_ ? 1 : 0) >= options_.buffers) {
    bool room = false;
    for (const auto& [number, other] : frames_) {
      if (number != frame.base && number != front_ && !other.presentation) {
        drop(number);
        room = true;
        break;
      }
    }
    if (!room) {
      for (const auto& [number, other] : frames_) {
        if (number != front_ && other.presentation) {
          return false;
        }
      }
      error(8, header.frame);
      return true;
    }
  }
  frame.slices = frame.base != 0 ? frames_.at(frame.base).slices : dark();
  receiving_ = header.frame;
  frames_.emplace(header.frame, std::move(frame));
  return true;
}

bool SlowDisplay::isOrphan(const Header& header) {
  if (receiving_ != 0 && header.frame == receiving_) {
    return false;
  }
  // Of a frame that is lost, what else comes is passed over.
  if (receiving_ != 0 || header.frame != lastLost_) {
    error(9, header.frame);
  }
  return true;
}

std::optional<Bytes> SlowDisplay::content(uint8_t coding, ByteSpan payload) const {
  std::optional<Bytes> content;
  switch (coding) {
    case kRaw:
      content = Bytes(payload.begin(), payload.end());
      break;
    case kRunLength:
      content = expandRunLength(payload, options_.sliceBytes());
      break;
    default:
      content = expandZstd(payload);
      break;
  }
  return content && content->size() == options_.sliceBytes() ? content : std::nullopt;
}

void SlowDisplay::slice(const Header& header, ByteSpan payload) {
  if (isOrphan(header)) {
    return;
  }
  Frame& frame = frames_.at(receiving_);
  if (header.slice >= options_.slices || !frame.due[header.slice]) {
    error(7, header.frame);
    return;
  }
  const bool isDifference = (header.coding & kDifference) != 0;
  const auto coding = static_cast<uint8_t>(header.coding & 127);
  if (isDifference && frame.base == 0 && options_.differences) {
    error(8, header.frame);
    return;
  }
  if (coding > kZstd || (coding == kRunLength && !options_.runLength) || (coding == kZstd && !options_.zstd) ||
      (isDifference && !options_.differences)) {
    error(5, header.frame);
    return;
  }
  std::optional<Bytes> planes = content(coding, payload);
  const size_t pad = 8 * options_.rowBytes() - options_.width;
  for (size_t i = options_.rowBytes() - 1; planes && i < planes->size(); i += options_.rowBytes()) {
    if (pad != 0 && ((*planes)[i] >> (8 - pad)) != 0) {
      planes.reset();
    }
  }
  if (!planes) {
    error(6, header.frame);
    return;
  }
  frame.slices[header.slice] = isDifference ? difference(*planes, frame.slices[header.slice]) : *planes;
  frame.due[header.slice] = false;
  frame.sums.push_back(checksum(payload));
}

void SlowDisplay::end(const Header& header, ByteSpan payload) {
  if (isOrphan(header)) {
    return;
  }
  Frame& frame = frames_.at(receiving_);
  const bool complete = std::ranges::find(frame.due, true) == frame.due.end();
  const Bytes right = frameEndPayload(frame.sums.size(), frame.sums);
  if (payload.size() != right.size()) {
    error(4, header.frame);
  } else if (!complete || u32(payload, 0) != frame.sums.size()) {
    error(10, header.frame);
  } else if (!std::ranges::equal(payload, right)) {
    error(1, header.frame);
  } else {
    frame.whole = true;
    newestWhole_ = header.frame;
    receiving_ = 0;
    ++arrived;
    event(kArrived, header.frame);
    arrivals_.insert_or_assign(header.frame, frame.slices);
    freeBases();
  }
}

void SlowDisplay::present(const Header& header, ByteSpan payload) {
  if (payload.size() != 12 || u16(payload, 10) > 7) {
    error(4, header.frame);
    return;
  }
  const Presentation presentation{{u64(payload, 0), u16(payload, 8)}, u16(payload, 10)};
  if ((presentation.flags & kAtNextRefresh) == 0 &&
      (presentation.phase.slice >= options_.slices || (presentation.phase.slice != 0 && !options_.anyPhase))) {
    error(4, header.frame);
    return;
  }
  const auto found = frames_.find(header.frame);
  if (found != frames_.end() && header.frame != front_ && !found->second.gone) {
    found->second.presentation = presentation;
  }
}

// A base that is neither shown nor waiting any more is kept while the frame that is being received needs it.
void SlowDisplay::freeBases() {
  const uint32_t base = receiving_ == 0 ? 0 : frames_.at(receiving_).base;
  std::erase_if(frames_, [&](const auto& entry) { return entry.second.gone && entry.first != base; });
}

void SlowDisplay::drop(uint32_t number) {
  frames_.at(number).gone = true;
  ++dropped;
  event(kDropped, number);
  freeBases();
}

bool SlowDisplay::isDue(const Frame& frame) const {
  if (frame.gone || frame.number == front_ || !frame.presentation) {
    return false;
  }
  const auto& [phase, flags] = *frame.presentation;
  if (!frame.whole) {
    const bool some = !frame.sums.empty();
    if (!options_.coarse || !some || frame.shownCoarse || (flags & kCoarseWhenLate) == 0 ||
        (flags & kAtNextRefresh) != 0) {
      return false;
    }
  }
  if ((flags & kAtNextRefresh) != 0) {
    return phase_.slice == 0;
  }
  const bool anySlice = (flags & kTearWhenLate) != 0 && options_.anyPhase;
  return phase_ >= phase && (anySlice || phase_.slice == phase.slice);
}

Slices SlowDisplay::filled(const Frame& frame) const {
  Slices slices = frame.slices;
  const auto count = static_cast<int>(options_.slices);
  for (int i = 0; i < count; ++i) {
    if (frame.due[static_cast<size_t>(i)]) {
      int nearest = -1;
      for (int j = 0; j < count; ++j) {
        if (!frame.due[static_cast<size_t>(j)] && (nearest < 0 || std::abs(j - i) < std::abs(nearest - i))) {
          nearest = j;
        }
      }
      slices[static_cast<size_t>(i)] = frame.slices[static_cast<size_t>(nearest)];
    }
  }
  return slices;
}

void SlowDisplay::show(Frame& frame) {
  const Presentation& asked = *frame.presentation;
  const bool late = (asked.flags & kAtNextRefresh) == 0 && phase_ > asked.phase;
  const auto flags =
      static_cast<uint8_t>((late ? kLate : 0) | (frame.whole ? 0 : kCoarse) | (phase_.slice != 0 ? kTorn : 0));
  shown += frame.whole ? 1 : 0;
  frontInOldBuffer_ = false;
  if (front_ != 0) {
    frames_.at(front_).gone = true;
  }
  frontSlices_ = filled(frame);
  frontName_ = frame.whole ? int64_t{frame.number} : -int64_t{frame.number};
  front_ = frame.whole ? frame.number : 0;
  frame.shownCoarse = !frame.whole;
  std::vector<uint32_t> older;
  for (const auto& [number, other] : frames_) {
    if (number < frame.number && !other.gone) {
      older.push_back(number);
    }
  }
  for (const uint32_t number : older) {
    drop(number);
  }
  freeBases();
  event(kShown, frame.number, static_cast<uint16_t>(phase_.slice), flags);
  changeParts();
}

void SlowDisplay::changeParts() {
  if (phase_.slice == 0) {
    now_.parts.clear();
  }
  now_.parts.emplace_back(phase_.slice, frontName_);
}

void SlowDisplay::step() {
  if (++phase_.slice == options_.slices) {
    phase_ = {phase_.refresh + 1, 0};
    last_ = std::move(now_);
    now_ = {.slices = dark(), .parts = {{0, frontName_}}};
  }
  for (auto each = frames_.rbegin(); each != frames_.rend(); ++each) {
    if (isDue(each->second)) {
      show(each->second);
      break;
    }
  }
  now_.slices[phase_.slice] = frontSlices_[phase_.slice];
}

}  // namespace ocelli::test
