#include "oc_core/scene/texture_bake.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/scene/edge_split.h"

namespace ocelli {
namespace {

/// A little more than the diagonal of a pixel, so that a square pixel becomes two triangles and is left at that.
constexpr float kPixelsInEdge = 1.5f;
/// With a vertex at the middle of each pixel, too: eight triangles a pixel.
constexpr float kPixelsInFineEdge = kPixelsInEdge / 2;
constexpr double kFineTriangles = 4;
/// Each round halves the edges: enough for the longest texture, and an end for coordinates that are out of all bounds.
constexpr int kMaxRounds = 16;

/// A layer, and how many pixels its texture has along u and v.
struct LayerPixels {
  TextureLayer& layer;
  glm::vec2 pixels;
};

std::vector<LayerPixels> layersOf(TexturedMesh& part, const std::vector<Texture>& textures) {
  std::vector<LayerPixels> layers;
  for (std::optional<TextureLayer>* layer : {&part.base, &part.emissive, &part.mask}) {
    if (*layer) {
      const Image<Rgb8>& image = textures[(*layer)->texture].image;
      layers.push_back({**layer, {image.width(), image.height()}});
    }
  }
  return layers;
}

/// About how many triangles the splitting will add: each covers half a pixel of the finest texture.
double estimateNew(const Mesh& mesh, const std::vector<LayerPixels>& layers) {
  double added = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    double wanted = 0;
    for (const auto& [layer, pixels] : layers) {
      const glm::vec2 ab = (layer.uvs[t.y] - layer.uvs[t.x]) * pixels;
      const glm::vec2 ac = (layer.uvs[t.z] - layer.uvs[t.x]) * pixels;
      const double twiceArea = std::abs(static_cast<double>(ab.x) * ac.y - static_cast<double>(ab.y) * ac.x);
      wanted = std::isfinite(twiceArea) ? std::max(wanted, twiceArea) : wanted;
    }
    added += std::max(0.0, wanted - 1);
  }
  return added;
}

/// For each edge its length in pixels of the finest texture, or that of the longest edge between the same two places.
std::vector<float> pixelLengths(const Mesh& mesh, const EdgeList& list, const std::vector<LayerPixels>& layers) {
  std::vector<unsigned> place(mesh.positions.size());
  meshopt_generateVertexRemap(place.data(), nullptr, place.size(), mesh.positions.data(), place.size(),
                              sizeof(glm::vec3));
  std::vector<float> lengths(list.edges.size());
  std::vector<std::pair<uint64_t, uint32_t>> byPlaces(list.edges.size());
  for (uint32_t i = 0; i < list.edges.size(); ++i) {
    const Edge& edge = list.edges[i];
    for (const auto& [layer, pixels] : layers) {
      const float length = glm::length((layer.uvs[edge.high] - layer.uvs[edge.low]) * pixels);
      lengths[i] = std::isfinite(length) ? std::max(lengths[i], length) : lengths[i];
    }
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

/// Splits until no edge is longer than `pixelsInEdge`, or the mesh has `most` triangles or more.
void splitToPixels(TexturedMesh& part, const std::vector<LayerPixels>& layers, float pixelsInEdge, size_t most) {
  Mesh& mesh = part.mesh;
  for (int round = 0; round < kMaxRounds && mesh.triangles.size() < most; ++round) {
    const EdgeList list = findEdges(mesh);
    const std::vector<float> lengths = pixelLengths(mesh, list, layers);
    std::vector<uint32_t> chosen;
    for (uint32_t i = 0; i < lengths.size(); ++i) {
      if (lengths[i] > pixelsInEdge) {
        chosen.push_back(i);
      }
    }
    if (chosen.empty()) {
      return;
    }
    splitEdges(mesh, list, chosen);
    for (const uint32_t edge : chosen) {
      part.added.push_back({list.edges[edge].low, list.edges[edge].high});
    }
    for (const auto& [layer, pixels] : layers) {
      for (const uint32_t edge : chosen) {
        layer.uvs.push_back((layer.uvs[list.edges[edge].low] + layer.uvs[list.edges[edge].high]) * 0.5f);
      }
    }
  }
}

void setColors(TexturedMesh& part, const std::vector<Texture>& textures) {
  const auto sample = [&](const std::optional<TextureLayer>& layer, size_t vertex) {
    return layer ? textures[layer->texture].sample(layer->uvs[vertex]) : glm::vec3(1);
  };
  std::vector<glm::vec3>& colors = part.mesh.colors;
  colors.resize(part.mesh.positions.size(), glm::vec3(1));
  for (size_t i = 0; i < colors.size(); ++i) {
    colors[i] = glm::min(colors[i] * sample(part.base, i) + part.emission * sample(part.emissive, i), glm::vec3(1));
  }
}

void cutByMask(TexturedMesh& part, const std::vector<Texture>& textures) {
  const Texture& mask = textures[part.mask->texture];
  std::vector<float> values;
  values.reserve(part.mesh.positions.size());
  for (const glm::vec2& uv : part.mask->uvs) {
    values.push_back(mask.value(uv));
  }
  const std::vector<EdgeVertex> cut = cutAway(part.mesh, values, part.maskCutoff);
  part.added.insert(part.added.end(), cut.begin(), cut.end());
}

/// Of each texture whether it is one of values.
std::vector<char> findMasks(const std::vector<TexturedMesh>& parts, size_t textures) {
  std::vector<char> isMask(textures, 0);
  for (const TexturedMesh& part : parts) {
    if (part.mask) {
      isMask[part.mask->texture] = 1;
    }
  }
  return isMask;
}

}  // namespace

BakedTextures bakeTextures(std::vector<TexturedMesh>& parts, std::vector<Texture> textures, size_t maxTriangles) {
  for (const TexturedMesh& part : parts) {
    for (const std::optional<TextureLayer>* layer : {&part.base, &part.emissive, &part.mask}) {
      OC_CHECK(!*layer || ((*layer)->uvs.size() == part.mesh.positions.size() && (*layer)->texture < textures.size()),
               "a layer has a texture and a coordinate a vertex");
    }
  }
  const auto addedInAll = [&] {
    double added = 0;
    for (TexturedMesh& part : parts) {
      added += part.hasTexture() ? estimateNew(part.mesh, layersOf(part, textures)) : 0;
    }
    return added;
  };
  const auto canShrink = [](const Texture& texture) { return texture.image.width() > 1 || texture.image.height() > 1; };
  const std::vector<char> isMask = findMasks(parts, textures.size());
  const auto limit = static_cast<double>(maxTriangles);
  double total = addedInAll();
  BakedTextures baked{.wanted = total};
  const bool isFine = kFineTriangles * total <= limit;
  for (; total > limit && std::any_of(textures.begin(), textures.end(), canShrink); total = addedInAll()) {
    ++baked.halvings;
    for (size_t i = 0; i < textures.size(); ++i) {
      textures[i] = isMask[i] != 0 ? textures[i].halvedValues() : textures[i].halved();
    }
  }
  // The estimate leaves slivers out: the limit of each part has room for them. Coordinates that run over a texture very
  // often ask for too many triangles even where it has one pixel: then they share what there may be.
  constexpr double kRoom = 4;
  baked.isCut = total > limit;
  const double factor = baked.isCut ? limit / total : isFine ? kRoom * kFineTriangles : kRoom;
  for (TexturedMesh& part : parts) {
    if (maxTriangles > 0 && part.hasTexture()) {
      const std::vector<LayerPixels> layers = layersOf(part, textures);
      splitToPixels(part, layers, isFine ? kPixelsInFineEdge : kPixelsInEdge,
                    part.mesh.triangles.size() + static_cast<size_t>(factor * estimateNew(part.mesh, layers)));
    }
    if (part.hasTexture() || part.emission != glm::vec3(0)) {
      setColors(part, textures);
    }
    if (part.mask) {
      cutByMask(part, textures);
    }
  }
  return baked;
}

}  // namespace ocelli
