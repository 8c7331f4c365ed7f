#include "oc_core/render/gpc_raster_zone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace ocelli {
namespace {

constexpr int kZoneWidth = 800;
constexpr int kZoneHeight = 480;

/// Zooms in and out, wide and narrow transitions, small and large regions. The last one nearly folds: f' has a least
/// value of 0.003 where it is cubic.
std::vector<GpcRegion> regions() {
  return {{{0.5f, 0.5f}, {0.5f, 0.5f}, 3, 1},        {{0.25f, 0.5f}, {0.2f, 0.3f}, 4, 0.8f},
          {{0.8f, 0.3f}, {0.1f, 0.2f}, 6, 0.3f},     {{0.5f, 0.5f}, {0.1f, 0.1f}, 64, 4},
          {{0.4f, 0.6f}, {0.02f, 0.03f}, 10, 20},    {{0.7f, 0.7f}, {0.3f, 0.2f}, 1.05f, 0.01f},
          {{0.8f, 0.6f}, {0.15f, 0.3f}, 0.8f, 1.5f}, {{0.5f, 0.5f}, {0.3f, 0.3f}, 0.501f, 2}};
}

/// Calls visit(zone, raster zone, name) for the regions above with each sampling that may have them.
template <class Visit>
void forEachZone(const Visit& visit) {
  for (const GpcSampling& sampling : gpcSamplings()) {
    for (const GpcRegion& region : regions()) {
      const GpcZone zone(region, sampling, {kZoneWidth, kZoneHeight});
      if (zone.profile().isIncreasing()) {
        visit(zone, GpcRasterZone(zone, 0, {kZoneWidth, kZoneHeight}),
              std::string(sampling.name) + " " + std::to_string(region.zoom));
      }
    }
  }
}

/// A run whose points are `at(i)`.
template <class At>
GpcRun runOf(const At& at) {
  GpcRun run;
  for (size_t i = 0; i < GpcRun::kSize; ++i) {
    const glm::vec2 p = at(i);
    run.u[i] = run.x[i] = p.x;
    run.v[i] = run.y[i] = p.y;
    run.part[i] = GpcRasterZone::kAround;
  }
  return run;
}

GpcBend bendOf(const GpcRun& run, size_t i) {
  return {run.xx[i], run.yy[i], run.xy[i]};
}

TEST(GpcRasterZone, placesPointsAsTheMap) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(0, 1);
  int tabulated = 0;
  int bent = 0;
  forEachZone([&](const GpcZone& zone, const GpcRasterZone& raster, const std::string& name) {
    tabulated += raster.isTabulated();
    for (int k = 0; k < 100; ++k) {
      const float size = std::exp2(-8 * any(random));
      GpcRun run = runOf([&](size_t) {
        return glm::vec2(zone.center()) +
               1.1f * size * glm::vec2(zone.outerHalf()) * (2.0f * glm::vec2(any(random), any(random)) - 1.0f);
      });
      raster.place(run);
      for (size_t i = 0; i < GpcRun::kSize; ++i) {
        const glm::dvec2 p(run.u[i], run.v[i]);
        const glm::dvec2 expected = zone.imageFromPinhole(p);
        // What single precision has of places in this image, twice, and what a zoom makes of it.
        const double rounding = 2 * kZoneWidth * 0x1p-24 * std::max(zone.profile().greatestRate(), 1.0);
        ASSERT_LE(std::max(std::abs(static_cast<double>(run.x[i]) - expected.x),
                           std::abs(static_cast<double>(run.y[i]) - expected.y)),
                  GpcRasterZone::kMaxErrorPixels + rounding)
            << name << " " << p.x << " " << p.y;
        // Which part, but for points on the lines between them.
        const glm::dvec2 d = (p - zone.center()) / zone.half();
        const double f = std::max(std::abs(d.x), std::abs(d.y));
        const bool isOnLine = std::abs(f - zone.profile().outer()) < 1e-4 * f ||
                              std::abs(f * zone.profile().zoom() - 1) < 1e-4 ||
                              std::abs(std::abs(d.x) - std::abs(d.y)) < 1e-4 * f;
        if (!isOnLine) {
          const bool isWithin = f < zone.profile().outer();
          const bool isInner = f * zone.profile().zoom() < 1;
          ASSERT_EQ(run.part[i] != GpcRasterZone::kAround, isWithin) << name;
          ASSERT_EQ(GpcRasterZone::isInTransition(run.part[i]), isWithin && !isInner) << name;
          if (isWithin && !isInner) {
            ASSERT_EQ(GpcRasterZone::isBeside(run.part[i]), std::abs(d.x) > std::abs(d.y)) << name;
            ++bent;
          }
        }
      }
    }
  });
  EXPECT_GT(bent, 50000);
  EXPECT_GE(tabulated, 18);  // of 3 x 8, some of which fold
}

// Triangles in one part whose bend is 1 at most: between corners that are placed exactly, everything else is too, but
// for 1/64 pixel.
TEST(GpcRasterZone, aStraightTriangleStraysByAChordAtMost) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> any(0, 1);
  double worstOfAll = 0;
  int straight = 0;
  forEachZone([&](const GpcZone& zone, const GpcRasterZone& raster, const std::string& name) {
    double worst = 0;
    for (int k = 0; k < 3000; ++k) {
      // 42 triangles of about the same size around a point of the transition or near it.
      const glm::vec2 around = glm::vec2(zone.center()) + 1.05f * glm::vec2(zone.outerHalf()) *
                                                              (2.0f * glm::vec2(any(random), any(random)) - 1.0f);
      const float size = 64 * std::exp2(-9 * any(random));
      GpcRun run = runOf([&](size_t) {
        return around + size * (glm::vec2(any(random), any(random)) - 0.5f) * glm::vec2(1, any(random));
      });
      raster.place(run);
      for (size_t i = 0; i + 2 < GpcRun::kSize; i += 3) {
        const auto [left, right] = std::minmax({run.x[i], run.x[i + 1], run.x[i + 2]});
        const auto [top, bottom] = std::minmax({run.y[i], run.y[i + 1], run.y[i + 2]});
        const GpcBend bend = max(max(bendOf(run, i), bendOf(run, i + 1)), bendOf(run, i + 2));
        if (!GpcRasterZone::isInTransition(run.part[i]) || run.part[i] != run.part[i + 1] ||
            run.part[i] != run.part[i + 2] || !(bend(right - left, bottom - top) <= 1)) {
          continue;
        }
        ++straight;
        for (int n = 0; n < 8; ++n) {
          // On edges, where it strays most, and within.
          glm::dvec3 share(any(random), any(random), n % 2 == 0 ? 0 : any(random));
          share /= share.x + share.y + share.z;
          glm::dvec2 p(0);
          glm::dvec2 chord(0);
          for (size_t corner = 0; corner < 3; ++corner) {
            const glm::dvec2 q(run.u[i + corner], run.v[i + corner]);
            p += q * share[static_cast<int>(corner)];
            chord += zone.imageFromPinhole(q) * share[static_cast<int>(corner)];
          }
          worst = std::max(worst, glm::distance(zone.imageFromPinhole(p), chord));
        }
      }
    }
    EXPECT_LE(worst, 0.75 * GpcRasterZone::kChordPixels) << name;
    worstOfAll = std::max(worstOfAll, worst);
  });
  // The bound is of use: it lets triangles pass, and some of them come near to it.
  EXPECT_GT(straight, 100000);
  EXPECT_GT(worstOfAll, GpcRasterZone::kChordPixels / 2);
}

// Around the zone an edge that is known to be straight does not reach it.
TEST(GpcRasterZone, edgesAroundEndBeforeTheZone) {
  forEachZone([&](const GpcZone& zone, const GpcRasterZone& raster, const std::string& name) {
    GpcRun run = runOf([&](size_t i) {
      const double angle = 2 * 3.141592653589793 * static_cast<double>(i) / GpcRun::kSize;
      return glm::vec2(zone.center() + 1.5 * zone.outerHalf() * glm::dvec2(std::cos(angle), std::sin(angle)));
    });
    raster.place(run);
    for (size_t i = 0; i < GpcRun::kSize; ++i) {
      if (run.part[i] == GpcRasterZone::kAround) {
        const glm::dvec2 away =
            glm::max(glm::abs(glm::dvec2(run.u[i], run.v[i]) - zone.center()) - zone.outerHalf(), 0.0);
        const auto distance = static_cast<float>(glm::length(away));
        EXPECT_GT(bendOf(run, i)(distance, 0), 1) << name;
        EXPECT_GT(bendOf(run, i)(0, distance), 1) << name;
        EXPECT_LE(bendOf(run, i)(0.9f * distance - 0.1f, 0), 1) << name;
      }
    }
  });
}

// And every pixel of the outer rectangle is in the inner one, or in a row's part, or in a column's.
TEST(GpcRasterZone, samplesOfPixelsAreThoseOfTheMap) {
  forEachZone([&](const GpcZone& zone, const GpcRasterZone& raster, const std::string& name) {
    const PixelBounds& outer = raster.outerPixels();
    ASSERT_GT((outer.x1 - outer.x0) * (outer.y1 - outer.y0), 100);
    Image<int> times(kZoneWidth, kZoneHeight, 0);
    for (int y = outer.y0; y < outer.y1; ++y) {
      if (raster.row(y).r > 1) {
        const GpcRasterZone::Range x = raster.columnsNearerThan(raster.row(y), outer.x0, outer.x1 - 1);
        for (int at = x.first; at <= x.last; ++at) {
          ++times(at, y);
        }
      }
    }
    for (int x = outer.x0; x < outer.x1; ++x) {
      if (raster.column(x).r > 1) {
        const GpcRasterZone::Range y = raster.rowsNoFartherThan(raster.column(x), outer.y0, outer.y1 - 1);
        for (int at = y.first; at <= y.last; ++at) {
          ++times(x, at);
        }
      }
    }
    for (int y = outer.y0; y < outer.y1; ++y) {
      for (int x = outer.x0; x < outer.x1; ++x) {
        ASSERT_EQ(times(x, y), raster.isInner(x, y) ? 0 : 1) << name << " " << x << " " << y;
        const glm::dvec2 expected = zone.pinholeFromImage(glm::dvec2(x, y) + 0.5);
        const GpcRasterZone::Line& column = raster.column(x);
        const GpcRasterZone::Line& row = raster.row(y);
        const GpcRasterZone::Line& line = column.r >= row.r ? column : row;
        const glm::dvec2 at = zone.center() + glm::dvec2(column.offset, row.offset) * line.scale;
        ASSERT_LT(glm::distance(at, expected), 1e-9) << name;
      }
    }
  });
}

TEST(GpcRasterZone, imageBoxHoldsEveryPoint) {
  std::mt19937 random(10);
  std::uniform_real_distribution<float> any(0, 1);
  forEachZone([&](const GpcZone& zone, const GpcRasterZone& raster, const std::string& name) {
    for (int i = 0; i < 4000; ++i) {
      const glm::vec2 from(kZoneWidth * any(random), kZoneHeight * any(random));
      const float size = std::exp2(-10 * any(random));
      const ImageBox box{from, from + glm::vec2(kZoneWidth * any(random), kZoneHeight * any(random)) * size};
      const ImageBox image = raster.imageBox(box);
      for (int k = 0; k < 20; ++k) {
        const glm::dvec2 p =
            glm::mix(glm::dvec2(box.lower), glm::dvec2(box.upper), glm::dvec2(any(random), any(random)));
        const glm::dvec2 q = zone.imageFromPinhole(p);
        ASSERT_TRUE(glm::all(glm::lessThanEqual(glm::dvec2(image.lower), q)) &&
                    glm::all(glm::lessThanEqual(q, glm::dvec2(image.upper))))
            << name << " " << p.x << " " << p.y;
      }
    }
  });
}

// Of a box of half a pixel: its sides are as far apart as the images of points on them.
TEST(GpcRasterZone, imageBoxIsTight) {
  forEachZone([&](const GpcZone& zone, const GpcRasterZone& raster, const std::string& name) {
    for (float y = 0; y < kZoneHeight - 1; y += 17) {
      for (float x = 0; x < kZoneWidth - 1; x += 17) {
        const ImageBox box{{x, y}, {x + 0.5f, y + 0.5f}};
        const ImageBox image = raster.imageBox(box);
        glm::dvec2 lower(1e30);
        glm::dvec2 upper(-1e30);
        constexpr int kSteps = 8;
        for (int k = 0; k < (kSteps + 1) * (kSteps + 1); ++k) {
          const glm::dvec2 at = glm::dvec2(k % (kSteps + 1), k / (kSteps + 1)) / (2.0 * kSteps);
          const glm::dvec2 q = zone.imageFromPinhole(glm::dvec2(box.lower) + at);
          lower = glm::min(lower, q);
          upper = glm::max(upper, q);
        }
        // The slack on both sides, and single precision.
        const glm::dvec2 wider = glm::dvec2(image.upper - image.lower) - (upper - lower);
        ASSERT_LT(std::max(wider.x, wider.y), 3 * static_cast<double>(GpcRasterZone::kBoxSlack)) << name;
      }
    }
  });
}

}  // namespace
}  // namespace ocelli
