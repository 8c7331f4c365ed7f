#include "oc_core/ocri/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera/gpc_map.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr int kMaxTaps = 16;
/// Places are looked up on this grid: the axes of a view are single floats, which moves a ray by 1e-5 pixels.
constexpr double kSubSample = 4096;
constexpr double kRateRounding = 1e-3;  ///< a rate this close to 1 is 1

/// Whether the samples are those of a pinhole, wherever on its image they lie.
bool isOfAPinhole(const ReferenceImages& images) {
  const ReferenceImage& image = images.front();
  const bool isPlain = images.size() == 1 && !image.isPlaced() && image.rows == ImageRows::kAligned &&
                       image.tileSide == 0 && image.pinholeSize.x == 0;
  if (!isPlain || !image.layout.regions.empty()) {
    return isPlain;
  }
  return std::all_of(image.displacement.begin(), image.displacement.end(),
                     [](const glm::vec2& d) { return d == glm::vec2(0); });
}

/// The image of a pinhole, or of a general one, by directions.
class PinholeSource {
 public:
  explicit PinholeSource(const ReferenceImage& image)
      : image_(image),
        camera_(image.reference()),
        map_(image.layout, image.width(), image.height()),
        focal_(static_cast<double>(camera_.focalPixels())),
        center_(camera_.centerPixels()),
        axes_(glm::transpose(
            glm::dmat3(glm::dvec3(camera_.right()), glm::dvec3(camera_.down()), glm::dvec3(camera_.forward())))) {
    for (size_t i = 0; i < image.t.size(); ++i) {
      nearest_ = image.holds(i) ? std::min(nearest_, image.t[i]) : nearest_;
    }
  }

  const PinholeCamera& camera() const { return camera_; }

  /// Where a direction of the world meets the image; nothing behind the eye, and beyond the borders.
  std::optional<glm::dvec2> place(const glm::dvec3& direction) const {
    const glm::dvec3 d = axes_ * direction;
    if (!(d.z > 0)) {
      return std::nullopt;
    }
    const glm::dvec2 q = map_.imageFromPinhole(center_ + glm::dvec2(d) * (focal_ / d.z));
    const bool isInside = q.x >= 0 && q.y >= 0 && q.x <= image_.width() && q.y <= image_.height();
    return isInside ? std::optional(q) : std::nullopt;
  }

  /// By what a place of the image moves where a direction changes by `du` and `dv`.
  glm::dmat2 steps(const glm::dvec2& place, const glm::dvec3& direction, const glm::dvec3& du,
                   const glm::dvec3& dv) const {
    const glm::dvec3 d = axes_ * direction;
    const auto moved = [&](const glm::dvec3& step) {
      const glm::dvec3 s = axes_ * step;
      return (glm::dvec2(s) * d.z - glm::dvec2(d) * s.z) * (focal_ / (d.z * d.z));
    };
    return glm::inverse(map_.jacobian(place)) * glm::dmat2(moved(du), moved(dv));
  }

  /// Samples for a length of 1 that faces the eye at a world point, in the direction that has fewest.
  std::optional<double> samplesPerLength(const glm::vec3& worldPoint) const {
    const glm::dvec3 p = axes_ * (glm::dvec3(worldPoint) - glm::dvec3(camera_.eye()));
    if (!(p.z > 0)) {
      return std::nullopt;
    }
    return map_.rateAt(map_.imageFromPinhole(center_ + glm::dvec2(p) * (focal_ / p.z))) * focal_ / p.z;
  }

  /// Between the four samples around a place.
  glm::vec3 colorAt(const glm::dvec2& place) const {
    const glm::dvec2 last(image_.width() - 1, image_.height() - 1);
    const glm::dvec2 snapped = glm::round(place * kSubSample) / kSubSample;
    const glm::dvec2 at = glm::clamp(snapped - 0.5, glm::dvec2(0), last);
    const glm::ivec2 lower(glm::min(glm::floor(at), glm::max(last - 1.0, 0.0)));
    const glm::ivec2 upper = glm::min(lower + 1, glm::ivec2(last));
    const glm::vec2 f(at - glm::dvec2(lower));
    const auto mixed = [&](int y) { return image_.color(lower.x, y) * (1 - f.x) + image_.color(upper.x, y) * f.x; };
    return mixed(lower.y) * (1 - f.y) + mixed(upper.y) * f.y;
  }

  /// Whether nothing stands on a ray from elsewhere, as far as the image tells: it sees all of the ray up to infinity.
  /// What lies behind its samples it does not see. `direction` has a length of 1 along the view direction of `eye`.
  bool seesAll(const glm::vec3& eye, const glm::dvec3& direction) const {
    constexpr int kSteps = 128;
    constexpr double kBehind = 1.01;
    const glm::dvec3 from = glm::dvec3(eye) - glm::dvec3(camera_.eye());
    for (int i = 0; i <= kSteps; ++i) {
      // Equal steps of 1/z, from half of the nearest sample's z.
      const double inverse = 2.0 / static_cast<double>(nearest_) * (kSteps - i) / kSteps;
      const glm::dvec3 point = from * inverse + direction;  // divided by its z
      const std::optional<glm::dvec2> at = place(point);
      if (!at) {
        if (i == kSteps) {
          return false;
        }
        continue;
      }
      const int x = std::min(static_cast<int>(at->x), image_.width() - 1);
      const int y = std::min(static_cast<int>(at->y), image_.height() - 1);
      if (image_.holds(x, y) && (axes_ * point).z > kBehind * static_cast<double>(image_.t(x, y)) * inverse) {
        return false;
      }
    }
    return true;
  }

 private:
  const ReferenceImage& image_;
  PinholeCamera camera_;
  GpcMap map_;
  double focal_;
  glm::dvec2 center_;
  float nearest_ = 1e9f;  ///< z of its samples
  glm::dmat3 axes_;       ///< camera coordinates from those of the world
};

/// The directions of a view's pixels, not of unit length.
struct ViewRays {
  explicit ViewRays(const PinholeCamera& view)
      : forward(view.forward()),
        du(glm::dvec3(view.right()) / static_cast<double>(view.focalPixels())),
        dv(glm::dvec3(view.down()) / static_cast<double>(view.focalPixels())),
        center(view.centerPixels()) {}
  glm::dvec3 at(const glm::dvec2& pixel) const {
    return forward + du * (pixel.x - center.x) + dv * (pixel.y - center.y);
  }

  glm::dvec3 forward, du, dv;
  glm::dvec2 center;
};

/// What rows find out, to be summed up in their order.
struct RateSum {
  size_t known = 0;
  size_t coarse = 0;
  double least = std::numeric_limits<double>::infinity();

  void add(double rate) {
    ++known;
    coarse += rate < 1 - kRateRounding;
    least = std::min(least, rate);
  }
};

template <class Body>
void forViewRows(ResampledView& view, const Body& body) {
  std::vector<RateSum> sums(static_cast<size_t>(view.color.height()));
  parallelFor(sums.size(), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      body(static_cast<int>(row), sums[row]);
    }
  });
  const RateSum all = std::accumulate(sums.begin(), sums.end(), RateSum{}, [](RateSum a, const RateSum& b) {
    return RateSum{a.known + b.known, a.coarse + b.coarse, std::min(a.least, b.least)};
  });
  if (all.known > 0) {
    view.coarse = static_cast<double>(all.coarse) / static_cast<double>(all.known);
    view.leastRate = all.least;
  }
}

void lookUp(const PinholeSource& source, const PinholeCamera& camera, ResampledView& view) {
  const ViewRays rays(camera);
  forViewRows(view, [&](int y, RateSum& rates) {
    for (int x = 0; x < camera.width(); ++x) {
      const glm::dvec2 corner(x, y);
      const glm::dvec3 ray = rays.at(corner + 0.5);
      const std::optional<glm::dvec2> middle = source.place(ray);
      if (!middle) {
        view.hole(x, y) = 1;
        continue;
      }
      const glm::dmat2 steps = source.steps(*middle, ray, rays.du, rays.dv);
      rates.add(singularValues(steps).y);
      const auto taps = [](const glm::dvec2& step) {
        return std::clamp(static_cast<int>(std::ceil(glm::length(step) - kRateRounding)), 1, kMaxTaps);
      };
      const glm::ivec2 count(taps(steps[0]), taps(steps[1]));
      glm::vec3 sum(0);
      float found = 0;
      for (int j = 0; j < count.y; ++j) {
        for (int i = 0; i < count.x; ++i) {
          const auto at = source.place(rays.at(corner + (glm::dvec2(i, j) + 0.5) / glm::dvec2(count)));
          if (at) {
            sum += source.colorAt(*at);
            ++found;
          }
        }
      }
      view.color(x, y) = found > 0 ? sum / found : source.colorAt(*middle);
    }
  });
}

/// `source` is null where the images are not those of a pinhole.
void warp(const ReferenceImages& images, const PinholeSource* source, const PinholeCamera& camera,
          ResampledView& view) {
  const Mesh mesh = unionMesh(images);
  const FragmentImage fragments = rasterize(camera, mesh);
  const ViewRays rays(camera);
  view.isWarped = true;
  forViewRows(view, [&](int y, RateSum& rates) {
    for (int x = 0; x < camera.width(); ++x) {
      const Fragment& fragment = fragments(x, y);
      if (fragment.covered()) {
        view.color(x, y) = colorOf(fragment, mesh);
        view.t(x, y) = fragment.t;
        if (source != nullptr) {
          const auto samples = source->samplesPerLength(positionOf(fragment, mesh));
          rates.add(samples.value_or(0) * static_cast<double>(fragment.t) / static_cast<double>(camera.focalPixels()));
        }
        continue;
      }
      view.hole(x, y) = source == nullptr || !source->seesAll(camera.eye(), rays.at(glm::dvec2(x, y) + 0.5));
    }
  });
}

}  // namespace

double ResampledView::holes() const {
  return static_cast<double>(std::count(hole.begin(), hole.end(), uint8_t{1})) /
         static_cast<double>(std::max<size_t>(hole.size(), 1));
}

ResampledView resample(const ReferenceImages& images, const PinholeCamera& camera) {
  OC_CHECK(!images.empty(), "there is an image to resample");
  ResampledView view{Image<glm::vec3>(camera.width(), camera.height(), glm::vec3(0)),
                     Image<float>(camera.width(), camera.height()), Image<uint8_t>(camera.width(), camera.height())};
  const ReferenceImage& first = images.front();
  const bool isPinhole = isOfAPinhole(images);
  const std::optional<PinholeSource> source = isPinhole ? std::optional<PinholeSource>(first) : std::nullopt;
  if (isPinhole && first.view.eye == camera.eye()) {
    lookUp(*source, camera, view);
  } else {
    warp(images, isPinhole ? &*source : nullptr, camera, view);
  }
  return view;
}

}  // namespace ocelli
