// The letters of the orientation pattern, read as people read them who stand around the display; and what they see of a
// display that is built wrongly, as its checklist says.
#include <gtest/gtest.h>

#include <array>
#include <glm/vec3.hpp>
#include <map>

#include "display_driver/selftest/misbuilt_displays.h"
#include "display_driver/selftest/test_patterns.h"
#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/conventions.h"
#include "tests/display_driver_selftest/pattern_profiles.h"

namespace ocelli {
namespace {

using Letter = std::vector<std::string>;
const Letter kF{"#####", "#....", "#....", "####.", "#....", "#....", "#...."};
const Letter kR{"####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#"};
const Letter kB{"####.", "#...#", "#...#", "####.", "#...#", "#...#", "####."};
const Letter kL{"#....", "#....", "#....", "#....", "#....", "#....", "#####"};
const Letter kTop{"#####..###..####.", "..#...#...#.#...#", "..#...#...#.#...#", "..#...#...#.####.",
                  "..#...#...#.#....", "..#...#...#.#....", "..#....###..#...."};

Letter mirrored(Letter letter) {
  for (std::string& row : letter) {
    row = {row.rbegin(), row.rend()};
  }
  return letter;
}

Letter upsideDown(Letter letter) {
  return {letter.rbegin(), letter.rend()};
}

/// Which cells of a field are lit for the most part: `place` says for a point how far right and down it lies in the
/// field, both in [0, 1), or nothing.
template <class Place>
Letter read(const Volume& volume, size_t columns, size_t rows, const Place& place) {
  const SweepGeometry geometry(volume.profile());
  std::vector<size_t> lit(columns * rows);
  std::vector<size_t> all(columns * rows);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (int row = 0; row < volume.height(); ++row) {
      for (int column = 0; column < volume.width(); ++column) {
        if (const auto at = place(geometry.voxelCenter(slice, column, row))) {
          const size_t cell = static_cast<size_t>(at->second * static_cast<double>(rows)) * columns +
                              static_cast<size_t>(at->first * static_cast<double>(columns));
          ++all[cell];
          lit[cell] += volume.colorBits(slice, column, row) != 0;
        }
      }
    }
  }
  Letter letter(rows, std::string(columns, '.'));
  for (size_t cell = 0; cell < all.size(); ++cell) {
    EXPECT_GT(all[cell], 0u);
    if (2 * lit[cell] > all[cell]) {
      letter[cell / columns][cell % columns] = '#';
    }
  }
  return letter;
}

using InField = std::optional<std::pair<double, double>>;

/// The near letter, from outside: by someone who stands in the direction (cos, sin) of x and z.
Letter readFrom(const Volume& volume, double degrees, bool above) {
  const double radians = degrees * kPi / 180;
  return read(volume, 5, 7, [&](const glm::dvec3& p) -> InField {
    // As the pattern's description says: cells of 0.14 by 0.1 on the cylinder of radius 0.95, middles at y = +-0.45.
    if (std::abs(std::hypot(p.x, p.z) - 0.95) > 1.0 / volume.width()) {
      return std::nullopt;
    }
    const double towards = p.x * std::cos(radians) + p.z * std::sin(radians);
    // To the right of someone who looks along -towards, y up: towards x up, turned.
    const double right = p.x * std::sin(radians) - p.z * std::cos(radians);
    if (towards <= 0) {
      return std::nullopt;
    }
    const double x = 0.95 * std::atan2(right, towards) / 0.7 + 0.5;
    const double y = ((above ? 0.45 : -0.45) - p.y) / 0.7 + 0.5;
    return x >= 0 && x < 1 && y >= 0 && y < 1 ? InField({x, y}) : std::nullopt;
  });
}

Letter readFromAbove(const Volume& volume, double height) {
  return read(volume, 17, 7, [&](const glm::dvec3& p) -> InField {
    const double x = p.x / 1.6 + 0.5;
    const double y = p.z / (1.6 * 7 / 17) + 0.5;
    const bool inside = std::abs(p.y - height) < 1.0 / volume.height() && x >= 0 && x < 1 && y >= 0 && y < 1;
    return inside ? InField({x, y}) : std::nullopt;
  });
}

constexpr double kRight = 0;
constexpr double kFront = 90;
constexpr double kLeft = 180;
constexpr double kBack = 270;

/// Reads a volume as a display shows it whose slices, columns or rows run the wrong way.
Volume misbuilt(const Volume& right, bool slices, bool columns, bool rows) {
  Volume wrong(right.profile());
  const int half = right.profile().slicesPerHalfTurn;
  for (int slice = 0; slice < right.slices(); ++slice) {
    for (int row = 0; row < right.height(); ++row) {
      for (int column = 0; column < right.width(); ++column) {
        // What stands at the angle t is shown at -t, which is slice N - i, seen from the other side of the axis.
        const int shown = slices ? (half - slice) % half : slice;
        const bool flipped = columns != (slices && slice != 0);
        wrong.light(shown, flipped ? right.width() - 1 - column : column, rows ? right.height() - 1 - row : row,
                    right.colorBits(slice, column, row));
      }
    }
  }
  return wrong;
}

class Orientation : public testing::Test {
 protected:
  const Volume right_ = testPattern("orientation").volume(test::patternProfile(90, 128, 128));
};

TEST_F(Orientation, LettersReadFromTheirSides) {
  EXPECT_EQ(readFrom(right_, kFront, true), kF);
  EXPECT_EQ(readFrom(right_, kRight, true), kR);
  EXPECT_EQ(readFrom(right_, kBack, false), kB);
  EXPECT_EQ(readFrom(right_, kLeft, false), kL);
  EXPECT_EQ(readFromAbove(right_, 0.85), kTop);
}

TEST_F(Orientation, OtherHalvesAreFree) {
  const Letter dark(7, ".....");
  EXPECT_EQ(readFrom(right_, kFront, false), dark);
  EXPECT_EQ(readFrom(right_, kRight, false), dark);
  EXPECT_EQ(readFrom(right_, kBack, true), dark);
  EXPECT_EQ(readFrom(right_, kLeft, true), dark);
}

TEST_F(Orientation, ColumnsTheWrongWayAreHalfATurn) {
  const Volume wrong = misbuilt(right_, false, true, false);
  EXPECT_EQ(columnsReversed(right_), wrong);
  EXPECT_EQ(readFrom(wrong, kFront, false), kB);
  EXPECT_EQ(readFrom(wrong, kRight, false), kL);
  EXPECT_EQ(readFrom(wrong, kBack, true), kF);
  EXPECT_EQ(readFrom(wrong, kLeft, true), kR);
}

TEST_F(Orientation, SlicesTheWrongWayMirrorAndSwapFrontAndBack) {
  const Volume wrong = misbuilt(right_, true, false, false);
  EXPECT_EQ(slicesReversed(right_), wrong);
  EXPECT_EQ(readFrom(wrong, kFront, false), mirrored(kB));
  EXPECT_EQ(readFrom(wrong, kBack, true), mirrored(kF));
  EXPECT_EQ(readFrom(wrong, kRight, true), mirrored(kR));
  EXPECT_EQ(readFrom(wrong, kLeft, false), mirrored(kL));
}

TEST_F(Orientation, SlicesAndColumnsTheWrongWayMirrorAndSwapRightAndLeft) {
  const Volume wrong = misbuilt(right_, true, true, false);
  EXPECT_EQ(slicesAndColumnsReversed(right_), wrong);
  EXPECT_EQ(readFrom(wrong, kFront, true), mirrored(kF));
  EXPECT_EQ(readFrom(wrong, kBack, false), mirrored(kB));
  EXPECT_EQ(readFrom(wrong, kRight, false), mirrored(kL));
  EXPECT_EQ(readFrom(wrong, kLeft, true), mirrored(kR));
}

TEST_F(Orientation, RowsTheWrongWayStandLettersOnTheirHeads) {
  const Volume wrong = misbuilt(right_, false, false, true);
  EXPECT_EQ(rowsReversed(right_), wrong);
  EXPECT_EQ(readFrom(wrong, kFront, false), upsideDown(kF));
  EXPECT_EQ(readFromAbove(wrong, -0.85), kTop);
}

}  // namespace
}  // namespace ocelli
