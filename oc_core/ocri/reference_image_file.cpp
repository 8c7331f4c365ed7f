#include "oc_core/ocri/reference_image_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/image/exr_reader.h"
#include "oc_core/ocri/layered_depth_image.h"

namespace ocelli {
namespace {

constexpr int kFormat = 1;
constexpr int kMaxPixelsASide = PinholeCamera::kMaxPixelsASide;
constexpr int64_t kMaxPixels = PinholeCamera::kMaxPixels;
constexpr size_t kMaxParts = 64;
constexpr const char* kNext = "build it again with `ocelli ocri build`";

std::vector<ExrChannel> channelsOf(const ReferenceImage& image) {
  const glm::vec3* color = image.color.data();
  std::vector<ExrChannel> channels{{"R", &color->x, sizeof(*color)},
                                   {"G", &color->y, sizeof(*color)},
                                   {"B", &color->z, sizeof(*color)},
                                   {"Z", image.t.data(), sizeof(float)}};
  if (image.isPlaced()) {
    const glm::vec3* position = image.position.data();
    const glm::vec3* direction = image.direction.data();
    channels.insert(channels.end(), {{"P.X", &position->x, sizeof(*position)},
                                     {"P.Y", &position->y, sizeof(*position)},
                                     {"P.Z", &position->z, sizeof(*position)},
                                     {"D.X", &direction->x, sizeof(*direction)},
                                     {"D.Y", &direction->y, sizeof(*direction)},
                                     {"D.Z", &direction->z, sizeof(*direction)}});
  } else {
    const glm::vec2* displacement = image.displacement.data();
    channels.insert(channels.end(), {{"offset.u", &displacement->x, sizeof(*displacement)},
                                     {"offset.v", &displacement->y, sizeof(*displacement)}});
  }
  return channels;
}

struct RowsName {
  ImageRows rows;
  const char* name;
};
constexpr std::array<RowsName, 3> kRowsNames{
    {{ImageRows::kAligned, "aligned"}, {ImageRows::kShifted, "shifted"}, {ImageRows::kShiftedRing, "shifted_ring"}}};

std::string attributeText(const ReferenceImage& image) {
  nlohmann::ordered_json json;
  json["format"] = kFormat;
  json["camera"] = image.camera;
  json["view"] = nlohmann::ordered_json::parse(jsonText(image.view));
  if (image.triangleBound > 0) {
    json["triangle_bound"] = image.triangleBound;
  }
  if (image.pinholeSize.x > 0) {
    json["pinhole_size"] = {{"width", image.pinholeSize.x}, {"height", image.pinholeSize.y}};
  }
  if (image.rows != ImageRows::kAligned) {
    json["rows"] = kRowsNames[static_cast<size_t>(image.rows)].name;
  }
  if (image.layer > 0) {
    json["layer"] = image.layer;
  }
  if (image.tileSide > 0) {
    json["tile_side"] = image.tileSide;
    json["tile_spacing"] = image.tileSpacing;
  }
  if (image.seenFromAside) {
    json["seen_from_aside"] = true;
  }
  if (image.isPlaced()) {
    json["placed"] = true;
  }
  if (image.wrapsAround) {
    json["wraps_around"] = true;
  }
  if (!image.layout.regions.empty()) {
    json["layout"] = nlohmann::ordered_json::parse(jsonText(image.layout));
  }
  return textOfJson(json);
}

ImageRows readRows(JsonFields& fields) {
  const std::string name = fields.text("rows", kRowsNames[0].name);
  for (const RowsName& known : kRowsNames) {
    if (name == known.name) {
      return known.rows;
    }
  }
  fields.fail("rows", "must be aligned, shifted or shifted_ring");
}

/// Returns whether its samples say where they are.
bool readAttribute(const std::string& text, const std::string& where, ReferenceImage& image) {
  const std::string attribute = where + ", attribute \"ocelli\"";
  const nlohmann::json json = parseJson(text, attribute);
  if (json.is_object() && json.contains("type")) {
    throw InputError("this is a ray map, which holds rays and no samples", where,
                     "give it to --camera, which builds a reference image of a scene along its rays");
  }
  JsonFields fields(json, attribute);
  fields.integer("format", kFormat, kFormat);
  image.camera = fields.text("camera");
  image.view = viewFromJsonText(fields.value("view").dump(), attribute + ", \"view\"");
  image.triangleBound = static_cast<size_t>(fields.integer("triangle_bound", 0, 2147483647, 0));
  if (fields.has("pinhole_size")) {
    JsonFields size = fields.inner("pinhole_size");
    image.pinholeSize = {size.integer("width", 1, kMaxPixelsASide), size.integer("height", 1, kMaxPixelsASide)};
    size.rejectUnknown();
    if (int64_t{image.pinholeSize.x} * image.pinholeSize.y > kMaxPixels) {
      fields.fail("pinhole_size", "must be at most 2^26 pixels in all");
    }
  }
  image.rows = readRows(fields);
  image.layer = fields.integer("layer", 1, kMaxLayers, 0);
  image.tileSide = fields.integer("tile_side", 2, kMaxPixelsASide, 0);
  image.tileSpacing = static_cast<float>(fields.number("tile_spacing", 0.01, 100, 1));
  image.seenFromAside = fields.boolean("seen_from_aside", false);
  image.wrapsAround = fields.boolean("wraps_around", false);
  const bool placed = fields.boolean("placed", false);
  if (placed && (image.rows != ImageRows::kAligned || image.tileSide > 0 || image.layer > 0)) {
    fields.fail("placed", "says nothing of rows, tiles and layers, which displace a pinhole's image");
  }
  if (image.wrapsAround && !placed) {
    fields.fail("wraps_around", "is for placed samples");
  }
  if (fields.has("layout")) {
    JsonFields layout = fields.inner("layout");
    readGpcLayout(layout, image.layout);
    layout.rejectUnknown();
    if (placed || image.rows != ImageRows::kAligned || image.tileSide > 0 || image.pinholeSize.x > 0) {
      fields.fail("layout", "is for the image of a pinhole alone");
    }
  }
  fields.rejectUnknown();
  return placed;
}

void allocate(ReferenceImage& image, int width, int height, bool placed) {
  ReferenceImage blank = blankReferenceImage(image.camera, image.view, width, height, placed);
  image.color = std::move(blank.color);
  image.t = std::move(blank.t);
  image.held = std::move(blank.held);
  image.displacement = std::move(blank.displacement);
  image.position = std::move(blank.position);
  image.direction = std::move(blank.direction);
}

/// Camera, view and an image of the right size, from a header that fits a reference image of `fileBytes` bytes.
void readHeader(const ExrPartHeader& header, size_t fileBytes, const std::string& where, ReferenceImage& image) {
  const int64_t width = header.width;
  const int64_t height = header.height;
  if (header.left != 0 || header.top != 0 || width < 1 || height < 1 || width > kMaxPixelsASide ||
      height > kMaxPixelsASide || width * height > kMaxPixels) {
    throw InputError("its data window is not that of a reference image of at most 2^26 pixels", where, kNext);
  }
  if (!header.description) {
    throw InputError("it has no \"ocelli\" attribute, so it is no reference image", where, kNext);
  }
  const bool placed = readAttribute(*header.description, where, image);
  // One pixel of it names the channels.
  allocate(image, 1, 1, placed);
  const std::vector<ExrChannel> channels = channelsOf(image);
  for (const ExrChannel& channel : channels) {
    const ExrChannelHeader* stored = header.find(channel.name);
    if (stored == nullptr || !stored->isFloat || !stored->fullSize) {
      throw InputError("channel " + std::string(channel.name) + " is missing or no full-size 32-bit float", where,
                       kNext);
    }
  }
  // No more memory than the file can fill.
  if (width * height * static_cast<int64_t>(channels.size() * sizeof(float)) >
      kMaxExrCompression * static_cast<int64_t>(fileBytes)) {
    throw InputError(
        "it is too short for the " + std::to_string(width) + "x" + std::to_string(height) + " samples of its header",
        where, kNext);
  }
  allocate(image, static_cast<int>(width), static_cast<int>(height), placed);
}

/// Which pixels hold a sample: where a pinhole's image is displaced those of positive z, elsewhere those whose rays
/// have a direction. Throws InputError where the values are not those of a reference image.
void findSamples(ReferenceImage& image, const std::string& where) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const float t = image.t(x, y);
      const glm::vec2& d = image.displacement(x, y);
      const glm::vec3& c = image.color(x, y);
      const glm::vec3 place = image.isPlaced() ? image.position(x, y) + image.direction(x, y) : glm::vec3(0);
      if (!(image.isPlaced() || t >= 0) ||
          !std::isfinite(t + d.x + d.y + c.x + c.y + c.z + place.x + place.y + place.z)) {
        throw InputError("the sample at pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                             ") has a negative depth or a value that is not a finite number",
                         where, kNext);
      }
      image.held(x, y) = image.isPlaced() ? image.direction(x, y) != glm::vec3(0) : t > 0;
      if (!image.holds(x, y)) {
        image.t(x, y) = 0;
      }
    }
  }
}

std::string partName(const std::string& where, size_t part, size_t parts) {
  return parts == 1 ? where : fmt::format("{}, part {}", where, part);
}

}  // namespace

void writeReferenceImages(const std::filesystem::path& path, const ReferenceImages& images) {
  OC_CHECK(!images.empty(), "a file holds a reference image at least");
  if (images.size() > kMaxParts) {
    throw InputError(
        "these are " + std::to_string(images.size()) + " images; a file holds " + std::to_string(kMaxParts),
        path.string(), "fewer --viewers, or a camera of fewer images");
  }
  std::vector<ExrPart> parts;
  for (const ReferenceImage& image : images) {
    parts.push_back({fmt::format("{:02} {}", parts.size(), image.camera), image.width(), image.height(),
                     channelsOf(image), attributeText(image)});
  }
  writeFile(path, exrBytes(parts));
}

ReferenceImages referenceImagesFromBytes(std::string_view bytes, const std::string& where) {
  ReferenceImages images;
  try {
    const std::vector<ExrPartHeader> headers = exrHeaders(bytes, kMaxParts);
    int64_t pixels = 0;
    for (const ExrPartHeader& header : headers) {
      images.emplace_back();
      readHeader(header, bytes.size(), partName(where, images.size() - 1, headers.size()), images.back());
      pixels += static_cast<int64_t>(images.back().t.size());
      if (pixels > kMaxPixels) {
        throw InputError("its images have more than 2^26 pixels in all", where, kNext);
      }
    }
    ExrReader reader(bytes);
    for (size_t i = 0; i < images.size(); ++i) {
      reader.read(i, headers[i], channelsOf(images[i]));
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("cannot read this as an EXR file (" + std::string(error.what()) + ")", where, kNext);
  }
  for (size_t i = 0; i < images.size(); ++i) {
    const std::string part = partName(where, i, images.size());
    findSamples(images[i], part);
    const ReferenceImage* before = i > 0 ? &images[i - 1] : nullptr;
    if (images[i].layer > 0 &&
        (before == nullptr || images[i].layer != before->layer + 1 || images[i].width() != before->width() ||
         images[i].height() != before->height() || images[i].view != before->view)) {
      throw InputError("it is layer " + std::to_string(images[i].layer) + " of another image than the part before it",
                       part, kNext);
    }
  }
  return images;
}

ReferenceImages readReferenceImages(const std::filesystem::path& path) {
  return referenceImagesFromBytes(readFile(path), path.string());
}

}  // namespace ocelli
