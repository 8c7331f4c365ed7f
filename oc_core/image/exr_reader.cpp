#include "oc_core/image/exr_reader.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace ocelli {
namespace {

/// An OpenEXR stream from bytes in memory.
class BytesIn : public Imf::IStream {
 public:
  explicit BytesIn(std::string_view bytes) : IStream("memory"), bytes_(bytes) {}
  bool read(char c[], int n) override {
    if (n < 0 || position_ > bytes_.size() || static_cast<size_t>(n) > bytes_.size() - position_) {
      throw std::runtime_error("it ends too early");
    }
    std::memcpy(c, bytes_.data() + position_, static_cast<size_t>(n));
    position_ += static_cast<size_t>(n);
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  size_t position_ = 0;
};

ExrPartHeader partHeaderOf(const Imf::Header& header) {
  const Imath::Box2i& window = header.dataWindow();
  ExrPartHeader part{.left = window.min.x,
                     .top = window.min.y,
                     .width = int64_t{window.max.x} - window.min.x + 1,
                     .height = int64_t{window.max.y} - window.min.y + 1};
  for (auto each = header.channels().begin(); each != header.channels().end(); ++each) {
    const Imf::Channel& channel = each.channel();
    part.channels.push_back(
        {each.name(), channel.type == Imf::FLOAT, channel.xSampling == 1 && channel.ySampling == 1});
  }
  if (const auto* text = header.findTypedAttribute<Imf::StringAttribute>(kExrDescription)) {
    part.description = text->value();
  }
  return part;
}

}  // namespace

const ExrChannelHeader* ExrPartHeader::find(std::string_view channel) const {
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const ExrChannelHeader& each) { return each.name == channel; });
  return found == channels.end() ? nullptr : &*found;
}

std::vector<ExrPartHeader> exrHeaders(std::string_view bytes, size_t maxParts) {
  const auto byte = [&](size_t i) { return static_cast<uint32_t>(static_cast<unsigned char>(bytes[i])); };
  const auto word = [&](size_t i) { return byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24; };
  constexpr size_t kMagicAndVersion = 8;
  if (bytes.size() < kMagicAndVersion || word(0) != static_cast<uint32_t>(Imf::MAGIC)) {
    throw std::runtime_error("it does not start like one");
  }
  BytesIn stream(bytes);
  stream.seekg(kMagicAndVersion);
  auto version = static_cast<int>(word(4));
  std::vector<ExrPartHeader> headers;
  const auto readOne = [&] {
    Imf::Header header;
    header.readFrom(stream, version);
    headers.push_back(partHeaderOf(header));
  };
  readOne();
  if (Imf::isMultiPart(version)) {
    const auto atEnd = [&] { return stream.tellg() >= bytes.size() || bytes[stream.tellg()] == '\0'; };
    while (!atEnd()) {
      if (headers.size() == maxParts) {
        throw std::runtime_error("it has more than " + std::to_string(maxParts) + " parts");
      }
      readOne();
    }
  }
  return headers;
}

struct ExrReader::Impl {
  explicit Impl(std::string_view bytes) : stream(bytes), file(stream) {}
  BytesIn stream;
  Imf::MultiPartInputFile file;
};

ExrReader::ExrReader(std::string_view bytes) : impl_(std::make_unique<Impl>(bytes)) {}

ExrReader::~ExrReader() = default;

void ExrReader::read(size_t part, const ExrPartHeader& header, const std::vector<ExrChannel>& channels) {
  Imf::FrameBuffer buffer;
  for (const ExrChannel& channel : channels) {
    // OpenEXR counts from pixel (0, 0), which may lie outside of the window.
    const auto columnBytes = static_cast<int64_t>(channel.stride);
    const int64_t rowBytes = columnBytes * header.width;
    auto* first = const_cast<char*>(static_cast<const char*>(channel.first));
    buffer.insert(channel.name, Imf::Slice(channel.isWhole ? Imf::UINT : Imf::FLOAT,
                                           first - header.left * columnBytes - header.top * rowBytes, channel.stride,
                                           static_cast<size_t>(rowBytes)));
  }
  Imf::InputPart input(impl_->file, static_cast<int>(part));
  input.setFrameBuffer(buffer);
  input.readPixels(static_cast<int>(header.top), static_cast<int>(header.top + header.height - 1));
}

}  // namespace ocelli
