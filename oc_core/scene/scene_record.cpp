#include "oc_core/scene/scene_record.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <string_view>
#include <type_traits>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/record_bytes.h"
#include "oc_core/scene/rig_record.h"

namespace ocelli {
namespace {

constexpr std::string_view kStart = "OCSCENE1";
constexpr std::string_view kEnd = "END.";
enum class RecordKind : uint32_t { kScene, kFailure };
enum PartFlag : uint8_t { kColors = 1, kBase = 2, kEmissive = 4, kMask = 8, kUnlit = 16, kLines = 32, kPoints = 64 };

static_assert(sizeof(glm::vec2) == 8 && sizeof(glm::vec3) == 12 && sizeof(glm::uvec3) == 12 && sizeof(Rgb8) == 3,
              "arrays of them are written as they stand");

void writeLayer(RecordWriter& writer, const std::optional<TextureLayer>& layer) {
  if (layer) {
    writer.count(layer->texture);
    writer.list(layer->uvs);
  }
}

constexpr RecordWords kWords{"scene", "convert the scene to binary PLY"};

class RecordReader : public RecordParser {
 public:
  using RecordParser::RecordParser;

  SceneRecord read() {
    expect(kStart);
    switch (static_cast<RecordKind>(number())) {
      case RecordKind::kScene:
        return scene();
      case RecordKind::kFailure: {
        const std::string message = text();
        expectEnd();
        throw errorAsItWas(message);
      }
    }
    fail("unknown kind");
  }

 private:
  void expectEnd() {
    expect(kEnd);
    if (!atEnd()) {
      fail("bytes are left over");
    }
  }

  SceneRecord scene() {
    SceneRecord record;
    for (uint32_t left = count(sizeof(uint32_t)); left > 0; --left) {
      record.warnings.push_back(text());
    }
    for (uint32_t left = count(2 * sizeof(uint32_t) + 2 + sizeof(Rgb8)); left > 0; --left) {
      record.textures.push_back(texture());
    }
    for (uint32_t left = count(2 * sizeof(uint32_t) + 1 + sizeof(glm::vec3)); left > 0; --left) {
      record.parts.push_back(part(record.textures.size()));
    }
    for (uint32_t left = count(sizeof(uint32_t) + sizeof(glm::mat4)); left > 0; --left) {
      record.instances.push_back(instance(record.parts.size()));
    }
    if (const uint32_t rigs = number(); rigs > 1) {
      fail("it has more than one rig");
    } else if (rigs == 1) {
      record.rig = readRig(*this, record);
    }
    expectEnd();
    return record;
  }

  Texture texture() {
    const uint64_t width = number();
    const uint64_t height = number();
    if (width == 0 || height == 0 || width > kMaxTexturePixels || height > kMaxTexturePixels ||
        width * height > kMaxTexturePixels) {
      fail("a texture has an impossible size");
    }
    const TextureWrap wrapU = wrap();
    const TextureWrap wrapV = wrap();
    const auto pixels = take(width * height * sizeof(Rgb8));
    Texture texture{Image<Rgb8>(static_cast<int>(width), static_cast<int>(height)), wrapU, wrapV};
    std::memcpy(texture.image.data(), pixels.data(), pixels.size());
    return texture;
  }

  TextureWrap wrap() {
    const auto number = value<uint8_t>();
    if (number > static_cast<uint8_t>(TextureWrap::kClamp)) {
      fail("a texture wraps in an unknown way");
    }
    return static_cast<TextureWrap>(number);
  }

  TexturedMesh part(size_t textures) {
    TexturedMesh part;
    const uint64_t vertices = number();
    const uint64_t triangles = number();
    const auto flags = value<uint8_t>();
    if (flags > (kColors | kBase | kEmissive | kMask | kUnlit | kLines | kPoints)) {
      fail("a mesh holds what is unknown");
    }
    if ((flags & kColors) != 0 && vertices == 0) {
      fail("a mesh without vertices has colours");
    }
    part.emission = value<glm::vec3>();
    part.mesh.positions = list<glm::vec3>(vertices);
    part.mesh.colors = list<glm::vec3>((flags & kColors) != 0 ? vertices : 0);
    part.mesh.triangles = list<glm::uvec3>(triangles);
    if ((flags & kBase) != 0) {
      part.base = layer(vertices, textures);
    }
    if ((flags & kEmissive) != 0) {
      part.emissive = layer(vertices, textures);
    }
    if ((flags & kMask) != 0) {
      part.mask = layer(vertices, textures);
      part.maskCutoff = value<float>();
    }
    part.isUnlit = (flags & kUnlit) != 0;
    if ((flags & kLines) != 0) {
      part.lines = list<glm::uvec2>(someOf(count(sizeof(glm::uvec2))));
    }
    if ((flags & kPoints) != 0) {
      part.points = list<uint32_t>(someOf(count(sizeof(uint32_t))));
    }
    check(part);
    return part;
  }

  /// A list that a flag tells of is not empty, so that what is read is written as the same bytes.
  uint32_t someOf(uint32_t count) const {
    if (count == 0) {
      fail("a list that it tells of is empty");
    }
    return count;
  }

  TextureLayer layer(uint64_t vertices, size_t textures) {
    TextureLayer layer;
    layer.texture = number();
    if (layer.texture >= textures) {
      fail("a mesh has a texture that is not there");
    }
    layer.uvs = list<glm::vec2>(vertices);
    return layer;
  }

  void check(const TexturedMesh& part) const {
    const Mesh& mesh = part.mesh;
    const auto isInside = [&](const glm::uvec3& t) { return std::max({t.x, t.y, t.z}) < mesh.positions.size(); };
    if (!std::all_of(mesh.triangles.begin(), mesh.triangles.end(), isInside)) {
      fail("a triangle has a corner that is not there");
    }
    const auto isColor = [](const glm::vec3& c) {
      return c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1 && c.z >= 0 && c.z <= 1;
    };
    if (!std::all_of(mesh.colors.begin(), mesh.colors.end(), isColor)) {
      fail("a colour is out of range");
    }
    const auto isVertex = [&](uint32_t vertex) { return vertex < mesh.positions.size(); };
    if (!std::ranges::all_of(part.points, isVertex) || !std::ranges::all_of(part.lines, [&](const glm::uvec2& line) {
          return isVertex(line.x) && isVertex(line.y);
        })) {
      fail("a line or a point has a vertex that is not there");
    }
    if (part.mask && !(part.maskCutoff > 0 && std::isfinite(part.maskCutoff))) {
      fail("a mask has an impossible cutoff");
    }
    if (!isFinite(part.emission) || part.emission.x < 0 || part.emission.y < 0 || part.emission.z < 0) {
      fail("an emission is out of range");
    }
  }

  Instance instance(size_t parts) {
    Instance instance;
    instance.mesh = number();
    if (instance.mesh >= parts) {
      fail("a copy is of a mesh that is not there");
    }
    instance.worldFromMesh = value<glm::mat4>();
    const float* first = glm::value_ptr(instance.worldFromMesh);
    if (!std::all_of(first, first + 16, [](float x) { return std::isfinite(x); })) {
      fail("a copy is moved by what is no number");
    }
    return instance;
  }
};

}  // namespace

void writeSceneRecord(const SceneRecord& record, const ByteSink& sink) {
  RecordWriter writer(sink);
  writer.raw(kStart.data(), kStart.size());
  writer.value(RecordKind::kScene);
  writer.count(record.warnings.size());
  for (const std::string& warning : record.warnings) {
    writer.text(warning);
  }
  writer.count(record.textures.size());
  for (const Texture& texture : record.textures) {
    writer.count(static_cast<size_t>(texture.image.width()));
    writer.count(static_cast<size_t>(texture.image.height()));
    writer.value(static_cast<uint8_t>(texture.wrapU));
    writer.value(static_cast<uint8_t>(texture.wrapV));
    writer.raw(texture.image.data(), texture.image.size() * sizeof(Rgb8));
  }
  writer.count(record.parts.size());
  for (const TexturedMesh& part : record.parts) {
    const int flags = (part.mesh.colors.empty() ? 0 : kColors) | (part.base ? kBase : 0) |
                      (part.emissive ? kEmissive : 0) | (part.mask ? kMask : 0) | (part.isUnlit ? kUnlit : 0) |
                      (part.lines.empty() ? 0 : kLines) | (part.points.empty() ? 0 : kPoints);
    writer.count(part.mesh.positions.size());
    writer.count(part.mesh.triangles.size());
    writer.value(static_cast<uint8_t>(flags));
    writer.value(part.emission);
    writer.list(part.mesh.positions);
    writer.list(part.mesh.colors);
    writer.list(part.mesh.triangles);
    writeLayer(writer, part.base);
    writeLayer(writer, part.emissive);
    writeLayer(writer, part.mask);
    if (part.mask) {
      writer.value(part.maskCutoff);
    }
    if (!part.lines.empty()) {
      writer.count(part.lines.size());
      writer.list(part.lines);
    }
    if (!part.points.empty()) {
      writer.count(part.points.size());
      writer.list(part.points);
    }
  }
  writer.count(record.instances.size());
  for (const Instance& instance : record.instances) {
    writer.count(instance.mesh);
    writer.value(instance.worldFromMesh);
  }
  writer.count(record.rig ? 1 : 0);
  if (record.rig) {
    writeRig(writer, *record.rig);
  }
  writer.raw(kEnd.data(), kEnd.size());
}

void writeFailureRecord(const std::string& message, const ByteSink& sink) {
  RecordWriter writer(sink);
  writer.raw(kStart.data(), kStart.size());
  writer.value(RecordKind::kFailure);
  writer.text(message);
  writer.raw(kEnd.data(), kEnd.size());
}

SceneRecord sceneFromRecord(std::span<const std::byte> bytes, const std::string& writer) {
  return RecordReader(bytes, writer, kWords).read();
}

}  // namespace ocelli
