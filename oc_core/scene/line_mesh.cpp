#include "oc_core/scene/line_mesh.h"

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/scene/scene.h"

namespace ocelli {
namespace {

/// Neighbouring sides meet at 45 degrees, which shading.h takes for smooth.
constexpr uint32_t kTubeSides = 8;
constexpr uint32_t kNoSegment = std::numeric_limits<uint32_t>::max();

class TubeMaker {
 public:
  TubeMaker(const LineSet& lines, double width, std::vector<uint32_t>* sources)
      : lines_(lines), radius_(width / 2), sources_(sources), at_(lines.positions.size()) {
    for (uint32_t s = 0; s < lines.segments.size(); ++s) {
      if (hasLength(s)) {
        for (const uint32_t end : {lines.segments[s].x, lines.segments[s].y}) {
          At& at = at_[end];
          (at.count == 0 ? at.first : at.second) = s;
          ++at.count;
        }
      }
    }
  }

  Mesh make() {
    used_.assign(lines_.segments.size(), 0);
    for (uint32_t s = 0; s < lines_.segments.size(); ++s) {
      if (used_[s] == 0 && hasLength(s)) {
        addTube(s);
      }
    }
    return std::move(mesh_);
  }

 private:
  /// Segments at a vertex.
  struct At {
    uint32_t count = 0;
    uint32_t first = kNoSegment;
    uint32_t second = kNoSegment;
  };

  bool hasLength(uint32_t segment) const {
    const glm::uvec2& ends = lines_.segments[segment];
    return lines_.positions[ends.x] != lines_.positions[ends.y];
  }

  glm::dvec3 place(uint32_t vertex) const { return lines_.positions[vertex]; }
  glm::dvec3 direction(uint32_t from, uint32_t to) const { return glm::normalize(place(to) - place(from)); }
  uint32_t otherEnd(uint32_t segment, uint32_t vertex) const {
    const glm::uvec2& ends = lines_.segments[segment];
    return ends.x == vertex ? ends.y : ends.x;
  }

  /// The segment that goes on from `segment` at its end `vertex` in the same tube, or kNoSegment.
  uint32_t following(uint32_t segment, uint32_t vertex) const {
    const At& at = at_[vertex];
    if (at.count != 2) {
      return kNoSegment;
    }
    const uint32_t next = at.first == segment ? at.second : at.first;
    const bool bendsLittle =
        glm::dot(direction(otherEnd(segment, vertex), vertex), direction(vertex, otherEnd(next, vertex))) > 0;
    return next != segment && bendsLittle ? next : kNoSegment;
  }

  /// The whole tube that a segment is part of, from one of its ends.
  void addTube(uint32_t segment) {
    uint32_t vertex = lines_.segments[segment].x;
    uint32_t first = segment;
    for (uint32_t before = following(first, vertex); before != kNoSegment && before != segment;
         before = following(first, vertex)) {
      vertex = otherEnd(before, vertex);
      first = before;
    }
    std::vector<uint32_t> chain{vertex};
    for (uint32_t s = first; s != kNoSegment && used_[s] == 0; s = following(s, chain.back())) {
      used_[s] = 1;
      chain.push_back(otherEnd(s, chain.back()));
    }
    addChain(chain);
  }

  void addVertex(const glm::dvec3& position, uint32_t source) {
    mesh_.positions.emplace_back(position);
    if (!lines_.colors.empty()) {
      mesh_.colors.push_back(lines_.colors[source]);
    }
    if (sources_ != nullptr) {
      sources_->push_back(source);
    }
  }

  /// A ring around a vertex where the tube goes from `in` to `out`, each of length 1: in the plane half-way between, so
  /// that both cylinders meet in it. `across_` is turned along.
  void addRing(uint32_t vertex, const glm::dvec3& in, const glm::dvec3& out) {
    across_ -= in * glm::dot(across_, in);
    across_ = glm::normalize(across_);
    const glm::dvec3 up = glm::cross(in, across_);
    const glm::dvec3 normal = in + out;
    for (uint32_t i = 0; i < kTubeSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kTubeSides;
      const glm::dvec3 offset = (across_ * std::cos(angle) + up * std::sin(angle)) * radius_;
      // Along `in` onto the plane through the vertex.
      addVertex(place(vertex) + offset - in * (glm::dot(offset, normal) / glm::dot(in, normal)), vertex);
    }
  }

  void addChain(const std::vector<uint32_t>& chain) {
    const auto begin = static_cast<uint32_t>(mesh_.positions.size());
    const glm::dvec3 start = direction(chain[0], chain[1]);
    // Any direction across the first segment: from the axis that it is least along.
    const glm::dvec3 size = glm::abs(start);
    across_ = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
              : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
    addVertex(place(chain[0]) - start * radius_, chain[0]);
    glm::dvec3 in = start;
    for (size_t i = 0; i < chain.size(); ++i) {
      const glm::dvec3 out = i + 1 < chain.size() ? direction(chain[i], chain[i + 1]) : in;
      addRing(chain[i], in, out);
      in = out;
    }
    addVertex(place(chain.back()) + in * radius_, chain.back());
    const auto rings = static_cast<uint32_t>(chain.size());
    const auto corner = [&](uint32_t ring, uint32_t side) { return begin + 1 + ring * kTubeSides + side % kTubeSides; };
    for (uint32_t side = 0; side < kTubeSides; ++side) {
      mesh_.triangles.emplace_back(begin, corner(0, side + 1), corner(0, side));
      for (uint32_t ring = 0; ring + 1 < rings; ++ring) {
        mesh_.triangles.emplace_back(corner(ring, side), corner(ring, side + 1), corner(ring + 1, side));
        mesh_.triangles.emplace_back(corner(ring, side + 1), corner(ring + 1, side + 1), corner(ring + 1, side));
      }
      mesh_.triangles.emplace_back(corner(rings - 1, side), corner(rings - 1, side + 1),
                                   begin + 1 + rings * kTubeSides);
    }
  }

  const LineSet& lines_;
  double radius_;
  std::vector<uint32_t>* sources_;
  std::vector<At> at_;
  std::vector<char> used_;
  glm::dvec3 across_{0};
  Mesh mesh_;
};

}  // namespace

Mesh meshOfLines(const LineSet& lines, double width, const std::string& where, std::vector<uint32_t>* sources) {
  OC_CHECK(width > 0 && (lines.colors.empty() || lines.colors.size() == lines.positions.size()),
           "lines have a width, and colours a vertex or none");
  // Two triangles a side, and both ends.
  if (lines.segments.size() > kMaxSceneTriangles / (4 * kTubeSides)) {
    throw InputError("the scene has more lines than become " + std::to_string(kMaxSceneTriangles) + " triangles", where,
                     "leave lines out");
  }
  for (const glm::uvec2& segment : lines.segments) {
    OC_CHECK(segment.x < lines.positions.size() && segment.y < lines.positions.size(), "a line joins two vertices");
    for (const uint32_t vertex : {segment.x, segment.y}) {
      if (!isFinite(lines.positions[vertex])) {
        throw InputError("a line has a coordinate that is not a finite number", where, "export the scene again");
      }
    }
  }
  if (sources != nullptr) {
    sources->clear();
  }
  return TubeMaker(lines, width, sources).make();
}

}  // namespace ocelli
