#include "oc_core/ray_map/ray_map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/exr_reader.h"

namespace ocelli {
namespace {

constexpr const char* kType = "rays";
constexpr int kFormat = 1;
constexpr size_t kMaxSegments = RayPath::kMaxPoints - 1;
constexpr size_t kMaxStoredSegments = size_t{1} << 27;  ///< several gigabytes
constexpr const char* kFileNext = "docs/ray_maps.md says what such a file holds; `ocelli camera rays` writes them";

/// What a part holds of each pixel, as its channels follow each other in memory.
struct StoredSegment {
  glm::vec3 origin{0};
  glm::vec3 direction{0};
  float length = 0;
  float tBegin = 0;
  float tEnd = 0;
};

using FloatIn = const float* (*)(const StoredSegment&);
struct ChannelRow {
  const char* name;
  FloatIn in;
};
constexpr std::array<ChannelRow, 6> kRayChannels{{
    {"origin.x", [](const StoredSegment& p) { return &p.origin.x; }},
    {"origin.y", [](const StoredSegment& p) { return &p.origin.y; }},
    {"origin.z", [](const StoredSegment& p) { return &p.origin.z; }},
    {"direction.x", [](const StoredSegment& p) { return &p.direction.x; }},
    {"direction.y", [](const StoredSegment& p) { return &p.direction.y; }},
    {"direction.z", [](const StoredSegment& p) { return &p.direction.z; }},
}};
constexpr ChannelRow kLengthChannel{"length", [](const StoredSegment& p) { return &p.length; }};
constexpr std::array<ChannelRow, 2> kParameterChannels{{
    {"t.begin", [](const StoredSegment& p) { return &p.tBegin; }},
    {"t.end", [](const StoredSegment& p) { return &p.tEnd; }},
}};

ExrChannel channelOf(const ChannelRow& row, const std::vector<StoredSegment>& segments) {
  return {row.name, row.in(segments.front()), sizeof(StoredSegment)};
}

// ---- the description

std::string descriptionOf(const RayMap& map) {
  const RayMapNotes& notes = map.notes();
  nlohmann::ordered_json json{{"type", kType}, {"format", kFormat}, {"name", notes.name}};
  json["frame"] = nameOf(notes.frame);
  if (notes.view) {
    json["view"] = nlohmann::ordered_json::parse(jsonText(*notes.view));
  }
  if (notes.wrapsAround) {
    json["wraps_around"] = true;
  }
  return textOfJson(json);
}

struct Description {
  RayMapNotes notes;
  float near = 0;
  float far = RayMap::kDefaultFar;
  bool saysRange = false;
};

/// `stem` is what a map without a name is called.
Description readDescription(const std::optional<std::string>& text, const std::string& where, const std::string& stem) {
  Description description;
  description.notes.name = stem;
  if (!text) {
    return description;
  }
  const std::string attribute = where + ", attribute \"ocelli\"";
  const nlohmann::json json = parseJson(*text, attribute);
  if (json.is_object() && !json.contains("type")) {
    throw InputError("this is a reference image, which holds samples and no rays", where,
                     "give --camera the camera that it was made with, or `ocelli resample` the image");
  }
  JsonFields fields(json, attribute);
  fields.choice("type", {kType});
  fields.integer("format", kFormat, kFormat);
  RayMapNotes& notes = description.notes;
  notes.name = fields.text("name", stem);
  notes.frame = fields.choiceOf("frame", kRayFrames, RayFrame::kWorld);
  notes.wrapsAround = fields.boolean("wraps_around", false);
  if (fields.has("view")) {
    notes.view = viewFromJsonText(fields.value("view").dump(), attribute + ", \"view\"");
  }
  description.saysRange = fields.has("near") || fields.has("far");
  description.near = static_cast<float>(fields.number("near", 0, 1e9, description.near));
  description.far = static_cast<float>(fields.number("far", 1e-6, 1e9, description.far));
  fields.rejectUnknown();
  if (!(description.far > description.near)) {
    fields.fail("far", "must be greater than \"near\"");
  }
  return description;
}

// ---- writing

/// Segment `number` of each ray; 0 for rays of fewer segments.
void fillSegments(const RayMap& map, size_t number, std::vector<StoredSegment>& segments) {
  parallelFor(static_cast<size_t>(map.height()), 8, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const RayMapRay ray = map.ray(x, static_cast<int>(y));
        StoredSegment& segment = segments[y * static_cast<size_t>(map.width()) + static_cast<size_t>(x)];
        segment = {};
        if (number + 1 < ray.points.size()) {
          const glm::dvec3 from(ray.points[number]);
          const glm::dvec3 way = glm::dvec3(ray.points[number + 1]) - from;
          const double length = glm::length(way);
          segment = {ray.points[number], glm::vec3(length > 0 ? way / length : glm::dvec3(0, 0, 1)),
                     static_cast<float>(length), ray.parameters[number], ray.parameters[number + 1]};
        }
      }
    }
  });
}

// ---- reading

void requireChannels(const ExrPartHeader& header, std::span<const ChannelRow> rows, const std::string& where) {
  for (const ChannelRow& row : rows) {
    const ExrChannelHeader* channel = header.find(row.name);
    if (channel == nullptr) {
      throw InputError(fmt::format("it has no channel \"{}\"", row.name), where, kFileNext);
    }
    if (!channel->isFloat || !channel->fullSize) {
      throw InputError(fmt::format("channel \"{}\" has no 32-bit float for each pixel", row.name), where,
                       "write it as 32-bit float (FLOAT), without subsampling");
    }
  }
}

bool hasAny(const ExrPartHeader& header, std::span<const ChannelRow> rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const ChannelRow& row) { return header.find(row.name) != nullptr; });
}

glm::ivec2 sizeOf(const ExrPartHeader& header, const std::string& where) {
  if (header.width < 1 || header.height < 1 || header.width > PinholeCamera::kMaxPixelsASide ||
      header.height > PinholeCamera::kMaxPixelsASide || header.width * header.height > PinholeCamera::kMaxPixels) {
    throw InputError(fmt::format("its image has {}x{} pixels", header.width, header.height), where,
                     "a ray map has 32768 a side, and 2^26 in all, at most");
  }
  return {static_cast<int>(header.width), static_cast<int>(header.height)};
}

/// Whether the numbers are those of a ray, and not those of a pixel without one.
bool isRay(const StoredSegment& segment) {
  const float sum = segment.origin.x + segment.origin.y + segment.origin.z + segment.direction.x + segment.direction.y +
                    segment.direction.z;
  return std::isfinite(sum) && segment.direction != glm::vec3(0);
}

/// Puts the segments of one pixel after the other together to polylines.
class PolylineReader {
 public:
  PolylineReader(const glm::ivec2& size, std::string where) : size_(size), where_(std::move(where)) {
    lengths_.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  }

  /// Segment `number` of all pixels. `saysT`: whether the file says the parameters; otherwise they are lengths.
  void add(size_t number, const std::vector<StoredSegment>& segments, bool saysT) {
    parts_.emplace_back();
    for (size_t i = 0; i < segments.size(); ++i) {
      if (!isRay(segments[i])) {
        continue;
      }
      if (lengths_[i] != number) {
        refuse(i, number, "follows no segment of its ray");
      }
      ++lengths_[i];
      parts_.back().push_back(segments[i]);
      StoredSegment& segment = parts_.back().back();
      // With parameters of its own a segment may be shorter than coordinates are rounded by.
      if (!(saysT ? segment.length >= 0 : segment.length > 0) || !std::isfinite(segment.length)) {
        refuse(i, number, fmt::format("has the length {}", segment.length));
      }
      if (saysT && !(segment.tEnd > segment.tBegin)) {
        refuse(i, number, fmt::format("runs from t {} to {}, which does not grow", segment.tBegin, segment.tEnd));
      }
    }
    stored_ += parts_.back().size();
    if (stored_ > kMaxStoredSegments) {
      throw InputError("its rays have more than 2^27 segments", where_, "write fewer pixels, or fewer segments a ray");
    }
  }

  RayMap finish(RayMapNotes notes, bool saysT) {
    std::vector<size_t> ends(lengths_.size());
    size_t end = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
      end += lengths_[i] > 0 ? lengths_[i] + 1 : 0;
      ends[i] = end;
    }
    std::vector<glm::vec3> points(end);
    std::vector<float> parameters(end);
    for (size_t number = 0; number < parts_.size(); ++number) {
      size_t stored = 0;
      for (size_t i = 0; i < lengths_.size(); ++i) {
        if (lengths_[i] > number) {
          const size_t at = (i == 0 ? 0 : ends[i - 1]) + number;
          place(i, number, parts_[number][stored++], saysT, &points[at], &parameters[at]);
        }
      }
      parts_[number] = {};
    }
    return RayMap::ofPolylines(size_, std::move(ends), std::move(points), std::move(parameters), std::move(notes),
                               where_);
  }

 private:
  /// `point` and `t` are those of the beginning; the ones behind them of the end.
  void place(size_t pixel, size_t number, const StoredSegment& segment, bool saysT, glm::vec3* point, float* t) const {
    // Of coordinates and parameters: some roundings to single precision.
    constexpr float kSegmentRounding = 1e-5f;
    if (number > 0) {
      const float scale = 1 + std::max(glm::length(segment.origin), glm::length(*point));
      if (!(glm::distance(segment.origin, *point) <= kSegmentRounding * scale)) {
        refuse(pixel, number, "does not begin where the segment before it ends");
      }
      if (saysT && !(std::abs(segment.tBegin - *t) <= kSegmentRounding * (1 + std::abs(*t)))) {
        refuse(pixel, number,
               fmt::format("begins at t {}, where the segment before it ends at {}", segment.tBegin, *t));
      }
    }
    const glm::dvec3 along = glm::normalize(glm::dvec3(segment.direction));
    point[0] = segment.origin;
    point[1] = glm::vec3(glm::dvec3(segment.origin) + along * static_cast<double>(segment.length));
    if (saysT) {
      t[0] = segment.tBegin;
      t[1] = segment.tEnd;
    } else {
      t[1] = t[0] + segment.length;
    }
  }

  [[noreturn]] void refuse(size_t pixel, size_t number, const std::string& problem) const {
    const auto width = static_cast<size_t>(size_.x);
    throw InputError(
        fmt::format("segment {} of the ray of pixel ({}, {}) {}", number, pixel % width, pixel / width, problem),
        where_, kFileNext);
  }

  glm::ivec2 size_;
  std::string where_;
  std::vector<size_t> lengths_;                    ///< of the ray of each pixel, in segments
  std::vector<std::vector<StoredSegment>> parts_;  ///< without pixels that have none
  size_t stored_ = 0;
};

/// Of one part without lengths.
RayMap straightRays(const glm::ivec2& size, const std::vector<StoredSegment>& segments, Description description,
                    const std::string& where) {
  std::vector<glm::vec3> origins;
  std::vector<glm::vec3> directions;
  for (const StoredSegment& segment : segments) {
    origins.push_back(segment.origin);
    directions.push_back(segment.direction);
  }
  return RayMap::ofStraightRays(size, origins, directions, description.near, description.far,
                                std::move(description.notes), where);
}

std::string partName(const std::string& where, size_t part, size_t parts) {
  return parts == 1 ? where : fmt::format("{}, part {}", where, part);
}

std::string stemOf(const std::string& where) {
  const std::string stem = std::filesystem::path(where).stem().string();
  return stem.empty() ? kType : stem;
}

[[noreturn]] void failReading(const std::exception& error, const std::string& where) {
  throw InputError("cannot read this as an EXR file (" + std::string(error.what()) + ")", where, kFileNext);
}

/// The headers of a ray map, and what channels it has.
struct MapHeaders {
  std::vector<ExrPartHeader> parts;
  glm::ivec2 size{0};
  Description description;
  bool saysLength = false;
  bool saysT = false;
};

MapHeaders headersOf(std::string_view bytes, const std::string& where) {
  MapHeaders headers;
  try {
    headers.parts = exrHeaders(bytes, kMaxSegments);
  } catch (const std::exception& error) {
    failReading(error, where);
  }
  const ExrPartHeader& first = headers.parts.front();
  headers.description = readDescription(first.description, where, stemOf(where));
  headers.size = sizeOf(first, where);
  headers.saysLength = headers.parts.size() > 1 || first.find(kLengthChannel.name) != nullptr;
  headers.saysT = hasAny(first, kParameterChannels);
  for (size_t i = 0; i < headers.parts.size(); ++i) {
    const std::string part = partName(where, i, headers.parts.size());
    const ExrPartHeader& header = headers.parts[i];
    requireChannels(header, kRayChannels, part);
    if (headers.saysLength) {
      requireChannels(header, {&kLengthChannel, 1}, part);
    }
    if (headers.saysT) {
      requireChannels(header, kParameterChannels, part);
    }
    if (sizeOf(header, part) != headers.size) {
      throw InputError(fmt::format("it has {}x{} pixels, and the first part {}x{}", header.width, header.height,
                                   headers.size.x, headers.size.y),
                       part, "give all segments of rays the same size");
    }
  }
  if (headers.saysT && !headers.saysLength) {
    throw InputError("it has parameters t.begin and t.end, and no length", where,
                     "add the channel \"length\", or leave them out");
  }
  if (headers.saysLength && headers.description.saysRange) {
    throw InputError("its attribute says \"near\" or \"far\", and a channel the length of each ray", where,
                     "leave one of them out");
  }
  return headers;
}

}  // namespace

bool namesRayMap(std::string_view nameOrFile) {
  return nameOrFile.ends_with(".exr");
}

bool holdsRays(const std::filesystem::path& path) {
  try {
    return exrHeaders(readFile(path), kMaxSegments).front().find(kRayChannels[0].name) != nullptr;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {
    return false;
  }
}

std::string rayMapBytes(const RayMap& map, const Progress& progress) {
  std::vector<StoredSegment> segments(static_cast<size_t>(map.width()) * static_cast<size_t>(map.height()));
  std::vector<ExrChannel> channels;
  for (const ChannelRow& row : kRayChannels) {
    channels.push_back(channelOf(row, segments));
  }
  channels.push_back(channelOf(kLengthChannel, segments));
  for (const ChannelRow& row : kParameterChannels) {
    channels.push_back(channelOf(row, segments));
  }
  std::vector<ExrPart> parts;
  for (size_t number = 0; number < map.maxSegments(); ++number) {
    parts.push_back({fmt::format("segment {:03}", number), map.width(), map.height(), channels, descriptionOf(map)});
  }
  return exrBytes(parts, [&](size_t number) {
    fillSegments(map, number, segments);
    report(progress, "file", static_cast<double>(number + 1) / static_cast<double>(parts.size()));
  });
}

void writeRayMap(const std::filesystem::path& path, const RayMap& map, const Progress& progress) {
  writeFile(path, rayMapBytes(map, progress));
}

RayMap rayMapFromBytes(std::string_view bytes, const std::string& where) {
  MapHeaders headers = headersOf(bytes, where);
  const size_t pixels = static_cast<size_t>(headers.size.x) * static_cast<size_t>(headers.size.y);
  // No more memory than the file can fill.
  if (pixels * sizeof(float) * kRayChannels.size() * headers.parts.size() >
      static_cast<size_t>(kMaxExrCompression) * bytes.size()) {
    throw InputError(fmt::format("it is too short for the {}x{} rays of its header", headers.size.x, headers.size.y),
                     where, kFileNext);
  }
  std::vector<StoredSegment> segments(pixels);
  std::vector<ExrChannel> channels;
  for (const ChannelRow& row : kRayChannels) {
    channels.push_back(channelOf(row, segments));
  }
  if (headers.saysLength) {
    channels.push_back(channelOf(kLengthChannel, segments));
  }
  if (headers.saysT) {
    for (const ChannelRow& row : kParameterChannels) {
      channels.push_back(channelOf(row, segments));
    }
  }
  PolylineReader polylines(headers.size, where);
  try {
    ExrReader reader(bytes);
    for (size_t i = 0; i < headers.parts.size(); ++i) {
      reader.read(i, headers.parts[i], channels);
      if (headers.saysLength) {
        polylines.add(i, segments, headers.saysT);
      }
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    failReading(error, where);
  }
  return headers.saysLength ? polylines.finish(std::move(headers.description.notes), headers.saysT)
                            : straightRays(headers.size, segments, std::move(headers.description), where);
}

RayMap readRayMap(const std::filesystem::path& path) {
  return rayMapFromBytes(readFile(path), path.string());
}

RayMapHeader readRayMapHeader(const std::filesystem::path& path) {
  MapHeaders headers = headersOf(readFile(path), path.string());
  return {headers.size, std::move(headers.description.notes)};
}

}  // namespace ocelli
