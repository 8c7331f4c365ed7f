// The files that other programs read: parsed here without the code that wrote them.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <glm/common.hpp>

#include "display_sim/exports/export_nrrd.h"
#include "display_sim/exports/export_png.h"
#include "display_sim/exports/export_vti.h"
#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_slicing/test_files.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::coloredTorus;
using test::smallProfile;
using test::TemporaryFolder;

TEST(ExportPng, holdsEverySliceAsTheConventionSays) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(smallProfile(11, 20, 17));
  exportPngStack(folder / "new folder", volume);
  for (int i = 0; i < 11; ++i) {
    const Image<Rgb8> image =
        readPng(folder.path() / "new folder" / (i < 10 ? "slice_000" + std::to_string(i) + ".png" : "slice_0010.png"));
    ASSERT_EQ(image.width(), 20);
    ASSERT_EQ(image.height(), 17);
    for (int y = 0; y < 17; ++y) {
      for (int x = 0; x < 20; ++x) {
        for (int channel = 0; channel < 3; ++channel) {
          EXPECT_EQ(image(x, y)[channel], (volume.colorBits(i, x, y) >> channel & 1u) != 0 ? 255 : 0);
        }
      }
    }
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "new folder"), {}), 11);
}

TEST(ExportPng, replacesTheSlicesOfAnEarlierRunAndNothingElse) {
  const TemporaryFolder folder;
  const auto count = [&] { return std::distance(std::filesystem::directory_iterator(folder / "slices"), {}); };
  for (const int slices : {9, 4}) {
    exportPngStack(folder / "slices", Volume(smallProfile(slices, 8, 8)));
    EXPECT_EQ(count(), slices);
  }
  folder.write("slices/notes.txt", "mine");
  exportPngStack(folder / "slices", Volume(smallProfile(2, 8, 8)));
  EXPECT_EQ(count(), 3);
  EXPECT_TRUE(std::filesystem::exists(folder / "slices/notes.txt"));
  EXPECT_FALSE(std::filesystem::exists(folder / "slices.partial"));
  folder.write("file", "mine");
  EXPECT_THROW(exportPngStack(folder / "file", Volume(smallProfile(2, 8, 8))), InputError);
  EXPECT_THROW(exportPngStack(folder / "file/slices", Volume(smallProfile(2, 8, 8))), WorkError);
}

TEST(ExportPng, leavesNothingAndTheOldSlicesWhereItIsInterrupted) {
  struct Interrupted {};
  const TemporaryFolder folder;
  const Progress interrupt = [&](std::string_view, double fraction) {
    EXPECT_EQ(std::filesystem::exists(folder / "slices.partial/slice_0000.png"), fraction > 0);
    if (fraction > 0) {
      throw Interrupted{};
    }
  };
  const Volume volume(smallProfile(100, 8, 8));
  std::filesystem::create_directory(folder / "slices.partial");
  folder.write("slices.partial/slice_0007.png.partial", "of a run that was killed");
  EXPECT_THROW(exportPngStack(folder / "slices", volume, interrupt), Interrupted);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  exportPngStack(folder / "slices", Volume(smallProfile(3, 8, 8)));
  EXPECT_THROW(exportPngStack(folder / "slices", volume, interrupt), Interrupted);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "slices"), {}), 3);
  EXPECT_FALSE(std::filesystem::exists(folder / "slices.partial"));
}

TEST(ExportNrrd, holdsTheNativeArray) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(smallProfile(7, 20, 17));
  exportNrrd(folder / "a.nrrd", volume);
  const std::vector<uint8_t> file = bytesOf(folder / "a.nrrd");
  const std::string text(file.begin(), file.end());
  const size_t end = text.find("\n\n");
  ASSERT_NE(end, std::string::npos);
  const std::string head = text.substr(0, end + 1);
  EXPECT_TRUE(head.starts_with("NRRD0005\n"));
  for (const char* line : {"type: uint8", "dimension: 4", "sizes: 3 20 17 7", "encoding: gzip"}) {
    EXPECT_NE(head.find("\n" + std::string(line) + "\n"), std::string::npos) << line;
  }
  EXPECT_NE(head.find("\nocelli_profile:=" + jsonText(volume.profile()) + "\n"), std::string::npos);

  std::vector<uint8_t> data(3 * 20 * 17 * 7 + 1);
  z_stream stream{};
  stream.next_in = const_cast<Bytef*>(file.data() + end + 2);
  stream.avail_in = static_cast<uInt>(file.size() - end - 2);
  stream.next_out = data.data();
  stream.avail_out = static_cast<uInt>(data.size());
  ASSERT_EQ(inflateInit2(&stream, 16 + MAX_WBITS), Z_OK);
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(stream.total_out, data.size() - 1);
  EXPECT_EQ(stream.avail_in, 0u);
  inflateEnd(&stream);
  const uint8_t* byte = data.data();
  for (int i = 0; i < 7; ++i) {
    for (int y = 0; y < 17; ++y) {
      for (int x = 0; x < 20; ++x) {
        for (int channel = 0; channel < 3; ++channel) {
          EXPECT_EQ(*byte++, (volume.colorBits(i, x, y) >> channel & 1u) != 0 ? 255 : 0);
        }
      }
    }
  }
}

TEST(ExportVti, everyLitVoxelLightsTheCubeAtItsCentreAndNoCubeIsFarFromOne) {
  DisplayProfile profile = smallProfile(20, 32, 24);
  profile.colorBitsPerChannel = 2;
  const SweepGeometry sweep(profile);
  const Volume volume = coloredTorus(profile);
  for (const int across : {8, 32, 100}) {
    const CartesianVolume grid = resample(volume, across);
    ASSERT_EQ(grid.cells.size(), static_cast<size_t>(across) * across * across);
    const auto cell = [&](double position) { return static_cast<int>((position + 1) / grid.spacing); };
    std::vector<glm::dvec3> centers;
    for (int i = 0; i < 20; ++i) {
      forEachLevel(volume, i, [&](int column, int row, const Rgb8& levels) {
        const glm::dvec3 p = sweep.voxelCenter(i, column, row);
        centers.push_back(p);
        // A centre may lie between cubes, where rounding decides.
        Rgb8 around(0);
        for (const double dx : {-1e-9, 1e-9}) {
          for (const double dy : {-1e-9, 1e-9}) {
            for (const double dz : {-1e-9, 1e-9}) {
              around = glm::max(around, grid.cells[grid.index(cell(p.x + dx), cell(p.y + dy), cell(p.z + dz))]);
            }
          }
        }
        EXPECT_EQ(glm::max(around, levelBytes(levels, volume.fullLevel())), around);
      });
    }
    // A cube that a cell reaches into: half a diagonal of the cube and one of the longest cell between their centres.
    const double reach = std::sqrt(3.0) / 2 * grid.spacing + std::hypot(1.0 / 32, 1.0 / 24, sweep.stepRadians() / 2);
    for (int z = 0; z < across; z += 3) {
      for (int y = 0; y < across; ++y) {
        for (int x = 0; x < across; ++x) {
          if (grid.cells[grid.index(x, y, z)] != Rgb8(0)) {
            const glm::dvec3 p = (glm::dvec3(x, y, z) + 0.5) * grid.spacing - 1.0;
            EXPECT_TRUE(
                std::ranges::any_of(centers, [&](const glm::dvec3& c) { return glm::distance(c, p) <= reach; }));
          }
        }
      }
    }
  }
}

TEST(Export, levelsBecomeBytesFromDarkToFullLight) {
  for (int full = 1; full <= 255; full = 2 * full + 1) {
    EXPECT_EQ(levelBytes(Rgb8(0, full, full), full), Rgb8(0, 255, 255));
    for (int level = 0; level < full; ++level) {
      // The nearest byte.
      EXPECT_NEAR(levelBytes(Rgb8(static_cast<uint8_t>(level)), full).x, 255.0 * level / full, 0.5);
    }
  }
}

TEST(ExportVti, aCellHasTheHighestLevelsOfItsVoxels) {
  DisplayProfile profile = smallProfile(4, 64, 64);
  profile.colorBitsPerChannel = 3;
  Volume volume(profile);
  // All in the cell from 0.5 to 1 along x, from 0 to 0.5 along y, from -0.5 to 0 or from 0 to 0.5 along z.
  volume.raise(0, 50, 20, Rgb8(3, 1, 0));
  volume.raise(0, 51, 20, Rgb8(1, 2, 0));
  const CartesianVolume grid = resample(volume, 4);
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        const bool reached = x == 3 && y == 2 && (z == 1 || z == 2);
        EXPECT_EQ(grid.cells[grid.index(x, y, z)], reached ? levelBytes(Rgb8(3, 2, 0), 7) : Rgb8(0))
            << x << " " << y << " " << z;
      }
    }
  }
}

TEST(ExportVti, standsAsVtkReadsIt) {
  const TemporaryFolder folder;
  DisplayProfile profile = loadProfile("vortex");
  profile.colorBitsPerChannel = 3;
  const Volume volume = coloredTorus(profile);
  exportVti(folder / "a.vti", volume, {.cellsAcross = 150});
  const std::vector<uint8_t> file = bytesOf(folder / "a.vti");
  const std::string text(file.begin(), file.end());
  EXPECT_NE(text.find("WholeExtent=\"0 150 0 75 0 150\" Origin=\"-1 -0.5 -1\""), std::string::npos);
  EXPECT_TRUE(text.ends_with("\n  </AppendedData>\n</VTKFile>\n"));
  const size_t start = text.find("<AppendedData encoding=\"raw\">\n_");
  ASSERT_NE(start, std::string::npos);
  const uint8_t* at = file.data() + start + std::strlen("<AppendedData encoding=\"raw\">\n_");
  const auto next64 = [&] {
    uint64_t value = 0;
    std::memcpy(&value, at, 8);
    at += 8;
    return value;
  };
  const uint64_t blocks = next64();
  const uint64_t blockBytes = next64();
  const uint64_t lastBytes = next64();
  ASSERT_EQ(blocks, 2u);
  EXPECT_EQ(blockBytes + lastBytes, 3u * 150 * 75 * 150);
  const uint64_t sizes[] = {next64(), next64()};
  std::vector<uint8_t> colors;
  for (const uint64_t size : sizes) {
    std::vector<uint8_t> block(blockBytes);
    uLongf length = block.size();
    ASSERT_EQ(uncompress(block.data(), &length, at, size), Z_OK);
    colors.insert(colors.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(length));
    at += size;
  }
  const CartesianVolume grid = resample(volume, 150);
  ASSERT_EQ(colors.size(), 3 * grid.cells.size());
  for (size_t i = 0; i < colors.size(); ++i) {
    ASSERT_EQ(colors[i], grid.cells[i / 3][static_cast<int>(i % 3)]) << i;
  }
}

TEST(ExportVti, sameBytesWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(loadProfile("test"));
  setThreadCount(1);
  exportVti(folder / "one.vti", volume, {.cellsAcross = 90});
  setThreadCount(8);
  exportVti(folder / "eight.vti", volume, {.cellsAcross = 90});
  setThreadCount(0);
  EXPECT_EQ(bytesOf(folder / "one.vti"), bytesOf(folder / "eight.vti"));
}

TEST(ExportVti, aSizeOutOfRangeIsAnInputError) {
  const TemporaryFolder folder;
  const Volume volume(loadProfile("test"));
  EXPECT_THROW(exportVti(folder / "a.vti", volume, {.cellsAcross = 1}), InputError);
  EXPECT_THROW(exportVti(folder / "a.vti", volume, {.cellsAcross = 1025}), InputError);
}

}  // namespace
}  // namespace ocelli
