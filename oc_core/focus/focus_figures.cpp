#include "oc_core/focus/focus_figures.h"

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/gpc_map.h"
#include "oc_core/focus/rate_image.h"

namespace ocelli {
namespace {

constexpr double kDifference = 1e-4;  // pixels
constexpr double kSparse = 0.5;
constexpr double kFoundAgain = 1e-3;  // pixels: rounding, with much to spare

/// What steps along the axes become, and how much those to one side differ from those to the other.
struct Steps {
  glm::dmat2 jacobian{0};
  double mismatch = 0;
};

Steps stepsAt(const FocusMap& map, const glm::dvec2& at) {
  Steps steps;
  const glm::dvec2 here = map.plainFromPicture(at);
  for (int axis = 0; axis < 2; ++axis) {
    glm::dvec2 by(0);
    by[axis] = kDifference;
    const glm::dvec2 forward = (map.plainFromPicture(at + by) - here) / kDifference;
    const glm::dvec2 backward = (here - map.plainFromPicture(at - by)) / kDifference;
    steps.jacobian[axis] = (forward + backward) / 2.0;
    steps.mismatch = std::max(steps.mismatch, glm::length(forward - backward));
  }
  return steps;
}

/// Where derivatives are taken, from a place: maps have corners and jumps along lines, such as the borders and
/// diagonals of a lens, and these often go through centres of pixels.
constexpr std::array<glm::dvec2, 4> kBeside{glm::dvec2(0.0031, 0.0017), glm::dvec2(-0.0023, 0.0041),
                                            glm::dvec2(-0.0031, -0.0017), glm::dvec2(0.0019, -0.0047)};

/// Samples for each one of the plain view at a place of the picture: least and greatest of all directions.
glm::dvec2 ratesAt(const FocusMap& map, const glm::dvec2& place) {
  constexpr double kSmooth = 0.02;  // the curvature of a lens hardly makes such a difference over that distance
  std::optional<Steps> best;
  for (const glm::dvec2& beside : kBeside) {
    const Steps steps = stepsAt(map, place + beside);
    if (!best || steps.mismatch < best->mismatch) {
      best = steps;
    }
    if (best->mismatch < kSmooth) {
      break;
    }
  }
  return 1.0 / singularValues(best->jacobian);
}

/// Where the picture shows a place of the plain view, if it really does.
std::optional<glm::dvec2> shownAt(const FocusMap& map, const glm::dvec2& plain, const glm::ivec2& size) {
  const std::optional<glm::dvec2> at = map.pictureFromPlain(plain);
  if (!at || at->x < 0 || at->y < 0 || at->x > size.x || at->y > size.y ||
      !(glm::length(map.plainFromPicture(*at) - plain) < kFoundAgain)) {
    return std::nullopt;
  }
  return at;
}

bool isInAny(const std::vector<FocusBox>& boxes, const glm::dvec2& p) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const FocusBox& box) { return box.contains(p); });
}

/// One result a row, on all threads, put together in order.
template <class Result, class Row, class Join>
Result overRows(int rows, const Row& row, const Join& join) {
  std::vector<Result> results(static_cast<size_t>(rows));
  parallelFor(results.size(), 4, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      results[y] = row(static_cast<int>(y));
    }
  });
  Result all{};
  for (const Result& each : results) {
    join(all, each);
  }
  return all;
}

constexpr double kNoRate = std::numeric_limits<double>::infinity();

// ---- of the picture

struct PictureSums {
  size_t inFocus = 0;
  double leastFocusRate = kNoRate;
  double greatestFocusRate = 0;
  double leastContextRate = kNoRate;
};

PictureSums picturePart(const FocusMap& map, const std::vector<FocusBox>& contents, const glm::ivec2& size) {
  return overRows<PictureSums>(
      size.y,
      [&](int y) {
        PictureSums row;
        for (int x = 0; x < size.x; ++x) {
          const glm::dvec2 at = glm::dvec2(x, y) + 0.5;
          const glm::dvec2 rates = ratesAt(map, at);
          if (isInAny(contents, map.plainFromPicture(at))) {
            ++row.inFocus;
            row.leastFocusRate = std::min(row.leastFocusRate, rates.x);
            row.greatestFocusRate = std::max(row.greatestFocusRate, rates.y);
          } else {
            row.leastContextRate = std::min(row.leastContextRate, rates.x);
          }
        }
        return row;
      },
      [](PictureSums& all, const PictureSums& row) {
        all.inFocus += row.inFocus;
        all.leastFocusRate = std::min(all.leastFocusRate, row.leastFocusRate);
        all.greatestFocusRate = std::max(all.greatestFocusRate, row.greatestFocusRate);
        all.leastContextRate = std::min(all.leastContextRate, row.leastContextRate);
      });
}

// ---- of the plain view

struct ContextSums {
  size_t context = 0;
  size_t hidden = 0;
  size_t sparse = 0;
};

ContextSums contextPart(const FocusMap& map, const std::vector<FocusBox>& contents, const glm::ivec2& size) {
  return overRows<ContextSums>(
      size.y,
      [&](int y) {
        ContextSums row;
        for (int x = 0; x < size.x; ++x) {
          const glm::dvec2 plain = glm::dvec2(x, y) + 0.5;
          if (isInAny(contents, plain)) {
            continue;
          }
          ++row.context;
          const std::optional<glm::dvec2> at = shownAt(map, plain, size);
          row.hidden += at ? 0 : 1;
          row.sparse += !at || ratesAt(map, *at).x < kSparse ? 1 : 0;
        }
        return row;
      },
      [](ContextSums& all, const ContextSums& row) {
        all.context += row.context;
        all.hidden += row.hidden;
        all.sparse += row.sparse;
      });
}

// ---- straight lines

/// How far what is straight in the plain view lies off the line between its ends in the picture, as a share of that
/// line's length; 0 where a part of it is not shown.
double bowOf(const FocusMap& map, const glm::dvec2& a, const glm::dvec2& b, const glm::ivec2& size) {
  constexpr int kParts = 32;
  const std::optional<glm::dvec2> begin = shownAt(map, a, size);
  const std::optional<glm::dvec2> end = shownAt(map, b, size);
  if (!begin || !end) {
    return 0;
  }
  const glm::dvec2 chord = *end - *begin;
  const double length = glm::length(chord);
  double bow = 0;
  for (int i = 1; i < kParts; ++i) {
    const std::optional<glm::dvec2> at = shownAt(map, glm::mix(a, b, static_cast<double>(i) / kParts), size);
    if (!at) {
      return 0;
    }
    const glm::dvec2 off = *at - *begin;
    bow = std::max(bow, std::abs(off.x * chord.y - off.y * chord.x) / (length * length));
  }
  return bow;
}

/// Lines from border to border of each focus, along the axes, and its diagonals.
double focusBend(const FocusMap& map, const std::vector<FocusBox>& contents, const glm::ivec2& size) {
  constexpr int kLines = 16;
  constexpr double kWithin = 1 - 1e-9;  // a border belongs to the focus
  double bend = 0;
  for (const FocusBox& box : contents) {
    const glm::dvec2 half = box.half * kWithin;
    const auto consider = [&](const glm::dvec2& a, const glm::dvec2& b) {
      bend = std::max(bend, bowOf(map, box.center + a * half, box.center + b * half, size));
    };
    for (int i = 0; i <= kLines; ++i) {
      const double at = 2.0 * i / kLines - 1;
      consider({-1, at}, {1, at});
      consider({at, -1}, {at, 1});
    }
    consider({-1, -1}, {1, 1});
    consider({-1, 1}, {1, -1});
  }
  return bend;
}

/// Whether any place of the segment from a to b lies in the box, the border of which belongs to it.
bool meets(const FocusBox& box, const glm::dvec2& a, const glm::dvec2& b) {
  double begin = 0;  // of the part that lies between the sides looked at, as shares of the segment
  double end = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = a[axis] - box.center[axis];
    const double step = b[axis] - a[axis];
    if (step == 0) {
      if (std::abs(from) > box.half[axis]) {
        return false;
      }
      continue;
    }
    const double lower = (-box.half[axis] - from) / step;
    const double upper = (box.half[axis] - from) / step;
    begin = std::max(begin, std::min(lower, upper));
    end = std::min(end, std::max(lower, upper));
  }
  return begin <= end;
}

/// Segments from the centre of every fourth pixel along the axes and both diagonals, where they lie in the context.
double contextBend(const FocusMap& map, const std::vector<FocusBox>& contents, const glm::ivec2& size) {
  constexpr int kEvery = 4;
  const double length = size.y / 8.0;
  const std::array<glm::dvec2, 4> ways{glm::dvec2(1, 0), glm::dvec2(0, 1), glm::normalize(glm::dvec2(1, 1)),
                                       glm::normalize(glm::dvec2(1, -1))};
  const auto isClear = [&](const glm::dvec2& a, const glm::dvec2& b) {
    return std::none_of(contents.begin(), contents.end(), [&](const FocusBox& box) { return meets(box, a, b); });
  };
  return overRows<double>((size.y + kEvery - 1) / kEvery,
                          [&](int row) {
                            double bend = 0;
                            for (int x = 0; x < size.x; x += kEvery) {
                              const glm::dvec2 a = glm::dvec2(x, row * kEvery) + 0.5;
                              for (const glm::dvec2& way : ways) {
                                const glm::dvec2 b = a + way * length;
                                if (b.x <= size.x && b.y >= 0 && b.y <= size.y && isClear(a, b)) {
                                  bend = std::max(bend, bowOf(map, a, b, size));
                                }
                              }
                            }
                            return bend;
                          },
                          [](double& all, double row) { all = std::max(all, row); });
}

// ---- jumps

/// Halves the way from a to b again and again, towards the half across which `change` is greater: what is left of it in
/// the end is a jump.
double jumpBetween(glm::dvec2 a, glm::dvec2 b,
                   const std::function<double(const glm::dvec2&, const glm::dvec2&)>& change, int halvings) {
  for (int i = 0; i < halvings; ++i) {
    const glm::dvec2 middle = (a + b) / 2.0;
    (change(a, middle) >= change(middle, b) ? b : a) = middle;
  }
  return change(a, b);
}

struct Jumps {
  double pixels = 0;
  double rate = 1;
};

/// Along every fourth row and column of pixels.
Jumps jumpsOf(const FocusMap& map, const glm::ivec2& size) {
  constexpr int kEvery = 4;
  constexpr int kPlaceHalvings = 30;   // to 1e-9 of a pixel
  constexpr int kRateHalvings = 8;     // to 1/256 of a pixel
  constexpr double kSmallStep = 0.02;  // from pixel to pixel: of factors, as a logarithm
  const auto distance = [&](const glm::dvec2& a, const glm::dvec2& b) {
    return glm::length(map.plainFromPicture(a) - map.plainFromPicture(b));
  };
  const auto logRate = [&](const glm::dvec2& at) { return std::log(ratesAt(map, at).x); };
  const auto factor = [&](const glm::dvec2& a, const glm::dvec2& b) { return std::abs(logRate(a) - logRate(b)); };
  const auto along = [&](int axis) {
    const int lines = (size[1 - axis] + kEvery - 1) / kEvery;
    return overRows<Jumps>(
        lines,
        [&](int line) {
          Jumps jumps;
          glm::dvec2 before(0.5);
          before[1 - axis] = line * kEvery + 0.5;
          double rateBefore = logRate(before);
          for (int i = 1; i < size[axis]; ++i) {
            glm::dvec2 at = before;
            at[axis] += 1;
            const double rate = logRate(at);
            if (distance(before, at) > jumps.pixels) {
              jumps.pixels = std::max(jumps.pixels, jumpBetween(before, at, distance, kPlaceHalvings));
            }
            if (const double step = std::abs(rate - rateBefore); step > std::max(kSmallStep, std::log(jumps.rate))) {
              jumps.rate = std::max(jumps.rate, std::exp(jumpBetween(before, at, factor, kRateHalvings)));
            }
            before = at;
            rateBefore = rate;
          }
          return jumps;
        },
        [](Jumps& all, const Jumps& row) {
          all = {std::max(all.pixels, row.pixels), std::max(all.rate, row.rate)};
        });
  };
  const Jumps across = along(0);
  const Jumps down = along(1);
  return {std::max(across.pixels, down.pixels), std::max(across.rate, down.rate)};
}

}  // namespace

FocusFigures focusFigures(const FocusMap& map, const GpcLayout& layout, const glm::ivec2& size) {
  const std::vector<FocusBox> contents = focusContents(layout, size);
  FocusFigures figures;
  const PictureSums picture = picturePart(map, contents, size);
  const size_t pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  figures.focusShare = static_cast<double>(picture.inFocus) / static_cast<double>(pixels);
  if (picture.inFocus > 0) {
    figures.leastFocusRate = picture.leastFocusRate;
    figures.greatestFocusRate = picture.greatestFocusRate;
  }
  if (picture.inFocus < pixels) {
    figures.leastContextRate = picture.leastContextRate;
  }
  const ContextSums context = contextPart(map, contents, size);
  const auto shareOfContext = [&](size_t part) {
    return static_cast<double>(part) / static_cast<double>(std::max<size_t>(context.context, 1));
  };
  figures.hiddenShare = shareOfContext(context.hidden);
  figures.sparseShare = shareOfContext(context.sparse);
  figures.focusBend = focusBend(map, contents, size);
  figures.contextBend = contextBend(map, contents, size);
  const Jumps jumps = jumpsOf(map, size);
  figures.jumpPixels = jumps.pixels;
  figures.rateStep = jumps.rate;
  return figures;
}

Image<float> pictureRates(const FocusMap& map, const glm::ivec2& size) {
  return rateImage(size, [&](const glm::dvec2& at) { return ratesAt(map, at).x; });
}

Image<float> plainRates(const FocusMap& map, const glm::ivec2& size) {
  return rateImage(size, [&](const glm::dvec2& plain) {
    const std::optional<glm::dvec2> at = shownAt(map, plain, size);
    return at ? ratesAt(map, *at).x : 0;
  });
}

}  // namespace ocelli
