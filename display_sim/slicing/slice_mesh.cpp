#include "display_sim/slicing/slice_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

float lightSteps(float light) {
  const float steps = std::round(std::clamp(light, 0.0f, 1.0f) * kLightSteps);
  return light > 0 ? std::max(steps, 1.0f) : 0.0f;
}

/// Numbers the vertices of a chunk in the order in which its triangles name them.
class LocalNumbers {
 public:
  explicit LocalNumbers(size_t vertices) : chunk_(vertices, 0), number_(vertices) {}

  void begin() {
    ++current_;
    sources_.clear();
  }
  uint16_t of(uint32_t vertex) {
    if (chunk_[vertex] != current_) {
      chunk_[vertex] = current_;
      number_[vertex] = static_cast<uint16_t>(sources_.size());
      sources_.push_back(vertex);
    }
    return number_[vertex];
  }
  const std::vector<uint32_t>& sources() const { return sources_; }

 private:
  std::vector<uint32_t> chunk_;
  std::vector<uint16_t> number_;
  std::vector<uint32_t> sources_;
  uint32_t current_ = 0;
};

}  // namespace

std::vector<glm::uvec3> trianglesForSlicing(const Mesh& mesh) {
  std::vector<glm::uvec3> triangles(mesh.triangles.size());
  if (!triangles.empty()) {
    meshopt_spatialSortTriangles(&triangles[0].x, &mesh.triangles[0].x, 3 * triangles.size(), &mesh.positions[0].x,
                                 mesh.positions.size(), sizeof(glm::vec3));
  }
  return triangles;
}

Mesh orderedForSlicing(const Mesh& mesh) {
  if (mesh.triangles.empty()) {
    return mesh;
  }
  const size_t indices = 3 * mesh.triangles.size();
  Mesh ordered;
  ordered.triangles = trianglesForSlicing(mesh);
  std::vector<uint32_t> places(mesh.positions.size());
  const size_t used =
      meshopt_optimizeVertexFetchRemap(places.data(), &ordered.triangles[0].x, indices, mesh.positions.size());
  meshopt_remapIndexBuffer(&ordered.triangles[0].x, &ordered.triangles[0].x, indices, places.data());
  ordered.positions.resize(used);
  meshopt_remapVertexBuffer(ordered.positions.data(), mesh.positions.data(), mesh.positions.size(), sizeof(glm::vec3),
                            places.data());
  if (!mesh.colors.empty()) {
    ordered.colors.resize(used);
    meshopt_remapVertexBuffer(ordered.colors.data(), mesh.colors.data(), mesh.colors.size(), sizeof(glm::vec3),
                              places.data());
  }
  return ordered;
}

SliceMesh::SliceMesh(const Mesh& mesh) : sourceCount_(mesh.positions.size()) {
  const std::vector<glm::uvec3>& triangles = mesh.triangles;
  chunks_.resize((triangles.size() + kChunkTriangles - 1) / kChunkTriangles);
  corners_.resize(3 * triangles.size());
  std::vector<std::vector<uint32_t>> sources(chunks_.size());
  parallelChunks(chunks_.size(), static_cast<size_t>(threadCount()), [&](size_t, size_t begin, size_t end) {
    LocalNumbers numbers(begin < end ? sourceCount_ : 0);
    for (size_t c = begin; c < end; ++c) {
      SliceChunk& chunk = chunks_[c];
      chunk.firstTriangle = static_cast<uint32_t>(c * kChunkTriangles);
      chunk.triangles = static_cast<uint32_t>(std::min(kChunkTriangles, triangles.size() - c * kChunkTriangles));
      numbers.begin();
      const std::span corners = std::span(corners_).subspan(3 * size_t{chunk.firstTriangle}, 3 * chunk.triangles);
      for (size_t t = 0; t < chunk.triangles; ++t) {
        const glm::uvec3& triangle = triangles[chunk.firstTriangle + t];
        for (int k = 0; k < 3; ++k) {
          corners[3 * t + static_cast<size_t>(k)] = numbers.of(triangle[k]);
        }
      }
      sources[c] = numbers.sources();
    }
  });
  for (size_t c = 0; c < chunks_.size(); ++c) {
    chunks_[c].firstVertex = static_cast<uint32_t>(sources_.size());
    chunks_[c].vertices = static_cast<uint32_t>(sources[c].size());
    sources_.insert(sources_.end(), sources[c].begin(), sources[c].end());
  }

  for (std::vector<float>* coordinate : {&x_, &y_, &z_}) {
    coordinate->resize(sources_.size() + kPadding);
  }
  setPositions(mesh.positions);
  setColors(mesh.colors);
}

void SliceMesh::setColors(std::span<const glm::vec3> colors) {
  OC_CHECK(colors.empty() || colors.size() == sourceCount_, "another number of colours than the mesh had vertices");
  if (white() && std::ranges::all_of(colors, [](const glm::vec3& color) { return color == glm::vec3(1); })) {
    return;
  }
  for (std::vector<float>* channel : {&red_, &green_, &blue_}) {
    channel->resize(sources_.size() + kPadding, static_cast<float>(kLightSteps));
  }
  parallelFor(chunks_.size(), 4, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      SliceChunk& chunk = chunks_[c];
      bool changed = false;
      for (size_t i = chunk.firstVertex; i < chunk.firstVertex + size_t{chunk.vertices}; ++i) {
        const glm::vec3 color = colors.empty() ? glm::vec3(1) : colors[sources_[i]];
        const glm::vec3 steps(lightSteps(color.r), lightSteps(color.g), lightSteps(color.b));
        changed |= steps != glm::vec3(red_[i], green_[i], blue_[i]);
        red_[i] = steps.r;
        green_[i] = steps.g;
        blue_[i] = steps.b;
      }
      chunk.version += changed ? 1 : 0;
    }
  });
}

void SliceMesh::setPositions(std::span<const glm::vec3> positions) {
  OC_CHECK(positions.size() == sourceCount_, "another number of vertices than the mesh had");
  parallelFor(chunks_.size(), 4, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      SliceChunk& chunk = chunks_[c];
      bool moved = false;
      for (size_t i = chunk.firstVertex; i < chunk.firstVertex + size_t{chunk.vertices}; ++i) {
        const glm::vec3& p = positions[sources_[i]];
        moved |= p.x != x_[i] || p.y != y_[i] || p.z != z_[i];
        x_[i] = p.x;
        y_[i] = p.y;
        z_[i] = p.z;
      }
      chunk.version += moved ? 1 : 0;
    }
  });
}

glm::vec3 SliceMesh::color(size_t vertex) const {
  return white() ? glm::vec3(1)
                 : glm::vec3(red_[vertex], green_[vertex], blue_[vertex]) / static_cast<float>(kLightSteps);
}

}  // namespace ocelli
