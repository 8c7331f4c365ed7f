#include "display_driver/wire/slice_coding.h"

#include <algorithm>
#include <cstring>

namespace ocelli::wire {
namespace {

/// Counts are written in groups of seven bits, the least significant first; all but the last have their top bit set.
void appendCount(std::vector<uint8_t>& bytes, size_t count) {
  for (; count >= 0x80; count >>= 7) {
    bytes.push_back(static_cast<uint8_t>(count | 0x80));
  }
  bytes.push_back(static_cast<uint8_t>(count));
}

/// nullopt at the end of the payload, and for counts beyond 35 bits.
std::optional<size_t> takeCount(std::span<const uint8_t>& payload) {
  size_t count = 0;
  for (unsigned shift = 0; shift < 35 && !payload.empty(); shift += 7) {
    const uint8_t byte = payload.front();
    payload = payload.subspan(1);
    count |= static_cast<size_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) {
      return count;
    }
  }
  return std::nullopt;
}

/// Zero bytes from here on.
size_t zerosAt(std::span<const uint8_t> content, size_t at) {
  size_t end = at;
  for (uint64_t word = 0; end + sizeof word <= content.size(); end += sizeof word) {
    std::memcpy(&word, content.data() + end, sizeof word);
    if (word != 0) {
      break;
    }
  }
  while (end < content.size() && content[end] == 0) {
    ++end;
  }
  return end - at;
}

/// Bytes from here on up to the next two zero bytes in a row, which cost less as a run.
size_t othersAt(std::span<const uint8_t> content, size_t at) {
  size_t end = at;
  while (end < content.size() && (content[end] != 0 || (end + 1 < content.size() && content[end + 1] != 0))) {
    ++end;
  }
  return end - at;
}

/// One line of the cache in so many bytes is looked at.
constexpr size_t kSampleStride = 1024;
constexpr size_t kSampleBytes = 64;
/// Lit words of a sample that tell something.
constexpr uint32_t kEnoughWords = 32;

/// The difference has hardly fewer lit words than the slice: 7 of 10 at least.
bool sampleFavoursWhole(std::span<const uint8_t> planes, std::span<const uint8_t> base) {
  uint32_t lit = 0;
  uint32_t changed = 0;
  for (size_t at = 0; at + kSampleBytes <= planes.size(); at += kSampleStride) {
    for (size_t word = at; word < at + kSampleBytes; word += sizeof(uint32_t)) {
      uint32_t a = 0;
      uint32_t b = 0;
      std::memcpy(&a, planes.data() + word, sizeof a);
      std::memcpy(&b, base.data() + word, sizeof b);
      lit += a != 0 ? 1 : 0;
      changed += a != b ? 1 : 0;
    }
  }
  return lit >= kEnoughWords && changed * 10 >= lit * 7;
}

}  // namespace

std::vector<uint8_t> runLengthEncode(std::span<const uint8_t> content) {
  std::vector<uint8_t> payload;
  for (size_t at = 0; at < content.size();) {
    const size_t zeros = zerosAt(content, at);
    const size_t others = othersAt(content, at + zeros);
    appendCount(payload, zeros);
    appendCount(payload, others);
    const auto begin = content.begin() + static_cast<std::ptrdiff_t>(at + zeros);
    payload.insert(payload.end(), begin, begin + static_cast<std::ptrdiff_t>(others));
    at += zeros + others;
  }
  return payload;
}

bool runLengthDecode(std::span<const uint8_t> payload, std::span<uint8_t> content) {
  size_t at = 0;
  while (!payload.empty()) {
    const std::optional<size_t> zeros = takeCount(payload);
    const std::optional<size_t> others = zeros ? takeCount(payload) : std::nullopt;
    if (!others || *zeros + *others == 0 || *zeros > content.size() - at || *others > content.size() - at - *zeros ||
        *others > payload.size()) {
      return false;
    }
    std::ranges::fill(content.subspan(at, *zeros), uint8_t{0});
    std::ranges::copy(payload.first(*others), content.begin() + static_cast<std::ptrdiff_t>(at + *zeros));
    payload = payload.subspan(*others);
    at += *zeros + *others;
  }
  return at == content.size();
}

SliceCoder::SliceCoder(uint32_t capabilities, Effort effort) : capabilities_(capabilities), effort_(effort) {}

CodedSlice SliceCoder::encode(std::span<const uint8_t> planes, std::span<const uint8_t> base) {
  uint8_t flag = 0;
  std::span<const uint8_t> content = planes;
  if (!base.empty() && (capabilities_ & kCanDelta) != 0 && !sampleFavoursWhole(planes, base)) {
    difference_.resize(planes.size());
    const WordCounts words = subtract(planes, base, difference_);
    if (words.changed < words.lit) {
      flag = kDeltaFlag;
      content = difference_;
    }
  }
  const auto coded = [&](Coding coding, std::vector<uint8_t> payload) {
    return CodedSlice{static_cast<uint8_t>(static_cast<uint8_t>(coding) | flag), std::move(payload)};
  };
  const bool canRunLength = (capabilities_ & kCanRunLength) != 0;
  if ((capabilities_ & kCanZstd) != 0 && (effort_ == Effort::kSmall || !canRunLength)) {
    const std::span<const uint8_t> block = zstd_.compress(content);
    if (block.size() < content.size()) {
      return coded(Coding::kZstd, {block.begin(), block.end()});
    }
  } else if (canRunLength) {
    std::vector<uint8_t> runs = runLengthEncode(content);
    if (runs.size() < content.size()) {
      return coded(Coding::kRunLength, std::move(runs));
    }
  }
  return coded(Coding::kRaw, {content.begin(), content.end()});
}

SliceDecoder::SliceDecoder(const DisplayProfile& profile, uint32_t capabilities)
    : capabilities_(capabilities), padding_(profile) {}

ErrorCode SliceDecoder::decode(uint8_t coding, std::span<const uint8_t> payload, std::span<const uint8_t> base,
                               std::span<uint8_t> planes) {
  const bool delta = (coding & kDeltaFlag) != 0;
  if (delta && (capabilities_ & kCanDelta) == 0) {
    return ErrorCode::kUnknownCoding;
  }
  if (delta && base.empty()) {
    return ErrorCode::kNoBase;
  }
  bool decoded = false;
  switch (static_cast<Coding>(coding & ~kDeltaFlag)) {
    case Coding::kRaw:
      decoded = payload.size() == planes.size();
      if (decoded) {
        std::ranges::copy(payload, planes.begin());
      }
      break;
    case Coding::kRunLength:
      if ((capabilities_ & kCanRunLength) == 0) {
        return ErrorCode::kUnknownCoding;
      }
      decoded = runLengthDecode(payload, planes);
      break;
    case Coding::kZstd:
      if ((capabilities_ & kCanZstd) == 0) {
        return ErrorCode::kUnknownCoding;
      }
      decoded = zstd_.decompress(payload, planes);
      break;
    default:  // any byte may have come
      return ErrorCode::kUnknownCoding;
  }
  if (!decoded) {
    return ErrorCode::kContent;
  }
  if (delta) {
    addDifference(planes, base);
  }
  return padding_.holds(planes) ? ErrorCode::kNone : ErrorCode::kContent;
}

std::vector<int> coarseToFineOrder(int slices) {
  std::vector<int> order;
  order.reserve(static_cast<size_t>(slices));
  std::vector<bool> taken(static_cast<size_t>(slices));
  unsigned bits = 0;
  while ((1 << bits) < slices) {
    ++bits;
  }
  for (int i = 0; i < 1 << bits; ++i) {
    int reversed = 0;
    for (unsigned bit = 0; bit < bits; ++bit) {
      reversed |= (i >> bit & 1) << (bits - 1 - bit);
    }
    // Scaled to the count: as evenly as it goes where that is no power of two.
    const auto slice = static_cast<size_t>((static_cast<int64_t>(reversed) * slices) >> bits);
    if (!taken[slice]) {
      taken[slice] = true;
      order.push_back(static_cast<int>(slice));
    }
  }
  return order;
}

std::vector<int> nearestPresent(const std::vector<bool>& present) {
  const auto count = static_cast<int>(present.size());
  std::vector<int> nearest(present.size(), -1);
  const auto sweep = [&](int from, int to, int step) {
    int last = -1;
    for (int i = from; i != to; i += step) {
      if (present[static_cast<size_t>(i)]) {
        last = i;
      }
      int& best = nearest[static_cast<size_t>(i)];
      if (last >= 0 && (best < 0 || std::abs(last - i) < std::abs(best - i))) {
        best = last;
      }
    }
  };
  sweep(0, count, 1);
  sweep(count - 1, -1, -1);
  return nearest;
}

}  // namespace ocelli::wire
