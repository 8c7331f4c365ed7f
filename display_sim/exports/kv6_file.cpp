#include "display_sim/exports/kv6_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr std::string_view kMagic = "Kvxl";
constexpr std::string_view kPaletteMagic = "SPal";
constexpr size_t kPaletteBytes = 768;
constexpr size_t kVoxelBytes = 8;
constexpr char kUnused = static_cast<char>(128);
constexpr int kNormals = 255;

void put(std::string& bytes, uint32_t value, int count) {
  for (int i = 0; i < count; ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }
}

class Kv6Parser {
 public:
  Kv6Parser(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("this is no KV6 model: " + what, where_, "give a file as voxel editors write it");
  }

  std::string_view take(uint64_t count, const char* what) {
    if (count > bytes_.size()) {
      fail(fmt::format("it ends before its {}", what));
    }
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  static uint32_t number(std::string_view bytes) {
    uint32_t value = 0;
    for (size_t i = 0; i < bytes.size(); ++i) {
      value |= static_cast<uint32_t>(static_cast<uint8_t>(bytes[i])) << (8 * i);
    }
    return value;
  }

  int side(const char* axis) {
    const uint32_t size = number(take(4, "head"));
    if (size < 1 || size > kMaxKv6Side) {
      fail(fmt::format("its size along {} is {}, and 1 to {} are possible", axis, static_cast<int32_t>(size),
                       kMaxKv6Side));
    }
    return static_cast<int>(size);
  }

  float pivot() {
    const auto value = std::bit_cast<float>(number(take(4, "head")));
    if (!std::isfinite(value)) {
      fail("its pivot is not finite");
    }
    return value;
  }

  bool atEnd() const { return bytes_.empty(); }
  bool startsWith(std::string_view text) const { return bytes_.starts_with(text); }

 private:
  std::string_view bytes_;
  const std::string& where_;
};

/// That voxels of a column grow in z, and lie in the grid.
void checkColumns(const Kv6Model& model, const Kv6Parser& parser) {
  size_t at = 0;
  for (size_t column = 0; column < model.voxelsOfColumn.size(); ++column) {
    int above = -1;
    for (const size_t end = at + model.voxelsOfColumn[column]; at < end; ++at) {
      const int z = model.voxels[at].z;
      if (z <= above || z >= model.sizeZ) {
        parser.fail(fmt::format("voxel {} has z {}, where more than {} and less than {} is possible", at, z, above,
                                model.sizeZ));
      }
      above = z;
    }
  }
}

const std::array<glm::dvec3, kNormals + 1>& normals() {
  static const auto table = [] {
    constexpr double kGoldenShare = 0.3819660112501052;  // of a turn: 1 - 1 / golden ratio
    std::array<glm::dvec3, kNormals + 1> directions{};
    for (int i = 0; i < kNormals; ++i) {
      const double z = (2.0 * i + 1) / kNormals - 1;
      const double r = std::sqrt(1 - z * z);
      const double turn = i * kGoldenShare * 2 * kPi;
      directions[static_cast<size_t>(i)] = {r * std::cos(turn), r * std::sin(turn), z};
    }
    return directions;
  }();
  return table;
}

}  // namespace

std::string kv6Bytes(const Kv6Model& model) {
  const auto sizeY = static_cast<size_t>(model.sizeY);
  OC_CHECK(model.voxelsOfColumn.size() == static_cast<size_t>(model.sizeX) * sizeY, "a count for each column");
  std::string bytes(kMagic);
  bytes.reserve(32 + kVoxelBytes * model.voxels.size() + 4 * static_cast<size_t>(model.sizeX) +
                2 * model.voxelsOfColumn.size());
  for (const int size : {model.sizeX, model.sizeY, model.sizeZ}) {
    put(bytes, static_cast<uint32_t>(size), 4);
  }
  for (const float at : {model.pivot.x, model.pivot.y, model.pivot.z}) {
    put(bytes, std::bit_cast<uint32_t>(at), 4);
  }
  put(bytes, static_cast<uint32_t>(model.voxels.size()), 4);
  for (const Kv6Voxel& voxel : model.voxels) {
    for (const uint8_t channel : {voxel.color.b, voxel.color.g, voxel.color.r}) {
      bytes.push_back(static_cast<char>(channel));
    }
    bytes.push_back(kUnused);
    put(bytes, voxel.z, 2);
    put(bytes, voxel.faces, 1);
    put(bytes, voxel.normal, 1);
  }
  for (size_t x = 0; x < static_cast<size_t>(model.sizeX); ++x) {
    uint32_t count = 0;
    for (size_t y = 0; y < sizeY; ++y) {
      count += model.voxelsOfColumn[x * sizeY + y];
    }
    put(bytes, count, 4);
  }
  for (const uint16_t count : model.voxelsOfColumn) {
    put(bytes, count, 2);
  }
  return bytes;
}

Kv6Model kv6FromBytes(std::string_view bytes, const std::string& where) {
  Kv6Parser parser(bytes, where);
  if (parser.take(kMagic.size(), "head") != kMagic) {
    parser.fail("it does not begin with \"Kvxl\"");
  }
  Kv6Model model;
  model.sizeX = parser.side("x");
  model.sizeY = parser.side("y");
  model.sizeZ = parser.side("z");
  for (int axis = 0; axis < 3; ++axis) {
    model.pivot[axis] = parser.pivot();
  }
  const uint32_t count = Kv6Parser::number(parser.take(4, "head"));
  const std::string_view voxels = parser.take(kVoxelBytes * uint64_t{count}, "voxels");
  const auto sizeX = static_cast<size_t>(model.sizeX);
  const auto sizeY = static_cast<size_t>(model.sizeY);
  const std::string_view planes = parser.take(4 * uint64_t{sizeX}, "counts");
  const std::string_view columns = parser.take(2 * uint64_t{sizeX} * sizeY, "counts");
  if (parser.startsWith(kPaletteMagic)) {
    parser.take(kPaletteMagic.size() + kPaletteBytes, "palette's end");
  }
  if (!parser.atEnd()) {
    parser.fail("bytes follow its end");
  }

  model.voxelsOfColumn.reserve(sizeX * sizeY);
  uint64_t counted = 0;
  for (size_t x = 0; x < sizeX; ++x) {
    uint64_t ofPlane = 0;
    for (size_t y = 0; y < sizeY; ++y) {
      const uint32_t ofColumn = Kv6Parser::number(columns.substr(2 * (x * sizeY + y), 2));
      model.voxelsOfColumn.push_back(static_cast<uint16_t>(ofColumn));
      ofPlane += ofColumn;
    }
    if (ofPlane != Kv6Parser::number(planes.substr(4 * x, 4))) {
      parser.fail(fmt::format("its columns at x {} have {} voxels, and its count there says otherwise", x, ofPlane));
    }
    counted += ofPlane;
  }
  if (counted != count) {
    parser.fail(fmt::format("it has {} voxels, and its columns have {}", count, counted));
  }
  model.voxels.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    const std::string_view record = voxels.substr(kVoxelBytes * i, kVoxelBytes);
    const auto byte = [&](size_t at) { return static_cast<uint8_t>(record[at]); };
    model.voxels.push_back({.color = Rgb8(byte(2), byte(1), byte(0)),
                            .z = static_cast<uint16_t>(Kv6Parser::number(record.substr(4, 2))),
                            .faces = static_cast<uint8_t>(byte(6) & kKv6Faces),
                            .normal = byte(7)});
  }
  checkColumns(model, parser);
  return model;
}

glm::dvec3 kv6Normal(uint8_t index) {
  return normals()[index];
}

uint8_t kv6NormalIndex(const glm::dvec3& direction) {
  if (direction == glm::dvec3(0)) {
    return kKv6NoNormal;
  }
  size_t nearest = 0;
  for (size_t i = 1; i < kNormals; ++i) {
    if (glm::dot(normals()[i], direction) > glm::dot(normals()[nearest], direction)) {
      nearest = i;
    }
  }
  return static_cast<uint8_t>(nearest);
}

}  // namespace ocelli
