#include "oc_core/miv/miv_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kMaxMivNameLength = 100;

bool isMivName(const std::string& name) {
  return !name.empty() && name.size() <= kMaxMivNameLength && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
  });
}

void requireMivName(const std::string& name) {
  if (!isMivName(name)) {
    throw InputError(fmt::format("\"{}\" is no name for files of this format", name), name,
                     "use up to 100 letters, digits, - and _");
  }
}

void validate(const MivView& view, double unitsPerMetre) {
  requireMivName(view.name);
  const int width = view.color.width();
  const int height = view.color.height();
  if (width != view.depth.width() || height != view.depth.height()) {
    throw InputError(
        fmt::format("its depth is {}x{}, and its colour {}x{}", view.depth.width(), view.depth.height(), width, height),
        view.name, "give both in one size");
  }
  if (width < 2 || height < 2 || width % 2 != 0 || height % 2 != 0) {
    throw InputError(fmt::format("its size is {}x{}, and chroma has a sample for each 2x2 pixels", width, height),
                     view.name, "use an even width and height");
  }
  ocelli::validate(view.view, view.name);
  bool hasDepth = false;
  for (size_t i = 0; i < view.depth.size(); ++i) {
    if (!(view.depth[i] >= 0) || !std::isfinite(view.depth[i])) {
      throw InputError(fmt::format("its depth at pixel ({}, {}) is negative or not a finite number",
                                   i % static_cast<size_t>(width), i / static_cast<size_t>(width)),
                       view.name, "0 stands for where nothing is seen");
    }
    hasDepth = hasDepth || view.depth[i] > 0;
  }
  if (!hasDepth) {
    throw InputError("this view has no depth at any pixel", view.name, "leave it out");
  }
  if (const double far = depthRangeOf(view, unitsPerMetre).far; far >= kMivInfinityMetres) {
    throw InputError(fmt::format("its farthest depth is {:.0f} m, and the test model takes {:.0f} m for infinity", far,
                                 kMivInfinityMetres),
                     view.name, "say how many units of the scene a metre has (--metre)");
  }
}

}  // namespace

void validate(const MivSequence& sequence) {
  requireMivName(sequence.content);
  if (!(sequence.unitsPerMetre > 0) || !std::isfinite(sequence.unitsPerMetre)) {
    throw InputError("a metre has a positive number of units", "--metre", "--metre 1");
  }
  if (sequence.views.empty()) {
    throw InputError("there are no views with depth", sequence.content, "give one at least");
  }
  std::set<std::string> names;
  for (const MivView& view : sequence.views) {
    validate(view, sequence.unitsPerMetre);
    if (!names.insert(view.name).second) {
      throw InputError("two views have this name", view.name, "rename one of them");
    }
  }
}

MivDepthRange depthRangeOf(const MivView& view, double unitsPerMetre) {
  constexpr double kMargin = 1e-3;
  double near = 0;
  double far = 0;
  for (const float depth : view.depth) {
    if (depth > 0) {
      const double metres = depth / unitsPerMetre;
      near = near > 0 ? std::min(near, metres) : metres;
      far = std::max(far, metres);
    }
  }
  return {near * (1 - kMargin), far * (1 + kMargin)};
}

std::string mivTextureFile(const std::string& name, int width, int height) {
  return fmt::format("{}_texture_{}x{}_yuv420p{}le.yuv", name, width, height, kMivColorBits);
}

std::string mivDepthFile(const std::string& name, int width, int height) {
  return fmt::format("{}_depth_{}x{}_yuv420p{}le.yuv", name, width, height, kMivDepthBits);
}

}  // namespace ocelli
