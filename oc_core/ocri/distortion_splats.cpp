#include "oc_core/ocri/distortion_splats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

glm::vec2 centreOf(int x, int y) {
  return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
}

constexpr float kUnlimited = 1e9f;

/// Lowers each value to what its neighbours and the growth per pixel between them allow for: a chamfer sweep, forwards
/// and backwards over the image, as for a distance transform. The first and the last column are a margin.
void spreadLeast(Image<float>& least, float growth) {
  const float diagonal = growth * std::numbers::sqrt2_v<float>;
  const int last = least.width() - 2;
  const auto takeFrom = [&](int y, int other) {
    for (int x = 1; x <= last; ++x) {
      const float side = std::min(least(x - 1, other), least(x + 1, other)) + diagonal;
      least(x, y) = std::min(least(x, y), std::min(side, least(x, other) + growth));
    }
  };
  for (int y = 0; y < least.height(); ++y) {
    if (y > 0) {
      takeFrom(y, y - 1);
    }
    for (int x = 1; x <= last; ++x) {
      least(x, y) = std::min(least(x, y), least(x - 1, y) + growth);
    }
  }
  for (int y = least.height(); y-- > 0;) {
    if (y + 1 < least.height()) {
      takeFrom(y, y + 1);
    }
    for (int x = last; x >= 1; --x) {
      least(x, y) = std::min(least(x, y), least(x + 1, y) + growth);
    }
  }
}

}  // namespace

SplatOwners claimPixels(const std::vector<DistortionSplat>& splats, int width, int height) {
  SplatOwners owners(width, height, -1);
  Image<float> nearest(width, height, 1e30f);
  // Bands of rows, so that each pixel is written by one thread and sees the splats in order.
  constexpr size_t kBands = 64;
  // Where splats come in row order, a band looks at those alone that may reach it.
  const auto above = [](const DistortionSplat& a, const DistortionSplat& b) {
    return std::floor(a.edge.position.y) < std::floor(b.edge.position.y);
  };
  const bool inOrder = std::is_sorted(splats.begin(), splats.end(), above);
  float farthest = 0;
  for (const DistortionSplat& splat : splats) {
    farthest = std::max(farthest, splat.reach());
  }
  const auto firstFrom = [&](float row) {
    DistortionSplat at;
    at.edge.position.y = row;
    return static_cast<size_t>(std::lower_bound(splats.begin(), splats.end(), at, above) - splats.begin());
  };
  parallelChunks(static_cast<size_t>(height), kBands, [&](size_t, size_t firstRow, size_t lastRow) {
    const size_t begin = inOrder ? firstFrom(static_cast<float>(firstRow) - farthest - 2) : 0;
    const size_t end = inOrder ? firstFrom(static_cast<float>(lastRow) + farthest + 2) : splats.size();
    for (size_t i = begin; i < end; ++i) {
      const DistortionSplat& splat = splats[i];
      const glm::vec2 centre = splat.edge.position;
      const float reach = splat.reach();
      const int y0 = std::max(static_cast<int>(std::ceil(centre.y - reach - 0.5f)), static_cast<int>(firstRow));
      const int y1 = std::min(static_cast<int>(std::floor(centre.y + reach - 0.5f)), static_cast<int>(lastRow) - 1);
      for (int y = y0; y <= y1; ++y) {
        const float dy = static_cast<float>(y) + 0.5f - centre.y;
        const float chord = std::sqrt(std::max(reach * reach - dy * dy, 0.0f));
        const int x0 = std::max(static_cast<int>(std::ceil(centre.x - chord - 0.5f)), 0);
        const int x1 = std::min(static_cast<int>(std::floor(centre.x + chord - 0.5f)), width - 1);
        if (x0 > x1) {
          continue;
        }
        // Without branches, so that it is done for several pixels at once.
        float* const near = &nearest(x0, y);
        int* const owner = &owners(x0, y);
        for (int k = 0; k <= x1 - x0; ++k) {
          const float dx = static_cast<float>(x0 + k) + 0.5f - centre.x;
          const float squared = dx * dx + dy * dy;
          const float side = dx * splat.edge.normal.x + dy * splat.edge.normal.y;
          const bool claims = (squared < near[k]) & (side >= -splat.hidden) & (side <= splat.room);
          near[k] = claims ? squared : near[k];
          owner[k] = claims ? static_cast<int>(i) : owner[k];
        }
      }
    }
  });
  return owners;
}

size_t shrinkConflicts(std::vector<DistortionSplat>& splats, const SplatOwners& owners, Conflicts conflicts,
                       float maxHiddenPerRoom) {
  std::vector<float> room(splats.size());
  for (size_t i = 0; i < splats.size(); ++i) {
    room[i] = splats[i].room;
  }
  const auto settle = [&](int first, int second) {
    if (first < 0 || second < 0 || first == second) {
      return;
    }
    const auto a = static_cast<size_t>(first);
    const auto b = static_cast<size_t>(second);
    const DepthEdge& ea = splats[a].edge;
    const DepthEdge& eb = splats[b].edge;
    const glm::vec2 between = eb.position - ea.position;
    const bool facing = glm::dot(between, ea.normal) > 0;
    if (glm::dot(ea.normal, eb.normal) >= 0 || (conflicts == Conflicts::kFacing && !facing)) {
      return;
    }
    const float distance = glm::length(between);
    if (splats[a].room + splats[b].room > distance) {
      room[a] = std::min(room[a], std::max(distance / 2, distance - splats[b].room));
      room[b] = std::min(room[b], std::max(distance / 2, distance - splats[a].room));
    }
  };
  for (int y = 0; y < owners.height(); ++y) {
    for (int x = 0; x < owners.width(); ++x) {
      if (x + 1 < owners.width()) {
        settle(owners(x, y), owners(x + 1, y));
      }
      if (y + 1 < owners.height()) {
        settle(owners(x, y), owners(x, y + 1));
      }
    }
  }
  size_t shrunk = 0;
  for (size_t i = 0; i < splats.size(); ++i) {
    shrunk += room[i] < splats[i].room;
    splats[i].room = room[i];
    splats[i].hidden = std::min(splats[i].hidden, maxHiddenPerRoom * room[i]);
  }
  return shrunk;
}

void limitBandGrowth(std::vector<DistortionSplat>& splats, float steepestGrowth) {
  if (splats.empty() || steepestGrowth <= 0) {
    return;
  }
  int width = 0;
  int height = 0;
  for (const DistortionSplat& splat : splats) {
    width = std::max(width, static_cast<int>(splat.edge.position.x) + 1);
    height = std::max(height, static_cast<int>(splat.edge.position.y) + 1);
  }
  // Hidden and visible bands have nothing to do with each other.
  constexpr std::array<float DistortionSplat::*, 2> kBands{&DistortionSplat::hidden, &DistortionSplat::room};
  parallelFor(kBands.size(), 1, [&](size_t begin, size_t end) {
    for (size_t band = begin; band < end; ++band) {
      // The least band of each pixel. A column on each side of them stays unlimited.
      Image<float> least(width + 2, height, kUnlimited);
      const auto cell = [&](const DistortionSplat& splat) -> float& {
        return least(static_cast<int>(splat.edge.position.x) + 1, static_cast<int>(splat.edge.position.y));
      };
      for (const DistortionSplat& splat : splats) {
        cell(splat) = std::min(cell(splat), splat.*kBands[band]);
      }
      spreadLeast(least, steepestGrowth);
      for (DistortionSplat& splat : splats) {
        splat.*kBands[band] = std::min(splat.*kBands[band], cell(splat));
      }
    }
  });
}

DistortionMap finalizeMap(const std::vector<DistortionSplat>& splats, const SplatOwners& owners,
                          DistortionMap::Lookup lookup) {
  DistortionMap map(owners.width(), owners.height(), lookup);
  parallelFor(static_cast<size_t>(owners.height()), 16, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < owners.width(); ++x) {
        if (owners(x, y) < 0) {
          continue;
        }
        const DistortionSplat& splat = splats[static_cast<size_t>(owners(x, y))];
        const glm::vec2 offset = centreOf(x, y) - splat.edge.position;
        const float side = glm::dot(offset, splat.edge.normal);
        DistortionSample& sample = map.samples()(x, y);
        if (glm::length(offset) <= splat.reach() && side >= -splat.hidden && side <= splat.room) {
          sample = {splat.edge.normal * splat.displacementAt(side), splat.edge.inverseNear, splat.edge.inverseFar};
        }
      }
    }
  });
  return map;
}

DistortionMap smoothMap(const DistortionMap& map, float sigmaPixels) {
  const int width = map.samples().width();
  const int height = map.samples().height();
  const int reach = static_cast<int>(std::ceil(2.5f * sigmaPixels));
  std::vector<float> kernel;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(std::exp(-0.5f * static_cast<float>(i * i) / (sigmaPixels * sigmaPixels)));
  }
  const auto weight = [&](int offset) { return kernel[static_cast<size_t>(offset + reach)]; };
  /// The weight of all pixels around the one at `i` of a row or column of `count`.
  const auto wholeWeight = [&](int i, int count) {
    float sum = 0;
    for (int k = std::max(-reach, -i); k <= std::min(reach, count - 1 - i); ++k) {
      sum += weight(k);
    }
    return sum;
  };
  /// Over the pixels with a depth interval; the others have no displacement.
  struct Sums {
    glm::vec2 displacement{0};
    float inverseNear = 0;
    float inverseFar = 0;
    float weight = 0;

    void add(const Sums& more, float times) {
      displacement += more.displacement * times;
      inverseNear += more.inverseNear * times;
      inverseFar += more.inverseFar * times;
      weight += more.weight * times;
    }
  };

  std::vector<float> columnWeights;  // of the pixels of a row
  for (int x = 0; x < width; ++x) {
    columnWeights.push_back(wholeWeight(x, width));
  }
  DistortionMap smooth(width, height, DistortionMap::Lookup::kBilinear);
  constexpr int kBandRows = 32;
  const auto bands = static_cast<size_t>((height + kBandRows - 1) / kBandRows);
  parallelChunks(static_cast<size_t>(height), bands, [&](size_t, size_t begin, size_t end) {
    const int firstRow = std::max(static_cast<int>(begin) - reach, 0);
    const int lastRow = std::min(static_cast<int>(end) + reach, height);
    // Along the rows first, then along the columns; both only where there is something to average: in [first, last).
    struct Extent {
      int first;
      int last = 0;
    };
    Image<Sums> rows(width, lastRow - firstRow);
    std::vector<Extent> extents(static_cast<size_t>(lastRow - firstRow), Extent{width});
    for (int y = firstRow; y < lastRow; ++y) {
      Extent& extent = extents[static_cast<size_t>(y - firstRow)];
      for (int x = 0; x < width; ++x) {
        const DistortionSample& s = map.samples()(x, y);
        if (s.inverseNear > s.inverseFar) {
          for (int i = std::max(-reach, -x); i <= std::min(reach, width - 1 - x); ++i) {
            rows(x + i, y - firstRow).add({s.displacement, s.inverseNear, s.inverseFar, 1}, weight(i));
          }
          extent.first = std::min(extent.first, std::max(x - reach, 0));
          extent.last = std::min(x + reach + 1, width);
        }
      }
    }
    std::vector<Sums> sums(static_cast<size_t>(width));
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      const float rowWeight = wholeWeight(y, height);
      Extent any{width};
      std::fill(sums.begin(), sums.end(), Sums{});
      for (int i = std::max(-reach, -y); i <= std::min(reach, height - 1 - y); ++i) {
        const Extent& extent = extents[static_cast<size_t>(y + i - firstRow)];
        for (int x = extent.first; x < extent.last; ++x) {
          const Sums& row = rows(x, y + i - firstRow);
          if (row.weight > 0) {
            sums[static_cast<size_t>(x)].add(row, weight(i));
          }
        }
        any = {std::min(any.first, extent.first), std::max(any.last, extent.last)};
      }
      for (int x = any.first; x < any.last; ++x) {
        const Sums& sum = sums[static_cast<size_t>(x)];
        if (sum.weight > 1e-6f) {
          smooth.samples()(x, y) = {sum.displacement / (rowWeight * columnWeights[static_cast<size_t>(x)]),
                                    sum.inverseNear / sum.weight, sum.inverseFar / sum.weight};
        }
      }
    }
  });
  return smooth;
}

}  // namespace ocelli
