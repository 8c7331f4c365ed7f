#include "oc_core/pack/sorted_triangles.h"

#include <fcntl.h>

#include <algorithm>
#include <array>

#include "oc_core/base/check.h"
#include "oc_core/pack/placed_file.h"

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

}  // namespace

void sortTriangles(const TriangleSource& source, const ScenePlan& plan, const SortedPaths& paths,
                   const std::function<void(double share)>& progress) {
  constexpr size_t kBuffered = 2048;  // triangles of a part
  std::filesystem::path growing = paths.triangles;
  growing += ".partial";
  std::filesystem::path growingPlaces = paths.places;
  growingPlaces += ".partial";
  {
    FixedPlaceWriter places(growingPlaces, plan.parts.size());
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
        const std::array<glm::vec3, 3> corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
        const uint32_t part = plan.partOf(plan.cellOf(corners[0], corners[1], corners[2]));
        forEachStrayCorner(plan, part, corners, [&](const PlaceBits& place, uint32_t home) {
          places.add(home, {place, part});
        });
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
    places.finish();
  }
  // The triangles last: where they are, both are.
  renameComplete(growingPlaces, paths.places);
  renameComplete(growing, paths.triangles);
}

PartTriangles readPartTriangles(const SortedPaths& paths, const ScenePlan& plan, uint32_t index) {
  constexpr size_t kAtOnce = 1 << 14;
  const ScenePart& part = plan.parts[index];
  const PlacedFile file(paths.triangles, O_RDONLY);
  PartTriangles result{{}, readFixedPlaces(paths.places, index)};
  std::vector<StoredTriangle> some;
  Welder welder(part.triangles);
  for (uint64_t first = 0; first < part.triangles; first += kAtOnce) {
    some.resize(std::min<uint64_t>(kAtOnce, part.triangles - first));
    file.read(some.data(), some.size() * sizeof(StoredTriangle), (part.firstTriangle + first) * sizeof(StoredTriangle));
    for (const StoredTriangle& triangle : some) {
      std::array<glm::vec3, 3> positions{};
      std::array<uint32_t, 3> corners{};
      for (size_t k = 0; k < 3; ++k) {
        const auto& [p, color, unused] = triangle[k];
        positions[k] = {p[0], p[1], p[2]};
        corners[k] = welder.vertex(positions[k], color);
      }
      welder.add(corners[0], corners[1], corners[2]);
      forEachStrayCorner(plan, index, positions, [&](const PlaceBits& place, uint32_t home) {
        result.fixed.push_back({place, home});
      });
    }
  }
  result.triangles = welder.take();
  sortPlaces(result.fixed);
  return result;
}

}  // namespace ocelli
