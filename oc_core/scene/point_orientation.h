// Normals of estimated planes, turned to one side.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace ocelli {

/// Turns the unit normals of points so that neighbours agree (Hoppe et al. 1992, section 3.3): from point to point
/// along neighbours of whose agreement there is the least doubt. Each connected part is turned outwards: what its six
/// extreme points along the axes say, each as much as its normal is along that axis; where they say nothing, as on a
/// flat part, towards +z, whence the default view looks. `neighbors` has `perPoint` of each point, kNoNeighbor where
/// there are fewer.
///
/// DEVIATION: doubts are rounded to 1024 steps, so that the tree of connections is the least one but for that.
void orientNormals(std::span<const glm::vec3> positions, std::span<const uint32_t> neighbors, size_t perPoint,
                   std::span<glm::vec3> normals);

inline constexpr uint32_t kNoNeighbor = 0xffffffffu;

}  // namespace ocelli
