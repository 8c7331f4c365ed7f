#include "oc_core/pack/sorted_triangles.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct StoredCorner {
  std::array<float, 3> position;
  PackedColor color;
  uint16_t unused = 0;
};
static_assert(sizeof(StoredCorner) == 20);
using StoredTriangle = std::array<StoredCorner, 3>;

StoredCorner storedCorner(const Mesh& mesh, uint32_t vertex) {
  const glm::vec3& p = mesh.positions[vertex];
  return {{p.x, p.y, p.z}, packedColor(mesh.color(vertex))};
}

/// A file that is read and written at any place.
class PlacedFile {
 public:
  PlacedFile(const std::filesystem::path& path, int flags) : path_(path), file_(::open(path.c_str(), flags, 0666)) {
    if (file_ < 0) {
      fail(errno);
    }
  }
  ~PlacedFile() { ::close(file_); }
  PlacedFile(const PlacedFile&) = delete;
  PlacedFile& operator=(const PlacedFile&) = delete;

  void write(const void* bytes, size_t count, uint64_t at) const {
    const auto* from = static_cast<const uint8_t*>(bytes);
    while (count > 0) {
      const ssize_t done = ::pwrite(file_, from, count, static_cast<off_t>(at));
      if (done == 0 || (done < 0 && errno != EINTR)) {
        fail(done == 0 ? ENOSPC : errno);
      }
      const size_t some = done > 0 ? static_cast<size_t>(done) : 0;
      from += some;
      at += some;
      count -= some;
    }
  }
  void read(void* bytes, size_t count, uint64_t at) const {
    auto* to = static_cast<uint8_t*>(bytes);
    while (count > 0) {
      const ssize_t done = ::pread(file_, to, count, static_cast<off_t>(at));
      if (done == 0 || (done < 0 && errno != EINTR)) {
        fail(done == 0 ? EIO : errno);
      }
      const size_t some = done > 0 ? static_cast<size_t>(done) : 0;
      to += some;
      at += some;
      count -= some;
    }
  }

 private:
  [[noreturn]] void fail(int reason) const {
    throw WorkError("the triangles cannot be sorted on disk: " + std::generic_category().message(reason),
                    path_.string(), "free some space, or write the packed scene to another disk");
  }

  std::filesystem::path path_;
  int file_;
};

}  // namespace

void sortTriangles(const TriangleSource& source, const ScenePlan& plan, const std::filesystem::path& path,
                   const std::function<void(double share)>& progress) {
  constexpr size_t kBuffered = 2048;  // triangles of a part
  std::filesystem::path growing = path;
  growing += ".partial";
  {
    const PlacedFile file(growing, O_WRONLY | O_CREAT | O_TRUNC);
    std::vector<std::vector<StoredTriangle>> buffers(plan.parts.size());
    std::vector<uint64_t> written(plan.parts.size(), 0);
    uint64_t seen = 0;
    const auto flush = [&](uint32_t part) {
      std::vector<StoredTriangle>& buffer = buffers[part];
      file.write(buffer.data(), buffer.size() * sizeof(StoredTriangle),
                 (plan.parts[part].firstTriangle + written[part]) * sizeof(StoredTriangle));
      written[part] += buffer.size();
      buffer.clear();
    };
    source.forEachPart([&](const Mesh& mesh) {
      for (const glm::uvec3& t : mesh.triangles) {
        const uint32_t part = plan.partOf(plan.cellOf(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
        buffers[part].push_back({storedCorner(mesh, t.x), storedCorner(mesh, t.y), storedCorner(mesh, t.z)});
        if (buffers[part].size() == kBuffered) {
          flush(part);
        }
        if (++seen % (1U << 20U) == 0) {
          progress(static_cast<double>(seen) / static_cast<double>(plan.triangles));
        }
      }
    });
    for (uint32_t part = 0; part < plan.parts.size(); ++part) {
      flush(part);
      OC_CHECK(!plan.parts[part].children.empty() || written[part] == plan.parts[part].triangles,
               "a source gives the same triangles each time");
    }
  }
  std::error_code error;
  std::filesystem::rename(growing, path, error);
  if (error) {
    throw WorkError("this file cannot be renamed: " + error.message(), growing.string(), "check its folder");
  }
}

WeldedTriangles readPartTriangles(const std::filesystem::path& path, const ScenePart& part) {
  constexpr size_t kAtOnce = 1 << 14;
  const PlacedFile file(path, O_RDONLY);
  std::vector<StoredTriangle> some;
  Welder welder(part.triangles);
  for (uint64_t first = 0; first < part.triangles; first += kAtOnce) {
    some.resize(std::min<uint64_t>(kAtOnce, part.triangles - first));
    file.read(some.data(), some.size() * sizeof(StoredTriangle), (part.firstTriangle + first) * sizeof(StoredTriangle));
    for (const StoredTriangle& triangle : some) {
      std::array<uint32_t, 3> corners{};
      for (size_t k = 0; k < 3; ++k) {
        const auto& [p, color, unused] = triangle[k];
        corners[k] = welder.vertex({p[0], p[1], p[2]}, color);
      }
      welder.add(corners[0], corners[1], corners[2]);
    }
  }
  return welder.take();
}

}  // namespace ocelli
