// Places: positions that are the same bit by bit, whatever colours the vertices there have. Surfaces that meet have
// vertices at the same places, as nothing ever moves a vertex.
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ocelli {

struct PlaceBits {
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t z = 0;

  auto operator<=>(const PlaceBits&) const = default;
};

/// Of a position of a cluster, which has no negative zeros (Welder).
inline PlaceBits placeBits(const glm::vec3& p) {
  return {std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y), std::bit_cast<uint32_t>(p.z)};
}

/// Places in order, each once.
class PlaceSet {
 public:
  PlaceSet() = default;
  /// In any order, also several times.
  explicit PlaceSet(std::vector<PlaceBits> places) : places_(std::move(places)) {
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  }

  bool contains(const PlaceBits& place) const { return std::binary_search(places_.begin(), places_.end(), place); }
  std::span<const PlaceBits> places() const { return places_; }

 private:
  std::vector<PlaceBits> places_;
};

/// Of each position the least index of a position at the same place.
std::vector<uint32_t> placeNumbers(std::span<const glm::vec3> positions);

}  // namespace ocelli
