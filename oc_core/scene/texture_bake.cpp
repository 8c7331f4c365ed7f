#include "oc_core/scene/texture_bake.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/scene/edge_split.h"

namespace ocelli {
namespace {

/// A little more than the diagonal of a pixel, so that a square pixel becomes two triangles and is left at that.
constexpr float kPixelsInEdge = 1.5f;
/// Each round halves the edges: enough for the longest texture, and an end for coordinates that are out of all bounds.
constexpr int kMostRounds = 16;

glm::vec2 pixelsOf(const TexturedMesh& part, const std::vector<Texture>& textures) {
  const Image<Rgb8>& image = textures[part.texture].image;
  return {image.width(), image.height()};
}

/// About how many triangles the splitting will add: each covers half a pixel.
double estimateNew(const TexturedMesh& part, const glm::vec2& pixels) {
  double added = 0;
  for (const glm::uvec3& t : part.mesh.triangles) {
    const glm::vec2 ab = (part.uvs[t.y] - part.uvs[t.x]) * pixels;
    const glm::vec2 ac = (part.uvs[t.z] - part.uvs[t.x]) * pixels;
    const double area = std::abs(static_cast<double>(ab.x) * ac.y - static_cast<double>(ab.y) * ac.x) / 2;
    const double wanted = area * 2;
    added += std::isfinite(wanted) ? std::max(0.0, wanted - 1) : 0.0;
  }
  return added;
}

/// For each edge its length in pixels, or that of the longest edge between the same two places.
std::vector<float> pixelLengths(const TexturedMesh& part, const EdgeList& list, const glm::vec2& pixels) {
  std::vector<unsigned> place(part.mesh.positions.size());
  meshopt_generateVertexRemap(place.data(), nullptr, place.size(), part.mesh.positions.data(), place.size(),
                              sizeof(glm::vec3));
  std::vector<float> lengths(list.edges.size());
  std::vector<std::pair<uint64_t, uint32_t>> byPlaces(list.edges.size());
  for (uint32_t i = 0; i < list.edges.size(); ++i) {
    const Edge& edge = list.edges[i];
    const float length = glm::length((part.uvs[edge.high] - part.uvs[edge.low]) * pixels);
    lengths[i] = std::isfinite(length) ? length : 0;
    const auto [low, high] = std::minmax(place[edge.low], place[edge.high]);
    byPlaces[i] = {static_cast<uint64_t>(low) << 32 | high, i};
  }
  std::sort(byPlaces.begin(), byPlaces.end());
  for (size_t begin = 0; begin < byPlaces.size();) {
    size_t end = begin;
    float longest = 0;
    for (; end < byPlaces.size() && byPlaces[end].first == byPlaces[begin].first; ++end) {
      longest = std::max(longest, lengths[byPlaces[end].second]);
    }
    for (; begin < end; ++begin) {
      lengths[byPlaces[begin].second] = longest;
    }
  }
  return lengths;
}

/// Splits until no edge is longer than kPixelsInEdge, or the mesh has `most` triangles or more.
void splitToPixels(TexturedMesh& part, const glm::vec2& pixels, size_t most) {
  for (int round = 0; round < kMostRounds && part.mesh.triangles.size() < most; ++round) {
    const EdgeList list = findEdges(part.mesh);
    const std::vector<float> lengths = pixelLengths(part, list, pixels);
    std::vector<uint32_t> chosen;
    for (uint32_t i = 0; i < lengths.size(); ++i) {
      if (lengths[i] > kPixelsInEdge) {
        chosen.push_back(i);
      }
    }
    if (chosen.empty()) {
      return;
    }
    splitEdges(part.mesh, list, chosen);
    for (const uint32_t edge : chosen) {
      part.uvs.push_back((part.uvs[list.edges[edge].low] + part.uvs[list.edges[edge].high]) * 0.5f);
    }
  }
}

}  // namespace

void bakeTextures(std::vector<TexturedMesh>& parts, std::vector<Texture> textures, size_t mostTriangles) {
  const auto addedInAll = [&] {
    double added = 0;
    for (const TexturedMesh& part : parts) {
      added += estimateNew(part, pixelsOf(part, textures));
    }
    return added;
  };
  const auto canShrink = [](const Texture& texture) { return texture.image.width() > 1 || texture.image.height() > 1; };
  while (addedInAll() > static_cast<double>(mostTriangles) &&
         std::any_of(textures.begin(), textures.end(), canShrink)) {
    for (Texture& texture : textures) {
      texture = texture.halved();
    }
  }
  for (TexturedMesh& part : parts) {
    OC_CHECK(part.uvs.size() == part.mesh.positions.size() && part.texture < textures.size(),
             "a textured mesh has a texture and a coordinate a vertex");
    if (mostTriangles > 0) {
      // The estimate leaves slivers out: the limit of each part has room for them.
      const glm::vec2 pixels = pixelsOf(part, textures);
      splitToPixels(part, pixels, part.mesh.triangles.size() + static_cast<size_t>(4 * estimateNew(part, pixels)));
    }
    part.mesh.colors.resize(part.mesh.positions.size(), glm::vec3(1));
    for (size_t i = 0; i < part.uvs.size(); ++i) {
      part.mesh.colors[i] *= textures[part.texture].sample(part.uvs[i]);
    }
  }
}

}  // namespace ocelli
