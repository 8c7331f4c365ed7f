#include "oc_core/volume/import/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kInflatedPiece = 1 << 18;

class Inflater {
 public:
  Inflater() {
    constexpr int kZlibOrGzip = 32;
    OC_CHECK(inflateInit2(&stream_, MAX_WBITS + kZlibOrGzip) == Z_OK, "zlib starts");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
};

}  // namespace

uint64_t inflateBytes(const ByteFeed& feed, uint64_t limit, const std::string& where, const ByteSink& sink) {
  Inflater inflater;
  z_stream& stream = inflater.stream();
  std::vector<std::byte> piece(kInflatedPiece);
  std::span<const std::byte> rest;
  uint64_t written = 0;
  bool isFirst = true;    // of the streams
  bool isWithin = false;  // a stream
  while (written < limit) {
    if (rest.empty()) {
      rest = feed();
      if (rest.empty()) {
        if (isWithin || isFirst) {
          throw InputError("the compressed voxels end too early", where, "copy or export the file again");
        }
        break;
      }
    }
    const size_t room = static_cast<size_t>(std::min<uint64_t>(piece.size(), limit - written));
    const size_t given = std::min<size_t>(rest.size(), 1U << 30U);
    // zlib takes it without const, and does not write to it.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(rest.data()));
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(room);
    const int status = inflate(&stream, Z_NO_FLUSH);
    rest = rest.subspan(given - stream.avail_in);
    const size_t got = room - stream.avail_out;
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
      if (!isFirst && !isWithin) {
        break;  // no further stream, but something else, such as zeros that fill a block
      }
      throw InputError("the compressed voxels are damaged", where, "copy or export the file again");
    }
    sink(std::span(piece).first(got));
    written += got;
    isWithin = status != Z_STREAM_END;
    if (status == Z_STREAM_END) {
      isFirst = false;
      inflateReset(&stream);
    }
  }
  return written;
}

}  // namespace ocelli
