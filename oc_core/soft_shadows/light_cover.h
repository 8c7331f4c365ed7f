// How many surfaces hide each sample of a light from a point, up to a number that is the same for all of them: from
// the edges alone at which that number changes (after S. Laine, T. Aila, U. Assarsson, J. Lehtinen and T. Akenine-
// Moller, Soft shadow volumes for ray tracing, SIGGRAPH 2005).
//
// Edges are projected onto the light. One that runs upwards past a row of samples changes the number of all that lie to
// the right of it; what happens left of the light is told by where edges cross the light's left side. So only edges
// that come over the light count, and one that is as short as a sample's pixel is two additions at most: samples hold
// the difference to their left neighbour until all edges are in.
#pragma once

#include <array>
#include <cstdint>

#include "oc_core/soft_shadows/light_grid.h"

namespace ocelli {

class LightCover {
 public:
  explicit LightCover(const LightGrid& grid);

  void clear();
  /// What is below the horizon of the receiver is hidden by more surfaces than there are.
  static constexpr int kHorizonWeight = 4096;
  /// An edge from `a` to `b`, in grid coordinates. `weight` surfaces lie to its left (seen with x to the right and y
  /// up) more than to its right.
  void add(const glm::vec2& a, const glm::vec2& b, int weight);

  /// The samples that fewest surfaces hide.
  struct Least {
    int count = 0;   ///< of them
    int column = 0;  ///< one of them, among others of them where there is such a one
    int row = 0;
    int otherColumn = 0;  ///< another one, far from it where there is
    int otherRow = 0;
    bool hasHidden = false;  ///< whether there are samples on the light that are not among them
    int hiddenColumn = 0;    ///< one of those, among others of those where there is such a one
    int hiddenRow = 0;
    int neighbours = 0;  ///< pairs of neighbouring samples of which one is among them
  };
  Least least();
  /// After least(): whether a sample is among them.
  bool isLeast(int column, int row) const { return hidden_[index(column, row)] == least_; }

 private:
  static constexpr size_t kSide = LightGrid::kMaxSide;
  static constexpr int16_t kOffLight = INT16_MAX;
  size_t index(int column, int row) const { return static_cast<size_t>(column) * kSide + static_cast<size_t>(row); }

  /// How many neighbours of a sample are among the least, too, or are not, as it is itself; -1 where it is not as
  /// asked, or beside the light.
  int alikeAround(int column, int row, bool isAmongLeast) const;

  const LightGrid& grid_;
  // Column by column.
  std::array<int16_t, kSide * kSide> change_{};  ///< to the left neighbour
  std::array<int16_t, kSide * kSide> hidden_{};
  std::array<int16_t, kSide * kSide> offLight_{};  ///< kOffLight there, else the least number
  std::array<int16_t, kSide + 1> changeOfRow_{};   ///< at the left side, to the row below
  int16_t least_ = 0;
};

}  // namespace ocelli
