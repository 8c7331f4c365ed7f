#include "oc_core/worlds/printed_textures.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/surface_noise.h"

namespace ocelli {
namespace {

struct PaintedShape {
  glm::vec2 center{0};
  glm::vec2 half{1};
  float turn = 0;
  bool isRound = false;
  glm::vec3 color{1};
};

/// How far inside, in [0, 1], with a soft rim of a width.
float insideShape(const PaintedShape& shape, const glm::vec2& p, float rim) {
  const glm::vec2 d = p - shape.center;
  const float c = std::cos(shape.turn);
  const float s = std::sin(shape.turn);
  const glm::vec2 q = glm::abs(glm::vec2(c * d.x + s * d.y, c * d.y - s * d.x));
  const float outside = shape.isRound ? (glm::length(q / shape.half) - 1) * std::min(shape.half.x, shape.half.y)
                                      : std::max(q.x - shape.half.x, q.y - shape.half.y);
  return smoothEdge(rim, -rim, outside);
}

glm::vec3 strokes(const glm::vec3& color, const glm::vec2& p, uint32_t seed) {
  const float turn = 3 * layeredNoise(p * 3.0f, 2, seed);
  const float c = std::cos(turn);
  const float s = std::sin(turn);
  const float brush = layeredNoise({(c * p.x + s * p.y) * 12, (c * p.y - s * p.x) * 60}, 3, seed + 1);
  const float varnish = layeredNoise(p * 2.0f, 4, seed + 2);
  return color * (1 + 0.22f * brush + 0.12f * varnish);
}

glm::vec3 landscape(const glm::vec2& p, const glm::vec2& size, uint32_t seed) {
  const glm::vec2 t = p / size;
  const float warm = latticeNoise(1, 2, seed);
  const glm::vec3 high = glm::mix(palette::fromSrgbBytes(88, 130, 180), palette::fromSrgbBytes(120, 110, 150), warm);
  const glm::vec3 low = glm::mix(palette::fromSrgbBytes(214, 214, 200), palette::fromSrgbBytes(240, 190, 130), warm);
  glm::vec3 color = glm::mix(low, high, smoothEdge(0.35f, 1.0f, t.y));
  const float cloud = layeredNoise({p.x * 3.5f, p.y * 8}, 5, seed + 1);
  color = glm::mix(color, glm::vec3(0.86f, 0.82f, 0.76f), 0.8f * smoothEdge(0.0f, 0.45f, cloud));
  for (int ridge = 0; ridge < 4; ++ridge) {
    const auto k = static_cast<float>(ridge);
    const float top =
        0.58f - 0.13f * k + (0.16f - 0.02f * k) * layeredNoise({t.x * (2.5f + k), 3.7f * k}, 5, seed + 10 + ridge);
    const glm::vec3 far = palette::fromSrgbBytes(120, 140, 160);
    const glm::vec3 near = palette::fromSrgbBytes(70, 84, 40) * (0.7f + 0.6f * latticeNoise(ridge, 5, seed));
    const float leaves = layeredNoise(p * (10 + 8 * k), 4, seed + 20 + ridge);
    const glm::vec3 ground = glm::mix(far, near, 0.25f + 0.25f * k) * (1 + (0.15f + 0.2f * k) * leaves);
    color = glm::mix(color, ground, smoothEdge(0.012f, -0.012f, t.y - top));
  }
  return color;
}

glm::vec3 portrait(const glm::vec2& p, const glm::vec2& size, uint32_t seed) {
  const glm::vec2 t = (p - size * glm::vec2(0.5f, 0.56f)) / size.x;
  const auto any = [&](int k) { return latticeNoise(k, 3, seed); };
  glm::vec3 color = palette::fromSrgbBytes(70, 52, 36) * (0.8f + 0.8f * any(1)) *
                    (1 + 0.5f * layeredNoise(p * 4.0f, 4, seed)) * (1.5f - 1.2f * glm::length(t));
  const glm::vec3 coat = bindingColor(seed + 5) * 0.7f;
  const auto put = [&](const PaintedShape& shape) {
    color = glm::mix(color, shape.color, insideShape(shape, t, 0.01f));
  };
  const float fold = layeredNoise({t.x * 14, t.y * 4}, 4, seed + 2);
  put({{0, -0.52f}, {0.42f, 0.36f}, 0, true, coat * (1 + 0.5f * fold)});
  put({{0, -0.2f}, {0.16f, 0.05f}, 0, true, glm::vec3(0.75f, 0.72f, 0.66f) * (1 + 0.3f * fold)});
  const glm::vec3 skin = palette::fromSrgbBytes(214, 168, 136) * (0.75f + 0.35f * any(2));
  const float lit = 1 - 1.6f * t.x + 0.2f * layeredNoise(t * 9.0f, 3, seed + 3);
  put({{0, -0.15f}, {0.075f, 0.12f}, 0, true, skin * 0.75f * lit});
  put({{0, 0.08f}, {0.2f, 0.24f}, 0, true, palette::fromSrgbBytes(60, 40, 24) * (0.6f + any(3) * 1.6f) * (1 + fold)});
  put({{0.005f, 0.02f}, {0.14f, 0.185f}, 0, true, skin * lit});
  for (const float side : {-1.0f, 1.0f}) {
    put({{side * 0.055f, 0.045f}, {0.028f, 0.013f}, 0, true, glm::vec3(0.62f, 0.58f, 0.54f)});
    put({{side * 0.055f, 0.045f}, {0.012f, 0.013f}, 0, true, glm::vec3(0.05f, 0.04f, 0.04f)});
    put({{side * 0.055f, 0.078f}, {0.035f, 0.007f}, side * -0.1f, true, skin * 0.35f});
  }
  put({{0.008f, -0.01f}, {0.015f, 0.045f}, 0, true, skin * 1.15f * lit});
  put({{0, -0.085f}, {0.045f, 0.012f}, 0, true, palette::fromSrgbBytes(150, 70, 66)});
  return color;
}

std::vector<PaintedShape> composition(const glm::vec2& size, uint32_t seed) {
  Random random(seed);
  std::vector<PaintedShape> shapes;
  const size_t count = 14 + random.below(14);
  for (size_t i = 0; i < count; ++i) {
    PaintedShape shape;
    shape.center = {random.inRange(0, size.x), random.inRange(0, size.y)};
    const float reach = random.inRange(0.05f, 0.32f) * std::min(size.x, size.y);
    shape.half = {reach, reach * random.inRange(0.2f, 1.1f)};
    shape.turn = random.inRange(-1.6f, 1.6f);
    shape.isRound = random.below(3) == 0;
    shape.color = bindingColor(static_cast<uint32_t>(random.next())) * random.inRange(0.9f, 1.8f);
    shapes.push_back(shape);
  }
  return shapes;
}

/// A line of writing or drawing: how dark at `p`, of a polyline that wanders.
float inkOfScribble(const glm::vec2& p, const glm::vec2& center, float radius, uint32_t seed) {
  const glm::vec2 d = p - center;
  const float angle = std::atan2(d.y, d.x);
  const float wanted = radius * (0.7f + 0.5f * layeredNoise({angle * 1.2f, radius * 9}, 3, seed));
  return smoothEdge(0.012f, 0.004f, std::abs(glm::length(d) - wanted));
}

}  // namespace

glm::vec3 bindingColor(uint32_t seed) {
  static const std::array<glm::vec3, 14> kColors{
      palette::fromSrgbBytes(112, 36, 34),  palette::fromSrgbBytes(36, 58, 98),   palette::fromSrgbBytes(40, 78, 56),
      palette::fromSrgbBytes(146, 104, 58), palette::fromSrgbBytes(64, 48, 40),   palette::fromSrgbBytes(196, 176, 138),
      palette::fromSrgbBytes(176, 64, 40),  palette::fromSrgbBytes(96, 96, 100),  palette::fromSrgbBytes(214, 206, 190),
      palette::fromSrgbBytes(70, 40, 76),   palette::fromSrgbBytes(206, 150, 46), palette::fromSrgbBytes(52, 110, 124),
      palette::fromSrgbBytes(140, 130, 92), palette::fromSrgbBytes(44, 42, 46)};
  Random random(seed);
  const glm::vec3 color = kColors[random.below(kColors.size())];
  const float light = random.inRange(0.7f, 1.35f);
  return color * light * glm::vec3(random.inRange(0.88f, 1.12f), 1, random.inRange(0.88f, 1.12f));
}

float inkOfText(const glm::vec2& p, float letterHeight, uint32_t seed) {
  const float line = letterHeight * 1.7f;
  const float row = std::floor(p.y / line);
  const float up = (p.y - row * line) / letterHeight;
  if (up > 1) {
    return 0;
  }
  const float width = letterHeight * 0.62f;
  const float column = std::floor(p.x / width);
  const float across = (p.x - column * width) / width;
  const auto r = static_cast<int>(row);
  const auto c = static_cast<int>(column);
  // Words of one to nine letters: a space where the noise of the place says so.
  if (across > 0.82f || latticeNoise(c, r, seed) < 0.17f) {
    return 0;
  }
  // Strokes of three by five parts, of which a bit more than half are inked.
  const auto sx = static_cast<int>(across / 0.82f * 3);
  const auto sy = static_cast<int>(up * 5);
  return latticeNoise(c * 3 + sx, r * 5 + sy, seed + 1) < 0.56f ? 1.0f : 0.0f;
}

SurfaceTexture paintingTexture(const glm::vec2& size, uint32_t seed) {
  const auto kind =
      static_cast<int>(latticeNoise(static_cast<int>(seed % 65536), static_cast<int>(seed / 65536), 11) * 4);
  if (kind == 0 || kind == 1) {
    return [=](const glm::vec2& p) {
      return strokes(kind == 0 ? landscape(p, size, seed) : portrait(p, size, seed), p, seed + 50);
    };
  }
  const auto shapes = std::make_shared<std::vector<PaintedShape>>(composition(size, seed));
  const glm::vec3 ground = bindingColor(seed + 3) * 1.6f + glm::vec3(0.08f);
  return [=](const glm::vec2& p) {
    glm::vec3 color = ground * (1 + 0.3f * layeredNoise(p * 2.5f, 4, seed));
    for (const PaintedShape& shape : *shapes) {
      const float shadow = insideShape(shape, p + glm::vec2(-0.015f, 0.015f), 0.02f);
      color *= 1 - 0.35f * shadow;
      const float form = 1 + (kind == 2 ? 2.2f : 0.5f) * (shape.center.y - p.y + p.x - shape.center.x);
      color = glm::mix(color, shape.color * std::clamp(form, 0.4f, 1.7f), insideShape(shape, p, 0.006f));
    }
    return strokes(color, p, seed + 50);
  };
}

SurfaceTexture spineTexture(const glm::vec2& size, uint32_t seed) {
  Random random(seed);
  const glm::vec3 cover = bindingColor(seed);
  const bool isLight = cover.x + cover.y + cover.z > 0.9f;
  const glm::vec3 ink = isLight ? glm::vec3(0.07f, 0.06f, 0.06f)
                                : glm::mix(palette::fromSrgbBytes(226, 190, 96), palette::fromSrgbBytes(236, 230, 216),
                                           random.below(2) == 0 ? 0.0f : 1.0f);
  const bool hasBands = random.below(3) == 0;
  const bool hasLabel = random.below(3) == 0;
  const glm::vec3 label = bindingColor(seed + 1);
  const float letter = std::clamp(size.x * random.inRange(0.3f, 0.55f), 0.008f, 0.03f);
  const float titleFrom = size.y * random.inRange(0.2f, 0.35f);
  const float titleTo = size.y * random.inRange(0.6f, 0.9f);
  const float bandStep = size.y / static_cast<float>(4 + random.below(3));
  return [=](const glm::vec2& p) {
    const float wear = layeredNoise(p * 30.0f, 3, seed + 2);
    const float fade = layeredNoise({p.x * 8, p.y * 3}, 3, seed + 3);
    glm::vec3 color = cover * (1 + 0.16f * wear + 0.18f * fade);
    if (hasLabel && p.y > titleFrom - 0.01f && p.y < titleTo + 0.01f) {
      color = label * (1 + 0.15f * wear);
    }
    if (hasBands) {
      const float band = std::abs(p.y - std::round(p.y / bandStep) * bandStep);
      color *= 1 - 0.45f * smoothEdge(0.008f, 0.002f, std::abs(band - 0.006f)) + 0.25f * smoothEdge(0.006f, 0.0f, band);
    }
    if (p.y > titleFrom && p.y < titleTo && p.x > 0.2f * size.x && p.x < 0.8f * size.x) {
      // Read from the bottom up.
      const glm::vec2 along(p.y - titleFrom, size.x / 2 + letter / 2 - p.x);
      if (along.y > 0 && along.y < letter) {
        color = glm::mix(color, ink, 0.9f * inkOfText(along, letter, seed + 4));
      }
    }
    if (p.y < 0.045f && p.y > 0.02f && p.x > 0.18f * size.x && p.x < 0.82f * size.x) {
      color = glm::mix(glm::vec3(0.7f, 0.68f, 0.62f), ink * 0.3f, inkOfText(p, 0.012f, seed + 5));
    }
    // The spine is round: it is lighter in the middle, and rubbed at its ends.
    const float round = 1 - 0.4f * std::pow(std::abs(2 * p.x / size.x - 1), 3.0f);
    const float rubbed = smoothEdge(0.012f, 0.0f, std::min(p.y, size.y - p.y));
    return glm::mix(color * round, glm::vec3(0.4f, 0.35f, 0.28f), 0.4f * rubbed);
  };
}

SurfaceTexture folderTexture(const glm::vec2& size, uint32_t seed) {
  const glm::vec3 cover = bindingColor(seed) * 1.25f;
  return [=](const glm::vec2& p) {
    glm::vec3 color =
        cover * (1 + 0.1f * layeredNoise(p * 26.0f, 3, seed + 1) + 0.12f * layeredNoise(p * 4.0f, 3, seed + 2));
    const float hole = glm::length(p - glm::vec2(size.x / 2, 0.07f));
    color = glm::mix(color, glm::vec3(0.45f), smoothEdge(0.018f, 0.014f, hole));
    color = glm::mix(color, glm::vec3(0.035f), smoothEdge(0.012f, 0.009f, hole));
    if (p.x > 0.15f * size.x && p.x < 0.85f * size.x && p.y > 0.42f * size.y && p.y < 0.9f * size.y) {
      const float ink = inkOfText({p.y, p.x}, 0.016f, seed + 3);
      color = glm::mix(glm::vec3(0.78f, 0.76f, 0.7f), glm::vec3(0.06f, 0.06f, 0.12f), 0.85f * ink);
    }
    return color;
  };
}

SurfaceTexture posterTexture(const glm::vec2& size, uint32_t seed) {
  const glm::vec3 ground = glm::mix(bindingColor(seed), glm::vec3(0.8f), 0.5f * latticeNoise(2, 2, seed) + 0.2f);
  const glm::vec3 ink = bindingColor(seed + 1) * 0.45f;
  const glm::vec2 picture = size * glm::vec2(0.84f, 0.46f);
  const SurfaceTexture image = paintingTexture(picture, seed + 2);
  return [=](const glm::vec2& p) {
    const float paper = 1 + 0.05f * layeredNoise(p * 25.0f, 3, seed + 3) + 0.07f * layeredNoise(p * 2.0f, 3, seed + 4);
    const glm::vec2 from(0.08f * size.x, 0.34f * size.y);
    const glm::vec2 q = p - from;
    if (q.x > 0 && q.y > 0 && q.x < picture.x && q.y < picture.y) {
      return image(q) * paper;
    }
    float dark = 0;
    if (p.x > from.x && p.x < size.x - from.x) {
      const float line = 0.09f * size.y;
      if (p.y > 0.84f * size.y && p.y < 0.84f * size.y + line) {
        dark = inkOfText({p.x, p.y - 0.84f * size.y}, line * 0.95f, seed + 5);
      } else if (p.y < 0.3f * size.y && p.y > 0.06f * size.y) {
        dark = inkOfText(p, 0.018f, seed + 6);
      }
    }
    return glm::mix(ground, ink, 0.9f * dark) * paper;
  };
}

SurfaceTexture paperTexture(const glm::vec2& size, uint32_t seed) {
  const bool hasFigure = latticeNoise(7, 1, seed) < 0.4f;
  return [=](const glm::vec2& p) {
    const glm::vec3 sheet = glm::vec3(0.78f, 0.77f, 0.73f) * (1 + 0.06f * layeredNoise(p * 9.0f, 3, seed));
    const glm::vec2 m(0.1f * size.x, 0.08f * size.y);
    if (p.x < m.x || p.y < m.y || p.x > size.x - m.x || p.y > size.y - m.y) {
      return sheet;
    }
    if (hasFigure && p.y > 0.55f * size.y) {
      const float bar = latticeNoise(static_cast<int>(p.x / 0.02f), 9, seed) * 0.35f * size.y;
      return p.y - 0.55f * size.y < bar ? bindingColor(seed + static_cast<uint32_t>(p.x / 0.02f)) * 1.3f : sheet;
    }
    return glm::mix(sheet, glm::vec3(0.12f), 0.7f * inkOfText(p, 0.009f, seed + 1));
  };
}

SurfaceTexture screenTexture(const glm::vec2& size, uint32_t seed) {
  const SurfaceTexture picture = paintingTexture(size * 0.4f, seed + 4);
  return [=](const glm::vec2& p) {
    const glm::vec2 t = p / size;
    glm::vec3 color = glm::mix(glm::vec3(0.05f, 0.12f, 0.3f), glm::vec3(0.2f, 0.1f, 0.35f), t.x) *
                      (1 + 0.5f * layeredNoise(p * 5.0f, 4, seed));
    if (t.x > 0.06f && t.x < 0.56f && t.y > 0.12f && t.y < 0.92f) {  // an editor
      const float ink = inkOfText(p, 0.011f, seed + 1);
      const auto line = static_cast<int>(p.y / 0.0187f);
      const bool isWritten = t.x < 0.12f + 0.42f * latticeNoise(line, 4, seed);
      const glm::vec3 text = bindingColor(seed + static_cast<uint32_t>(line)) * 2.0f + 0.15f;
      color = t.y > 0.88f ? glm::vec3(0.35f) : glm::mix(glm::vec3(0.035f, 0.04f, 0.05f), text, isWritten ? ink : 0.0f);
    }
    if (t.x > 0.5f && t.x < 0.94f && t.y > 0.3f && t.y < 0.8f) {  // a picture over it
      color = t.y > 0.75f ? glm::vec3(0.55f, 0.55f, 0.6f) : picture(p - size * glm::vec2(0.5f, 0.3f));
    }
    if (t.y < 0.06f) {
      color = glm::vec3(0.06f) + 0.4f * bindingColor(seed + static_cast<uint32_t>(p.x / 0.03f));
    }
    return glm::clamp(color * 1.15f + 0.02f, glm::vec3(0.03f), glm::vec3(1));
  };
}

SurfaceTexture whiteboardTexture(const glm::vec2& size, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float wiped = layeredNoise({p.x * 2 + p.y, p.y * 7}, 4, seed);
    glm::vec3 color =
        glm::vec3(0.83f, 0.85f, 0.86f) * (1 + 0.06f * wiped + 0.02f * layeredNoise(p * 30.0f, 2, seed + 1));
    const std::array<glm::vec3, 3> pens{glm::vec3(0.05f, 0.08f, 0.35f), glm::vec3(0.5f, 0.05f, 0.05f),
                                        glm::vec3(0.03f, 0.25f, 0.1f)};
    const glm::vec2 m = size * 0.06f;
    if (p.x > m.x && p.x < 0.5f * size.x && p.y > 0.3f * size.y && p.y < size.y - m.y) {
      const glm::vec2 slanted(p.x + 0.15f * p.y + 0.01f * layeredNoise(p * 6.0f, 2, seed + 2), p.y + 0.03f * p.x);
      const auto line = static_cast<uint32_t>(p.y / 0.25f);
      color = glm::mix(color, pens[line % 3], 0.8f * inkOfText(slanted, 0.05f, seed + 3));
    }
    for (uint32_t i = 0; i < 6; ++i) {
      const glm::vec2 center(size.x * (0.6f + 0.13f * static_cast<float>(i % 3)),
                             size.y * (0.32f + 0.36f * static_cast<float>(i / 3)));
      color = glm::mix(color, pens[i % 3], 0.85f * inkOfScribble(p, center, 0.13f, seed + 10 + i));
    }
    return color;
  };
}

SurfaceTexture keyboardTexture(const glm::vec2& size, uint32_t seed) {
  return [=](const glm::vec2& p) {
    constexpr float kKey = 0.019f;
    const float x = p.x + 0.006f * std::floor(p.y / kKey);
    const float edge = std::min(std::min(x - std::floor(x / kKey) * kKey, std::ceil(x / kKey) * kKey - x),
                                std::min(p.y - std::floor(p.y / kKey) * kKey, std::ceil(p.y / kKey) * kKey - p.y));
    const bool isKey = edge > 0.002f && p.x > 0.01f && p.x < size.x - 0.01f;
    const float tint = latticeNoise(static_cast<int>(x / kKey), static_cast<int>(p.y / kKey), seed);
    return glm::vec3(isKey ? 0.10f + 0.16f * tint : 0.035f) * (1 + 0.2f * layeredNoise(p * 40.0f, 2, seed));
  };
}

SurfaceTexture outdoorsTexture(const glm::vec2& size, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float t = p.y / size.y;
    const float cloud = smoothEdge(-0.1f, 0.5f, layeredNoise({p.x * 1.6f, p.y * 3}, 5, seed));
    glm::vec3 color = glm::mix(glm::vec3(0.42f, 0.62f, 0.92f), glm::vec3(0.92f), cloud);
    for (int row = 0; row < 3; ++row) {  // houses behind one another
      const auto k = static_cast<float>(row);
      const float width = 0.55f - 0.1f * k;
      const auto house = static_cast<int>(std::floor((p.x + 0.3f * k) / width));
      const float top = 0.5f - 0.12f * k + 0.14f * latticeNoise(house, row, seed);
      if (t < top) {
        const glm::vec2 q(p.x - static_cast<float>(house) * width, (top - t) * size.y);
        const bool isPane = std::fmod(q.x + 10, 0.11f) < 0.05f && std::fmod(q.y, 0.13f) > 0.06f;
        const glm::vec3 wall = bindingColor(seed + static_cast<uint32_t>(house * 7 + row)) + 0.25f;
        color = isPane ? glm::vec3(0.12f, 0.15f, 0.2f) : wall * (1 + 0.12f * layeredNoise(p * 20.0f, 3, seed + 2));
      }
    }
    const float hedge = 0.2f + 0.12f * layeredNoise({p.x * 2, 1}, 4, seed + 3);
    if (t < hedge) {
      color = glm::vec3(0.1f, 0.22f, 0.06f) * (1 + 0.9f * layeredNoise(p * 12.0f, 4, seed + 4));
    }
    return color;
  };
}

}  // namespace ocelli
