// What became of a walker in a composed image, from where it should be seen and where it is.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ocelli {

/// What became of one walker in one frame.
enum class WalkerFate {
  kRight,      ///< seen where the graph camera sees it, and nowhere else; or rightly not seen
  kBetween,    ///< crosses a near face, so that it fades, and is seen
  kDoubled,    ///< seen where it should be, and elsewhere too
  kMisplaced,  ///< seen elsewhere alone
  kMissing,    ///< not seen, though the camera of its frustum sees it
  kHidden,     ///< not seen, as that camera sees hardly anything of it: somebody stands before it
  kGhost,      ///< seen, though the graph camera does not see it
};
inline constexpr size_t kWalkerFates = 7;
const char* nameOf(WalkerFate fate);
/// One sentence for those who read a report.
const char* meaningOf(WalkerFate fate);

/// Where a walker is in an image.
struct WalkerArea {
  std::vector<double> pixels;  ///< by frustum
  int left = 0;                ///< its box; empty where right is not over left
  int top = 0;
  int right = 0;
  int bottom = 0;

  bool isEmpty() const { return right <= left; }
  double all() const;
  void add(size_t frustum, int x, int y);
};
using WalkerAreas = std::vector<WalkerArea>;  ///< of each walker
WalkerAreas emptyAreas(size_t walkers, size_t frusta);

/// `wanted`: in the graph camera's own rendering; `shown`: in the composed image; `seen`: what the cameras of the
/// frusta see at all, in the composed image's pixels; `fades`: it stands so near to a near face that it fades.
WalkerFate fateOf(const WalkerArea& wanted, const WalkerArea& shown, const WalkerArea& seen, bool fades);

}  // namespace ocelli
