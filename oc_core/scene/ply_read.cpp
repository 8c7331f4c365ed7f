#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/ply_header.h"
#include "oc_core/scene/point_cloud.h"
#include "oc_core/scene/scene.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using ply::Element;
using ply::Encoding;
using ply::Property;
using ply::Type;

static_assert(std::endian::native == std::endian::little, "big-endian values are the ones that are turned round");

/// Scalars of a file, one after the other, through a buffer of fixed size.
class ScalarStream {
 public:
  ScalarStream(std::istream& stream, Encoding encoding) : stream_(stream), encoding_(encoding), buffer_(1 << 18) {}

  /// Nothing where the file ends or, in ascii, where the next word is not a number.
  std::optional<double> next(Type type) { return encoding_ == Encoding::kAscii ? nextWord() : nextBinary(type); }

 private:
  std::optional<double> nextBinary(Type type) {
    std::array<char, 8> bytes;
    const size_t size = ply::byteSize(type);
    if (end_ - begin_ < size && !refill(size)) {
      return std::nullopt;
    }
    std::memcpy(bytes.data(), buffer_.data() + begin_, size);
    begin_ += size;
    if (encoding_ == Encoding::kBigEndian) {
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    }
    switch (type) {
      case Type::kInt8:
        return as<int8_t>(bytes);
      case Type::kUint8:
        return as<uint8_t>(bytes);
      case Type::kInt16:
        return as<int16_t>(bytes);
      case Type::kUint16:
        return as<uint16_t>(bytes);
      case Type::kInt32:
        return as<int32_t>(bytes);
      case Type::kUint32:
        return as<uint32_t>(bytes);
      case Type::kFloat32:
        return as<float>(bytes);
      case Type::kFloat64:
        return as<double>(bytes);
    }
    return std::nullopt;
  }

  std::optional<double> nextWord() {
    constexpr size_t kMaxWordBytes = 100;
    const auto isSpace = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    do {
      while (begin_ < end_ && isSpace(buffer_[begin_])) {
        ++begin_;
      }
    } while (begin_ == end_ && refill(1));
    if (end_ - begin_ < kMaxWordBytes) {
      refill(kMaxWordBytes);
    }
    size_t wordEnd = begin_;
    while (wordEnd < end_ && wordEnd - begin_ < kMaxWordBytes && !isSpace(buffer_[wordEnd])) {
      ++wordEnd;
    }
    const char* first = buffer_.data() + begin_;
    const char* last = buffer_.data() + wordEnd;
    if (first != last && *first == '+') {
      ++first;
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(first, last, value);
    begin_ = wordEnd;
    if (first == last || error == std::errc::invalid_argument || stop != last) {
      return std::nullopt;
    }
    return value;
  }

  template <class Value>
  static double as(const std::array<char, 8>& bytes) {
    Value value;
    std::memcpy(&value, bytes.data(), sizeof(value));
    return static_cast<double>(value);
  }

  /// Moves what is left to the front and reads on. False where fewer than `wanted` bytes are left in the file.
  bool refill(size_t wanted) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    stream_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<size_t>(stream_.gcount());
    return end_ >= wanted;
  }

  std::istream& stream_;
  Encoding encoding_;
  std::vector<char> buffer_;
  size_t begin_ = 0;  ///< what was read and not yet handed out is [begin_, end_) of the buffer
  size_t end_ = 0;
};

/// What 1.0 is as a colour of this type.
double fullColor(Type type) {
  switch (type) {
    case Type::kInt8:
      return std::numeric_limits<int8_t>::max();
    case Type::kUint8:
      return std::numeric_limits<uint8_t>::max();
    case Type::kInt16:
      return std::numeric_limits<int16_t>::max();
    case Type::kUint16:
      return std::numeric_limits<uint16_t>::max();
    case Type::kInt32:
      return std::numeric_limits<int32_t>::max();
    case Type::kUint32:
      return std::numeric_limits<uint32_t>::max();
    case Type::kFloat32:
    case Type::kFloat64:
      return 1;
  }
  return 1;
}

float linearColor(double value, Type type) {
  const double encoded = value > 0 ? std::min(value / fullColor(type), 1.0) : 0.0;
  if (type == Type::kUint8) {
    return linearFromSrgbByte(static_cast<uint8_t>(std::lround(encoded * 255)));
  }
  return linearFromSrgb(static_cast<float>(encoded));
}

/// How many rows a file may have, and what of it there must be.
struct PlyLimits {
  uint64_t maxTriangles = 0;
  uint64_t maxVertices = 0;
  bool needsFaces = true;
};

class PlyReader {
 public:
  PlyReader(std::istream& stream, uint64_t bytes, const std::string& where, PlyVisitor& visitor,
            const PlyLimits& limits)
      : where_(where),
        header_(ply::readHeader(stream, where)),
        scalars_(stream, header_.encoding),
        visitor_(visitor),
        limits_(limits) {
    checkSize(bytes - static_cast<uint64_t>(stream.tellg()));
  }

  void read() {
    bool hasFaces = false;
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        readFaces(element);
        hasFaces = true;
      } else {
        skip(element);
      }
    }
    if (limits_.needsFaces && !hasFaces) {
      fail("the file has no faces", "export it as a triangle mesh, not as points");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& next) const {
    throw InputError(what, where_, next);
  }
  [[noreturn]] void failAt(const Element& element, uint64_t row) const {
    fail("the file ends, or holds what is not a number, at " + element.name + " " + std::to_string(row) + " of " +
             std::to_string(element.count),
         "copy or export it again");
  }

  [[noreturn]] void failList(const Element& element, uint64_t row, double count) const {
    fail("a list of " + element.name + " " + std::to_string(row) + " has " + fmt::format("{:.15g}", count) + " entries",
         "repair the mesh, or export it again");
  }

  std::string whatIfTooLarge() const {
    if (!limits_.needsFaces) {
      return "leave points out";
    }
    // Only faces tell how many triangles there are, which is how packing finds out that they do not fit into memory.
    return limits_.maxTriangles > kMaxSceneTriangles || hasStrips()
               ? "reduce the mesh"
               : "reduce the mesh, or pack it with ocelli scene pack, which takes more";
  }

  bool hasStrips() const {
    return std::ranges::any_of(header_.elements, [](const Element& e) { return e.name == "tristrips" && e.count > 0; });
  }

  /// A count that the file cannot hold is found before any memory is taken for it.
  void checkSize(uint64_t bytes) const {
    uint64_t left = bytes + 1;  // the last number of an ascii file may have nothing after it
    for (const Element& element : header_.elements) {
      const uint64_t row = element.minRowBytes(header_.encoding);
      if (row > 0 && element.count > left / row) {
        fail("the file is too short for " + std::to_string(element.count) + " rows of '" + element.name + "'",
             "copy or export it again: it looks truncated");
      }
      left -= element.count * row;
      const uint64_t most =
          element.name == "face" || element.name == "tristrips" ? limits_.maxTriangles : limits_.maxVertices;
      if (element.count > most) {
        fail("the file has more than " + std::to_string(most) + " rows of '" + element.name + "'", whatIfTooLarge());
      }
    }
  }

  double value(const Element& element, uint64_t row, Type type) {
    const std::optional<double> scalar = scalars_.next(type);
    if (!scalar) {
      failAt(element, row);
    }
    return *scalar;
  }

  /// Reads the items of a list into `items_`.
  void readList(const Element& element, uint64_t row, const Property& property) {
    const double count = value(element, row, property.countType);
    if (!(count >= 0 && count <= kMaxCorners)) {
      failList(element, row, count);
    }
    items_.resize(static_cast<size_t>(count));
    for (double& item : items_) {
      item = value(element, row, property.type);
    }
  }

  void readOther(const Element& element, uint64_t row, const Property& property) {
    if (property.isList) {
      readList(element, row, property);
    } else {
      value(element, row, property.type);
    }
  }

  void skip(const Element& element) {
    for (uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      for (const Property& property : element.properties) {
        readOther(element, row, property);
      }
    }
  }

  void readVertices(const Element& element) {
    std::vector<int> slots;  // of each property: 0..2 position, 3..5 colour, 6..8 normal, -1 neither
    std::array<bool, 9> found{};
    for (const Property& property : element.properties) {
      slots.push_back(property.isList ? -1 : slotNamed(property.name));
      if (slots.back() >= 0) {
        found[static_cast<size_t>(slots.back())] = true;
      }
    }
    if (!found[0] || !found[1] || !found[2]) {
      fail("the vertices do not have x, y and z", "export it again with positions");
    }
    if (vertices_ > 0) {
      fail("there are two lists of vertices", "export it again");
    }
    const bool colored = found[3] && found[4] && found[5];
    const bool hasNormals = found[6] && found[7] && found[8];
    visitor_.beginVertices(element.count, colored);
    for (uint64_t row = 0; row < element.count; ++row) {
      glm::vec3 position(0);
      glm::vec3 color(1);
      glm::vec3 normal(0);
      for (size_t i = 0; i < slots.size(); ++i) {
        const Property& property = element.properties[i];
        if (slots[i] < 0) {
          readOther(element, row, property);
          continue;
        }
        const double scalar = value(element, row, property.type);
        if (slots[i] < 3) {
          position[slots[i]] = static_cast<float>(scalar);
        } else if (slots[i] >= 6) {
          normal[slots[i] - 6] = static_cast<float>(scalar);
        } else if (colored) {
          color[slots[i] - 3] = linearColor(scalar, property.type);
        }
      }
      visitor_.addVertex(position, color);
      if (hasNormals) {
        visitor_.addNormal(normal);
      }
    }
    vertices_ = element.count;
  }

  static int slotNamed(const std::string& name) {
    static constexpr std::array<std::array<const char*, 4>, 9> kNames{{{"x", "x", "x", "x"},
                                                                       {"y", "y", "y", "y"},
                                                                       {"z", "z", "z", "z"},
                                                                       {"red", "r", "diffuse_red", "Red"},
                                                                       {"green", "g", "diffuse_green", "Green"},
                                                                       {"blue", "b", "diffuse_blue", "Blue"},
                                                                       {"nx", "normal_x", "nx", "nx"},
                                                                       {"ny", "normal_y", "ny", "ny"},
                                                                       {"nz", "normal_z", "nz", "nz"}}};
    for (size_t slot = 0; slot < kNames.size(); ++slot) {
      if (std::find(kNames[slot].begin(), kNames[slot].end(), name) != kNames[slot].end()) {
        return static_cast<int>(slot);
      }
    }
    return -1;
  }

  /// Faces, or strips of triangles.
  void readFaces(const Element& element) {
    const bool isStrips = element.name == "tristrips";
    const auto isCorners = [](const Property& p) {
      return p.isList && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    if (element.count > 0 && std::none_of(element.properties.begin(), element.properties.end(), isCorners)) {
      fail(std::string("the ") + (isStrips ? "strips" : "faces") + " have no list 'vertex_indices'",
           "export it as a triangle mesh");
    }
    visitor_.beginFaces(element.count);
    for (uint64_t row = 0; row < element.count; ++row) {
      for (const Property& property : element.properties) {
        if (isStrips && isCorners(property)) {
          readStrip(element, row, property);
          continue;
        }
        readOther(element, row, property);
        if (isCorners(property)) {
          addFan(row);
        }
      }
    }
  }

  /// The corners in `items_` as triangles around the first one.
  void addFan(uint64_t row) {
    for (const double item : items_) {
      requireVertex("face", row, item);
    }
    if (triangles_ + items_.size() > limits_.maxTriangles + 2) {
      failTooMany();
    }
    for (size_t i = 2; i < items_.size(); ++i) {
      visitor_.addTriangle(
          {static_cast<uint32_t>(items_[0]), static_cast<uint32_t>(items_[i - 1]), static_cast<uint32_t>(items_[i])});
      ++triangles_;
    }
  }

  /// Each corner makes a triangle with the two before it, every second one turned round; -1 begins a new strip. Scans
  /// have all of their strips in one list of many millions, so it is not kept.
  void readStrip(const Element& element, uint64_t row, const Property& property) {
    const double count = value(element, row, property.countType);
    if (!(count >= 0)) {
      failList(element, row, count);
    }
    glm::uvec3 last(0);
    uint64_t length = 0;  // corners since the strip began
    for (double i = 0; i < count; ++i) {
      const double item = value(element, row, property.type);
      // -1, also where the type has no sign
      if (item == -1 || (property.type == Type::kUint32 && item == 0xffffffff)) {
        length = 0;
        continue;
      }
      requireVertex("strip", row, item);
      last = {last.y, last.z, static_cast<uint32_t>(item)};
      ++length;
      // A corner that is repeated turns the strip, and makes no triangle.
      if (length < 3 || last.x == last.y || last.y == last.z || last.z == last.x) {
        continue;
      }
      if (triangles_ == limits_.maxTriangles) {
        failTooMany();
      }
      visitor_.addTriangle(length % 2 == 1 ? last : glm::uvec3(last.y, last.x, last.z));
      ++triangles_;
    }
  }

  void requireVertex(const char* what, uint64_t row, double item) const {
    if (!(item >= 0 && item < static_cast<double>(vertices_))) {
      fail(std::string(what) + " " + std::to_string(row) + " names vertex " + fmt::format("{:.15g}", item) + " of " +
               std::to_string(vertices_),
           "repair the mesh, or export it again");
    }
  }

  [[noreturn]] void failTooMany() const {
    fail("the file has more than " + std::to_string(limits_.maxTriangles) + " triangles", whatIfTooLarge());
  }

  static constexpr double kMaxCorners = 1 << 20;

  const std::string& where_;
  ply::Header header_;
  ScalarStream scalars_;
  std::vector<double> items_;
  PlyVisitor& visitor_;
  PlyLimits limits_;
  uint64_t vertices_ = 0;
  uint64_t triangles_ = 0;
};

/// Of a shape in memory, which has positions and colors.
template <typename Shape>
class ShapeVisitor : public PlyVisitor {
 public:
  void beginVertices(uint64_t count, bool colored) override {
    shape.positions.reserve(count);
    shape.colors.reserve(colored ? count : 0);
    colored_ = colored;
  }
  void addVertex(const glm::vec3& position, const glm::vec3& color) override {
    shape.positions.push_back(position);
    if (colored_) {
      shape.colors.push_back(color);
    }
  }

  Shape shape;

 private:
  bool colored_ = false;
};

class MeshVisitor final : public ShapeVisitor<Mesh> {
 public:
  void beginFaces(uint64_t count) override { shape.triangles.reserve(count); }
  void addTriangle(const glm::uvec3& corners) override { shape.triangles.push_back(corners); }
};

class PointVisitor final : public ShapeVisitor<PointCloud> {
 public:
  void addNormal(const glm::vec3& normal) override { shape.normals.push_back(normal); }
  void beginFaces(uint64_t /*count*/) override {}
  void addTriangle(const glm::uvec3& /*corners*/) override {}
};

/// A stream of a file, and how many bytes it has.
std::pair<std::ifstream, uint64_t> opened(const fs::path& path) {
  std::error_code error;
  const uint64_t bytes = fs::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) {
    throw InputError("cannot open this file", path.string(), "check that it exists and may be read");
  }
  return {std::move(stream), bytes};
}

}  // namespace

Mesh readPly(const fs::path& path) {
  auto [stream, bytes] = opened(path);
  return readPly(stream, bytes, path.string());
}

Mesh readPly(std::istream& stream, uint64_t size, const std::string& where) {
  MeshVisitor visitor;
  PlyReader(stream, size, where, visitor, {kMaxSceneTriangles, 3 * kMaxSceneTriangles}).read();
  return std::move(visitor.shape);
}

bool plyHoldsPoints(const fs::path& path) {
  auto [stream, bytes] = opened(path);
  bool hasVertices = false;
  for (const Element& element : ply::readHeader(stream, path.string()).elements) {
    if (element.count > 0 && (element.name == "face" || element.name == "tristrips")) {
      return false;
    }
    hasVertices = hasVertices || element.name == "vertex";
  }
  return hasVertices;
}

PointCloud readPlyPoints(const fs::path& path) {
  auto [stream, bytes] = opened(path);
  return readPlyPoints(stream, bytes, path.string());
}

PointCloud readPlyPoints(std::istream& stream, uint64_t size, const std::string& where) {
  PointVisitor visitor;
  PlyReader(stream, size, where, visitor, {0, kMaxScenePoints, false}).read();
  return std::move(visitor.shape);
}

uint64_t plyFaceCount(const fs::path& path) {
  auto [stream, bytes] = opened(path);
  uint64_t faces = 0;
  for (const Element& element : ply::readHeader(stream, path.string()).elements) {
    faces += element.name == "face" ? element.count : 0;
  }
  return faces;
}

void visitPly(const fs::path& path, PlyVisitor& visitor, uint64_t maxTriangles) {
  auto [stream, bytes] = opened(path);
  const std::string where = path.string();
  PlyReader(stream, bytes, where, visitor, {maxTriangles, 3 * maxTriangles}).read();
}

}  // namespace ocelli
