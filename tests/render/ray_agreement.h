// How an image that was drawn differs from one that was cast along rays.
#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>

#include "oc_core/render/fragment_image.h"

namespace ocelli::test {

inline size_t coveredPixels(const FragmentImage& image) {
  return static_cast<size_t>(std::count_if(image.begin(), image.end(), [](const Fragment& f) { return f.covered(); }));
}

/// Whether two fragments of one pixel show the same place.
inline bool alike(const Fragment& a, const Fragment& b, float depthTolerance) {
  return a.covered() == b.covered() && std::abs(a.t - b.t) <= depthTolerance * a.t;
}

struct Disagreement {
  size_t samples = 0;    ///< pixels that either image covers
  size_t differing = 0;  ///< that differ: in what covers them, or in depth
  size_t apart = 0;      ///< of these, those where the images agree with no pixel beside: not moved edges
};

inline std::ostream& operator<<(std::ostream& out, const Disagreement& d) {
  return out << d.differing << " of " << d.samples << " samples differ, " << d.apart << " of them apart from edges";
}

/// A pixel at an edge or on a split line of one image shows what the other has within a pixel of it: both ways.
inline Disagreement disagreement(const FragmentImage& cast, const FragmentImage& drawn, float depthTolerance) {
  Disagreement d;
  const auto isNear = [&](const Fragment& f, const FragmentImage& image, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (image.contains(x + dx, y + dy) && alike(f, image(x + dx, y + dy), 0.02f)) {
          return true;
        }
      }
    }
    return false;
  };
  for (int y = 0; y < cast.height(); ++y) {
    for (int x = 0; x < cast.width(); ++x) {
      const Fragment& a = cast(x, y);
      const Fragment& b = drawn(x, y);
      d.samples += a.covered() || b.covered();
      if (!alike(a, b, depthTolerance)) {
        ++d.differing;
        d.apart += !isNear(a, drawn, x, y) && !isNear(b, cast, x, y);
      }
    }
  }
  return d;
}

}  // namespace ocelli::test
