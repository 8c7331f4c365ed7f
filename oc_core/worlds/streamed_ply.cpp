#include "oc_core/worlds/streamed_ply.h"

#include <algorithm>
#include <glm/common.hpp>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/scratch_file.h"
#include "oc_core/scene/box.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/shading.h"

namespace ocelli {
namespace {

/// Triangles or vertices between two moments at which memory is given back.
constexpr size_t kAtOnce = 1'000'000;

}  // namespace

struct StreamedPly::Arrays {
  explicit Arrays(const std::filesystem::path& folder)
      : positionFile(folder), colorFile(folder), normalFile(folder), triangleFile(folder) {}

  ScratchArray<glm::vec3> positionFile;
  ScratchArray<glm::vec3> colorFile;
  ScratchArray<glm::vec3> normalFile;
  ScratchArray<glm::uvec3> triangleFile;
  std::span<glm::vec3> positions{};
  std::span<glm::vec3> colors{};      ///< linear; none where the file has none
  std::span<glm::vec3> normals{};     ///< sums over the faces of a vertex; none without shading
  std::span<glm::uvec3> triangles{};  ///< as in the file
  std::vector<bool> isCreased{};      ///< of each vertex; none without shading

  glm::vec3 areaNormalOf(const glm::uvec3& t) const {
    return areaNormal(positions[t.x], positions[t.y], positions[t.z]);
  }

  void release() const {
    positionFile.release();
    colorFile.release();
    normalFile.release();
    triangleFile.release();
  }

  /// Calls `work(begin, end)` for runs of `count` items, and gives memory back in between.
  template <class Work>
  void inRuns(size_t count, const char* name, const Progress& progress, const Work& work) const {
    for (size_t begin = 0; begin < count; begin += kAtOnce) {
      report(progress, name, static_cast<double>(begin) / static_cast<double>(count));
      work(begin, std::min(begin + kAtOnce, count));
      release();
    }
  }
};

namespace {

/// Writes what is read to the arrays.
class ArrayWriter final : public PlyVisitor {
 public:
  ArrayWriter(ScratchArray<glm::vec3>& positions, ScratchArray<glm::vec3>& colors, ScratchArray<glm::uvec3>& triangles,
              const std::string& where, const Progress& progress)
      : positions_(positions), colors_(colors), triangles_(triangles), where_(where), progress_(progress) {}

  void beginVertices(uint64_t count, bool colored) override {
    vertexCount_ = count;
    colored_ = colored;
  }
  void addVertex(const glm::vec3& position, const glm::vec3& color) override {
    tell("reading vertices", vertices_, vertexCount_);
    if (!isFinite(position)) {
      throw InputError("vertex " + std::to_string(vertices_) + " has a coordinate that is not a finite number", where_,
                       "repair the mesh, or export it again");
    }
    ++vertices_;
    positions_.push(position);
    if (colored_) {
      colors_.push(color);
    }
  }
  void beginFaces(uint64_t count) override { faceCount_ = count; }
  void addTriangle(const glm::uvec3& corners) override {
    tell("reading triangles", triangleCount_++, faceCount_);
    triangles_.push(corners);
  }

 private:
  void tell(const char* what, uint64_t done, uint64_t of) const {
    if (done % kAtOnce == 0) {
      report(progress_, what, of > 0 ? std::min(1.0, static_cast<double>(done) / static_cast<double>(of)) : 0);
    }
  }

  ScratchArray<glm::vec3>& positions_;
  ScratchArray<glm::vec3>& colors_;
  ScratchArray<glm::uvec3>& triangles_;
  const std::string& where_;
  const Progress& progress_;
  bool colored_ = false;
  uint64_t vertexCount_ = 0;
  uint64_t faceCount_ = 0;
  uint64_t vertices_ = 0;
  uint64_t triangleCount_ = 0;
};

}  // namespace

StreamedPly::StreamedPly(const std::filesystem::path& path, const SceneOptions& options,
                         const std::filesystem::path& scratch, const Progress& progress)
    : arrays_(std::make_unique<Arrays>(scratch)), shading_(options.shading) {
  const std::string where = path.string();
  Arrays& all = *arrays_;
  ArrayWriter writer(all.positionFile, all.colorFile, all.triangleFile, where, progress);
  visitPly(path, writer, kMaxTriangles);
  all.positions = all.positionFile.map();
  all.colors = all.colorFile.map();
  all.triangles = all.triangleFile.map();

  // Vertices that no triangle uses are not of the scene.
  std::vector<bool> isUsed(all.positions.size(), false);
  all.inRuns(all.triangles.size(), "looking for what is used", progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = all.triangles[i];
      isUsed[t.x] = isUsed[t.y] = isUsed[t.z] = true;
    }
  });
  const auto forUsed = [&](const char* name, const auto& visit) {
    all.inRuns(all.positions.size(), name, progress, [&](size_t begin, size_t end) {
      Mesh points;
      for (size_t v = begin; v < end; ++v) {
        if (isUsed[v]) {
          points.positions.push_back(all.positions[v]);
        }
      }
      visit(points);
    });
  };
  if (options.fit) {
    Box box;
    forUsed("measuring", [&](const Mesh& points) {
      for (const glm::vec3& p : points.positions) {
        box.add(p);
      }
    });
    const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) * 0.5;
    double reach = 0;
    forUsed("measuring", [&](const Mesh& points) { reach = std::max(reach, reachOf(points, center)); });
    const glm::mat4 worldFromFile = unitFromSphere(center, reach, where);
    all.inRuns(all.positions.size(), "fitting", progress, [&](size_t begin, size_t end) {
      Mesh points;
      points.positions.assign(all.positions.begin() + static_cast<std::ptrdiff_t>(begin),
                              all.positions.begin() + static_cast<std::ptrdiff_t>(end));
      transform(points, worldFromFile);
      std::ranges::copy(points.positions, all.positions.begin() + static_cast<std::ptrdiff_t>(begin));
    });
  }
  if (shading_ == Shading::kLambert) {
    all.normalFile.pushZeros(all.positions.size());
    all.normals = all.normalFile.map();
    all.inRuns(all.triangles.size(), "shading", progress, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const glm::uvec3& t = all.triangles[i];
        const glm::vec3 normal = all.areaNormalOf(t);
        for (const uint32_t v : {t.x, t.y, t.z}) {
          all.normals[v] += normal;
        }
      }
    });
    all.isCreased.assign(all.positions.size(), false);
    all.inRuns(all.triangles.size(), "shading", progress, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const glm::uvec3& t = all.triangles[i];
        const glm::vec3 normal = all.areaNormalOf(t);
        for (const uint32_t v : {t.x, t.y, t.z}) {
          all.isCreased[v] = all.isCreased[v] || !smoothTogether(all.normals[v], normal);
        }
      }
    });
  }
}

StreamedPly::~StreamedPly() = default;

void StreamedPly::forEachPart(const std::function<void(const Mesh& part)>& visit) const {
  const Arrays& all = *arrays_;
  all.inRuns(all.triangles.size(), "", {}, [&](size_t begin, size_t end) {
    Mesh part;
    part.positions.reserve(3 * (end - begin));
    part.colors.reserve(3 * (end - begin));
    part.triangles.reserve(end - begin);
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = all.triangles[i];
      const glm::vec3 face = all.areaNormalOf(t);
      const auto first = static_cast<uint32_t>(part.positions.size());
      for (const uint32_t v : {t.x, t.y, t.z}) {
        glm::vec3 color = all.colors.empty() ? glm::vec3(1) : all.colors[v];
        if (shading_ == Shading::kLambert) {
          color *= shadeOfSum(all.isCreased[v] ? face : all.normals[v]);
        }
        part.positions.push_back(all.positions[v]);
        part.colors.push_back(color);
      }
      part.triangles.push_back({first, first + 1, first + 2});
    }
    visit(part);
  });
}

}  // namespace ocelli
