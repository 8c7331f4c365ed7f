#include "oc_core/depth_rays/graph_depth_image.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "oc_core/base/finite.h"

namespace ocelli {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// Slopes of rays to planes that rounding makes of 0: a ray within a side of a frustum is in it.
constexpr double kParallel = 1e-12;
/// How much steeper than next to there a surface may be between two pixels.
constexpr double kSteeper = 1.5;

struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< unit

  glm::dvec3 at(double distance) const { return origin + direction * distance; }
};

/// A part of a ray, by distances from its origin.
struct PieceSegment {
  double begin = 0;
  double end = 0;
  size_t piece = 0;
};

/// What of a segment is within a piece; it ends before it begins where nothing is.
PieceSegment clipped(PieceSegment segment, const Ray& ray, const FrustumPiece& piece) {
  for (const Plane& side : piece.sides) {
    const double height = side.height(ray.origin);
    const double rise = glm::dot(side.normal, ray.direction);
    if (std::abs(rise) <= kParallel) {
      segment.end = height > kParallel * (1 + glm::length(ray.origin)) ? -kInfinite : segment.end;
    } else if (rise > 0) {
      segment.end = std::min(segment.end, -height / rise);
    } else {
      segment.begin = std::max(segment.begin, -height / rise);
    }
  }
  return segment;
}

}  // namespace

/// Along the image of a segment of a ray, in one piece of a frustum.
class GraphDepthImage::Walk {
 public:
  Walk(const GraphDepthImage& image, const Ray& ray, const PieceSegment& segment, const Options& options, size_t& steps)
      : samples_(image.samples_),
        ray_(ray),
        segment_(segment),
        options_(options),
        steps_(steps),
        index_(image.pieces_[segment.piece].frustum),
        frustum_(image.camera_.frusta()[static_cast<size_t>(index_)]) {
    const glm::dvec4 first = frustum_.pixelFromWorld * glm::dvec4(ray.at(segment.begin), 1);
    const glm::dvec4 last = frustum_.pixelFromWorld * glm::dvec4(ray.at(segment.end), 1);
    from_ = glm::dvec2(first) / first.w;
    to_ = glm::dvec2(last) / last.w;
    fromWeight_ = first.w;
    toWeight_ = last.w;
    const glm::dvec2 way = glm::abs(to_ - from_);
    count_ = static_cast<int>(std::ceil(std::clamp(std::max(way.x, way.y), 1.0, 1e6)));
  }

  std::optional<Hit> run() {
    Step last = stepAt(0);
    for (int k = 0; k < count_;) {
      k = options_.coarse ? std::max(k + 1, endOfTile(k, last)) : k + 1;
      const Step step = stepAt(k);
      if (const std::optional<double> share = meeting(last, step)) {
        return Hit{distanceAt(*share), placeAt(*share), index_};
      }
      last = step;
    }
    return std::nullopt;
  }

 private:
  struct Step {
    double share = 0;    ///< of the way in the image
    double inverse = 0;  ///< 1/w of the ray
    glm::dvec2 place{0};
    glm::ivec2 pixel{0};
    GraphDepthSamples::Sample sample{};
    /// How much greater 1/w of the surface is: positive where the ray is behind it. Infinite where the surface is of a
    /// frustum before or behind, or there is none; no number where the pixel does not tell.
    double gap = kUnknown;
  };

  double shareOf(int k) const { return static_cast<double>(k) / count_; }
  glm::dvec2 placeAt(double share) const { return from_ + (to_ - from_) * share; }
  double inverseAt(double share) const { return (1 - share) / fromWeight_ + share / toWeight_; }
  /// As 1/w is linear in the image, and w along the ray.
  double distanceAt(double share) const {
    const double along = share * fromWeight_ / ((1 - share) * toWeight_ + share * fromWeight_);
    return segment_.begin + (segment_.end - segment_.begin) * along;
  }

  double gapOf(const GraphDepthSamples::Sample& sample, double inverse) const {
    if (sample.frustum == index_) {
      return sample.inverseWeight - inverse;
    }
    if (sample.frustum < 0 || samples_.comesBefore(index_, sample.frustum)) {
      return -kInfinite;
    }
    return samples_.comesBefore(sample.frustum, index_) ? kInfinite : kUnknown;
  }

  Step stepAt(int k) {
    ++steps_;
    Step step{shareOf(k), inverseAt(shareOf(k)), placeAt(shareOf(k))};
    step.pixel = samples_.pixelOf(step.place);
    step.sample = samples_.extended(step.pixel, step.place);
    step.gap = gapOf(step.sample, step.inverse);
    return step;
  }

  /// The first step beyond the tile of step k, where the ray stays before or behind all that the tile shows; else k.
  int endOfTile(int k, const Step& step) const {
    const GraphDepthSamples::Tile& tile = samples_.tileOf(step.pixel);
    if (!tile.uniform) {
      return k;
    }
    // The share of the way at which it leaves the tile.
    double end = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double speed = to_[axis] - from_[axis];
      const int corner = GraphDepthSamples::tileCorner(step.pixel)[axis];
      const double border = speed > 0 ? corner + GraphDepthSamples::kTile : corner;
      end = speed != 0 ? std::min(end, (border - from_[axis]) / speed) : end;
    }
    const int next = std::clamp(static_cast<int>(std::floor(end * count_)) + 1, k, count_);
    const auto [least, most] = std::minmax({step.inverse, inverseAt(shareOf(next))});
    const bool same = tile.frustum == index_;
    const bool before = tile.frustum < 0 || (same ? least > tile.nearest : samples_.comesBefore(index_, tile.frustum));
    const bool behind = same ? most < tile.farthest : tile.frustum >= 0 && samples_.comesBefore(tile.frustum, index_);
    return before || behind ? next : k;
  }

  /// Where between two steps the ray meets a surface.
  std::optional<double> meeting(const Step& a, const Step& b) const {
    if (std::isfinite(a.gap) != std::isfinite(b.gap)) {
      // A surface that passes from frustum to frustum as the ray does ends up to a pixel before it.
      const Step& known = std::isfinite(a.gap) ? a : b;
      const Step& other = std::isfinite(a.gap) ? b : a;
      const double gap = samples_.extended(known.pixel, other.place).inverseWeight - other.inverse;
      if (known.gap * gap <= 0 && known.gap != gap) {
        return known.share + (other.share - known.share) * (known.gap / (known.gap - gap));
      }
    }
    if (!(a.gap * b.gap <= 0) || a.gap == b.gap) {
      return std::nullopt;
    }
    if (std::isfinite(a.gap) && std::isfinite(b.gap) && joined(a, b)) {
      return a.share + (b.share - a.share) * (a.gap / (a.gap - b.gap));
    }
    const Step& behind = a.gap > 0 ? a : b;
    const bool within =
        std::isfinite(behind.gap) && way(behind, behind.sample.inverseWeight, behind.inverse) <= options_.thickness;
    return within ? std::optional(behind.share) : std::nullopt;
  }

  /// The distance between two weights on the ray of a step's pixel.
  double way(const Step& step, double inverseA, double inverseB) const {
    const double perWeight = glm::distance(ray_.at(distanceAt(step.share)), frustum_.viewpoint) * step.inverse;
    return perWeight * std::abs(1 / inverseA - 1 / inverseB);
  }

  /// Whether the pixels of two steps, which touch, show one surface.
  bool joined(const Step& a, const Step& b) const {
    const auto inverse = [&](const glm::ivec2& pixel) { return samples_[pixel].inverseWeight; };
    if (way(a, inverse(a.pixel), inverse(b.pixel)) <= options_.thickness) {
      return true;
    }
    const auto rise = [&](const glm::ivec2& p, const glm::ivec2& q) {
      return samples_.shows(p, index_) && samples_.shows(q, index_) ? std::abs(inverse(p) - inverse(q)) : 0;
    };
    const glm::ivec2 next = b.pixel - a.pixel;
    const double beside = std::max(rise(a.pixel - next, a.pixel), rise(b.pixel, b.pixel + next));
    return rise(a.pixel, b.pixel) <= kSteeper * beside;
  }

  const GraphDepthSamples& samples_;
  const Ray& ray_;
  const PieceSegment& segment_;
  const Options& options_;
  size_t& steps_;
  int index_;
  const GraphCamera::Frustum& frustum_;
  glm::dvec2 from_{0};
  glm::dvec2 to_{0};
  double fromWeight_ = 1;
  double toWeight_ = 1;
  int count_ = 1;
};

GraphDepthImage::GraphDepthImage(const GraphCamera& camera, const FragmentImage& fragments)
    : camera_(camera), pieces_(piecesOf(camera)), samples_(camera, fragments) {}

std::optional<GraphDepthImage::Hit> GraphDepthImage::intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                                                               const Options& options, size_t* steps) const {
  const double length = glm::length(direction);
  if (!isFinite(origin) || !(length > 0) || !std::isfinite(length)) {
    return std::nullopt;
  }
  const Ray ray{origin, direction / length};
  std::vector<PieceSegment> segments;
  for (size_t i = 0; i < pieces_.size(); ++i) {
    const PieceSegment whole{0, static_cast<double>(camera_.root().view().zFar), i};
    const PieceSegment segment = clipped(whole, ray, pieces_[i]);
    if (segment.begin < segment.end) {
      segments.push_back(segment);
    }
  }
  std::sort(segments.begin(), segments.end(),
            [](const PieceSegment& a, const PieceSegment& b) { return a.begin < b.begin; });
  size_t count = 0;
  std::optional<Hit> hit;
  for (size_t i = 0; i < segments.size() && !hit; ++i) {
    hit = Walk(*this, ray, segments[i], options, count).run();
  }
  if (steps != nullptr) {
    *steps += count;
  }
  return hit;
}

}  // namespace ocelli
