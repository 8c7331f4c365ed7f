#include "oc_core/scene/import/gltf_interpolation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

namespace ocelli {
namespace {

using Json = nlohmann::json;

/// A binary file begins with magic, version and length, and the length and type of its first chunk, 4 bytes each.
constexpr size_t kGlbJsonBegin = 20;

std::string jsonTextOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, kGlbJsonBegin> head{};
  file.read(head.data(), head.size());
  if (file.gcount() == kGlbJsonBegin && std::string_view(head.data(), 4) == "glTF") {
    uint32_t length = 0;
    std::memcpy(&length, head.data() + 12, sizeof(length));
    std::error_code error;
    const uintmax_t bytes = std::filesystem::file_size(path, error);
    std::string text(error ? 0 : std::min<uintmax_t>(length, bytes), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
  }
  file.clear();
  file.seekg(0);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The member of an object, or null.
const Json& member(const Json& object, const char* name) {
  static const Json kNull;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? *found : kNull;
}

/// The element of an array that another value names, or null.
const Json& elementNamed(const Json& array, const Json& index) {
  static const Json kNull;
  return array.is_array() && index.is_number_unsigned() && index.get<uint64_t>() < array.size()
             ? array[index.get<uint64_t>()]
             : kNull;
}

std::string textOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

}  // namespace

GltfInterpolations readGltfInterpolations(const std::filesystem::path& path) {
  const Json file = Json::parse(jsonTextOf(path), nullptr, false);
  GltfInterpolations found;
  unsigned number = 0;
  for (const Json& animation : member(file, "animations")) {
    for (const Json& channel : member(animation, "channels")) {
      const Json& sampler = elementNamed(member(animation, "samplers"), member(channel, "sampler"));
      const Json& target = member(channel, "target");
      const Json& node = elementNamed(member(file, "nodes"), member(target, "node"));
      const std::string how = textOf(member(sampler, "interpolation"));
      if (how == "STEP" || how == "CUBICSPLINE") {
        found[{number, textOf(member(node, "name")), textOf(member(target, "path"))}] = how;
      }
    }
    ++number;
  }
  return found;
}

}  // namespace ocelli
