#include "oc_core/feeds_measure/simulated_feed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/feeds/feed_lens.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr int kBackgroundScale = 2;          ///< samples a side of each pixel of what stands still
constexpr double kMaxStripSeconds = 2.5e-3;  ///< within which rows are taken together: a walker moves 4 mm
constexpr int kMaxStrips = 64;

/// The pinhole that holds all that the feed sees through its lens.
PinholeCamera idealCamera(const Feed& feed, int scale) {
  double halfX = 0;
  double halfY = 0;
  const auto reach = [&](double u, double v) {
    const auto direction = directionOf(feed.lens, {u, v});
    OC_CHECK(direction.has_value(), "the lens of a rig holds all of its image");
    halfX = std::max(halfX, std::abs(direction->x));
    halfY = std::max(halfY, std::abs(direction->y));
  };
  for (int x = 0; x <= feed.width; ++x) {
    reach(x, 0);
    reach(x, feed.height);
  }
  for (int y = 0; y <= feed.height; ++y) {
    reach(0, y);
    reach(feed.width, y);
  }
  const double focal = feed.lens.focal.x * scale;
  const int width = 2 * static_cast<int>(std::ceil(halfX * focal)) + 4;
  const int height = 2 * static_cast<int>(std::ceil(halfY * focal)) + 4;
  View view;
  view.eye = glm::vec3(feed.pose.eye);
  view.target = glm::vec3(feed.pose.target);
  view.up = glm::vec3(feed.pose.up);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(height / 2.0 / focal));
  view.zNear = 0.05f;
  return {view, width, height};
}

glm::vec2 idealPixel(const Feed& feed, const PinholeCamera& camera, const glm::dvec2& pixel) {
  const auto direction = directionOf(feed.lens, pixel);
  OC_CHECK(direction.has_value(), "the lens of a rig holds all of its image");
  return camera.centerPixels() + glm::vec2(*direction) * camera.focalPixels();
}

glm::vec3 bilinear(const Image<glm::vec3>& image, const glm::vec2& at) {
  const glm::vec2 last(image.width() - 1, image.height() - 1);
  const glm::vec2 p = glm::clamp(at - 0.5f, glm::vec2(0), last - 0.001f);
  const auto x = static_cast<int>(p.x);
  const auto y = static_cast<int>(p.y);
  const glm::vec2 f = p - glm::vec2(x, y);
  return (image(x, y) * (1 - f.x) + image(x + 1, y) * f.x) * (1 - f.y) +
         (image(x, y + 1) * (1 - f.x) + image(x + 1, y + 1) * f.x) * f.y;
}

}  // namespace

struct SimulatedFeed::Impl {
  Feed feed;
  PinholeCamera camera;
  Image<glm::vec3> background;
  std::vector<float> depths;     ///< of the background, in the ideal image; infinite where nothing is
  std::vector<uint32_t> places;  ///< of each pixel of the feed in the ideal image

  Impl(const Feed& f, const Mesh& place) : feed(f), camera(idealCamera(f, 1)), background(f.width, f.height) {
    const FragmentImage seen = rasterize(camera, place);
    for (const Fragment& fragment : seen) {
      depths.push_back(fragment.covered() ? fragment.t : std::numeric_limits<float>::infinity());
    }
    const PinholeCamera fine = idealCamera(f, kBackgroundScale);
    const Image<glm::vec3> colors = colorImage(rasterize(fine, place), place, skyColor());
    for (int y = 0; y < feed.height; ++y) {
      for (int x = 0; x < feed.width; ++x) {
        const glm::vec2 p = idealPixel(feed, camera, {x + 0.5, y + 0.5});
        places.push_back(static_cast<uint32_t>(seen.index(static_cast<int>(p.x), static_cast<int>(p.y))));
        glm::vec3 sum(0);
        for (const double dy : {0.25, 0.75}) {
          for (const double dx : {0.25, 0.75}) {
            sum += bilinear(colors, idealPixel(feed, fine, {x + dx, y + dy}));
          }
        }
        background(x, y) = sum / 4.0f;
      }
    }
  }

  template <class Visit>
  void visitWalkers(const Walkers& walkers, double seconds, double rollingSeconds, const Visit& visit) const {
    const auto strips = static_cast<size_t>(std::clamp(std::ceil(rollingSeconds / kMaxStripSeconds), 1.0,
                                                       static_cast<double>(std::min(kMaxStrips, feed.height))));
    const auto rows = static_cast<size_t>(feed.height);
    for (size_t k = 0; k < strips; ++k) {
      // The time of the middle of the strip; all at once, that of the frame.
      const double share = strips == 1 ? 0 : (static_cast<double>(k) + 0.5) / static_cast<double>(strips);
      visitRows(walkers, seconds + share * rollingSeconds, k * rows / strips, (k + 1) * rows / strips, visit);
    }
  }

  template <class Visit>
  void visitRows(const Walkers& walkers, double seconds, size_t from, size_t to, const Visit& visit) const {
    std::vector<uint8_t> walkerOfTriangle;
    const Mesh figures = walkers.meshAt(seconds, walkerOfTriangle);
    if (figures.empty()) {
      return;
    }
    const FragmentImage seen = rasterize(camera, figures);
    const auto width = static_cast<size_t>(feed.width);
    for (size_t i = from * width; i < to * width; ++i) {
      const Fragment& fragment = seen[places[i]];
      if (fragment.covered() && fragment.t < depths[places[i]]) {
        visit(i, fragment, figures, static_cast<uint8_t>(walkerOfTriangle[fragment.triangle] + 1));
      }
    }
  }
};

SimulatedFeed::SimulatedFeed(const Feed& feed, const Mesh& place) : impl_(std::make_unique<Impl>(feed, place)) {}
SimulatedFeed::~SimulatedFeed() = default;
SimulatedFeed::SimulatedFeed(SimulatedFeed&&) noexcept = default;

const Image<glm::vec3>& SimulatedFeed::background() const {
  return impl_->background;
}

SimulatedFrame SimulatedFeed::frame(const Walkers& walkers, double seconds, double rollingSeconds) const {
  SimulatedFrame frame{impl_->background, WalkerMask(impl_->feed.width, impl_->feed.height)};
  impl_->visitWalkers(walkers, seconds, rollingSeconds,
                      [&](size_t i, const Fragment& fragment, const Mesh& figures, uint8_t walker) {
                        frame.colors[i] = colorOf(fragment, figures);
                        frame.walkers[i] = walker;
                      });
  return frame;
}

WalkerMask SimulatedFeed::mask(const Walkers& walkers, double seconds, double rollingSeconds) const {
  WalkerMask mask(impl_->feed.width, impl_->feed.height);
  impl_->visitWalkers(walkers, seconds, rollingSeconds,
                      [&](size_t i, const Fragment&, const Mesh&, uint8_t walker) { mask[i] = walker; });
  return mask;
}

}  // namespace ocelli
