#include "display_sim/observing/tone.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <vector>

namespace ocelli {
namespace {

float brightest(const glm::vec3& color) {
  return std::max({color.x, color.y, color.z});
}

glm::vec3 curved(const glm::vec3& x, ToneCurve curve) {
  switch (curve) {
    case ToneCurve::kClip:
      break;
    case ToneCurve::kReinhard:
      return x / (1 + glm::dot(x, glm::vec3(0.2126f, 0.7152f, 0.0722f)));
    case ToneCurve::kFilmic:
      return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
  }
  return x;
}

/// None for an image without light.
std::optional<double> gainOf(const Image<glm::vec3>& light) {
  std::vector<float> lit;
  for (const glm::vec3& pixel : light) {
    if (brightest(pixel) > 0) {
      lit.push_back(brightest(pixel));
    }
  }
  if (lit.empty()) {
    return std::nullopt;
  }
  const auto percentile = lit.begin() + static_cast<std::ptrdiff_t>((lit.size() - 1) * 99 / 100);
  std::ranges::nth_element(lit, percentile);
  return 0.95 / static_cast<double>(*percentile);
}

}  // namespace

double automaticGain(const Image<glm::vec3>& light) {
  return gainOf(light).value_or(1);
}

void CommonGain::add(const Image<glm::vec3>& light) {
  if (const std::optional<double> gain = gainOf(light)) {
    least_ = std::min(*gain, least_.value_or(*gain));
  }
}

void applyTone(Image<glm::vec3>& image, const Tone& tone) {
  const auto gain = static_cast<float>(tone.gain);
  const auto exponent = static_cast<float>(1 / tone.gamma);
  for (glm::vec3& pixel : image) {
    pixel = curved(pixel * gain, tone.curve);
    if (tone.gamma != 1) {
      pixel = glm::pow(pixel, glm::vec3(exponent));
    }
  }
}

}  // namespace ocelli
