// What can stand for the geometry of a sea, by name.
//
// Recipe for a new one: a row of the table in oc_core/sea_input/sea_proxies.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// What proxies are made of.
struct ProxyInput {
  const Mesh* scene = nullptr;        ///< none of images in a folder
  std::vector<glm::dvec3> positions;  ///< of the images
  std::vector<glm::dvec3> points;     ///< of surfaces, where some are known
  size_t triangles = 0;               ///< at most, of what is simplified
  std::filesystem::path folder = {};  ///< of the images; empty of those that are rendered
};

struct ProxyKind {
  const char* name;
  const char* meaning;
  Mesh (*make)(const ProxyInput& input);
};

std::span<const ProxyKind> proxyKinds();

/// By the name of a row, or from the file of a mesh. Throws InputError for names of neither, and for what cannot be
/// made of the input.
Mesh makeSeaProxy(const std::string& nameOrFile, const ProxyInput& input);

/// The box that holds all of `positions` and, on each axis, all of `points` but the outermost fiftieth: twelve
/// triangles.
Mesh boxAround(const std::vector<glm::dvec3>& positions, const std::vector<glm::dvec3>& points);

}  // namespace ocelli
