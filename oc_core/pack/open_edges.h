// The borders of some triangles: edges that no other triangle passes in the other direction. What is next to the
// triangles fits along some of them; the others are rims of the scene.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ocelli {

struct OpenEdge {
  uint32_t from = 0;  ///< a place (placeNumbers())
  uint32_t to = 0;
  uint32_t times = 0;  ///< how many times more often it is passed in this direction than in the other

  auto operator<=>(const OpenEdge&) const = default;
};

/// In order. `indices`: three vertices a triangle; `places`: the place of each vertex.
std::vector<OpenEdge> openEdges(std::span<const uint32_t> indices, std::span<const uint32_t> places);

/// Whether coarser triangles fit where the finer ones did, and have no hole that these had not: every edge between two
/// places of which `isShared` is open as before, and others are open between places of the old rims alone.
bool keepsBorders(std::span<const OpenEdge> fine, std::span<const OpenEdge> coarse, std::span<const uint8_t> isShared);

/// Of each place the number of the piece of surface that it belongs to: its least place. Triangles that share a place
/// are of one piece.
std::vector<uint32_t> connectedPieces(std::span<const uint32_t> indices, std::span<const uint32_t> places);

}  // namespace ocelli
