// KV6 models: what is exported is what the reader reads back, and hostile files are refused.
#include "display_sim/exports/export_kv6.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::coloredTorus;
using test::fileBytes;
using test::smallProfile;
using test::TemporaryFolder;
using testing::HasSubstr;

CartesianVolume gridOf(int x, int y, int z) {
  CartesianVolume grid;
  grid.sizeX = x;
  grid.sizeY = y;
  grid.sizeZ = z;
  grid.spacing = grid.spacingY = 2.0 / x;
  grid.cells.resize(grid.index(0, 0, z), Rgb8(0));
  return grid;
}

CartesianVolume randomGrid(uint64_t seed) {
  Random random(seed);
  CartesianVolume grid = gridOf(7, 5, 6);
  for (Rgb8& cell : grid.cells) {
    if (random.below(2) == 0) {
      cell = Rgb8(random.below(256), random.below(256), random.below(256));
    }
  }
  return grid;
}

std::string refusal(const std::string& bytes) {
  try {
    kv6FromBytes(bytes, "a.kv6");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void putNumber(std::string& bytes, size_t at, uint32_t value, size_t count = 4) {
  for (size_t i = 0; i < count; ++i) {
    bytes.at(at + i) = static_cast<char>(value >> (8 * i) & 0xff);
  }
}

TEST(Kv6File, oneVoxelByteByByte) {
  CartesianVolume grid = gridOf(2, 3, 4);
  grid.cells[grid.index(1, 0, 2)] = Rgb8(10, 20, 30);
  const std::string bytes = kv6Bytes(kv6Model(grid));
  // x to the right, y towards the viewer (grid z), z down (grid y from above).
  const unsigned char expected[] = {
      'K', 'v', 'x',  'l',  2, 0, 0,  0,    4, 0, 0,    0,    3, 0, 0, 0,  // sizes
      0,   0,   0x80, 0x3f, 0, 0, 0,  0x40, 0, 0, 0xc0, 0x3f, 1, 0, 0, 0,  // pivot 1, 2, 1.5; one voxel
      30,  20,  10,   128,  2, 0, 63, 255,                                 // z 2, all faces, no normal
      0,   0,   0,    0,    1, 0, 0,  0,    0, 0, 0,    0,    0, 0, 0, 0,
      0,   0,   0,    0,    1, 0, 0,  0};  // of x, and of (x, y)
  ASSERT_EQ(bytes.size(), sizeof expected);
  EXPECT_EQ(std::memcmp(bytes.data(), expected, sizeof expected), 0);
}

TEST(Kv6File, everyCellComesBackWithItsColourAndTheFacesThatNothingCovers) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const CartesianVolume grid = randomGrid(seed);
    const Kv6Model model = kv6FromBytes(kv6Bytes(kv6Model(grid)), "a.kv6");
    EXPECT_EQ(model, kv6Model(grid));
    ASSERT_EQ(model.sizeX, grid.sizeX);
    ASSERT_EQ(model.sizeY, grid.sizeZ);
    ASSERT_EQ(model.sizeZ, grid.sizeY);
    CartesianVolume read = gridOf(grid.sizeX, grid.sizeY, grid.sizeZ);
    const auto lit = [&](int x, int y, int z) {
      return x >= 0 && x < grid.sizeX && y >= 0 && y < grid.sizeY && z >= 0 && z < grid.sizeZ &&
             grid.cells[grid.index(x, y, z)] != Rgb8(0);
    };
    size_t at = 0;
    for (int x = 0; x < model.sizeX; ++x) {
      for (int y = 0; y < model.sizeY; ++y) {
        for (int i = 0; i < model.voxelsOfColumn[static_cast<size_t>(x * model.sizeY + y)]; ++i, ++at) {
          const Kv6Voxel& voxel = model.voxels[at];
          const int height = model.sizeZ - 1 - voxel.z;
          read.cells[read.index(x, height, y)] = voxel.color;
          const int free = (lit(x - 1, height, y) ? 0 : 1) + (lit(x + 1, height, y) ? 0 : 2) +
                           (lit(x, height, y - 1) ? 0 : 4) + (lit(x, height, y + 1) ? 0 : 8) +
                           (lit(x, height + 1, y) ? 0 : 16) + (lit(x, height - 1, y) ? 0 : 32);
          EXPECT_EQ(voxel.faces, free);
          EXPECT_TRUE(free != 0 || voxel.normal == kKv6NoNormal);
        }
      }
    }
    EXPECT_EQ(read.cells, grid.cells);
  }
}

TEST(Kv6File, normalsOfTheTableAreThoseOfASpiralAndFindThemselves) {
  EXPECT_EQ(kv6Normal(kKv6NoNormal), glm::dvec3(0));
  EXPECT_EQ(kv6NormalIndex(glm::dvec3(0)), kKv6NoNormal);
  EXPECT_NEAR(kv6Normal(0).z, -254.0 / 255, 1e-12);
  EXPECT_NEAR(kv6Normal(254).z, 254.0 / 255, 1e-12);
  EXPECT_NEAR(kv6Normal(127).z, 0, 1e-12);
  EXPECT_NEAR(kv6Normal(0).y, 0, 1e-12);
  EXPECT_GT(kv6Normal(0).x, 0);
  for (int i = 0; i < 255; ++i) {
    const auto index = static_cast<uint8_t>(i);
    EXPECT_NEAR(glm::length(kv6Normal(index)), 1, 1e-12);
    EXPECT_EQ(kv6NormalIndex(0.1 * kv6Normal(index)), index);
  }
}

TEST(Kv6File, normalsOfABallPointToItsMiddle) {
  constexpr int kSide = 31;
  CartesianVolume grid = gridOf(kSide, kSide, kSide);
  const glm::dvec3 middle((kSide - 1) / 2.0);
  for (int z = 0; z < kSide; ++z) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        if (glm::distance(glm::dvec3(x, y, z), middle) < 13) {
          grid.cells[grid.index(x, y, z)] = Rgb8(255);
        }
      }
    }
  }
  const Kv6Model model = kv6Model(grid);
  size_t at = 0;
  size_t checked = 0;
  double sum = 0;
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int i = 0; i < model.voxelsOfColumn[static_cast<size_t>(x * kSide + y)]; ++i, ++at) {
        const Kv6Voxel& voxel = model.voxels[at];
        if (voxel.faces != 0) {
          const glm::dvec3 inwards = glm::normalize(middle - glm::dvec3(x, y, voxel.z));
          const double degrees = std::acos(glm::dot(kv6Normal(voxel.normal), inwards)) * 180 / kPi;
          // The nearest of 255 directions is up to 9 degrees away; the rest is from the steps of a surface of which
          // two cells each way are seen. The worst of this ball is 20.2 degrees.
          EXPECT_LT(degrees, 21);
          sum += degrees;
          ++checked;
        }
      }
    }
  }
  ASSERT_GT(checked, 1000u);
  EXPECT_LT(sum / static_cast<double>(checked), 9);
}

TEST(ExportKv6, holdsTheGridThatParaViewGetsAtAnyNumberOfThreads) {
  const TemporaryFolder folder;
  DisplayProfile profile = smallProfile(40, 64, 48);
  profile.colorBitsPerChannel = 2;
  profile.halfHeightRadii = 0.75;
  const Volume volume = coloredTorus(profile);
  setThreadCount(1);
  exportKv6(folder / "one.kv6", volume, {.cellsAcross = 50});
  setThreadCount(8);
  exportKv6(folder / "eight.kv6", volume, {.cellsAcross = 50});
  setThreadCount(0);
  EXPECT_EQ(fileBytes(folder / "one.kv6"), fileBytes(folder / "eight.kv6"));
  const Kv6Model model = kv6FromBytes(fileBytes(folder / "one.kv6"), "one.kv6");
  const CartesianVolume grid = resample(volume, 50);
  EXPECT_EQ(model.sizeZ, 38);
  EXPECT_EQ(model.voxels.size(),
            static_cast<size_t>(std::ranges::count_if(grid.cells, [](const Rgb8& cell) { return cell != Rgb8(0); })));
  EXPECT_GT(model.voxels.size(), 1000u);
  EXPECT_EQ(model, kv6Model(grid));
}

TEST(ExportKv6, aDarkVolumeIsAModelWithoutVoxels) {
  const TemporaryFolder folder;
  exportKv6(folder / "dark.kv6", Volume(loadProfile("test")), {.cellsAcross = 8});
  EXPECT_TRUE(kv6FromBytes(fileBytes(folder / "dark.kv6"), "dark.kv6").voxels.empty());
  EXPECT_THROW(exportKv6(folder / "a.kv6", Volume(loadProfile("test")), {.cellsAcross = 1}), InputError);
  EXPECT_THROW(exportKv6(folder / "a.kv6", Volume(loadProfile("test")), {.cellsAcross = 1025}), InputError);
}

TEST(Kv6Hostile, damageIsRefusedAndNamed) {
  const CartesianVolume grid = randomGrid(3);
  const std::string good = kv6Bytes(kv6Model(grid));
  const size_t voxels = kv6Model(grid).voxels.size();
  const auto damaged = [&](size_t at, uint32_t value, size_t count = 4) {
    std::string bytes = good;
    putNumber(bytes, at, value, count);
    return refusal(bytes);
  };
  EXPECT_EQ(refusal(good), "");
  EXPECT_EQ(refusal(good + "SPal" + std::string(768, 'x')), "");
  for (size_t size = 0; size < good.size(); ++size) {
    EXPECT_THAT(refusal(good.substr(0, size)), HasSubstr("a.kv6")) << size;
  }
  EXPECT_THAT(refusal(good + "x"), HasSubstr("bytes follow"));
  EXPECT_THAT(refusal(good + "SPal" + std::string(767, 'x')), HasSubstr("palette"));
  EXPECT_THAT(damaged(0, 0), HasSubstr("Kvxl"));
  for (const size_t size : {4, 8, 12}) {
    EXPECT_THAT(damaged(size, 0), HasSubstr("size"));
    EXPECT_THAT(damaged(size, 0xffffffff), HasSubstr("size"));
    EXPECT_NE(damaged(size, 65535), size == 12 ? "x" : "");
  }
  EXPECT_THAT(damaged(16, 0x7fc00000), HasSubstr("pivot"));
  EXPECT_THAT(damaged(28, 0xffffffff), HasSubstr("ends before"));
  EXPECT_NE(damaged(28, static_cast<uint32_t>(voxels) + 1), "");
  EXPECT_THAT(damaged(32 + 4, 5, 2), HasSubstr("has z 5"));                    // outside of the grid
  EXPECT_THAT(damaged(32 + 8 * voxels, 9999), HasSubstr("at x 0"));            // the count of an x
  EXPECT_THAT(damaged(32 + 8 * voxels + 28, 0xffff, 2), HasSubstr("at x 0"));  // of a column
}

TEST(Kv6Hostile, noFlipOfAnyBitGivesAModelThatContradictsItself) {
  const std::string good = kv6Bytes(kv6Model(randomGrid(4)));
  size_t accepted = 0;
  for (size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string bytes = good;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    try {
      const Kv6Model model = kv6FromBytes(bytes, "a.kv6");
      EXPECT_EQ(kv6FromBytes(kv6Bytes(model), "a.kv6"), model);
      ++accepted;
    } catch (const InputError&) {
      // Any other exception fails the test.
    }
  }
  EXPECT_GT(accepted, 0u) << "colours and normals may be anything";
}

}  // namespace
}  // namespace ocelli
