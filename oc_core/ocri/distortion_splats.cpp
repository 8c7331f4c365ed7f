#include "oc_core/ocri/distortion_splats.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

glm::vec2 centreOf(int x, int y) {
  return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
}

}  // namespace

SplatOwners claimPixels(const std::vector<DistortionSplat>& splats, int width, int height) {
  SplatOwners owners(width, height, -1);
  Image<float> nearest(width, height, 1e30f);
  // Bands of rows, so that each pixel is written by one thread and sees the splats in order.
  constexpr size_t kBands = 64;
  parallelChunks(static_cast<size_t>(height), kBands, [&](size_t, size_t firstRow, size_t lastRow) {
    for (size_t i = 0; i < splats.size(); ++i) {
      const glm::vec2 centre = splats[i].edge.position;
      const float reach = splats[i].reach();
      const int y0 = std::max(static_cast<int>(std::ceil(centre.y - reach - 0.5f)), static_cast<int>(firstRow));
      const int y1 = std::min(static_cast<int>(std::floor(centre.y + reach - 0.5f)), static_cast<int>(lastRow) - 1);
      const int x0 = std::max(static_cast<int>(std::ceil(centre.x - reach - 0.5f)), 0);
      const int x1 = std::min(static_cast<int>(std::floor(centre.x + reach - 0.5f)), width - 1);
      for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
          const glm::vec2 offset = centreOf(x, y) - centre;
          const float squared = glm::dot(offset, offset);
          if (squared >= nearest(x, y) || squared > reach * reach) {
            continue;
          }
          const float side = glm::dot(offset, splats[i].edge.normal);
          if (side >= -splats[i].hidden && side <= splats[i].room) {
            nearest(x, y) = squared;
            owners(x, y) = static_cast<int>(i);
          }
        }
      }
    }
  });
  return owners;
}

size_t shrinkConflicts(std::vector<DistortionSplat>& splats, const SplatOwners& owners, Conflicts conflicts,
                       float mostHiddenPerRoom) {
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
    splats[i].hidden = std::min(splats[i].hidden, mostHiddenPerRoom * room[i]);
  }
  return shrunk;
}

void limitBandGrowth(std::vector<DistortionSplat>& splats, float steepestGrowth) {
  if (splats.empty() || steepestGrowth <= 0) {
    return;
  }
  // A chamfer sweep on a grid of the splats' pixels: forwards and backwards over the image, as for a distance
  // transform.
  int width = 0;
  int height = 0;
  for (const DistortionSplat& splat : splats) {
    width = std::max(width, static_cast<int>(splat.edge.position.x) + 1);
    height = std::max(height, static_cast<int>(splat.edge.position.y) + 1);
  }
  Image<glm::vec2> least(width, height, glm::vec2(1e9f));
  const auto cell = [&](const DistortionSplat& splat) -> glm::vec2& {
    return least(static_cast<int>(splat.edge.position.x), static_cast<int>(splat.edge.position.y));
  };
  for (const DistortionSplat& splat : splats) {
    cell(splat) = glm::min(cell(splat), glm::vec2(splat.hidden, splat.room));
  }
  const auto relax = [&](int x, int y, int dx, int dy) {
    if (least.contains(x + dx, y + dy)) {
      const float distance = dx != 0 && dy != 0 ? std::numbers::sqrt2_v<float> : 1.0f;
      least(x, y) = glm::min(least(x, y), least(x + dx, y + dy) + steepestGrowth * distance);
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      relax(x, y, -1, 0);
      relax(x, y, -1, -1);
      relax(x, y, 0, -1);
      relax(x, y, 1, -1);
    }
  }
  for (int y = height; y-- > 0;) {
    for (int x = width; x-- > 0;) {
      relax(x, y, 1, 0);
      relax(x, y, 1, 1);
      relax(x, y, 0, 1);
      relax(x, y, -1, 1);
    }
  }
  for (DistortionSplat& splat : splats) {
    splat.hidden = std::min(splat.hidden, cell(splat).x);
    splat.room = std::min(splat.room, cell(splat).y);
  }
}

DistortionMap finalizeMap(const std::vector<DistortionSplat>& splats, const SplatOwners& owners,
                          DistortionMap::Lookup lookup) {
  DistortionMap map(owners.width(), owners.height(), lookup);
  for (int y = 0; y < owners.height(); ++y) {
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
  return map;
}

DistortionMap smoothMap(const DistortionMap& map, float sigmaPixels) {
  const int width = map.samples().width();
  const int height = map.samples().height();
  const int reach = static_cast<int>(std::ceil(2.5f * sigmaPixels));
  Image<float> kernel(2 * reach + 1, 1);
  for (int i = -reach; i <= reach; ++i) {
    kernel(i + reach, 0) = std::exp(-0.5f * static_cast<float>(i * i) / (sigmaPixels * sigmaPixels));
  }
  struct Sums {
    glm::vec2 displacement{0};
    float weight = 0;  ///< of all pixels
    float inverseNear = 0;
    float inverseFar = 0;
    float depthWeight = 0;  ///< of the pixels with a depth interval
  };
  const auto add = [](Sums& sums, const Sums& more, float weight) {
    sums.displacement += more.displacement * weight;
    sums.weight += more.weight * weight;
    sums.inverseNear += more.inverseNear * weight;
    sums.inverseFar += more.inverseFar * weight;
    sums.depthWeight += more.depthWeight * weight;
  };
  Image<Sums> rows(width, height);
  parallelFor(static_cast<size_t>(height), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        for (int i = std::max(-reach, -x); i <= std::min(reach, width - 1 - x); ++i) {
          const DistortionSample& s = map.samples()(x + i, y);
          const float has = s.inverseNear > s.inverseFar ? 1.0f : 0.0f;
          add(rows(x, y), {s.displacement, 1, s.inverseNear * has, s.inverseFar * has, has}, kernel(i + reach, 0));
        }
      }
    }
  });
  DistortionMap smooth(width, height, DistortionMap::Lookup::kBilinear);
  parallelFor(static_cast<size_t>(height), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        Sums sums;
        for (int i = std::max(-reach, -y); i <= std::min(reach, height - 1 - y); ++i) {
          add(sums, rows(x, y + i), kernel(i + reach, 0));
        }
        if (sums.depthWeight > 1e-6f) {
          smooth.samples()(x, y) = {sums.displacement / sums.weight, sums.inverseNear / sums.depthWeight,
                                    sums.inverseFar / sums.depthWeight};
        }
      }
    }
  });
  return smooth;
}

}  // namespace ocelli
