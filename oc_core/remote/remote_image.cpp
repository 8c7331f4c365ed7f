#include "oc_core/remote/remote_image.h"

#include <algorithm>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/camera/gpc_map.h"
#include "oc_core/image/color.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote/depth_smoothing.h"
#include "oc_core/remote/remote_depth.h"
#include "oc_core/remote/row_names.h"

namespace ocelli {
namespace {

constexpr const char* kImage = "message \"image\"";
constexpr double kMaxSeconds = 1e9;

size_t readBytes(JsonFields& fields) {
  return static_cast<size_t>(fields.integer("bytes", 0, static_cast<int>(RemoteImageHeader::kMaxPlaneBytes)));
}

void readLayout(JsonFields& fields, GpcLayout& layout) {
  const bool hasRegions = !fields.value("regions").empty();
  if (hasRegions) {
    readGpcLayout(fields, layout);
  } else {
    layout.sampling = findGpcSampling(fields.choice("sampling", rowNames(gpcSamplings())).c_str());
  }
}

void readDepth(JsonFields plane, RemoteImageHeader& header) {
  constexpr double kTiny = 1e-12;
  header.depthCodec = plane.choice("codec", rowNames(depthCodecs()));
  header.depthBytes = readBytes(plane);
  header.inverseNear = plane.number("inverse_near", kTiny, 1 / kTiny);
  header.inverseFar = plane.number("inverse_far", kTiny, header.inverseNear);
  header.levels = plane.integer("levels", RemoteDepth::kMinLevels, RemoteDepth::kMaxLevels);
  plane.rejectUnknown();
}

void readColor(JsonFields plane, RemoteImageHeader& header) {
  header.colorCodec = plane.choice("codec", rowNames(colorCodecs()));
  header.colorBytes = readBytes(plane);
  plane.rejectUnknown();
}

void readSeconds(JsonFields seconds, RemoteImageHeader& header) {
  header.drawSeconds = seconds.number("draw", 0, kMaxSeconds);
  header.encodeSeconds = seconds.number("encode", 0, kMaxSeconds);
  seconds.rejectUnknown();
}

glm::ivec2 readSize(JsonFields& fields) {
  const std::vector<double> size = fields.numbers("size", 2, 1, kMaxCodedSide);
  const glm::ivec2 pixels(static_cast<int>(size[0]), static_cast<int>(size[1]));
  if (glm::dvec2(pixels) != glm::dvec2(size[0], size[1]) || size[0] * size[1] > static_cast<double>(kMaxCodedPixels)) {
    fields.fail("size", "must be whole numbers, with at most " + std::to_string(kMaxCodedPixels) + " pixels");
  }
  return pixels;
}

/// The densest samples' pixels for a length of 1 at a distance of 1.
double greatestFocalPixels(const ReferenceImage& image) {
  float zoom = 1;
  for (const GpcRegion& region : image.layout.regions) {
    zoom = std::max(zoom, region.zoom);
  }
  return static_cast<double>(image.reference().focalPixels()) * static_cast<double>(zoom);
}

}  // namespace

std::string jsonText(const RemoteImageHeader& header) {
  const auto parsed = [](const std::string& text) { return nlohmann::ordered_json::parse(text); };
  return textOfJson({{"type", "image"},
                     {"id", header.id},
                     {"sequence", header.sequence},
                     {"view", parsed(jsonText(header.view))},
                     {"size", {header.size.x, header.size.y}},
                     {"sampling", header.layout.sampling->name},
                     {"regions", parsed(gpcRegionsText(header.layout))},
                     {"color", {{"codec", header.colorCodec}, {"bytes", header.colorBytes}}},
                     {"depth",
                      {{"codec", header.depthCodec},
                       {"bytes", header.depthBytes},
                       {"inverse_near", header.inverseNear},
                       {"inverse_far", header.inverseFar},
                       {"levels", header.levels}}},
                     {"seconds", {{"draw", header.drawSeconds}, {"encode", header.encodeSeconds}}}});
}

RemoteImageHeader remoteImageHeaderFromJson(const std::string& text) {
  return readAs("docs/remote_protocol.md", [&] {
    if (text.size() > RemoteImageHeader::kMaxTextBytes) {
      throw InputError("a header has at most " + std::to_string(RemoteImageHeader::kMaxTextBytes) + " bytes", kImage,
                       "send less");
    }
    const nlohmann::json json = parseJson(text, kImage);
    JsonFields fields(json, kImage);
    RemoteImageHeader header;
    fields.choice("type", {"image"});
    header.id = static_cast<uint32_t>(fields.integer("id", 0, std::numeric_limits<int>::max()));
    header.sequence = static_cast<uint32_t>(fields.integer("sequence", 0, std::numeric_limits<int>::max()));
    header.view = viewFromJsonText(fields.value("view").dump(), std::string(kImage) + ", \"view\"");
    header.size = readSize(fields);
    readLayout(fields, header.layout);
    readColor(fields.inner("color"), header);
    readDepth(fields.inner("depth"), header);
    readSeconds(fields.inner("seconds"), header);
    fields.rejectUnknown();
    return header;
  });
}

RemoteImage encodeRemoteImage(const ReferenceImage& image, const RemoteSettings& settings, uint32_t id,
                              uint32_t sequence, double drawSeconds) {
  validate(settings, "settings");
  const int64_t start = steadyNanoseconds();
  RemoteImage coded{.id = id, .sequence = sequence};
  RemoteDepth depth;
  const auto encodeColor = [&] {
    coded.color = findColorCodec(settings.color)->encode(srgbFromLinear(image.color), settings.quality);
  };
  const auto encodeDepth = [&] {
    const int levels = depthLevels(image.t, greatestFocalPixels(image), settings.translation, settings.depthError);
    depth = roundedDepth(image.t, levels);
    coded.depth = findDepthCodec(settings.depth)->encode(depth.values);
  };
  // Most codecs work on one thread.
  parallelFor(2, 1, [&](size_t begin, size_t end) {
    for (size_t plane = begin; plane < end; ++plane) {
      plane == 0 ? encodeColor() : encodeDepth();
    }
  });
  coded.headerJson =
      jsonText(RemoteImageHeader{.id = id,
                                 .sequence = sequence,
                                 .view = image.view,
                                 .size = {image.width(), image.height()},
                                 .layout = image.layout,
                                 .colorCodec = settings.color,
                                 .colorBytes = coded.color.size(),
                                 .depthCodec = settings.depth,
                                 .depthBytes = coded.depth.size(),
                                 .inverseNear = depth.inverseNear,
                                 .inverseFar = depth.inverseFar,
                                 .levels = depth.levels,
                                 .drawSeconds = drawSeconds,
                                 .encodeSeconds = static_cast<double>(steadyNanoseconds() - start) * 1e-9});
  return coded;
}

ReferenceImage decodeRemoteImage(const std::string& headerJson, std::span<const std::byte> color,
                                 std::span<const std::byte> depth) {
  const RemoteImageHeader header = remoteImageHeaderFromJson(headerJson);
  const Image<Rgb8> colors = findColorCodec(header.colorCodec)->decode(color, header.size);
  RemoteDepth depths{.inverseNear = header.inverseNear, .inverseFar = header.inverseFar, .levels = header.levels};
  if (!depth.empty()) {
    depths.values = findDepthCodec(header.depthCodec)->decode(depth, header.size);
    if (std::ranges::any_of(depths.values, [&](uint16_t value) { return value > header.levels; })) {
      throw InputError("a depth is larger than \"levels\"", kImage, "send it again");
    }
  }
  ReferenceImage image = blankReferenceImage("gpc", header.view, header.size.x, header.size.y);
  image.layout = header.layout;
  const GpcMap map(header.layout, header.size.x, header.size.y);
  const Image<float> levels = smoothedLevels(depths.values);
  parallelFor(static_cast<size_t>(header.size.y), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < header.size.x; ++x) {
        const Rgb8& rgb = colors(x, y);
        image.color(x, y) = {linearFromSrgbByte(rgb.x), linearFromSrgbByte(rgb.y), linearFromSrgbByte(rgb.z)};
        if (!depths.values.empty() && depths.values(x, y) > 0) {
          image.t(x, y) = static_cast<float>(1 / depths.inverseDepth(static_cast<double>(levels(x, y))));
          image.held(x, y) = 1;
          const glm::dvec2 center(x + 0.5, y + 0.5);
          image.displacement(x, y) = glm::vec2(center - map.pinholeFromImage(center));
        }
      }
    }
  });
  return image;
}

}  // namespace ocelli
