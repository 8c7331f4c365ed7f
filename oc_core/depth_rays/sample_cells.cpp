#include "oc_core/depth_rays/sample_cells.h"

#include <algorithm>
#include <numeric>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

constexpr size_t kGrain = 1 << 14;

/// The number of the cell of each triangle of a part, whose layers follow each other.
std::vector<uint32_t> cellsOf(const MeshedImages& part, uint32_t firstPixel) {
  std::vector<uint32_t> cells(part.mesh.triangles.size());
  parallelFor(cells.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      cells[i] = firstPixel + part.sampleOfVertex[part.mesh.triangles[i].x];
    }
  });
  return cells;
}

}  // namespace

SampleCells::Place SampleCells::placeOf(uint32_t triangle) const {
  OC_CHECK(triangle < mesh.triangles.size(), "the image has no such triangle");
  const auto after = std::upper_bound(firstTriangle.begin(), firstTriangle.end(), triangle);
  const auto cell = static_cast<uint32_t>(after - firstTriangle.begin() - 1);
  const auto grid =
      std::prev(std::upper_bound(grids.begin(), grids.end(), cell,
                                 [](uint32_t value, const SampleGrid& each) { return value < each.firstPixel; }));
  const auto pixel = static_cast<int>(cell - grid->firstPixel);
  return {grid->image, pixel % grid->width, pixel / grid->width};
}

SampleCells sampleCells(const ReferenceImages& images) {
  SampleCells cells;
  std::vector<uint32_t> cellOfTriangle;
  uint32_t pixels = 0;
  for (MeshedImages& part : meshEach(images)) {
    const std::vector<uint32_t> more = cellsOf(part, pixels);
    cellOfTriangle.insert(cellOfTriangle.end(), more.begin(), more.end());
    for (size_t i = part.first; i < part.end; ++i) {
      cells.grids.push_back({i, images[i].width(), images[i].height(), pixels});
      pixels += static_cast<uint32_t>(images[i].t.size());
    }
    if (part.first == 0) {
      cells.mesh = std::move(part.mesh);
    } else {
      append(cells.mesh, part.mesh);
    }
  }
  // Sorted by cell; within one, in their order.
  cells.firstTriangle.assign(static_cast<size_t>(pixels) + 1, 0);
  for (const uint32_t cell : cellOfTriangle) {
    ++cells.firstTriangle[cell + 1];
  }
  std::partial_sum(cells.firstTriangle.begin(), cells.firstTriangle.end(), cells.firstTriangle.begin());
  std::vector<uint32_t> next(cells.firstTriangle.begin(), cells.firstTriangle.end() - 1);
  std::vector<glm::uvec3> sorted(cellOfTriangle.size());
  for (size_t i = 0; i < sorted.size(); ++i) {
    sorted[next[cellOfTriangle[i]]++] = cells.mesh.triangles[i];
  }
  cells.mesh.triangles = std::move(sorted);
  return cells;
}

SampleCells triangleCells(const Mesh& mesh) {
  // As wide as the groups that a pyramid makes of neighbours, so that each holds triangles that follow each other.
  constexpr int kColumns = 4;
  const size_t count = mesh.triangles.size();
  const auto rows = static_cast<int>((count + kColumns - 1) / kColumns);
  SampleCells cells{mesh, {}, std::vector<uint32_t>(static_cast<size_t>(rows) * kColumns + 1)};
  for (size_t i = 0; i < cells.firstTriangle.size(); ++i) {
    cells.firstTriangle[i] = static_cast<uint32_t>(std::min(i, count));
  }
  if (rows > 0) {
    cells.grids.push_back({0, kColumns, rows, 0});
  }
  return cells;
}

}  // namespace ocelli
