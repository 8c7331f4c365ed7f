// A glTF 2.0 file as it is, for what Assimp does not hand over: its JSON, and the numbers of its accessors. Include it
// in .cpp files only: nlohmann/json is slow to compile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ocelli {

using GltfJson = nlohmann::json;

/// The member of an object, or null.
const GltfJson& gltfMember(const GltfJson& object, const char* name);
/// The element of an array that another value names, or null.
const GltfJson& gltfElement(const GltfJson& array, const GltfJson& index);
/// Empty where it is no text.
std::string gltfText(const GltfJson& value);

class GltfFile {
 public:
  /// .gltf or .glb. What cannot be read is a file whose JSON is null.
  explicit GltfFile(const std::filesystem::path& path);

  const GltfJson& json() const { return json_; }
  /// An element of one of the lists of the file, such as "nodes", or null.
  const GltfJson& element(const char* list, const GltfJson& index) const;

  /// All numbers of an accessor, normalized where it has whole ones (sections 3.6.2 and 3.11: c / 127, or -1, and so
  /// on); one at least. Nothing where it or its buffer is missing, too short, sparse, or of more than 2^28 numbers.
  std::optional<std::vector<float>> numbers(const GltfJson& accessor);

 private:
  std::optional<std::string> bytesOf(const GltfJson& buffer, uint64_t begin, uint64_t count);

  std::filesystem::path path_;
  GltfJson json_;
  uint64_t binaryBegin_ = 0;  ///< where the binary chunk of a .glb file begins; 0: it has none
  uint64_t binaryBytes_ = 0;
  std::map<std::string, std::string> embedded_;  ///< bytes of data URIs, by these
};

}  // namespace ocelli
