#include "display_sim/frames/zstd_block.h"

#include <zstd.h>

#include <new>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// The default, 3, takes as long and writes as much; from 4 on it takes more than twice as long for a few percent.
constexpr int kCompressionLevel = 1;

}  // namespace

void ZstdEncoder::Free::operator()(ZSTD_CCtx_s* context) const {
  ZSTD_freeCCtx(context);
}

ZstdEncoder::ZstdEncoder() : context_(ZSTD_createCCtx()) {
  if (!context_) {
    throw std::bad_alloc();
  }
}

std::span<const uint8_t> ZstdEncoder::compress(std::span<const uint8_t> bytes) {
  compressed_.resize(ZSTD_compressBound(bytes.size()));
  const size_t size = ZSTD_compressCCtx(context_.get(), compressed_.data(), compressed_.size(), bytes.data(),
                                        bytes.size(), kCompressionLevel);
  OC_CHECK(ZSTD_isError(size) == 0, "zstd refused a buffer of the size that it asked for");
  return std::span(compressed_).first(size);
}

void ZstdDecoder::Free::operator()(ZSTD_DCtx_s* context) const {
  ZSTD_freeDCtx(context);
}

ZstdDecoder::ZstdDecoder() : context_(ZSTD_createDCtx()) {
  if (!context_) {
    throw std::bad_alloc();
  }
}

bool ZstdDecoder::decompress(std::span<const uint8_t> block, std::span<uint8_t> content) {
  return ZSTD_findFrameCompressedSize(block.data(), block.size()) == block.size() &&
         ZSTD_getFrameContentSize(block.data(), block.size()) == content.size() &&
         ZSTD_decompressDCtx(context_.get(), content.data(), content.size(), block.data(), block.size()) ==
             content.size();
}

}  // namespace ocelli
