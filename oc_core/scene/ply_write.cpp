#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <system_error>

#include "oc_core/base/check.h"
#include "oc_core/base/color.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/ply_file.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "values are written as they stand in memory");

constexpr size_t kRecordsInBlock = 1 << 15;

/// A file that grows under a temporary name, and is removed again unless it is kept. A device is written as it stands.
class PendingFile {
 public:
  explicit PendingFile(const fs::path& path) : path_(path), target_(path), temporary_(path) {
    std::error_code ignored;
    if (fs::exists(path, ignored)) {
      target_ = fs::canonical(path, ignored);  // a link stays one
    }
    isDevice_ = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) && !fs::is_directory(path, ignored);
    temporary_ = isDevice_ ? target_ : fs::path(target_.string() + ".part");
    errno = 0;
    stream_.open(temporary_, std::ios::binary | std::ios::trunc);
    check();
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    stream_.close();
    if (!kept_ && !isDevice_) {
      std::error_code ignored;
      fs::remove(temporary_, ignored);
    }
  }

  void write(const char* bytes, size_t count) {
    stream_.write(bytes, static_cast<std::streamsize>(count));
    check();
  }

  void keep() {
    stream_.close();
    check();
    std::error_code error;
    if (!isDevice_) {
      fs::rename(temporary_, target_, error);
    }
    if (error) {
      fail(error.message());
    }
    kept_ = true;
  }

 private:
  void check() const {
    if (!stream_) {
      fail(errno != 0 ? std::strerror(errno) : "write error");
    }
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw WorkError("cannot write this PLY file (" + reason + ")", path_.string(),
                    "check that the folder exists, is writable and has space");
  }

  fs::path path_;    ///< as the user wrote it
  fs::path target_;  ///< where that leads
  fs::path temporary_;
  std::ofstream stream_;
  bool isDevice_ = false;
  bool kept_ = false;
};

template <class Value>
char* put(char* to, const Value& value) {
  std::memcpy(to, &value, sizeof(value));
  return to + sizeof(value);
}

/// Writes `count` records of `recordBytes`, block by block. `putRecord(to, i)` returns the end of what it put.
template <class PutRecord>
void writeRecords(PendingFile& file, size_t count, size_t recordBytes, const PutRecord& putRecord) {
  std::vector<char> block(std::min(count, kRecordsInBlock) * recordBytes);
  for (size_t begin = 0; begin < count; begin += kRecordsInBlock) {
    const size_t end = std::min(count, begin + kRecordsInBlock);
    char* to = block.data();
    for (size_t i = begin; i < end; ++i) {
      to = putRecord(to, i);
    }
    file.write(block.data(), static_cast<size_t>(to - block.data()));
  }
}

}  // namespace

void writePly(const fs::path& path, const Mesh& mesh) {
  OC_CHECK(mesh.positions.size() <= static_cast<size_t>(std::numeric_limits<int32_t>::max()),
           "vertex indices are signed in PLY files");
  const bool colored = !mesh.colors.empty();
  PendingFile file(path);
  const std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment made by Ocelli; colours are sRGB\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), colored ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "",
      mesh.triangles.size());
  file.write(header.data(), header.size());
  writeRecords(file, mesh.positions.size(), 3 * sizeof(float) + 3, [&](char* to, size_t i) {
    to = put(to, mesh.positions[i]);
    for (glm::length_t channel = 0; colored && channel < 3; ++channel) {
      to = put(to, srgbByteFromLinear(mesh.colors[i][channel]));
    }
    return to;
  });
  writeRecords(file, mesh.triangles.size(), 1 + 3 * sizeof(uint32_t),
               [&](char* to, size_t i) { return put(put(to, uint8_t{3}), mesh.triangles[i]); });
  file.keep();
}

}  // namespace ocelli
