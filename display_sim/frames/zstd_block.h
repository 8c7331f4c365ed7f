// Bytes as one zstd frame (RFC 8878) that states its content size, and back. An object works on one block at a time and
// keeps its buffers; threads have one each.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace ocelli {

class ZstdEncoder {
 public:
  ZstdEncoder();

  /// The result stays until the next call.
  std::span<const uint8_t> compress(std::span<const uint8_t> bytes);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
  std::vector<uint8_t> compressed_;
};

class ZstdDecoder {
 public:
  ZstdDecoder();

  /// Fills all of `content`. False for anything but exactly one zstd frame that states and has so much content; then
  /// `content` may hold anything.
  bool decompress(std::span<const uint8_t> block, std::span<uint8_t> content);

 private:
  struct Free {
    void operator()(ZSTD_DCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

}  // namespace ocelli
