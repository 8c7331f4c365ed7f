#include "oc_core/volume/import/vti_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/inflate.h"

namespace ocelli {
namespace {

constexpr size_t kPieceBytes = 3 << 16;

/// The 6 bits of a character of base64; -1 for "=", -2 for white space, -3 for all others.
int base64Bits(char c) {
  if (c >= 'A' && c <= 'Z') {
    return c - 'A';
  }
  if (c >= 'a' && c <= 'z') {
    return c - 'a' + 26;
  }
  if (c >= '0' && c <= '9') {
    return c - '0' + 52;
  }
  if (c == '+' || c == '/') {
    return c == '+' ? 62 : 63;
  }
  return c == '=' ? -1 : c == ' ' || c == '\n' || c == '\r' || c == '\t' ? -2 : -3;
}

/// Decoded bytes, one after the other.
class VtiByteReader {
 public:
  VtiByteReader(const ByteSource& source, uint64_t offset, bool isBase64)
      : source_(source), at_(offset), isBase64_(isBase64) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(what, source_.name(), "copy or export the file again");
  }

  void read(std::span<std::byte> into) {
    if (!isBase64_) {
      source_.read(at_, into);
      at_ += into.size();
      return;
    }
    while (!into.empty()) {
      if (decodedAt_ == decoded_) {
        decodeFour();
      }
      const size_t count = std::min(into.size(), decoded_ - decodedAt_);
      std::memcpy(into.data(), quantum_.data() + decodedAt_, count);
      decodedAt_ += count;
      into = into.subspan(count);
    }
  }

  uint64_t word(const VtiEncoding& encoding) {
    std::array<std::byte, 8> bytes{};
    read(std::span(bytes).first(encoding.wordBytes));
    if (encoding.isSwapped) {
      std::reverse(bytes.begin(), bytes.begin() + static_cast<ptrdiff_t>(encoding.wordBytes));
    }
    uint64_t word = 0;
    std::memcpy(&word, bytes.data(), encoding.wordBytes);
    return word;
  }

  /// Bytes that follow were encoded by themselves: what fills up the last four characters is over.
  void startRun() { decodedAt_ = decoded_ = 0; }

 private:
  char nextCharacter() {
    if (textAt_ == text_.size()) {
      const uint64_t left = source_.size() - std::min(at_, source_.size());
      text_.resize(static_cast<size_t>(std::min<uint64_t>(left, kPieceBytes)));
      if (text_.empty()) {
        fail("the file ends too early");
      }
      source_.read(at_, std::as_writable_bytes(std::span(text_)));
      at_ += text_.size();
      textAt_ = 0;
    }
    return text_[textAt_++];
  }

  void decodeFour() {
    std::array<int, 4> bits{};
    for (int& sextet : bits) {
      do {
        sextet = base64Bits(nextCharacter());
      } while (sextet == -2);
      if (sextet == -3) {
        fail("the voxels are not sound base64");
      }
    }
    decoded_ = bits[3] >= 0 ? 3 : bits[2] >= 0 ? 2 : 1;
    if (bits[0] < 0 || bits[1] < 0 || (bits[2] < 0 && bits[3] >= 0)) {
      fail("the voxels are not sound base64");
    }
    const unsigned all = static_cast<unsigned>(bits[0]) << 18U | static_cast<unsigned>(bits[1]) << 12U |
                         static_cast<unsigned>(std::max(bits[2], 0)) << 6U |
                         static_cast<unsigned>(std::max(bits[3], 0));
    quantum_ = {static_cast<std::byte>(all >> 16U), static_cast<std::byte>(all >> 8U), static_cast<std::byte>(all)};
    decodedAt_ = 0;
  }

  const ByteSource& source_;
  uint64_t at_;
  bool isBase64_;
  std::vector<char> text_;
  size_t textAt_ = 0;
  std::array<std::byte, 3> quantum_{};
  size_t decoded_ = 0;
  size_t decodedAt_ = 0;
};

void checkVtiBytes(const VtiByteReader& reader, uint64_t got, uint64_t expected) {
  if (got != expected) {
    reader.fail(fmt::format("the array has {} bytes, and its extent and type need {}", got, expected));
  }
}

void decodePlain(VtiByteReader& reader, uint64_t expected, const ByteSink& sink) {
  std::vector<std::byte> piece(static_cast<size_t>(std::min<uint64_t>(kPieceBytes, expected)));
  for (uint64_t left = expected; left > 0;) {
    const auto count = static_cast<size_t>(std::min<uint64_t>(left, piece.size()));
    reader.read(std::span(piece).first(count));
    sink(std::span(piece).first(count));
    left -= count;
  }
}

void decodeDeflated(const VtiEncoding& encoding, VtiByteReader& reader, const ByteSource& source, uint64_t expected,
                    const ByteSink& sink) {
  const uint64_t blocks = reader.word(encoding);
  const uint64_t blockBytes = reader.word(encoding);
  const uint64_t lastBytes = reader.word(encoding);
  // Each has a word in the header, and makes no more than `expected` bytes.
  if (blocks == 0 || blocks > source.size() / encoding.wordBytes || blockBytes > expected || lastBytes > blockBytes) {
    reader.fail("the sizes of compressed blocks are out of range");
  }
  const uint64_t partial = lastBytes > 0 ? 1 : 0;
  const uint64_t whole = blocks - partial;
  if (blockBytes > 0 && whole > expected / blockBytes) {
    reader.fail("the sizes of compressed blocks are out of range");
  }
  checkVtiBytes(reader, whole * blockBytes + lastBytes, expected);
  std::vector<uint64_t> sizes(static_cast<size_t>(blocks));
  for (uint64_t& size : sizes) {
    size = reader.word(encoding);
  }
  reader.startRun();
  std::vector<std::byte> piece(kPieceBytes);
  for (size_t block = 0; block < sizes.size(); ++block) {
    uint64_t left = sizes[block];
    const ByteFeed feed = [&]() -> std::span<const std::byte> {
      const auto count = static_cast<size_t>(std::min<uint64_t>(left, piece.size()));
      reader.read(std::span(piece).first(count));
      left -= count;
      return std::span(piece).first(count);
    };
    const uint64_t bytes = block < whole ? blockBytes : lastBytes;
    checkVtiBytes(reader, inflateBytes(feed, bytes, source.name(), sink), bytes);
    while (left > 0) {
      feed();
    }
  }
}

}  // namespace

uint64_t readVtiWord(const VtiEncoding& encoding, const ByteSource& source, uint64_t offset) {
  return VtiByteReader(source, offset, encoding.isBase64).word(encoding);
}

void decodeVtiArray(const VtiEncoding& encoding, const ByteSource& source, uint64_t offset, uint64_t expected,
                    const ByteSink& sink) {
  VtiByteReader reader(source, offset, encoding.isBase64);
  if (encoding.isDeflated) {
    decodeDeflated(encoding, reader, source, expected, sink);
  } else {
    checkVtiBytes(reader, reader.word(encoding), expected);
    decodePlain(reader, expected, sink);
  }
}

}  // namespace ocelli
