#include "oc_core/depth_views/views_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

/// One view, and how close together its samples are.
class SampledView {
 public:
  SampledView(const ReferenceImage& image, const ViewsSurfaceOptions& options)
      : image_(image),
        options_(options),
        angle_(pixelAngle(image)),
        project_(projectionOf(image)),
        points_(image.width(), image.height(), glm::vec3(0)),
        spaces_(image.width(), image.height(), 0),
        widest_(image.width(), image.height(), 0),
        grades_(image.width(), image.height(), 0) {
    const PinholeCamera reference = image.reference();
    forRows([&](int x, int y) {
      if (const auto point = image.pointOf(x, y, reference)) {
        points_(x, y) = *point;
        spaces_(x, y) = footprint(x, y);
      }
    });
    // Distances of neighbours, once all have their points.
    Image<float> spaces = spaces_;
    forRows([&](int x, int y) {
      if (spaces_(x, y) > 0) {
        const float rows = stepAlong(x, y, {1, 0});
        const float columns = stepAlong(x, y, {0, 1});
        const float own = footprint(x, y);
        spaces(x, y) = std::max({own, std::min(rows, columns) > 0 ? std::max(rows, columns) : own});
        // What has no neighbour along a row or a column may be as sparse as anything.
        const float widest = rows > 0 && columns > 0 ? spaces(x, y) : options_.maxStepFootprints * own;
        widest_(x, y) = widest;
      }
    });
    spaces_ = std::move(spaces);
  }

  /// The distance that half of the samples are closer together than, world units.
  float medianSpace() const {
    std::vector<float> all;
    std::copy_if(widest_.begin(), widest_.end(), std::back_inserter(all), [](float space) { return space > 0; });
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
  }
  /// Most samples are of grade 0 where `usual` is a usual distance: nothing divides them.
  void gradeBy(float usual) {
    forRows([&](int x, int y) {
      if (holds(x, y)) {
        grades_(x, y) =
            static_cast<int>(std::floor(std::log(widest_(x, y) / usual) / std::log(options_.betterBy) + 0.5f));
      }
    });
  }

  bool holds(int x, int y) const { return spaces_(x, y) > 0; }
  const glm::vec3& point(int x, int y) const { return points_(x, y); }
  /// Less is better: the logarithm of the distance between samples.
  int grade(int x, int y) const { return grades_(x, y); }

  /// Whether it has a sample of that place whose grade is at most `worst`.
  bool shows(const glm::vec3& place, int worst) const {
    const auto q = project_(place);
    if (!q || !(std::abs(q->u) < PinholeCamera::kMaxPixelsASide && std::abs(q->v) < PinholeCamera::kMaxPixelsASide)) {
      return false;
    }
    const int column = static_cast<int>(std::floor(q->u));
    const int row = static_cast<int>(std::floor(q->v));
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) {
        const int u = image_.wrapsAround ? (x + image_.width()) % image_.width() : x;
        if (image_.t.contains(u, y) && holds(u, y) && grade(u, y) <= worst &&
            glm::distance(point(u, y), place) <= options_.maxSpaces * spaces_(u, y)) {
          return true;
        }
      }
    }
    return false;
  }

  template <class Body>
  void forRows(const Body& body) const {
    parallelFor(static_cast<size_t>(image_.height()), 4, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        for (int x = 0; x < image_.width(); ++x) {
          body(x, static_cast<int>(row));
        }
      }
    });
  }

 private:
  float footprint(int x, int y) const { return std::abs(image_.t(x, y)) * angle_; }

  /// To the closer one of the two neighbours of a row or column, where that is close enough to be of its surface; else
  /// 0.
  float stepAlong(int x, int y, const glm::ivec2& step) const {
    float closest = 0;
    for (const int sign : {-1, 1}) {
      int u = x + sign * step.x;
      const int v = y + sign * step.y;
      u = image_.wrapsAround ? (u + image_.width()) % image_.width() : u;
      if (!image_.t.contains(u, v) || !holds(u, v)) {
        continue;
      }
      const float distance = glm::distance(points_(u, v), points_(x, y));
      if (distance <= options_.maxStepFootprints * std::min(footprint(x, y), footprint(u, v)) &&
          (closest == 0 || distance < closest)) {
        closest = distance;
      }
    }
    return closest;
  }

  const ReferenceImage& image_;
  const ViewsSurfaceOptions& options_;
  float angle_;
  Projection project_;
  Image<glm::vec3> points_;
  Image<float> spaces_;  ///< to the next samples, world units; 0 where there is no sample
  Image<float> widest_;  ///< the same, where a neighbour is missing as wide as can be
  Image<int> grades_;
};

/// Which samples of a view no better one shows.
Image<uint8_t> keptOf(const std::vector<SampledView>& sampled, size_t view, const ReferenceImage& image) {
  Image<uint8_t> marks(image.width(), image.height(), 0);
  const SampledView& own = sampled[view];
  own.forRows([&](int x, int y) {
    bool kept = own.holds(x, y);
    for (size_t other = 0; kept && other < sampled.size(); ++other) {
      // Grades and then places in the list order all views, so that one of them keeps each place.
      const int worst = own.grade(x, y) - (other < view ? 0 : 1);
      kept = other == view || !sampled[other].shows(own.point(x, y), worst);
    }
    marks(x, y) = kept ? 1 : 0;
  });
  return marks;
}

}  // namespace

size_t ViewsSurface::keptSamples() const {
  return std::accumulate(kept.begin(), kept.end(), size_t{0});
}

ViewsSurface surfaceOfViews(std::vector<DepthView> views, const ViewsSurfaceOptions& options,
                            const Progress& progress) {
  ViewsSurface surface;
  surface.samples = sampleCount(views);
  std::vector<Image<uint8_t>> marks;
  if (views.size() > 1 && !options.keepsAll) {
    std::vector<SampledView> sampled;
    sampled.reserve(views.size());
    for (const DepthView& view : views) {
      sampled.emplace_back(view.image, options);
    }
    const float usual = sampled.front().medianSpace();
    for (SampledView& view : sampled) {
      view.gradeBy(usual);
    }
    for (size_t i = 0; i < views.size(); ++i) {
      report(progress, "joining views", static_cast<double>(i) / static_cast<double>(views.size()));
      marks.push_back(keptOf(sampled, i, views[i].image));
    }
  }
  ReferenceImages images;
  for (size_t i = 0; i < views.size(); ++i) {
    ReferenceImage& image = views[i].image;
    image.seenFromAside = views.size() > 1;
    if (!marks.empty()) {
      for (int step = 0; step < options.seamPixels; ++step) {
        growAlongSurface(marks[i], image);
      }
      keepMarked(image, marks[i]);
    }
    surface.kept.push_back(image.sampleCount());
    images.push_back(std::move(image));
  }
  surface.mesh = unionMesh(images);
  surface.mesh.isPart = true;
  surface.mesh.isSampled = true;
  return surface;
}

}  // namespace ocelli
