#include "display_sim/exports/export_vti.h"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <string>

#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kCellsPerBlock = size_t{1} << 20;

/// So many points of a side of this length are at most half a cell apart; an odd number, to have one in the middle.
int samplesAlong(double length, double spacing) {
  return static_cast<int>(std::ceil(2 * length / spacing)) | 1;
}

/// Where in the cell's side, from -1/2 to 1/2, the sample stands.
double fraction(int sample, int count) {
  return (sample + 0.5) / count - 0.5;
}

int cellOf(double position, double spacing, int count) {
  return std::clamp(static_cast<int>(position / spacing), 0, count - 1);
}

class Resampler {
 public:
  Resampler(const Volume& volume, CartesianVolume& grid)
      : volume_(volume),
        sweep_(volume.profile()),
        grid_(grid),
        columnSamples_(samplesAlong(sweep_.columnWidth(), grid.spacing)),
        rowSamples_(samplesAlong(sweep_.rowHeight(), grid.spacingY)),
        arcSamples_(samplesAlong(sweep_.stepRadians(), grid.spacing)) {}

  void add(int slice) {
    std::vector<glm::dvec2> directions;
    for (int a = 0; a < arcSamples_; ++a) {
      const double angle = (slice + fraction(a, arcSamples_)) * sweep_.stepRadians();
      directions.emplace_back(std::cos(angle), std::sin(angle));
    }
    forEachLevel(volume_, slice, [&](int column, int row, const Rgb8& levels) {
      const Rgb8 color = levelBytes(levels, volume_.fullLevel());
      for (int c = 0; c < columnSamples_; ++c) {
        const double r = sweep_.columnRadius(column) + fraction(c, columnSamples_) * sweep_.columnWidth();
        for (const glm::dvec2& direction : directions) {
          for (int k = 0; k < rowSamples_; ++k) {
            light(r * direction.x, sweep_.rowCenterY(row) + fraction(k, rowSamples_) * sweep_.rowHeight(),
                  r * direction.y, color);
          }
        }
      }
    });
  }

 private:
  void light(double x, double y, double z, const Rgb8& color) {
    Rgb8& cell = grid_.cells[grid_.index(cellOf(x + 1, grid_.spacing, grid_.sizeX),
                                         cellOf(y + sweep_.halfHeight(), grid_.spacingY, grid_.sizeY),
                                         cellOf(z + 1, grid_.spacing, grid_.sizeZ))];
    for (int channel = 0; channel < kColorChannels; ++channel) {
      raise(cell[channel], color[channel]);
    }
  }

  /// Slices are added by several threads; the highest level does not depend on their order.
  static void raise(uint8_t& value, uint8_t least) {
    const std::atomic_ref shared(value);
    uint8_t seen = shared.load(std::memory_order_relaxed);
    while (seen < least && !shared.compare_exchange_weak(seen, least, std::memory_order_relaxed)) {
    }
  }

  const Volume& volume_;
  SweepGeometry sweep_;
  CartesianVolume& grid_;
  int columnSamples_;
  int rowSamples_;
  int arcSamples_;
};

std::vector<uint8_t> compressedColors(std::span<const Rgb8> cells) {
  static_assert(sizeof(Rgb8) == 3, "cells are compressed as they stand");
  uLongf size = compressBound(cells.size_bytes());
  std::vector<uint8_t> compressed(size);
  OC_CHECK(compress2(compressed.data(), &size, reinterpret_cast<const Bytef*>(cells.data()), cells.size_bytes(),
                     Z_BEST_SPEED) == Z_OK,
           "zlib refused a buffer of the size that it asked for");
  compressed.resize(size);
  return compressed;
}

void append64(std::string& bytes, uint64_t value) {
  for (int i = 0; i < 8; ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }
}

std::string vtiHead(const CartesianVolume& grid, const DisplayProfile& profile) {
  const std::string extent =
      "0 " + std::to_string(grid.sizeX) + " 0 " + std::to_string(grid.sizeY) + " 0 " + std::to_string(grid.sizeZ);
  char placement[200];
  std::snprintf(placement, sizeof placement, "Origin=\"-1 %.17g -1\" Spacing=\"%.17g %.17g %.17g\"",
                -profile.halfHeightRadii, grid.spacing, grid.spacingY, grid.spacing);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <ImageData WholeExtent=\"" +
         extent + "\" " + placement + ">\n    <Piece Extent=\"" + extent +
         "\">\n      <CellData Scalars=\"color\">\n        <DataArray type=\"UInt8\" Name=\"color\" "
         "NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>\n      </CellData>\n    </Piece>\n  "
         "</ImageData>\n"
         "  <AppendedData encoding=\"raw\">\n_";
}

}  // namespace

CartesianVolume resample(const Volume& volume, int cellsAcross) {
  const double halfHeight = volume.profile().halfHeightRadii;
  CartesianVolume grid;
  grid.sizeX = grid.sizeZ = cellsAcross;
  grid.spacing = 2.0 / cellsAcross;
  grid.sizeY = std::max(static_cast<int>(std::lround(cellsAcross * halfHeight)), 1);
  grid.spacingY = 2 * halfHeight / grid.sizeY;
  grid.cells.resize(grid.index(0, 0, grid.sizeZ), Rgb8(0));
  Resampler resampler(volume, grid);
  parallelFor(static_cast<size_t>(volume.slices()), 1, [&](size_t begin, size_t end) {
    for (size_t slice = begin; slice < end; ++slice) {
      resampler.add(static_cast<int>(slice));
    }
  });
  return grid;
}

void checkGridSize(int cellsAcross, const DisplayProfile& profile, const std::filesystem::path& output) {
  constexpr double kMaxCells = 1 << 30;
  const double across = cellsAcross;
  if (across < 2 || across > 1024 || across * across * across * profile.halfHeightRadii > kMaxCells) {
    throw InputError("the grid must have 2 to 1024 cells across, and at most 2^30 in all", output.string(),
                     "change the size of the grid");
  }
}

void exportVti(const std::filesystem::path& path, const Volume& volume, const VtiOptions& options,
               const Progress& progress) {
  checkGridSize(options.cellsAcross, volume.profile(), path);
  OutputFile file(path);
  report(progress, "resampling", 0);
  const CartesianVolume grid = resample(volume, options.cellsAcross);
  std::vector<std::vector<uint8_t>> blocks((grid.cells.size() + kCellsPerBlock - 1) / kCellsPerBlock);
  report(progress, "compressing", 0.5);
  parallelFor(blocks.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t first = i * kCellsPerBlock;
      blocks[i] = compressedColors(
          std::span<const Rgb8>(grid.cells).subspan(first, std::min(kCellsPerBlock, grid.cells.size() - first)));
    }
  });
  // The head of compressed data: number of blocks, bytes of a block, bytes of the last one if it is shorter (else 0),
  // and the compressed bytes of each.
  std::string head;
  append64(head, blocks.size());
  append64(head, 3 * kCellsPerBlock);
  append64(head, 3 * (grid.cells.size() % kCellsPerBlock));
  for (const std::vector<uint8_t>& block : blocks) {
    append64(head, block.size());
  }
  file.write(vtiHead(grid, volume.profile()));
  file.write(head);
  for (const std::vector<uint8_t>& block : blocks) {
    file.write(block);
  }
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
  report(progress, "compressing", 1);
}

}  // namespace ocelli
