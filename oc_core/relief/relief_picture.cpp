#include "oc_core/relief/relief_picture.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <glm/common.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/relief/relief_clock.h"
#include "oc_core/relief/relief_light.h"

namespace ocelli {
namespace {

/// What a pixel shows, before its light is known.
struct PixelMeeting {
  std::optional<ReliefScene::Meeting> tile = {};
  Fragment geometry = {};
  float z = 0;  ///< 0: nothing
};

/// The rays of a picture: their steps are 1 long along the view direction, so that shares are depths.
struct EyeRays {
  explicit EyeRays(const PinholeCamera& camera)
      : perColumn(camera.right() / camera.focalPixels()), perRow(camera.down() / camera.focalPixels()) {
    first = camera.forward() + perColumn * (0.5f - camera.centerPixels().x) + perRow * (0.5f - camera.centerPixels().y);
  }
  glm::vec3 at(int x, int y) const {
    return first + perColumn * static_cast<float>(x) + perRow * static_cast<float>(y);
  }

  glm::vec3 first{0};
  glm::vec3 perColumn;
  glm::vec3 perRow;
};

/// A tile as a picture sees it.
struct SeenTile {
  size_t tile = 0;
  float nearest = 0;  ///< z of its box
  glm::ivec2 from{0};
  glm::ivec2 to{0};  ///< one behind the last pixel
};

/// The pixels of a box; nothing where they are none.
std::optional<SeenTile> seenTile(const ReliefScene& scene, size_t tile, const PinholeCamera& camera) {
  const Box& box = scene.boxOf(tile);
  if (box.empty()) {
    return std::nullopt;
  }
  SeenTile seen{.tile = tile, .nearest = camera.view().zFar, .to = {camera.width(), camera.height()}};
  glm::vec2 low(1e30f);
  glm::vec2 high(-1e30f);
  float farthest = 0;
  bool whole = false;
  // The corners of the tile's own box lie closer around it than those of the box in the world.
  const Box own = scene.objectOf(tile).bounds();
  for (const glm::vec3& corner : cornersOf(own)) {
    const glm::vec3 p = camera.cameraFromWorld(glm::vec3(scene.tiles()[tile].worldFromTile * glm::vec4(corner, 1)));
    seen.nearest = std::min(seen.nearest, p.z);
    farthest = std::max(farthest, p.z);
    if (p.z < camera.view().zNear) {
      whole = true;
      continue;
    }
    const ImagePoint q = camera.imageFromCamera(p);
    low = glm::min(low, glm::vec2(q.u, q.v));
    high = glm::max(high, glm::vec2(q.u, q.v));
  }
  if (farthest <= 0) {
    return std::nullopt;
  }
  if (!whole) {
    const glm::vec2 size(camera.width(), camera.height());
    seen.from = glm::ivec2(glm::clamp(glm::floor(low - 1.0f), glm::vec2(0), size));
    seen.to = glm::ivec2(glm::clamp(glm::ceil(high + 1.0f), glm::vec2(0), size));
  }
  if (seen.from.x >= seen.to.x || seen.from.y >= seen.to.y) {
    return std::nullopt;
  }
  return seen;
}

std::vector<SeenTile> seenTiles(const ReliefScene& scene, const PinholeCamera& camera) {
  std::vector<SeenTile> seen;
  for (size_t tile = 0; tile < scene.tiles().size(); ++tile) {
    if (const auto each = seenTile(scene, tile, camera)) {
      seen.push_back(*each);
    }
  }
  std::sort(seen.begin(), seen.end(), [](const SeenTile& a, const SeenTile& b) {
    return std::pair(a.nearest, a.tile) < std::pair(b.nearest, b.tile);
  });
  return seen;
}

/// A strip of the picture, in which tiles are drawn one after the other.
class Strip {
 public:
  Strip(const ReliefScene& scene, const PinholeCamera& camera, const EyeRays& rays, Image<PixelMeeting>& pixels)
      : scene_(scene), camera_(camera), rays_(rays), pixels_(pixels) {}

  void draw(const SeenTile& tile, int top, int bottom) {
    const glm::mat4& m = scene_.tileFromWorld(tile.tile);
    const glm::mat3 turn(m);
    RayBlock block;
    block.origin = glm::vec3(m * glm::vec4(camera_.eye(), 1));
    block.perColumn = turn * rays_.perColumn;
    block.perRow = turn * rays_.perRow;
    const int firstRow = std::max(tile.from.y, top);
    const int lastRow = std::min(tile.to.y, bottom);
    for (int y = firstRow; y < lastRow; y += RayBlock::kMaxSide) {
      block.rows = std::min(RayBlock::kMaxSide, lastRow - y);
      for (int x = tile.from.x; x < tile.to.x; x += RayBlock::kMaxSide) {
        block.columns = std::min(RayBlock::kMaxSide, tile.to.x - x);
        block.first = turn * rays_.at(x, y);
        meet(tile, block, x, y);
      }
    }
  }

  RayCost cost;
  size_t raysMet = 0;

 private:
  void meet(const SeenTile& tile, RayBlock& block, int x, int y) {
    bool hidden = true;
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        const PixelMeeting& pixel = pixels_(x + column, y + row);
        const auto i = static_cast<size_t>(block.indexOf(column, row));
        block.reach[i] = pixel.z > 0 ? pixel.z : camera_.view().zFar;
        block.meets[i] = false;
        hidden = hidden && block.reach[i] < tile.nearest;
      }
    }
    if (hidden) {
      return;
    }
    scene_.objectOf(tile.tile).meetBlock(block, cost);
    raysMet += static_cast<size_t>(block.rays());
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        const auto i = static_cast<size_t>(block.indexOf(column, row));
        if (block.meets[i]) {
          PixelMeeting& pixel = pixels_(x + column, y + row);
          pixel.tile = ReliefScene::Meeting{tile.tile, block.meeting[i]};
          pixel.z = static_cast<float>(block.meeting[i].share);
        }
      }
    }
  }

  const ReliefScene& scene_;
  const PinholeCamera& camera_;
  const EyeRays& rays_;
  Image<PixelMeeting>& pixels_;
};

/// Surfaces and the sun: from what pixels meet to what they look like.
class Lighting {
 public:
  Lighting(const ReliefScene& tiles, const PlainGeometry* around, const PinholeCamera& camera)
      : tiles_(tiles), around_(around), camera_(camera), rays_(camera) {
    Box box = tiles.bounds();
    if (around != nullptr && !around->rays().bounds().empty()) {
      box.add(around->rays().bounds().lower);
      box.add(around->rays().bounds().upper);
    }
    extent_ = box.empty() ? 1.0f : glm::length(box.size()) * 1.01f;
  }

  void light(const PixelMeeting& pixel, int x, int y, bool withShadows, ReliefPicture& picture) const {
    const size_t i = picture.shown.index(x, y);
    if (!(pixel.z > 0)) {
      picture.color[i] = reliefBackground();
      return;
    }
    const glm::vec3 step = rays_.at(x, y);
    const glm::vec3 point = camera_.eye() + step * pixel.z;
    ReliefScene::Surface surface;
    float offset = kOffset * extent_;
    if (pixel.tile) {
      surface = tiles_.surfaceAt(*pixel.tile, step);
      offset = kTexels * tiles_.objectOf(pixel.tile->tile).texelSize() * tiles_.scaleOf(pixel.tile->tile);
      picture.shown[i] = static_cast<int32_t>(pixel.tile->tile);
    } else {
      const Fragment& f = pixel.geometry;
      const ReliefSurface own = around_->labels().surfaceOf(f.triangle, f.b1, f.b2);
      const float length = glm::length(own.normal);
      const glm::vec3 normal = length > 0 ? own.normal / length : glm::vec3(0, 1, 0);
      surface = {own.color, glm::dot(normal, step) > 0 ? -normal : normal};
      picture.shown[i] = ReliefPicture::kGeometry;
      picture.triangle[i] = f.triangle;
    }
    picture.z[i] = pixel.z;
    picture.point[i] = point;
    const bool faces = glm::dot(surface.normal, directionToSun()) > 0;
    const bool shadowed = faces && withShadows && blocked(point + (surface.normal + directionToSun()) * offset);
    picture.inShadow[i] = shadowed ? 1 : 0;
    picture.color[i] = surface.color * sunlitShade(surface.normal, !shadowed);
  }

 private:
  static constexpr float kOffset = 1e-4f;  ///< of rays to the sun, of the size of the scene
  static constexpr float kTexels = 1.5f;   ///< of those that leave tiles

  bool blocked(const glm::vec3& from) const {
    const glm::vec3 step = directionToSun() * extent_;
    RayCost ignored;
    return tiles_.meetsAny({from, step, 1}, ignored) ||
           (around_ != nullptr && around_->rays().intersect({from, from + step}).covered());
  }

  const ReliefScene& tiles_;
  const PlainGeometry* around_;
  const PinholeCamera& camera_;
  EyeRays rays_;
  float extent_ = 1;
};

ReliefPicture blankPicture(const PinholeCamera& camera) {
  const int w = camera.width();
  const int h = camera.height();
  return {.shown = Image<int32_t>(w, h, ReliefPicture::kNothing),
          .triangle = Image<uint32_t>(w, h, Fragment::kNoTriangle),
          .z = Image<float>(w, h, 0.0f),
          .point = Image<glm::vec3>(w, h, glm::vec3(0)),
          .color = Image<glm::vec3>(w, h, glm::vec3(0)),
          .inShadow = Image<uint8_t>(w, h, 0),
          .cost = {}};
}

/// What pixels show without tiles.
Image<PixelMeeting> behindTiles(const PlainGeometry* around, const PinholeCamera& camera) {
  Image<PixelMeeting> pixels(camera.width(), camera.height());
  if (around == nullptr || around->labels().mesh().empty()) {
    return pixels;
  }
  const EyeRays rays(camera);
  const FragmentImage fragments =
      castRays(camera.width(), camera.height(), around->rays(), [&](const glm::vec2& pixel) -> RayPath {
        const glm::vec3 step = rays.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
        return {camera.eye(), camera.eye() + step * camera.view().zFar};
      });
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (fragments[i].covered()) {
      pixels[i].geometry = fragments[i];
      pixels[i].z = std::max(camera.cameraFromWorld(positionOf(fragments[i], around->labels().mesh())).z, 1e-30f);
    }
  }
  return pixels;
}

constexpr int kStripRows = RayBlock::kMaxSide;

}  // namespace

ReliefRenderer::ReliefRenderer(std::shared_ptr<const ReliefScene> tiles, std::shared_ptr<const PlainGeometry> around)
    : tiles_(std::move(tiles)), around_(std::move(around)) {}

ReliefPicture ReliefRenderer::draw(const PinholeCamera& camera, const ReliefDrawing& how) const {
  ReliefPicture picture = blankPicture(camera);
  Image<PixelMeeting> behind;
  for (int run = 0; run < how.runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    behind = behindTiles(around_.get(), camera);
    const double taken = millisecondsSince(start);
    picture.geometryMilliseconds = run == 0 ? taken : std::min(picture.geometryMilliseconds, taken);
  }
  const EyeRays rays(camera);
  Image<PixelMeeting> pixels;
  const auto strips = static_cast<size_t>((camera.height() + kStripRows - 1) / kStripRows);
  for (int run = 0; run < how.runs; ++run) {
    pixels = behind;
    std::vector<RayCost> costs(strips);
    std::vector<size_t> counts(strips);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t begun = std::clock();
    const std::vector<SeenTile> seen = seenTiles(*tiles_, camera);
    parallelFor(strips, 1, [&](size_t begin, size_t end) {
      for (size_t s = begin; s < end; ++s) {
        Strip strip(*tiles_, camera, rays, pixels);
        const int top = static_cast<int>(s) * kStripRows;
        for (const SeenTile& tile : seen) {
          strip.draw(tile, top, std::min(top + kStripRows, camera.height()));
        }
        costs[s] = strip.cost;
        counts[s] = strip.raysMet;
      }
    });
    const double taken = millisecondsSince(start);
    const double used = 1000.0 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    picture.milliseconds = run == 0 ? taken : std::min(picture.milliseconds, taken);
    picture.cpuMilliseconds = run == 0 ? used : std::min(picture.cpuMilliseconds, used);
    picture.cost = {};
    picture.rays = 0;
    for (size_t s = 0; s < strips; ++s) {
      picture.cost += costs[s];
      picture.rays += counts[s];
    }
  }
  const Lighting lighting(*tiles_, around_.get(), camera);
  const auto light = [&](bool withShadows) {
    const auto start = std::chrono::steady_clock::now();
    parallelFor(static_cast<size_t>(camera.height()), 2, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        for (int x = 0; x < camera.width(); ++x) {
          const int y = static_cast<int>(row);
          lighting.light(pixels(x, y), x, y, withShadows, picture);
        }
      }
    });
    return millisecondsSince(start);
  };
  for (int run = 0; run < how.runs; ++run) {
    const double without = light(false);
    if (!how.shadows) {
      break;
    }
    const double taken = std::max(light(true) - without, 0.0);
    picture.shadowMilliseconds = run == 0 ? taken : std::min(picture.shadowMilliseconds, taken);
  }
  return picture;
}

ReliefPicture ReliefRenderer::drawSlowly(const PinholeCamera& camera) const {
  ReliefPicture picture = blankPicture(camera);
  Image<PixelMeeting> pixels = behindTiles(around_.get(), camera);
  const EyeRays rays(camera);
  const Lighting lighting(*tiles_, around_.get(), camera);
  const std::vector<SeenTile> seen = seenTiles(*tiles_, camera);
  parallelFor(pixels.size(), 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const int x = static_cast<int>(i) % camera.width();
      const int y = static_cast<int>(i) / camera.width();
      for (const SeenTile& tile : seen) {
        const float reach = pixels[i].z > 0 ? pixels[i].z : camera.view().zFar;
        const StraightRay ray = tiles_->rayInTile({camera.eye(), rays.at(x, y), reach}, tile.tile);
        if (const auto found = ray.hasDirection() ? tiles_->objectOf(tile.tile).meetSlowly(ray) : std::nullopt) {
          pixels[i].tile = ReliefScene::Meeting{tile.tile, *found};
          pixels[i].z = static_cast<float>(found->share);
        }
      }
      lighting.light(pixels[i], x, y, false, picture);
    }
  });
  return picture;
}

}  // namespace ocelli
