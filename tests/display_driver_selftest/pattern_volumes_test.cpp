// What each pattern lights, asked of the centre of every voxel: an independent, slow description of the same things.
#include "display_driver/selftest/pattern_volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/conventions.h"
#include "tests/display_driver_selftest/pattern_profiles.h"

namespace ocelli {
namespace {

/// A voxel by where it is.
struct Seen {
  glm::dvec3 point;
  double radius;
  int sector;  ///< by its angle, in [0, 2N)
  int row;
  Rgb8 levels;

  bool isLit() const { return levels != Rgb8(0); }
};

template <class Visit>
void forEachVoxel(const Volume& volume, const Visit& visit) {
  const SweepGeometry geometry(volume.profile());
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (int row = 0; row < volume.height(); ++row) {
      for (int column = 0; column < volume.width(); ++column) {
        const glm::dvec3 p = geometry.voxelCenter(slice, column, row);
        const long turns = std::lround(std::atan2(p.z, p.x) / geometry.stepRadians());
        const int sector = static_cast<int>((turns + geometry.sectors()) % geometry.sectors());
        visit(Seen{p, std::hypot(p.x, p.z), sector, row, volume.levels(slice, column, row)});
      }
    }
  }
}

/// As many voxels as are lit although `expected` says no, or the other way round.
template <class Expected>
size_t countWrong(const Volume& volume, const Expected& expected) {
  size_t wrong = 0;
  forEachVoxel(volume, [&](const Seen& seen) { wrong += seen.isLit() != expected(seen); });
  return wrong;
}

const DisplayProfile kProfile = test::patternProfile(36, 90, 70);
constexpr int kSectors = 72;
constexpr double kColumn = 2.0 / 90;
constexpr double kRow = 2.0 / 70;

TEST(PatternVolumes, DarkAndWhiteAreThat) {
  EXPECT_EQ(darkPattern(kProfile).litVoxels(), 0u);
  EXPECT_EQ(whitePattern(kProfile).litVoxels(), 36u * 90 * 70);
}

TEST(PatternVolumes, AxisIsThinAndItsRingsAreWhereTheyShouldBe) {
  EXPECT_EQ(countWrong(axisPattern(kProfile),
                       [](const Seen& v) {
                         const auto near = [&](double radius) { return std::abs(v.radius - radius) <= kColumn / 2; };
                         const bool front = v.sector < kSectors / 2;
                         const bool inLine = v.radius < kColumn && (3 * v.row < 70 || front == (3 * v.row < 140));
                         // The row below the equator. The column at the rim ends there.
                         const bool onRing =
                             v.row == 35 && (near(0.25) || near(0.5) || near(0.75) || near(1 - kColumn / 2));
                         const bool onSmallRing = near(0.125) && std::abs(std::abs(v.point.y) - 0.75) <= kRow / 2;
                         return inLine || onRing || onSmallRing;
                       }),
            0u);
}

TEST(PatternVolumes, PhaseLightsOneSliceAndItsScale) {
  EXPECT_EQ(countWrong(phasePattern(kProfile),
                       [](const Seen& v) {
                         const int right = std::min(v.sector, kSectors - v.sector);
                         const int left = std::abs(v.sector - kSectors / 2);
                         const int from = std::min(right, left);
                         // The last 70 / 32 rows.
                         const bool tick =
                             v.row >= 68 && from <= 10 && from % 2 == 0 && v.radius >= (from == 10 ? 0.8 : 0.9) - 1e-9;
                         return right == 0 || (left == 0 && v.point.y < 0) || tick;
                       }),
            0u);
}

TEST(PatternVolumes, PhaseTellsTheHalfTurnsApartWhereTheyDiffer) {
  DisplayProfile own = kProfile;
  own.secondHalfTurn = SecondHalfTurn::kOwn;
  const Volume volume = phasePattern(own);
  EXPECT_EQ(volume.levels(0, 80, 10), Rgb8(1, 0, 0));
  EXPECT_EQ(volume.levels(36, 9, 10), Rgb8(0, 1, 1));
}

TEST(PatternVolumes, WedgesTakeTurnsAllAround) {
  EXPECT_EQ(wedgeWidths(kProfile), (std::vector<int>{1, 3, 9, 36}));
  EXPECT_EQ(wedgeWidths(loadProfile("perspecta")), (std::vector<int>{1, 3, 9, 33, 99}));
  EXPECT_EQ(wedgeWidths(test::patternProfile(97, 8, 8)), (std::vector<int>{1, 97}));
  // Of each radius on the equator, which sectors are lit.
  std::map<long, std::set<int>> lit;
  forEachVoxel(wedgesPattern(kProfile), [&](const Seen& v) {
    if (v.isLit() && v.row == 35 && v.radius < 0.93) {
      lit[std::lround(v.radius / kColumn - 0.5)].insert(v.sector);
    }
  });
  std::vector<int> widths;  // from the innermost radius outwards
  for (const auto& [column, sectors] : lit) {
    ASSERT_EQ(sectors.size(), kSectors / 2u) << column;
    int width = 0;
    while (sectors.contains(width)) {
      ++width;
    }
    for (int sector = 0; sector < kSectors; ++sector) {
      EXPECT_EQ(sectors.contains(sector), sector / width % 2 == 0) << column << " " << sector;
    }
    if (widths.empty() || widths.back() != width) {
      widths.push_back(width);
    }
  }
  EXPECT_EQ(widths, (std::vector<int>{36, 9, 3, 1}));
}

TEST(PatternVolumes, WedgesMarkTheFirstSliceAndTheDirection) {
  std::map<int, std::set<int>> rows;  // of each sector, at the rim
  forEachVoxel(wedgesPattern(kProfile), [&](const Seen& v) {
    if (v.isLit() && v.radius > 0.95) {
      rows[v.sector].insert(v.row);
    }
  });
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows.at(0).size(), 70u);
  EXPECT_EQ(rows.at(9).size(), 35u);
  EXPECT_EQ(*rows.at(9).begin(), 35);
}

TEST(PatternVolumes, StairsHaveOneStepASlice) {
  for (const DisplayProfile& profile : {kProfile, test::patternProfile(12, 20, 100)}) {
    const int sectors = 2 * profile.slicesPerHalfTurn;
    std::map<int, std::set<int>> rows;
    std::map<int, size_t> voxels;
    forEachVoxel(stairsPattern(profile), [&](const Seen& v) {
      if (v.isLit()) {
        rows[v.sector].insert(profile.height - 1 - v.row);
        ++voxels[v.sector];
        EXPECT_GE(v.radius, 0.6 - 2.0 / profile.width);
        EXPECT_LE(v.radius, 0.95 + 2.0 / profile.width);
      }
    });
    ASSERT_EQ(rows.size(), static_cast<size_t>(sectors));
    for (int sector = 0; sector < sectors; ++sector) {
      EXPECT_EQ(voxels[sector], voxels[0]);
      const auto size = static_cast<int>(rows[sector].size());
      EXPECT_EQ(*rows[sector].rbegin() - *rows[sector].begin() + 1, size);
      // The whole stair is as high as the display, less that one step.
      EXPECT_NEAR(*rows[sector].begin(), (profile.height - size) * sector / (sectors - 1.0), 1.0);
      if (sector > 0) {
        EXPECT_GE(*rows[sector].begin(), *rows[sector - 1].begin());
        EXPECT_LE(*rows[sector].begin(), *rows[sector - 1].rbegin() + 1) << "a gap";
      }
    }
    EXPECT_EQ(*rows[0].begin(), 0);
    EXPECT_EQ(*rows[sectors - 1].rbegin(), profile.height - 1);
  }
}

TEST(PatternVolumes, BoxIsSquareAndClosed) {
  DisplayProfile low = kProfile;
  low.halfHeightRadii = 0.5;
  for (const DisplayProfile& profile : {kProfile, low}) {
    const BoxSides sides = boxSides(profile);
    const double row = 2 * profile.halfHeightRadii / profile.height;
    EXPECT_EQ(sides.up, profile.halfHeightRadii == 1 ? 0.6 : 0.45);
    std::map<int, std::set<int>> sectorsOfRow;
    forEachVoxel(boxPattern(profile), [&](const Seen& v) {
      if (!v.isLit()) {
        return;
      }
      EXPECT_LE(std::abs(v.point.y), sides.up + row / 2);
      // Within a voxel: half its width, and how far its arc reaches across it.
      const double tolerance = kColumn / 2 + v.radius * kPi / 72;
      EXPECT_NEAR(std::max(std::abs(v.point.x), std::abs(v.point.z)), sides.across, tolerance);
      sectorsOfRow[v.row].insert(v.sector);
    });
    // Edges go around without a gap; between them stand four edges and four middle lines.
    size_t closed = 0;
    for (const auto& [at, sectors] : sectorsOfRow) {
      closed += sectors.size() == kSectors;
      EXPECT_TRUE(sectors.size() == kSectors || sectors == (std::set<int>{0, 9, 18, 27, 36, 45, 54, 63})) << at;
    }
    EXPECT_EQ(closed, 3u);
  }
}

TEST(PatternVolumes, SphereIsRound) {
  const double radius = sphereRadius(kProfile);
  EXPECT_EQ(radius, 0.9);
  std::map<int, std::set<int>> rows;
  std::map<int, std::set<int>> sectors;
  forEachVoxel(spherePattern(kProfile), [&](const Seen& v) {
    if (v.isLit()) {
      EXPECT_NEAR(glm::length(v.point), radius, std::hypot(kColumn, kRow));
      rows[v.sector].insert(v.row);
      sectors[v.row].insert(v.sector);
    }
  });
  // Twelve meridians from pole to pole, five parallels all around.
  const size_t high = rows[0].size();
  EXPECT_NEAR(static_cast<double>(high), 2 * radius / kRow, 2);
  EXPECT_EQ(std::ranges::count_if(rows, [&](const auto& each) { return each.second.size() == high; }), 12);
  EXPECT_EQ(std::ranges::count_if(sectors, [](const auto& each) { return each.second.size() == kSectors; }), 5);
}

TEST(PatternVolumes, FocusHasLinesOfOneAndTwoVoxels) {
  const DisplayProfile profile = test::patternProfile(36, 120, 120);
  const Volume volume = focusPattern(profile);
  // Lengths of the lit runs along a row and a column of slice 0, in the outermost, topmost target.
  const auto runs = [&](auto isLit, int from, int to) {
    std::set<int> lengths;
    for (int at = from, length = 0; at <= to; ++at) {
      length = at < to && isLit(at) ? length + 1 : 0;
      if (length > 0 && !(at + 1 < to && isLit(at + 1))) {
        lengths.insert(length);
      }
    }
    return lengths;
  };
  // Targets are 14 of 20 columns wide and 28 of 40 rows high: this one has columns 103 to 116 and rows 6 to 33.
  const auto alongRow = [&](int row) {
    return runs([&](int column) { return volume.colorBits(0, column, row) != 0; }, 103, 110);
  };
  const auto alongColumn = [&](int column, int from, int to) {
    return runs([&](int row) { return volume.colorBits(0, column, row) != 0; }, from, to);
  };
  EXPECT_EQ(alongRow(10), std::set<int>{1});
  EXPECT_EQ(alongRow(30), std::set<int>{2});
  EXPECT_EQ(alongColumn(113, 6, 20), std::set<int>{1});
  EXPECT_EQ(alongColumn(113, 20, 34), std::set<int>{2});
  // The same on the slice a quarter turn on, nothing but fans on others.
  EXPECT_TRUE(std::ranges::equal(volume.slice(0), volume.slice(18)));
  std::set<int> rows;
  std::set<int> sectors;
  forEachVoxel(volume, [&](const Seen& v) {
    if (v.isLit() && v.sector % 18 != 0) {
      rows.insert(v.row);
      sectors.insert(v.sector);
    }
  });
  EXPECT_EQ(rows, (std::set<int>{3, 116}));
  EXPECT_EQ(sectors.size(), 36u - 4u);
  EXPECT_TRUE(std::ranges::all_of(sectors, [](int sector) { return sector % 2 == 0; }));
}

TEST(PatternVolumes, ColoursStandInTheirOrderAndStepDown) {
  DisplayProfile profile = kProfile;
  profile.height = 140;
  profile.colorBitsPerChannel = 3;
  EXPECT_EQ(colourSteps(profile), (std::vector<int>{7, 6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(colourSteps(kProfile), std::vector<int>{1});
  profile.colorBitsPerChannel = 8;
  EXPECT_EQ(colourSteps(profile), (std::vector<int>{255, 223, 191, 159, 128, 96, 64, 32}));
  profile.colorBitsPerChannel = 3;
  std::vector<Rgb8> last(7, Rgb8(8));
  std::array<std::set<int>, 7> levels;
  const std::array<glm::bvec3, 7> channels{glm::bvec3(true, false, false),
                                           {false, true, false},
                                           {false, false, true},
                                           {false, true, true},
                                           {true, false, true},
                                           {true, true, false},
                                           {true, true, true}};
  const Volume volume = coloursPattern(profile);
  // Slice 9 stands at 45 degrees, where nothing is notched.
  for (int row = 0; row < profile.height; ++row) {
    const size_t band = static_cast<size_t>(row / 20);
    const Rgb8 light = volume.levels(9, 45 + 31, row);
    const int most = std::max({light.r, light.g, light.b});
    if (most == 0) {
      EXPECT_GE(row % 20, 18) << row;
      continue;
    }
    EXPECT_EQ(light, Rgb8(channels[band].r ? most : 0, channels[band].g ? most : 0, channels[band].b ? most : 0));
    EXPECT_TRUE(levels[band].empty() || most <= *levels[band].begin()) << "not downwards";
    levels[band].insert(most);
  }
  for (const std::set<int>& each : levels) {
    EXPECT_EQ(each, (std::set<int>{1, 2, 3, 4, 5, 6, 7}));
  }
}

TEST(PatternVolumes, ColoursAreNotchedForThoseWhoCannotTellThemApart) {
  const DisplayProfile profile = test::patternProfile(180, 128, 70);
  const Volume volume = coloursPattern(profile);
  for (const std::pair<const int, int>& band :
       std::map<int, int>{{2, 1}, {12, 2}, {22, 3}, {32, 0}, {42, 0}, {52, 0}, {62, 0}}) {
    // Dark stretches on the way around, past the front.
    int seen = 0;
    for (int slice = 60; slice < 120; ++slice) {
      const auto isDark = [&](int i) { return volume.colorBits(i, 64 + 44, band.first) == 0; };
      seen += isDark(slice) && !isDark(slice - 1);
    }
    EXPECT_EQ(seen, band.second) << band.first;
  }
}

TEST(PatternVolumes, BrightnessGivesLowerRingsTheSameLightForTheirLength) {
  std::map<int, std::map<long, size_t>> lit;  // by row and radius
  forEachVoxel(brightnessPattern(kProfile), [&](const Seen& v) {
    if (v.isLit()) {
      ++lit[v.row][std::lround(v.radius / kColumn - 0.5)];
    }
  });
  const std::vector<BrightnessRing> rings = brightnessRings(kProfile);
  ASSERT_EQ(rings.size(), 10u);
  EXPECT_EQ(lit.size(), 20u);
  const double outermost = rings.back().ring + 0.5;
  for (const BrightnessRing& ring : rings) {
    EXPECT_EQ(lit[ring.upperRow], (std::map<long, size_t>{{ring.ring, kSectors}}));
    EXPECT_EQ(lit[ring.lowerRow].size(), 1u);
    // Half a voxel of rounding, and the borders of the count.
    EXPECT_NEAR(static_cast<double>(lit[ring.lowerRow][ring.ring]), kSectors * (ring.ring + 0.5) / outermost, 1.0);
    EXPECT_EQ(ring.upperRow + ring.lowerRow, kProfile.height - 1);
  }
}

}  // namespace
}  // namespace ocelli
