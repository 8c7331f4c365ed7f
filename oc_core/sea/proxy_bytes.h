// The proxy of a sea as bytes: places on a grid of 16 bits a side, coded by meshoptimizer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

inline constexpr uint32_t kMaxProxyVertices = 1u << 22;
inline constexpr uint32_t kMaxProxyTriangles = 1u << 23;

/// Positions and triangles alone. Throws InputError, naming `where`, for a mesh with more than these, or with
/// coordinates that are not finite. No triangles: no proxy.
std::vector<uint8_t> proxyBytes(const Mesh& mesh, const std::string& where);
/// Throws InputError where they are none. Takes no more memory than the numbers above allow.
Mesh proxyFromBytes(std::span<const uint8_t> bytes, const std::string& where);

}  // namespace ocelli
