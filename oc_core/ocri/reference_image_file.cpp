#include "oc_core/ocri/reference_image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <array>
#include <cmath>
#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr int kFormat = 1;
constexpr const char* kAttribute = "ocelli";
constexpr int kMostPixelsASide = 32768;
constexpr int64_t kMostPixels = int64_t{1} << 27;
constexpr const char* kNext = "build it again with `ocelli ocri build`";

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

struct Channel {
  const char* name;
  const void* first;  ///< the value of the first pixel
  size_t stride;      ///< bytes from one pixel to the next
};

std::array<Channel, 6> channelsOf(const ReferenceImage& image) {
  const glm::vec3* color = image.color.data();
  const glm::vec2* displacement = image.displacement.data();
  return {Channel{"R", &color->x, sizeof(*color)},
          Channel{"G", &color->y, sizeof(*color)},
          Channel{"B", &color->z, sizeof(*color)},
          Channel{"Z", image.z.data(), sizeof(float)},
          Channel{"offset.u", &displacement->x, sizeof(*displacement)},
          Channel{"offset.v", &displacement->y, sizeof(*displacement)}};
}

Imf::FrameBuffer frameBufferOf(const ReferenceImage& image) {
  Imf::FrameBuffer buffer;
  for (const Channel& channel : channelsOf(image)) {
    // OpenEXR takes writable pointers for reading and writing alike.
    auto* base = const_cast<char*>(static_cast<const char*>(channel.first));
    buffer.insert(channel.name,
                  Imf::Slice(Imf::FLOAT, base, channel.stride, channel.stride * static_cast<size_t>(image.width())));
  }
  return buffer;
}

std::string attributeText(const ReferenceImage& image) {
  nlohmann::ordered_json json;
  json["format"] = kFormat;
  json["camera"] = image.camera;
  json["view"] = nlohmann::ordered_json::parse(jsonText(image.view));
  if (image.triangleBound > 0) {
    json["triangle_bound"] = image.triangleBound;
  }
  return json.dump();
}

void readAttribute(const std::string& text, const std::string& where, ReferenceImage& image) {
  const std::string attribute = where + ", attribute \"ocelli\"";
  const nlohmann::json json = parseJson(text, attribute);
  JsonFields fields(json, attribute);
  fields.integer("format", kFormat, kFormat);
  image.camera = fields.text("camera");
  image.view = viewFromJsonText(fields.value("view").dump(), attribute + ", \"view\"");
  image.triangleBound = static_cast<size_t>(fields.integer("triangle_bound", 0, 2147483647, 0));
  fields.rejectUnknown();
}

void validate(const ReferenceImage& image, const std::string& where) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const float z = image.z(x, y);
      const glm::vec2& d = image.displacement(x, y);
      const glm::vec3& c = image.color(x, y);
      if (!(z >= 0) || !std::isfinite(z + d.x + d.y + c.x + c.y + c.z)) {
        throw InputError("the sample at pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                             ") has a negative depth or a value that is not a finite number",
                         where, kNext);
      }
    }
  }
}

}  // namespace

void writeReferenceImage(const std::filesystem::path& path, const ReferenceImage& image) {
  OC_CHECK(!image.z.empty(), "an empty image has no EXR form");
  Imf::Header header(image.width(), image.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const Channel& channel : channelsOf(image)) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  }
  header.insert(kAttribute, Imf::StringAttribute(attributeText(image)));
  BytesOut stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frameBufferOf(image));
    file.writePixels(image.height());
  }
  writeFile(path, stream.bytes);
}

ReferenceImage referenceImageFromBytes(std::string_view bytes, const std::string& where) {
  ReferenceImage image;
  try {
    BytesIn stream(bytes);
    Imf::InputFile file(stream);
    const Imf::Header& header = file.header();
    const Imath::Box2i& window = header.dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1;
    const int64_t height = int64_t{window.max.y} - window.min.y + 1;
    if (window.min.x != 0 || window.min.y != 0 || width < 1 || height < 1 || width > kMostPixelsASide ||
        height > kMostPixelsASide || width * height > kMostPixels) {
      throw InputError("its data window is not that of a reference image of at most 2^27 pixels", where, kNext);
    }
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(kAttribute);
    if (attribute == nullptr) {
      throw InputError("it has no \"ocelli\" attribute, so it is no reference image", where, kNext);
    }
    readAttribute(attribute->value(), where, image);
    const int w = static_cast<int>(width);
    const int h = static_cast<int>(height);
    image.color = Image<glm::vec3>(w, h);
    image.z = Image<float>(w, h);
    image.displacement = Image<glm::vec2>(w, h);
    for (const Channel& channel : channelsOf(image)) {
      const Imf::Channel* stored = header.channels().findChannel(channel.name);
      if (stored == nullptr || stored->type != Imf::FLOAT || stored->xSampling != 1 || stored->ySampling != 1) {
        throw InputError("channel " + std::string(channel.name) + " is missing or no full-size 32-bit float", where,
                         kNext);
      }
    }
    file.setFrameBuffer(frameBufferOf(image));
    file.readPixels(0, h - 1);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("cannot read this as an EXR file (" + std::string(error.what()) + ")", where, kNext);
  }
  validate(image, where);
  return image;
}

ReferenceImage readReferenceImage(const std::filesystem::path& path) {
  return referenceImageFromBytes(readFile(path), path.string());
}

}  // namespace ocelli
