#include "oc_core/pack/one_color.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>
#include <tuple>

#include "oc_core/pack/place_bits.h"

namespace ocelli {
OneColorTriangles withOneColor(const WeldedTriangles& welded) {
  std::vector<uint32_t> order(welded.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return std::tuple(placeBits(welded.positions[a]), a) < std::tuple(placeBits(welded.positions[b]), b);
  });
  std::vector<PackedColor> means(order.size());
  std::vector<float> spreads(order.size(), 0);
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin;
    glm::vec3 sum(0);
    while (end < order.size() && placeBits(welded.positions[order[end]]) == placeBits(welded.positions[order[begin]])) {
      sum += linearColor(welded.colors[order[end++]]);
    }
    const PackedColor mean = packedColor(sum / static_cast<float>(end - begin));
    float spread = 0;
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3 off = glm::abs(linearColor(welded.colors[order[i]]) - linearColor(mean));
      spread = end - begin > 1 ? std::max({spread, off.r, off.g, off.b}) : 0;
    }
    for (size_t i = begin; i < end; ++i) {
      means[order[i]] = mean;
      spreads[order[i]] = spread;
    }
    begin = end;
  }

  OneColorTriangles result;
  Welder welder(order.size());
  const auto vertexOf = [&](uint32_t old) {
    const uint32_t vertex = welder.vertex(welded.positions[old], means[old]);
    result.spread.resize(std::max<size_t>(result.spread.size(), vertex + 1), 0);
    result.spread[vertex] = std::max(result.spread[vertex], spreads[old]);
    return vertex;
  };
  for (size_t i = 0; i + 2 < welded.indices.size(); i += 3) {
    const uint32_t a = vertexOf(welded.indices[i]);
    const uint32_t b = vertexOf(welded.indices[i + 1]);
    const uint32_t c = vertexOf(welded.indices[i + 2]);
    welder.add(a, b, c);
  }
  result.triangles = welder.take();
  return result;
}

}  // namespace ocelli
