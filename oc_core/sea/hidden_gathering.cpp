#include "oc_core/sea/hidden_gathering.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace ocelli {
namespace {

/// Surfaces along a ray that are looked at.
constexpr int kMaxSurfaces = 16;
/// A surface is that of a point where their distances from the eye differ by so little, as a share.
constexpr float kSameSurface = 0.03f;
/// Behind a surface the next one is looked for from so far on, as a share of its distance.
constexpr float kStepBehind = 1e-3f;

/// Levels of samples of a cell that are of one surface differ by so much at most.
constexpr long kLevelsOfCell = 2;
/// A surface has at least so many samples in a cell.
constexpr size_t kMinInCell = 3;

/// A point on the ray of a pixel.
struct Sample {
  size_t pixel = 0;
  float distance = 0;
  glm::vec3 point{0};
};

/// Of a pose, with what is asked of it again and again.
class Eye {
 public:
  Eye(const SeaProxy& proxy, const SeaProjection& projection, const SeaPose& pose)
      : proxy_(proxy),
        projection_(projection),
        position_(pose.position),
        worldFromCamera_(glm::mat3_cast(pose.worldFromCamera)),
        cameraFromWorld_(glm::transpose(worldFromCamera_)) {}

  const SeaProjection& projection() const { return projection_; }
  const glm::vec3& position() const { return position_; }

  /// Of the middle of a pixel, in the world.
  glm::vec3 direction(size_t pixel) const {
    const auto width = static_cast<size_t>(projection_.width);
    return worldFromCamera_ *
           projection_.direction({static_cast<float>(pixel % width) + 0.5f, static_cast<float>(pixel / width) + 0.5f});
  }
  /// Nothing beyond the borders.
  std::optional<glm::vec2> place(const glm::vec3& point) const {
    const glm::vec3 way = cameraFromWorld_ * (point - position_);
    const auto found = glm::dot(way, way) > 0 ? projection_.pixel(way) : std::nullopt;
    const bool isInside = found && found->x >= 0 && found->y >= 0 &&
                          found->x <= static_cast<float>(projection_.width) &&
                          found->y <= static_cast<float>(projection_.height);
    return isInside ? found : std::nullopt;
  }
  /// Whether something stands before each point, as warps judge it.
  std::vector<uint8_t> hiddenOf(std::span<const glm::vec3> points) const {
    std::vector<SightLine> lines;
    lines.reserve(points.size());
    for (const glm::vec3& point : points) {
      lines.push_back({position_, glm::mix(point, position_, kSightMargin)});
    }
    std::vector<uint8_t> isHidden(lines.size());
    proxy_.blocked().find(lines, isHidden);
    return isHidden;
  }

 private:
  const SeaProxy& proxy_;
  const SeaProjection& projection_;
  glm::vec3 position_;
  glm::mat3 worldFromCamera_;
  glm::mat3 cameraFromWorld_;
};

/// Distances of the points that are hidden, by the pixels that they lie in.
class PointsByPixel {
 public:
  PointsByPixel(const Eye& eye, std::span<const glm::vec3> points) : projection_(eye.projection()) {
    const std::vector<uint8_t> isHidden = eye.hiddenOf(points);
    std::vector<std::pair<size_t, float>> found;
    for (size_t i = 0; i < points.size(); ++i) {
      const auto place = isHidden[i] != 0 ? eye.place(points[i]) : std::nullopt;
      if (place) {
        const int x = std::min(static_cast<int>(place->x), projection_.width - 1);
        const int y = std::min(static_cast<int>(place->y), projection_.height - 1);
        found.emplace_back(static_cast<size_t>(y) * static_cast<size_t>(projection_.width) + static_cast<size_t>(x),
                           glm::distance(points[i], eye.position()));
      }
    }
    std::sort(found.begin(), found.end());
    starts_.assign(pixels() + 1, 0);
    for (const auto& [pixel, distance] : found) {
      ++starts_[pixel + 1];
      distances_.push_back(distance);
    }
    for (size_t i = 0; i < pixels(); ++i) {
      starts_[i + 1] += starts_[i];
    }
  }

  size_t pixels() const { return static_cast<size_t>(projection_.width) * static_cast<size_t>(projection_.height); }

  /// Calls `test` with the distances of the points in a pixel and around it, until it is true.
  template <class Test>
  bool anyAround(size_t pixel, const Test& test) const {
    const auto width = static_cast<size_t>(projection_.width);
    for (int down = -1; down <= 1; ++down) {
      for (int right = -1; right <= 1; ++right) {
        int x = static_cast<int>(pixel % width) + right;
        const int y = static_cast<int>(pixel / width) + down;
        x = projection_.wraps() ? (x + projection_.width) % projection_.width : x;
        if (x < 0 || y < 0 || x >= projection_.width || y >= projection_.height) {
          continue;
        }
        const size_t at = static_cast<size_t>(y) * width + static_cast<size_t>(x);
        for (size_t i = starts_[at]; i < starts_[at + 1]; ++i) {
          if (test(distances_[i])) {
            return true;
          }
        }
      }
    }
    return false;
  }

 private:
  const SeaProjection& projection_;
  std::vector<size_t> starts_;  ///< in distances_, one more than pixels
  std::vector<float> distances_;
};

/// Surfaces behind the first one along the rays of all pixels that have points on them, by pixel, the nearest first.
std::vector<Sample> surfacesBehind(const SeaProxy& proxy, const Eye& eye, const PointsByPixel& points) {
  struct Ray {
    size_t pixel;
    glm::vec3 direction;
  };
  std::vector<Ray> rays;
  std::vector<SightLine> lines;
  for (size_t pixel = 0; pixel < points.pixels(); ++pixel) {
    if (points.anyAround(pixel, [](float) { return true; })) {
      rays.push_back({pixel, eye.direction(pixel)});
      lines.push_back({eye.position(), eye.position() + rays.back().direction * proxy.far()});
    }
  }
  std::vector<Sample> samples;
  std::vector<float> shares;
  for (int surface = 0; surface < kMaxSurfaces && !rays.empty(); ++surface) {
    shares.resize(lines.size());
    proxy.rays().meet(lines, shares);
    size_t left = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
      if (std::isinf(shares[i])) {
        continue;
      }
      const glm::vec3 point = glm::mix(lines[i].from, lines[i].to, shares[i]);
      const float distance = glm::distance(point, eye.position());
      const auto isSame = [&](float other) { return std::abs(distance - other) <= kSameSurface * other; };
      if (surface > 0 && points.anyAround(rays[i].pixel, isSame)) {
        samples.push_back({rays[i].pixel, distance, point});
      }
      rays[left] = rays[i];
      lines[left] = {point + rays[i].direction * (kStepBehind * distance), lines[i].to};
      ++left;
    }
    rays.resize(left);
    lines.resize(left);
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.pixel != b.pixel ? a.pixel < b.pixel : a.distance < b.distance;
  });
  return samples;
}

std::vector<glm::vec3> pointsOf(const std::vector<Sample>& samples) {
  std::vector<glm::vec3> points;
  points.reserve(samples.size());
  for (const Sample& sample : samples) {
    points.push_back(sample.point);
  }
  return points;
}

/// Without those that lie so close behind a surface that warps take them as seen.
std::vector<Sample> hiddenOnly(const Eye& eye, const std::vector<Sample>& samples) {
  const std::vector<uint8_t> isHidden = eye.hiddenOf(pointsOf(samples));
  std::vector<Sample> hidden;
  for (size_t i = 0; i < samples.size(); ++i) {
    if (isHidden[i] != 0) {
      hidden.push_back(samples[i]);
    }
  }
  return hidden;
}

/// Where a sample is seen.
struct Sighting {
  size_t views = 0;  ///< that see it
  size_t first = 0;  ///< the nearest of them
  glm::vec2 place{0};
};

std::vector<Sighting> sightingsOf(const SeaProxy& proxy, const SeaProjection& projection,
                                  const std::vector<Sample>& samples, const std::vector<SeaPose>& views) {
  const std::vector<glm::vec3> points = pointsOf(samples);
  std::vector<Sighting> sightings(samples.size());
  for (size_t view = 0; view < views.size(); ++view) {
    const Eye eye(proxy, projection, views[view]);
    const std::vector<uint8_t> isHidden = eye.hiddenOf(points);
    for (size_t i = 0; i < samples.size(); ++i) {
      const auto place = isHidden[i] == 0 ? eye.place(points[i]) : std::nullopt;
      if (place && sightings[i].views++ == 0) {
        sightings[i].first = view;
        sightings[i].place = *place;
      }
    }
  }
  return sightings;
}

/// A layer while it is made.
struct OpenLayer {
  explicit OpenLayer(const SeaProjection& projection)
      : color{Image<Rgb8>(projection.width, projection.height, Rgb8(0)),
              Image<uint8_t>(projection.width, projection.height)},
        level(HiddenSamples::levelSize(projection).x, HiddenSamples::levelSize(projection).y),
        viewOf(projection.width, projection.height, kNoView),
        places(projection.width, projection.height) {}

  bool takesFrom(size_t view) const { return std::find(viewOf.begin(), viewOf.end(), view) != viewOf.end(); }
  void colorFrom(size_t view, const WarpReference& image) {
    WarpMap map(places.width(), places.height(), glm::vec2(std::numeric_limits<float>::quiet_NaN()));
    for (size_t i = 0; i < map.size(); ++i) {
      if (viewOf[i] == view) {
        map[i] = places[i];
      }
    }
    const Image<Rgb8> colors = warpedImage(image, map);
    for (size_t i = 0; i < map.size(); ++i) {
      if (viewOf[i] == view) {
        color.image[i] = colors[i];
        color.isKnown[i] = 1;
      }
    }
  }

  static constexpr size_t kNoView = std::numeric_limits<size_t>::max();

  PartialImage color;
  Image<uint16_t> level;
  Image<size_t> viewOf;  ///< the view that each pixel takes its colour from
  WarpMap places;        ///< and where there
};

/// A sample that is kept, by its cell and level.
struct CellSample {
  size_t cell = 0;
  long level = 0;
  size_t sample = 0;

  bool operator<(const CellSample& other) const {
    return std::tie(cell, level, sample) < std::tie(other.cell, other.level, other.sample);
  }
};

std::vector<CellSample> byCells(const std::vector<size_t>& kept, const std::vector<Sample>& samples,
                                const HiddenSamples& hidden, const SeaProjection& projection) {
  std::vector<CellSample> cells;
  const auto width = static_cast<size_t>(projection.width);
  const auto across = static_cast<size_t>(HiddenSamples::levelSize(projection).x);
  for (const size_t i : kept) {
    const size_t x = samples[i].pixel % width / HiddenSamples::kCell;
    const size_t y = samples[i].pixel / width / HiddenSamples::kCell;
    cells.push_back({y * across + x, std::lround(hidden.levelOf(samples[i].distance)), i});
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// Samples of one cell and surface become a cell of a layer: the first one that is free there.
std::vector<OpenLayer> layersOf(const std::vector<CellSample>& cells, const std::vector<Sample>& samples,
                                const std::vector<Sighting>& sightings, const SeaProjection& projection) {
  std::vector<OpenLayer> layers;
  size_t layer = 0;
  for (size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    layer = begin > 0 && cells[begin - 1].cell == cells[begin].cell ? layer : 0;
    const long lowest = cells[begin].level;
    end = begin + 1;
    while (end < cells.size() && cells[end].cell == cells[begin].cell && cells[end].level <= lowest + kLevelsOfCell) {
      ++end;
    }
    if (layer == HiddenSamples::kMaxLayers || end - begin < kMinInCell) {
      continue;
    }
    if (layer == layers.size()) {
      layers.emplace_back(projection);
    }
    layers[layer].level[cells[begin].cell] = static_cast<uint16_t>((lowest + cells[end - 1].level) / 2);
    for (size_t i = begin; i < end; ++i) {
      const size_t sample = cells[i].sample;
      layers[layer].viewOf[samples[sample].pixel] = sightings[sample].first;
      layers[layer].places[samples[sample].pixel] = sightings[sample].place;
    }
    ++layer;
  }
  return layers;
}

}  // namespace

HiddenSamples gatherHiddenSamples(const SeaProxy& proxy, const SeaCamera& inner, std::span<const glm::vec3> points,
                                  const HiddenViews& views) {
  const SeaProjection& projection = inner.projection;
  const Eye eye(proxy, projection, inner.pose);
  const std::vector<Sample> samples = hiddenOnly(eye, surfacesBehind(proxy, eye, PointsByPixel(eye, points)));
  const std::vector<Sighting> sightings = sightingsOf(proxy, projection, samples, views.poses);
  std::vector<size_t> kept;
  float nearest = std::numeric_limits<float>::infinity();
  for (size_t i = 0; i < samples.size(); ++i) {
    if (sightings[i].views >= std::max<size_t>(1, views.fewest)) {
      kept.push_back(i);
      nearest = std::min(nearest, samples[i].distance);
    }
  }
  HiddenSamples hidden;
  if (kept.empty()) {
    return hidden;
  }
  hidden.nearest = nearest;
  std::vector<OpenLayer> layers = layersOf(byCells(kept, samples, hidden, projection), samples, sightings, projection);
  for (size_t view = 0; view < views.poses.size(); ++view) {
    if (std::none_of(layers.begin(), layers.end(), [&](const OpenLayer& layer) { return layer.takesFrom(view); })) {
      continue;
    }
    const WarpReference image(views.image(view), projection);
    for (OpenLayer& layer : layers) {
      layer.colorFrom(view, image);
    }
  }
  for (OpenLayer& layer : layers) {
    fillUnknown(layer.color);
    hidden.layers.push_back({std::move(layer.color.image), std::move(layer.level)});
  }
  return hidden;
}

}  // namespace ocelli
