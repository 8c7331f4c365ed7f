#include "oc_core/depth_rays/rim_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/grid_cell.h"
#include "oc_core/ocri/sample_join.h"

namespace ocelli {
namespace {

constexpr uint32_t kNone = 0xffffffffu;
constexpr int kHalvings = 5;  ///< a rim is found to 1/32 of a pixel

/// Pixels that have to do with each other: the part of the reference pinhole, or a tile.
struct Block {
  glm::ivec2 first{0};
  glm::ivec2 end{0};
  bool isTile = false;

  bool holds(const glm::ivec2& p) const { return p.x >= first.x && p.y >= first.y && p.x < end.x && p.y < end.y; }
};

std::vector<Block> blocksOf(const ReferenceImage& image) {
  const int rows = image.tileSide > 0 ? image.pinholeSize.y : image.height();
  const int columns = image.tileSide > 0 ? image.pinholeSize.x : image.width();
  std::vector<Block> blocks{{{0, 0}, {columns, rows}}};
  for (int y = rows; image.tileSide > 0 && y < image.height(); y += image.tileSide) {
    for (int x = 0; x < image.width(); x += image.tileSide) {
      const glm::ivec2 end(std::min(x + image.tileSide, image.width()), std::min(y + image.tileSide, image.height()));
      blocks.push_back({{x, y}, end, true});
    }
  }
  return blocks;
}

/// The neighbours of a pixel, in the order of Rims.
constexpr std::array<glm::ivec2, 4> kWays{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

class RimMesher {
 public:
  RimMesher(const ReferenceImage& image, const std::function<RayPath(const glm::vec2&)>& ray, const RayTarget& geometry)
      : image_(image),
        ray_(ray),
        geometry_(geometry),
        camera_(image.reference()),
        vertexOf_(image.width(), image.height(), kNone) {}

  RimCells mesh() {
    addSamples();
    const std::vector<Block> blocks = blocksOf(image_);
    for (const Block& block : blocks) {
      planRims(block);
    }
    addRims();
    for (const Block& block : blocks) {
      for (int y = block.first.y - 1; y < block.end.y; ++y) {
        for (int x = block.first.x - 1; x < block.end.x; ++x) {
          closeCellAt({x, y}, block);
        }
      }
    }
    std::vector<uint32_t> cellOfTriangle;
    for (const glm::uvec3& triangle : mesh_.triangles) {
      cellOfTriangle.push_back(pixelOfVertex_[triangle.x]);
    }
    const auto pixels = static_cast<uint32_t>(image_.t.size());
    return {cellsFrom(std::move(mesh_), {{0, image_.width(), image_.height(), 0}}, pixels, cellOfTriangle),
            rims_.size(), std::move(pixelOfVertex_)};
  }

 private:
  /// A point of a surface beside a sample.
  struct Rim {
    glm::ivec2 pixel{0};
    size_t way = 0;
    float reach = 1;  ///< of the search, pixels
    std::optional<Hit> found = {};
  };
  using Corners = std::array<glm::ivec2, 4>;

  bool valid(const glm::ivec2& p) const { return vertexOf_.contains(p.x, p.y) && vertexOf_(p.x, p.y) != kNone; }
  bool valid(const glm::ivec2& p, const Block& block) const { return block.holds(p) && valid(p); }

  void addVertex(const glm::vec3& position, const glm::vec3& color, const glm::ivec2& p) {
    mesh_.positions.push_back(position);
    mesh_.colors.push_back(color);
    pixelOfVertex_.push_back(static_cast<uint32_t>(image_.t.index(p.x, p.y)));
  }

  void addSamples() {
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        if (const auto point = image_.pointOf(x, y, camera_)) {
          vertexOf_(x, y) = static_cast<uint32_t>(mesh_.positions.size());
          addVertex(*point, image_.color(x, y), {x, y});
        }
      }
    }
    rimOf_.assign(4 * image_.t.size(), kNone);
  }

  /// As image_mesh.h joins them.
  bool joined(const glm::ivec2& p, const glm::ivec2& q, const Block& block) const {
    if (!valid(p, block) || !valid(q, block)) {
      return false;
    }
    const float spacing = block.isTile ? image_.tileSpacing : 1;
    const auto sample = [&](const glm::ivec2& at) {
      return valid(at, block) ? image_.undistorted(at.x, at.y) : ImagePoint{};
    };
    return samplesJoin(sample(p + p - q), sample(p), sample(q), sample(q + q - p), false, camera_.focalPixels(),
                       spacing, options_);
  }

  void planRims(const Block& block) {
    for (int y = block.first.y; y < block.end.y; ++y) {
      for (int x = block.first.x; x < block.end.x; ++x) {
        const glm::ivec2 p(x, y);
        for (size_t way = 0; way < kWays.size() && valid(p); ++way) {
          const glm::ivec2 q = p + kWays[way];
          if (!joined(p, q, block)) {
            // Beside a sample of a tile there may be no ray: what is not stored has none.
            constexpr float kOwnPixel = 0.499f;
            rimOf_[4 * image_.t.index(x, y) + way] = static_cast<uint32_t>(rims_.size());
            rims_.push_back({p, way, !block.isTile || valid(q, block) ? 1 : kOwnPixel});
          }
        }
      }
    }
  }

  void addRims() {
    parallelFor(rims_.size(), 64, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        search(rims_[i]);
      }
    });
    firstRim_ = static_cast<uint32_t>(mesh_.positions.size());
    for (const Rim& rim : rims_) {
      // One that no ray finds is the sample itself.
      const uint32_t sample = vertexOf_(rim.pixel.x, rim.pixel.y);
      addVertex(rim.found ? rim.found->position : mesh_.positions[sample],
                rim.found ? rim.found->color : mesh_.colors[sample], rim.pixel);
    }
  }

  /// What the ray of a place in the image meets, also beyond its end: rays of a sample may end at its surface.
  std::optional<Hit> seenAt(const glm::vec2& place) const {
    RayPath path = ray_(place);
    if (path.size() < 2) {
      return std::nullopt;
    }
    const size_t last = path.size() - 1;
    const glm::vec3 way = path[last] - path[last - 1];
    const float length = glm::length(way);
    if (length > 0 && path.size() < RayPath::kMaxPoints) {
      constexpr float kBeyond = 0.1f;  // of the distance from the eye
      const float more = kBeyond * glm::distance(camera_.eye(), path[last]) / length;
      path.add(path[last] + way * more, path.t(last) + (path.t(last) - path.t(last - 1)) * more);
    }
    return geometry_.hit(path);
  }

  void search(Rim& rim) const {
    const glm::ivec2& p = rim.pixel;
    const glm::ivec2 q = p + kWays[rim.way];
    const float other = vertexOf_.contains(q.x, q.y) && valid(q) && rim.reach == 1 ? image_.t(q.x, q.y) : 0;
    float reached = image_.t(p.x, p.y);
    const auto onSurface = [&](float share) -> std::optional<Hit> {
      const glm::vec2 way(kWays[rim.way]);
      const std::optional<Hit> hit =
          seenAt(glm::vec2(static_cast<float>(p.x) + 0.5f, static_cast<float>(p.y) + 0.5f) + way * share);
      if (!hit || !(hit->t > 0)) {
        return std::nullopt;
      }
      const float away = std::abs(1 / hit->t - 1 / reached);
      const bool isNearest = !(other > 0) || away < std::abs(1 / hit->t - 1 / other);
      const float footprint = std::min(hit->t, reached) / camera_.focalPixels();
      return isNearest && depthsJoin(hit->t, reached, footprint, 1, options_) ? hit : std::nullopt;
    };
    float inside = 0;
    float outside = rim.reach;
    if (std::optional<Hit> all = onSurface(outside)) {
      rim.found = all;
      return;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const float middle = (inside + outside) / 2;
      if (std::optional<Hit> hit = onSurface(middle)) {
        inside = middle;
        reached = hit->t;
        rim.found = hit;
      } else {
        outside = middle;
      }
    }
  }

  uint32_t vertexAt(const glm::ivec2& p) const { return vertexOf_(p.x, p.y); }
  /// The rim of `p` towards its neighbour `q`.
  uint32_t rimTowards(const glm::ivec2& p, const glm::ivec2& q) const {
    const auto way = static_cast<size_t>(std::find(kWays.begin(), kWays.end(), q - p) - kWays.begin());
    return firstRim_ + rimOf_[4 * image_.t.index(p.x, p.y) + way];
  }

  void add(uint32_t a, uint32_t b, uint32_t c) {
    const std::vector<glm::vec3>& at = mesh_.positions;
    if (at[a] != at[b] && at[b] != at[c] && at[c] != at[a]) {
      mesh_.triangles.emplace_back(a, b, c);
    }
  }

  void closeCellAt(const glm::ivec2& a, const Block& block) {
    const Corners corners{a, a + glm::ivec2(0, 1), a + glm::ivec2(1, 1), a + glm::ivec2(1, 0)};
    std::array<bool, 4> side{};  // from a corner to the next
    for (size_t i = 0; i < 4; ++i) {
      side[i] = joined(corners[i], corners[(i + 1) % 4], block);
    }
    std::array<bool, 4> cut{};  // the triangle of a corner and its neighbours
    closeCell(
        0, 1, 2, 3, {side[0], side[1], side[2], side[3]},
        [&](int p, int q) { return joined(corners[static_cast<size_t>(p)], corners[static_cast<size_t>(q)], block); },
        [&](int p) {
          const glm::ivec2& at = corners[static_cast<size_t>(p)];
          return 1 / image_.t(at.x, at.y);
        },
        [&](int p, int q, int r) {
          add(vertexAt(corners[static_cast<size_t>(p)]), vertexAt(corners[static_cast<size_t>(q)]),
              vertexAt(corners[static_cast<size_t>(r)]));
          // The corner that the triangle lacks is across from the one that it cuts.
          cut[static_cast<size_t>((6 - p - q - r + 2) % 4)] = true;
        });
    for (size_t i = 0; i < 4; ++i) {
      // Each piece of a surface, from where it begins.
      if (valid(corners[i], block) && !side[(i + 3) % 4]) {
        closePiece(corners, side, cut, i);
      }
    }
  }

  /// Between the samples from corner `first` on that are joined, and the rims at both ends of them.
  void closePiece(const Corners& corners, const std::array<bool, 4>& side, const std::array<bool, 4>& cut,
                  size_t first) {
    size_t last = first;
    while (side[last % 4] && last < first + 3) {
      ++last;
    }
    const auto corner = [&](size_t i) { return vertexAt(corners[i % 4]); };
    const uint32_t before = rimTowards(corners[first], corners[(first + 3) % 4]);
    const uint32_t behind = rimTowards(corners[last % 4], corners[(last + 1) % 4]);
    if (last == first + 3) {
      // A ring with one side open: what is left is a triangle at either end of that side.
      const bool cutsSecond = cut[(first + 1) % 4];
      const uint32_t apex = corner(cutsSecond ? first + 2 : first + 1);
      add(before, corner(first), apex);
      add(apex, corner(last), behind);
      return;
    }
    if (last == first + 2 && cut[(first + 1) % 4]) {
      add(before, corner(first), corner(last));
      add(before, corner(last), behind);
      return;
    }
    // A fan around the rim before.
    for (size_t i = first; i < last; ++i) {
      add(before, corner(i), corner(i + 1));
    }
    add(before, corner(last), behind);
  }

  const ReferenceImage& image_;
  const std::function<RayPath(const glm::vec2&)>& ray_;
  const RayTarget& geometry_;
  ImageMeshOptions options_;
  PinholeCamera camera_;
  Image<uint32_t> vertexOf_;
  std::vector<Rim> rims_;
  std::vector<uint32_t> rimOf_;  ///< of each pixel, one a way
  uint32_t firstRim_ = 0;        ///< vertex
  Mesh mesh_;
  std::vector<uint32_t> pixelOfVertex_;
};

}  // namespace

bool canHaveRims(const ReferenceImages& images) {
  return images.size() == 1 && !images[0].isPlaced() && images[0].rows == ImageRows::kAligned &&
         !images[0].wrapsAround && images[0].layer == 0;
}

RimCells rimCells(const ReferenceImage& image, const std::function<RayPath(const glm::vec2& pixel)>& ray,
                  const RayTarget& geometry) {
  OC_CHECK(canHaveRims({image}), "an image without rims");
  return RimMesher(image, ray, geometry).mesh();
}

}  // namespace ocelli
