// Places that several parts of a scene may have. A part is simplified alone: what it has at such places must stay, so
// that the parts fit, until it is put together with the other one.
//
// Which places these are is found without keeping the scene in memory. Every place has a home: the part in whose cells
// it lies. Of two parts that share a place one at least is not its home; so it is enough to look at the triangles that
// reach beyond the cells of their part. Each such place is fixed in the part of the triangle, for the sake of its home,
// and in its home, for the sake of the part of the triangle.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "oc_core/pack/place_bits.h"
#include "oc_core/pack/placed_file.h"
#include "oc_core/pack/scene_parts.h"

namespace ocelli {

struct FixedPlace {
  /// For the sake of clusters that stay as they are until the end.
  static constexpr uint32_t kForEver = 0xffffffffu;

  PlaceBits place;
  uint32_t part = kForEver;  ///< the part without children for whose sake it is fixed

  auto operator<=>(const FixedPlace&) const = default;
};

/// In order, each once.
void sortPlaces(std::vector<FixedPlace>& fixed);
PlaceSet placesOf(const std::vector<FixedPlace>& fixed);

/// Of the places of the children of a part those that stay fixed when these are put together.
std::vector<FixedPlace> fixedAbove(const ScenePlan& plan, uint32_t part, std::vector<FixedPlace> ofChildren);

/// Calls `visit(place, home)` for each corner of a triangle of `part` that has its home in another part.
template <class Visit>
void forEachStrayCorner(const ScenePlan& plan, uint32_t part, const std::array<glm::vec3, 3>& corners,
                        const Visit& visit) {
  if (plan.isWithinOneCell(corners)) {
    return;
  }
  for (const glm::vec3& corner : corners) {
    const glm::vec3 p = corner + 0.0f;  // as a Welder has it: no negative zeros
    const uint32_t home = plan.partOf(plan.cellOf(p, p, p));
    if (home != part) {
      visit(placeBits(p), home);
    }
  }
}

/// Writes what triangles of other parts fix in each part, in any order, to a file.
class FixedPlaceWriter {
 public:
  /// Throw WorkError naming the file.
  FixedPlaceWriter(const std::filesystem::path& path, size_t parts);
  void add(uint32_t part, const FixedPlace& place);
  void finish();

 private:
  void flush(uint32_t part);

  PlacedFile file_;
  uint64_t end_ = 0;
  std::vector<std::vector<FixedPlace>> buffers_;  ///< of each part
  struct Block {
    uint64_t at = 0;
    uint32_t part = 0;
    uint32_t count = 0;
  };
  std::vector<Block> blocks_;

  friend std::vector<FixedPlace> readFixedPlaces(const std::filesystem::path& path, uint32_t part);
};

/// What was written of one part. Throws WorkError naming the file.
std::vector<FixedPlace> readFixedPlaces(const std::filesystem::path& path, uint32_t part);

}  // namespace ocelli
