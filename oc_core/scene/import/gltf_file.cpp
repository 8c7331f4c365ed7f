#include "oc_core/scene/import/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include "oc_core/scene/import/percent_decoded.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// A binary file begins with magic, version and length; each chunk with its length and type; 4 bytes each.
constexpr uint64_t kChunkHead = 8;
constexpr uint64_t kJsonBegin = 12 + kChunkHead;
constexpr uint64_t kMaxNumbers = uint64_t{1} << 28U;
/// Sums of two offsets stay far from overflow.
constexpr uint64_t kMaxOffset = uint64_t{1} << 48U;

std::optional<std::string> bytesOfFile(const fs::path& path, uint64_t begin, uint64_t count) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return std::nullopt;
  }
  const uintmax_t size = fs::file_size(path, error);
  if (error || begin > size || count > size - begin) {
    return std::nullopt;
  }
  std::string bytes(count, '\0');
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(begin));
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  return file ? std::optional(std::move(bytes)) : std::nullopt;
}

/// As LimitedFiles has them: the name as it stands, or what it says as a URI.
fs::path besides(const fs::path& folder, const std::string& uri) {
  std::error_code ignored;
  return fs::is_regular_file(folder / uri, ignored) ? folder / uri : folder / percentDecoded(uri);
}

uint32_t littleWord(const std::string& bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

/// Up to what is no digit of base64.
std::string bytesOfBase64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) {
      break;
    }
    bits = bits << 6U | static_cast<uint32_t>(digit);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<char>(bits >> static_cast<unsigned>(held) & 0xffU));
    }
  }
  return bytes;
}

/// Whole numbers stand for shares of their greatest one.
template <class T>
float numberAt(const char* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof(T));
  if constexpr (std::numeric_limits<T>::is_integer) {
    return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
  } else {
    return value;
  }
}

struct ComponentType {
  uint64_t number;
  size_t bytes;
  float (*read)(const char* bytes);
};
constexpr std::array<ComponentType, 5> kComponentTypes{{{5120, 1, numberAt<int8_t>},
                                                        {5121, 1, numberAt<uint8_t>},
                                                        {5122, 2, numberAt<int16_t>},
                                                        {5123, 2, numberAt<uint16_t>},
                                                        {5126, 4, numberAt<float>}}};

/// Those whose elements are a list of numbers without gaps.
struct ElementType {
  std::string_view name;
  size_t width;
};
constexpr std::array<ElementType, 4> kElementTypes{{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};

/// A number of an object, as it must be: whole and not negative.
std::optional<uint64_t> wholeOf(const GltfJson& object, const char* name, std::optional<uint64_t> missing) {
  const GltfJson& value = gltfMember(object, name);
  if (value.is_null()) {
    return missing;
  }
  return value.is_number_unsigned() && value.get<uint64_t>() < kMaxOffset ? std::optional(value.get<uint64_t>())
                                                                          : std::nullopt;
}

}  // namespace

const GltfJson& gltfMember(const GltfJson& object, const char* name) {
  static const GltfJson kNull;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? *found : kNull;
}

const GltfJson& gltfElement(const GltfJson& array, const GltfJson& index) {
  static const GltfJson kNull;
  return array.is_array() && index.is_number_unsigned() && index.get<uint64_t>() < array.size()
             ? array[index.get<uint64_t>()]
             : kNull;
}

std::string gltfText(const GltfJson& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

GltfFile::GltfFile(const fs::path& path) : path_(path) {
  const std::optional<std::string> head = bytesOfFile(path, 0, kJsonBegin);
  if (!head || !head->starts_with("glTF")) {
    std::ifstream file(path, std::ios::binary);
    json_ = GltfJson::parse(std::string(std::istreambuf_iterator<char>(file), {}), nullptr, false);
    return;
  }
  const uint64_t jsonBytes = littleWord(*head, 12);
  json_ = GltfJson::parse(bytesOfFile(path, kJsonBegin, jsonBytes).value_or(""), nullptr, false);
  const uint64_t next = kJsonBegin + jsonBytes;
  if (const std::optional<std::string> chunk = bytesOfFile(path, next, kChunkHead);
      chunk && chunk->substr(4, 3) == "BIN") {
    binaryBegin_ = next + kChunkHead;
    binaryBytes_ = littleWord(*chunk, 0);
  }
}

const GltfJson& GltfFile::element(const char* list, const GltfJson& index) const {
  return gltfElement(gltfMember(json_, list), index);
}

std::optional<std::string> GltfFile::bytesOf(const GltfJson& buffer, uint64_t begin, uint64_t count) {
  const GltfJson& found = element("buffers", buffer);
  const std::string uri = gltfText(gltfMember(found, "uri"));
  if (!found.is_object()) {
    return std::nullopt;
  }
  if (uri.empty()) {
    const bool isThere = binaryBegin_ > 0 && begin <= binaryBytes_ && count <= binaryBytes_ - begin;
    return isThere ? bytesOfFile(path_, binaryBegin_ + begin, count) : std::nullopt;
  }
  if (!uri.starts_with("data:")) {
    return bytesOfFile(besides(path_.parent_path(), uri), begin, count);
  }
  constexpr std::string_view kEncoding = ";base64,";
  const auto [slot, isNew] = embedded_.try_emplace(uri);
  if (const size_t at = uri.find(kEncoding); isNew && at != std::string::npos) {
    slot->second = bytesOfBase64(std::string_view(uri).substr(at + kEncoding.size()));
  }
  const std::string& bytes = slot->second;
  return begin <= bytes.size() && count <= bytes.size() - begin ? std::optional(bytes.substr(begin, count))
                                                                : std::nullopt;
}

std::optional<std::vector<float>> GltfFile::numbers(const GltfJson& accessor) {
  const GltfJson& found = element("accessors", accessor);
  const GltfJson& view = element("bufferViews", gltfMember(found, "bufferView"));
  const std::string typeName = gltfText(gltfMember(found, "type"));
  const std::optional<uint64_t> component = wholeOf(found, "componentType", {});
  const auto* const read =
      std::ranges::find_if(kComponentTypes, [&](const ComponentType& known) { return component == known.number; });
  const auto* const type =
      std::ranges::find_if(kElementTypes, [&](const ElementType& known) { return known.name == typeName; });
  if (!view.is_object() || found.contains("sparse") || read == kComponentTypes.end() || type == kElementTypes.end()) {
    return std::nullopt;
  }
  const uint64_t elementBytes = read->bytes * type->width;
  const std::optional<uint64_t> count = wholeOf(found, "count", {});
  const std::optional<uint64_t> begin = wholeOf(found, "byteOffset", 0);
  const std::optional<uint64_t> viewBegin = wholeOf(view, "byteOffset", 0);
  const std::optional<uint64_t> viewBytes = wholeOf(view, "byteLength", {});
  const std::optional<uint64_t> stride = wholeOf(view, "byteStride", elementBytes);
  // A stride has one byte in the specification.
  if (!count || *count == 0 || *count * type->width > kMaxNumbers || !begin || !viewBegin || !viewBytes || !stride ||
      *stride < elementBytes || *stride > 255) {
    return std::nullopt;
  }
  const uint64_t bytes = (*count - 1) * *stride + elementBytes;
  if (*begin > *viewBytes || bytes > *viewBytes - *begin) {
    return std::nullopt;
  }
  const std::optional<std::string> data = bytesOf(gltfMember(view, "buffer"), *viewBegin + *begin, bytes);
  if (!data) {
    return std::nullopt;
  }
  std::vector<float> numbers;
  numbers.reserve(*count * type->width);
  for (uint64_t i = 0; i < *count; ++i) {
    for (uint64_t k = 0; k < type->width; ++k) {
      numbers.push_back(read->read(data->data() + i * *stride + k * read->bytes));
    }
  }
  return numbers;
}

}  // namespace ocelli
