#include "oc_core/miv/miv_samples.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

// BT.709: weights of luma, and the ranges of 10 bits.
constexpr double kRed = 0.2126;
constexpr double kBlue = 0.0722;
constexpr double kGreen = 1 - kRed - kBlue;
constexpr double kBlack = 64;
constexpr double kLumaSteps = 876;  // from black to white
constexpr double kNeutral = 512;
constexpr double kChromaSteps = 896;  // from the least to the greatest
constexpr double kMaxColorLevel = (1 << kMivColorBits) - 1;
constexpr uint16_t kNeutralDepth = 1U << (kMivDepthBits - 1);

struct Ycc {
  double y = 0, cb = 0, cr = 0;  ///< y from 0 to 1, others from -0.5 to 0.5
};

Ycc yccOf(const glm::vec3& linear) {
  const glm::dvec3 rgb{srgbFromLinear(std::clamp(linear.x, 0.0f, 1.0f)),
                       srgbFromLinear(std::clamp(linear.y, 0.0f, 1.0f)),
                       srgbFromLinear(std::clamp(linear.z, 0.0f, 1.0f))};
  const double y = kRed * rgb.x + kGreen * rgb.y + kBlue * rgb.z;
  return {y, (rgb.z - y) / (2 * (1 - kBlue)), (rgb.x - y) / (2 * (1 - kRed))};
}

glm::vec3 linearOf(const Ycc& c) {
  const double red = c.y + 2 * (1 - kRed) * c.cr;
  const double blue = c.y + 2 * (1 - kBlue) * c.cb;
  const double green = (c.y - kRed * red - kBlue * blue) / kGreen;
  const auto linear = [](double encoded) { return linearFromSrgb(static_cast<float>(std::clamp(encoded, 0.0, 1.0))); };
  return {linear(red), linear(green), linear(blue)};
}

void put(std::string& bytes, size_t sample, uint16_t level) {
  bytes[2 * sample] = static_cast<char>(level & 0xffU);
  bytes[2 * sample + 1] = static_cast<char>(level >> 8U);
}

uint16_t get(std::string_view bytes, size_t sample) {
  return static_cast<uint16_t>(static_cast<uint8_t>(bytes[2 * sample]) | static_cast<uint8_t>(bytes[2 * sample + 1])
                                                                             << 8U);
}

uint16_t colorLevel(double value) {
  return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0, kMaxColorLevel)));
}

struct InverseDepths {
  double low;
  double step;
};

InverseDepths inverseDepthsOf(const MivDepthRange& range) {
  OC_CHECK(range.near > 0 && range.far > range.near, "a range of depths begins before it ends");
  return {1 / range.far, (1 / range.near - 1 / range.far) / kMaxMivDepthLevel};
}

}  // namespace

size_t mivFrameBytes(int width, int height) {
  return static_cast<size_t>(width) * static_cast<size_t>(height) * 3;
}

std::string mivTextureBytes(const Image<glm::vec3>& linearColor) {
  const auto width = static_cast<size_t>(linearColor.width());
  const int halfWidth = linearColor.width() / 2;
  const int halfHeight = linearColor.height() / 2;
  std::string bytes(mivFrameBytes(linearColor.width(), linearColor.height()), '\0');
  const size_t cbPlane = linearColor.size();
  const size_t crPlane = cbPlane + cbPlane / 4;
  size_t chroma = 0;
  for (int row = 0; row < halfHeight; ++row) {
    for (int column = 0; column < halfWidth; ++column, ++chroma) {
      Ycc sum;
      for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)}) {
        const int x = 2 * column + at.x;
        const int y = 2 * row + at.y;
        const Ycc ycc = yccOf(linearColor(x, y));
        put(bytes, static_cast<size_t>(y) * width + static_cast<size_t>(x), colorLevel(kBlack + kLumaSteps * ycc.y));
        sum.cb += ycc.cb;
        sum.cr += ycc.cr;
      }
      put(bytes, cbPlane + chroma, colorLevel(kNeutral + kChromaSteps * sum.cb / 4));
      put(bytes, crPlane + chroma, colorLevel(kNeutral + kChromaSteps * sum.cr / 4));
    }
  }
  return bytes;
}

Image<glm::vec3> colorsOfMivTexture(std::string_view bytes, int width, int height) {
  OC_CHECK(bytes.size() == mivFrameBytes(width, height), "the bytes are those of one frame");
  Image<glm::vec3> colors(width, height);
  const size_t cbPlane = colors.size();
  const size_t crPlane = cbPlane + cbPlane / 4;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t chroma = static_cast<size_t>(y / 2) * static_cast<size_t>(width / 2) + static_cast<size_t>(x / 2);
      colors(x, y) = linearOf({(get(bytes, colors.index(x, y)) - kBlack) / kLumaSteps,
                               (get(bytes, cbPlane + chroma) - kNeutral) / kChromaSteps,
                               (get(bytes, crPlane + chroma) - kNeutral) / kChromaSteps});
    }
  }
  return colors;
}

std::string mivDepthBytes(const Image<float>& depth, const MivDepthRange& range, double unitsPerMetre) {
  const InverseDepths inverse = inverseDepthsOf(range);
  std::string bytes(mivFrameBytes(depth.width(), depth.height()), '\0');
  for (size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] > 0) {
      const long level = std::lround((unitsPerMetre / depth[i] - inverse.low) / inverse.step);
      put(bytes, i, static_cast<uint16_t>(std::clamp(level, 1L, long{kMaxMivDepthLevel})));
    }
  }
  for (size_t i = depth.size(); i < bytes.size() / 2; ++i) {
    put(bytes, i, kNeutralDepth);
  }
  return bytes;
}

Image<float> depthsOfMivDepth(std::string_view bytes, int width, int height, const MivDepthRange& range,
                              double unitsPerMetre) {
  OC_CHECK(bytes.size() == mivFrameBytes(width, height), "the bytes are those of one frame");
  const InverseDepths inverse = inverseDepthsOf(range);
  Image<float> depth(width, height, 0);
  for (size_t i = 0; i < depth.size(); ++i) {
    const uint16_t level = get(bytes, i);
    if (level > 0) {
      depth[i] = static_cast<float>(unitsPerMetre / (inverse.low + inverse.step * level));
    }
  }
  return depth;
}

}  // namespace ocelli
