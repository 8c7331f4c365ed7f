// fillUnseen(): a pyramid of means over what is seen.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "oc_core/sea/warped_image.h"

namespace ocelli {
namespace {

constexpr int kBlock = 8;  ///< pixels a side, of the finest level
constexpr int kStep = 2;   ///< of the pixels of a block that count

/// Sums of colours, and in w how much was summed up.
using Sums = Image<glm::vec4>;

Sums blockSums(const Image<Rgb8>& image, const WarpMap& map) {
  Sums sums((image.width() + kBlock - 1) / kBlock, (image.height() + kBlock - 1) / kBlock, glm::vec4(0));
  for (int y = 0; y < image.height(); y += kStep) {
    for (int x = 0; x < image.width(); x += kStep) {
      if (isSeen(map(x, y))) {
        sums(x / kBlock, y / kBlock) += glm::vec4(glm::vec3(image(x, y)), 1);
      }
    }
  }
  return sums;
}

Sums halved(const Sums& finer) {
  Sums sums((finer.width() + 1) / 2, (finer.height() + 1) / 2, glm::vec4(0));
  for (int y = 0; y < finer.height(); ++y) {
    for (int x = 0; x < finer.width(); ++x) {
      // What is seen little of counts as little; but full blocks do not outweigh what is next to a hole.
      const glm::vec4& sum = finer(x, y);
      sums(x / 2, y / 2) += sum.w > 1 ? sum / sum.w : sum;
    }
  }
  return sums;
}

/// Bilinearly between the middles of blocks of so many pixels; `at` in pixels.
glm::vec3 between(const Image<glm::vec3>& means, const glm::vec2& at, float block) {
  const glm::vec2 place = at / block - 0.5f;
  const glm::vec2 corner = glm::floor(place);
  const glm::vec2 share = place - corner;
  const auto mean = [&](int right, int down) {
    return means(std::clamp(static_cast<int>(corner.x) + right, 0, means.width() - 1),
                 std::clamp(static_cast<int>(corner.y) + down, 0, means.height() - 1));
  };
  return glm::mix(glm::mix(mean(0, 0), mean(1, 0), share.x), glm::mix(mean(0, 1), mean(1, 1), share.x), share.y);
}

}  // namespace

void fillUnseen(Image<Rgb8>& image, const WarpMap& map) {
  if (std::all_of(map.begin(), map.end(), isSeen)) {
    return;
  }
  std::vector<Sums> levels{blockSums(image, map)};
  while (levels.back().size() > 1) {
    levels.push_back(halved(levels.back()));
  }
  constexpr float kGrey = 128;
  const glm::vec4& all = levels.back()[0];
  Image<glm::vec3> means(1, 1, all.w > 0 ? glm::vec3(all) / all.w : glm::vec3(kGrey));
  for (size_t level = levels.size() - 1; level-- > 0;) {
    const Sums& sums = levels[level];
    Image<glm::vec3> finer(sums.width(), sums.height());
    for (int y = 0; y < sums.height(); ++y) {
      for (int x = 0; x < sums.width(); ++x) {
        const glm::vec4& sum = sums(x, y);
        const float known = std::min(sum.w, 1.0f);
        const glm::vec3 own = sum.w > 0 ? glm::vec3(sum) / sum.w : glm::vec3(0);
        finer(x, y) = known >= 1 ? own : glm::mix(between(means, glm::vec2(x, y) + 0.5f, 2), own, known);
      }
    }
    means = std::move(finer);
  }
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!isSeen(map(x, y))) {
        const glm::vec3 color = between(means, glm::vec2(x, y) + 0.5f, kBlock);
        image(x, y) = Rgb8(glm::clamp(color + 0.5f, 0.0f, 255.0f));
      }
    }
  }
}

}  // namespace ocelli
