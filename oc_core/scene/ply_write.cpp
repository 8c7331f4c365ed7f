#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/base/output_file.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/ply_file.h"

namespace ocelli {
namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they stand in memory");

constexpr size_t kRecordsInBlock = 1 << 15;

template <class Value>
char* put(char* to, const Value& value) {
  std::memcpy(to, &value, sizeof(value));
  return to + sizeof(value);
}

/// Writes `count` records of `recordBytes`, block by block. `putRecord(to, i)` returns the end of what it put.
template <class PutRecord>
void writeRecords(OutputFile& file, size_t count, size_t recordBytes, const PutRecord& putRecord) {
  std::vector<char> block(std::min(count, kRecordsInBlock) * recordBytes);
  for (size_t begin = 0; begin < count; begin += kRecordsInBlock) {
    const size_t end = std::min(count, begin + kRecordsInBlock);
    char* to = block.data();
    for (size_t i = begin; i < end; ++i) {
      to = putRecord(to, i);
    }
    file.write(std::string_view(block.data(), to));
  }
}

}  // namespace

void writePly(const std::filesystem::path& path, const Mesh& mesh) {
  OC_CHECK(mesh.positions.size() <= static_cast<size_t>(std::numeric_limits<int32_t>::max()),
           "vertex indices are signed in PLY files");
  const bool colored = !mesh.colors.empty();
  OutputFile file(path);
  const std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment made by Ocelli; colours are sRGB\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), colored ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "",
      mesh.triangles.size());
  file.write(header);
  writeRecords(file, mesh.positions.size(), 3 * sizeof(float) + 3, [&](char* to, size_t i) {
    to = put(to, mesh.positions[i]);
    for (glm::length_t channel = 0; colored && channel < 3; ++channel) {
      to = put(to, srgbByteFromLinear(mesh.colors[i][channel]));
    }
    return to;
  });
  writeRecords(file, mesh.triangles.size(), 1 + 3 * sizeof(uint32_t),
               [&](char* to, size_t i) { return put(put(to, uint8_t{3}), mesh.triangles[i]); });
  file.commit();
}

}  // namespace ocelli
