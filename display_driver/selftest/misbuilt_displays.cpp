#include "display_driver/selftest/misbuilt_displays.h"

#include <glm/common.hpp>
#include <utility>

#include "display_driver/selftest/pattern_canvas.h"
#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// The light of a place in space, as the half turn shows it that `like` belongs to; dark beyond the screen.
Rgb8 lightAt(const Volume& sent, const PatternGrid& grid, const PatternVoxel& like, int sector, int ring, int row) {
  const int half = grid.sectors() / 2;
  if (ring < 0 || ring >= grid.rings() || row < 0 || row >= grid.rows()) {
    return Rgb8(0);
  }
  sector = (sector % grid.sectors() + grid.sectors()) % grid.sectors();
  bool right = sector < half;
  int slice = sector % half;
  if (grid.profile().secondHalfTurn == SecondHalfTurn::kOwn) {
    right = 2 * like.column + 1 >= grid.profile().width;
    slice = right ? sector : (sector + half) % grid.sectors();
  }
  const int width = grid.profile().width;
  return sent.levels(slice, right ? width / 2 + ring : (width - 1) / 2 - ring, row);
}

/// A display that shows at each sector what `source` says: another sector.
template <class Source>
Volume sectorsMoved(const Volume& sent, const Source& source) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) { return lightAt(sent, grid, v, source(v), v.ring, v.row); });
}

/// The content of slices moved along the screen by so many columns, which depends on the row.
template <class Columns>
Volume screenMoved(const Volume& sent, const Columns& columns) {
  const PatternGrid grid(sent.profile());
  const bool mirrored = sent.profile().secondHalfTurn == SecondHalfTurn::kMirrored;
  const auto levels = [&](const PatternVoxel& v, int by) {
    const int column = v.column - by;
    return column >= 0 && column < sent.width() ? sent.levels(v.slice, column, v.row) : Rgb8(0);
  };
  return painted(grid, [&](const PatternVoxel& v) {
    const int by = columns(v.row);
    // Half a turn later the same offset goes the other way, seen from the room.
    return mirrored ? glm::max(levels(v, by), levels(v, -by)) : levels(v, by);
  });
}

int sectorsLate(const PatternGrid& grid) {
  return std::max(1, grid.sectors() / 20);
}

int columnsBeside(const Volume& sent) {
  return std::max(1, sent.width() / 40);
}

template <class Change>
Volume colorsChanged(const Volume& sent, const Change& change) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) { return change(sent.levels(v.slice, v.column, v.row), v); });
}

/// A pixel of the panel draws a whole circle: with mirrored slices as one column first and then as that opposite.
bool isSpoilt(const PatternGrid& grid, const PatternVoxel& v) {
  const bool mirrored = grid.profile().secondHalfTurn == SecondHalfTurn::kMirrored;
  const auto at = [&](double radius, double row) {
    const int ring = grid.ringAt(radius);
    return v.row == static_cast<int>(row * grid.rows()) &&
           (mirrored ? v.ring == ring : v.column == grid.profile().width / 2 + ring);
  };
  return at(0.3, 0.3) || at(0.6, 0.3) || at(0.8, 0.75);
}

}  // namespace

Volume slicesReversed(const Volume& sent) {
  return sectorsMoved(sent, [](const PatternVoxel& v) { return -v.sector; });
}

Volume columnsReversed(const Volume& sent) {
  const int half = sent.profile().slicesPerHalfTurn;
  return sectorsMoved(sent, [&](const PatternVoxel& v) { return v.sector + half; });
}

Volume slicesAndColumnsReversed(const Volume& sent) {
  const int half = sent.profile().slicesPerHalfTurn;
  return sectorsMoved(sent, [&](const PatternVoxel& v) { return half - v.sector; });
}

Volume rowsReversed(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) { return sent.levels(v.slice, v.column, grid.rows() - 1 - v.row); });
}

Volume notMirrored(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) {
    return glm::max(lightAt(sent, grid, v, v.sector, v.ring, v.row),
                    lightAt(sent, grid, v, v.sector + grid.sectors() / 2, v.ring, v.row));
  });
}

Volume shownLate(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return sectorsMoved(sent, [&](const PatternVoxel& v) { return v.sector - sectorsLate(grid); });
}

Volume secondHalfLate(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  const int late = std::max(2, sectorsLate(grid) / 3);
  const bool own = sent.profile().secondHalfTurn == SecondHalfTurn::kOwn;
  return painted(grid, [&](const PatternVoxel& v) {
    const Rgb8 inTime = lightAt(sent, grid, v, v.sector, v.ring, v.row);
    const Rgb8 tooLate = lightAt(sent, grid, v, v.sector - late, v.ring, v.row);
    return own ? (v.slice < grid.sectors() / 2 ? inTime : tooLate) : glm::max(inTime, tooLate);
  });
}

Volume shownTooFast(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  const int half = grid.sectors() / 2;
  const int ahead = std::max(2, half / 20);
  return painted(grid, [&](const PatternVoxel& v) {
    const int shown = v.sector % half + ahead * (v.sector % half) / (half - 1);
    return shown < half ? lightAt(sent, grid, v, v.sector / half * half + shown, v.ring, v.row) : Rgb8(0);
  });
}

Volume turningUnevenly(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return sectorsMoved(sent, [&](const PatternVoxel& v) {
    const double swing = sectorsLate(grid) * 1.5 * std::sin(grid.radiansOf(v.sector));
    return v.sector + static_cast<int>(std::lround(swing));
  });
}

Volume slicesLost(const Volume& sent) {
  const int half = sent.profile().slicesPerHalfTurn;
  const int lost = std::max(1, half / 40);
  return colorsChanged(sent, [&](const Rgb8& levels, const PatternVoxel& v) {
    const int place = v.slice % half;
    const bool isLost =
        (place >= half / 5 && place < half / 5 + lost) || (place >= half / 2 && place < half / 2 + lost);
    return isLost ? Rgb8(0) : levels;
  });
}

Volume slicesSwapped(const Volume& sent) {
  const int slices = sent.slices();
  return colorsChanged(sent, [&](const Rgb8& levels, const PatternVoxel& v) {
    const int swapped = v.slice ^ 4;
    return swapped < slices ? sent.levels(swapped, v.column, v.row) : levels;
  });
}

Volume shiningOn(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) {
    Rgb8 light(0);
    for (int later = 0; later < 3; ++later) {
      light = glm::max(light, lightAt(sent, grid, v, v.sector - later, v.ring, v.row));
    }
    return light;
  });
}

Volume rowsLate(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  const int late = std::max(2, sectorsLate(grid));
  return sectorsMoved(sent, [&](const PatternVoxel& v) { return v.sector - late * v.row / grid.rows(); });
}

Volume screenBesideAxis(const Volume& sent) {
  return screenMoved(sent, [&](int) { return columnsBeside(sent); });
}

Volume screenTilted(const Volume& sent) {
  return screenMoved(sent, [&](int row) {
    return static_cast<int>(std::lround(columnsBeside(sent) * (1 - 2.0 * row / sent.height())));
  });
}

Volume screenNarrow(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) { return lightAt(sent, grid, v, v.sector, v.ring * 5 / 4, v.row); });
}

Volume lightSpread(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return painted(grid, [&](const PatternVoxel& v) {
    Rgb8 light(0);
    for (const auto& [out, down] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      light = glm::max(light, lightAt(sent, grid, v, v.sector, v.ring + out, v.row + down));
    }
    return light;
  });
}

Volume pixelsStuck(const Volume& sent) {
  const PatternGrid grid(sent.profile());
  return colorsChanged(
      sent, [&](const Rgb8& levels, const PatternVoxel& v) { return isSpoilt(grid, v) ? grid.white() : levels; });
}

Volume channelsSwapped(const Volume& sent) {
  return colorsChanged(sent,
                       [](const Rgb8& levels, const PatternVoxel&) { return Rgb8(levels.b, levels.g, levels.r); });
}

Volume greenMissing(const Volume& sent) {
  return colorsChanged(sent, [](const Rgb8& levels, const PatternVoxel&) { return Rgb8(levels.r, 0, levels.b); });
}

}  // namespace ocelli
