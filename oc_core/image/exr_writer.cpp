#include "oc_core/image/exr_writer.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>

#include <cstring>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// An OpenEXR stream into a string.
class BytesOut : public Imf::OStream {
 public:
  BytesOut() : OStream("memory") {}
  void write(const char c[], int n) override {
    const size_t end = position_ + static_cast<size_t>(n);
    if (end > bytes.size()) {
      bytes.resize(end);
    }
    std::memcpy(bytes.data() + position_, c, static_cast<size_t>(n));
    position_ = end;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }

  std::string bytes;

 private:
  size_t position_ = 0;
};

Imf::PixelType typeOf(const ExrChannel& channel) {
  return channel.isWhole ? Imf::UINT : Imf::FLOAT;
}

Imf::Header headerOf(const ExrPart& part, const Imath::Box2i& window) {
  OC_CHECK(part.width > 0 && part.height > 0, "an empty image has no EXR form");
  Imf::Header header(window, Imath::Box2i({0, 0}, {part.width - 1, part.height - 1}));
  header.setName(part.name);
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const ExrChannel& channel : part.channels) {
    header.channels().insert(channel.name, Imf::Channel(typeOf(channel)));
  }
  header.insert(kExrDescription, Imf::StringAttribute(part.description));
  return header;
}

Imf::FrameBuffer frameBufferOf(const ExrPart& part) {
  Imf::FrameBuffer buffer;
  for (const ExrChannel& channel : part.channels) {
    // OpenEXR takes writable pointers for reading and writing alike.
    auto* base = const_cast<char*>(static_cast<const char*>(channel.first));
    buffer.insert(channel.name,
                  Imf::Slice(typeOf(channel), base, channel.stride, channel.stride * static_cast<size_t>(part.width)));
  }
  return buffer;
}

}  // namespace

std::string exrBytes(const std::vector<ExrPart>& parts, const std::function<void(size_t part)>& fill) {
  OC_CHECK(!parts.empty(), "an EXR file holds an image at least");
  Imath::Box2i window({0, 0}, {0, 0});
  for (const ExrPart& part : parts) {
    window.extendBy(Imath::V2i(part.width - 1, part.height - 1));
  }
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) {
    headers.push_back(headerOf(part, window));
  }
  BytesOut stream;
  {
    Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
    for (size_t i = 0; i < parts.size(); ++i) {
      if (fill) {
        fill(i);
      }
      Imf::OutputPart part(file, static_cast<int>(i));
      part.setFrameBuffer(frameBufferOf(parts[i]));
      part.writePixels(parts[i].height);
    }
  }
  return std::move(stream.bytes);
}

}  // namespace ocelli
