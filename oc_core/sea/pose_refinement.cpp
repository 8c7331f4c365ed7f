#include "oc_core/sea/pose_refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlopt.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr int kNoAlgorithm = -1;
constexpr std::array kMethods{
    PoseRefinementMethod{"none", "poses are taken as they are", kNoAlgorithm},
    PoseRefinementMethod{"bobyqa", "Powell's quadratic models within bounds", nlopt::LN_BOBYQA},
    PoseRefinementMethod{"subplex", "Rowan's Subplex", nlopt::LN_SBPLX}};

constexpr double kMaxTurn = radiansFromDegrees(5);
constexpr int kMaxEvaluations = 120;
constexpr double kMinSeen = 0.1;

double lumaDifference(const Rgb8& a, const Rgb8& b) {
  return std::abs(0.299 * (int{a.r} - int{b.r}) + 0.587 * (int{a.g} - int{b.g}) + 0.114 * (int{a.b} - int{b.b}));
}

}  // namespace

std::span<const PoseRefinementMethod> poseRefinementMethods() {
  return kMethods;
}

const PoseRefinementMethod& requirePoseRefinement(const std::string& name, const std::string& where) {
  std::string known;
  for (const PoseRefinementMethod& method : kMethods) {
    if (name == method.name) {
      return method;
    }
    known += known.empty() ? method.name : std::string(", ") + method.name;
  }
  throw InputError(fmt::format("no way to refine poses is called \"{}\"", name), where, "choose one of " + known);
}

double comparisonEnergy(const PoseComparison& comparison, const PoseOffset& offset) {
  const SeaPose moved = movedBy(comparison.targetPose, offset.translation, offset.rotation);
  const WarpMap map =
      makeWarpMap(comparison.proxy, {comparison.projection, moved}, {comparison.projection, comparison.referencePose});
  const Image<Rgb8> warped = warpedImage(comparison.reference, map);
  double sum = 0;
  size_t seen = 0;
  for (size_t i = 0; i < map.size(); ++i) {
    if (isSeen(map[i])) {
      sum += lumaDifference(warped[i], comparison.target[i]);
      ++seen;
    }
  }
  const bool isEnough = static_cast<double>(seen) >= kMinSeen * static_cast<double>(map.size());
  return isEnough ? sum / static_cast<double>(seen) : std::numeric_limits<double>::infinity();
}

PoseOffset refinedPose(const PoseComparison& comparison, const PoseRefinementMethod& method, double reach) {
  PoseOffset best;
  if (method.algorithm == kNoAlgorithm || !(reach > 0)) {
    return best;
  }
  double least = comparisonEnergy(comparison, best);
  // The first three in shares of the reach, the others of the turn.
  const auto offsetOf = [&](const std::vector<double>& x) {
    return PoseOffset{glm::dvec3(x[0], x[1], x[2]) * reach, glm::dvec3(x[3], x[4], x[5]) * kMaxTurn};
  };
  auto energy = [&](const std::vector<double>& x) {
    const PoseOffset offset = offsetOf(x);
    // NLopt wants numbers: what is seen too little of is worse than any image.
    const double found = std::min(comparisonEnergy(comparison, offset), 256.0);
    if (found < least) {
      least = found;
      best = offset;
    }
    return found;
  };
  constexpr unsigned kParameters = 6;
  nlopt::opt search(static_cast<nlopt::algorithm>(method.algorithm), kParameters);
  search.set_lower_bounds(-1);
  search.set_upper_bounds(1);
  search.set_initial_step(0.1);
  search.set_xtol_rel(1e-3);
  search.set_xtol_abs(1e-4);
  search.set_maxeval(kMaxEvaluations);
  using Energy = decltype(energy);
  search.set_min_objective([](const std::vector<double>& x, std::vector<double>& /*gradient*/,
                              void* data) { return (*static_cast<Energy*>(data))(x); },
                           &energy);
  std::vector<double> x(kParameters, 0.0);
  double found = 0;
  try {
    search.optimize(x, found);
  } catch (const nlopt::roundoff_limited&) {
    // It cannot get any better.
  }
  return best;
}

Image<Rgb8> reducedImage(const Image<Rgb8>& image, int width, int height) {
  OC_CHECK(width > 0 && height > 0 && width <= image.width() && height <= image.height(), "images become smaller");
  Image<Rgb8> reduced(width, height);
  for (int y = 0; y < height; ++y) {
    const int top = static_cast<int>(int64_t{y} * image.height() / height);
    const int bottom = static_cast<int>(int64_t{y + 1} * image.height() / height);
    for (int x = 0; x < width; ++x) {
      const int left = static_cast<int>(int64_t{x} * image.width() / width);
      const int right = static_cast<int>(int64_t{x + 1} * image.width() / width);
      glm::uvec3 sum(0);
      for (int row = top; row < bottom; ++row) {
        for (int column = left; column < right; ++column) {
          sum += glm::uvec3(image(column, row));
        }
      }
      const auto count = static_cast<unsigned>((bottom - top) * (right - left));
      reduced(x, y) = Rgb8((sum + count / 2) / count);
    }
  }
  return reduced;
}

}  // namespace ocelli
