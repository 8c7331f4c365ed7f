#include "oc_core/shade/shadow_figures.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

using ShadowValue = std::optional<double>;

struct ShadowColumn {
  FigureColumn column;
  ShadowValue (*value)(const BuiltShadow&, const ShadowFigures&);
};

ShadowValue anyShadow(double number) {
  return number > 0 ? ShadowValue(number) : std::nullopt;
}

double eachReceiver(double number, const ShadowFigures& f) {
  return f.asked > 0 ? number / static_cast<double>(f.asked) : 0;
}

const std::vector<ShadowColumn>& allShadowColumns() {
  static const std::vector<ShadowColumn> columns{
      {{"receivers", nullptr, "pixels of objects that receive light, which the light shines at", 0, 1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return static_cast<double>(f.receivers); }},
      {{"in_penumbra", nullptr, "those of them that see the light in part", 0, 1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return static_cast<double>(f.inPenumbra); }},
      {{"rmse", "RMSE", "of visibility (0 to 1) against 1,024 traced rays, over the pixels that receive light", 4, 1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return f.rmse; }},
      {{"penumbra_rmse", "penumbra", "the same over pixels that see the light in part", 4, 1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return f.penumbraRmse; }},
      {{"on_others_rmse", "on others", "the same over pixels of objects that no image stands for, such as floors", 4,
        1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue {
         return f.onOthers > 0 ? ShadowValue(f.onOthersRmse) : std::nullopt;
       }},
      {{"wrong", "wrong %", "pixels whose visibility is off by more than 0.1", 2, 100},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return f.wrong; }},
      {{"signed_mean", "mean error", "of visibility: positive where light leaks", 4, 1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return f.signedMean; }},
      {{"estimate", "expected", "the RMSE that the way itself expects, of what its images hold", 4, 1},
       [](const BuiltShadow&, const ShadowFigures& f) { return f.estimate; }},
      {{"samples", "samples", "of the images", 0, 1},
       [](const BuiltShadow& b, const ShadowFigures&) { return anyShadow(static_cast<double>(b.samples)); }},
      {{"edges", "edges", "of their surfaces, which may be outlines", 0, 1},
       [](const BuiltShadow& b, const ShadowFigures&) { return anyShadow(static_cast<double>(b.edges)); }},
      {{"elements", "looked at", "edges, nodes, texels or squares of texels, a pixel", 1, 1},
       [](const BuiltShadow&, const ShadowFigures& f) {
         return anyShadow(eachReceiver(static_cast<double>(f.work.elements), f));
       }},
      {{"rays", "rays", "a pixel", 1, 1},
       [](const BuiltShadow&, const ShadowFigures& f) {
         return anyShadow(eachReceiver(static_cast<double>(f.work.rays), f));
       }},
      {{"build_ms", "build ms", "of the images", 1, 1},
       [](const BuiltShadow& b, const ShadowFigures&) { return anyShadow(b.buildMilliseconds); }},
      {{"structure_ms", "tree ms", "of edges and their hierarchy, and of acceleration structures", 1, 1},
       [](const BuiltShadow& b, const ShadowFigures&) -> ShadowValue { return b.structureMilliseconds; }},
      {{"shadow_ms", "shadow ms", "of the visibility of all pixels, on all threads", 1, 1},
       [](const BuiltShadow&, const ShadowFigures& f) -> ShadowValue { return f.milliseconds; }},
  };
  return columns;
}

Rgb8 mixed(const Rgb8& from, const Rgb8& to, double share) {
  Rgb8 color;
  for (int i = 0; i < 3; ++i) {
    color[i] = static_cast<uint8_t>(std::lround(from[i] + (to[i] - from[i]) * share));
  }
  return color;
}

}  // namespace

ShadowFigures shadowFigures(const ShadowPixels& pixels, const std::vector<float>& truth, const LightVisibility& found) {
  ShadowFigures figures;
  double squares = 0;
  double penumbraSquares = 0;
  double onOthersSquares = 0;
  double sum = 0;
  double expected = 0;
  size_t wrong = 0;
  for (size_t i = 0; i < pixels.pixels.size(); ++i) {
    if (!pixels.pixels[i].isMeasured) {
      continue;
    }
    const double error = static_cast<double>(found.share[i]) - static_cast<double>(truth[i]);
    ++figures.receivers;
    squares += error * error;
    sum += error;
    wrong += std::abs(error) > ShadowFigures::kWrong;
    if (truth[i] > 0 && truth[i] < 1) {
      ++figures.inPenumbra;
      penumbraSquares += error * error;
    }
    if (!pixels.receivers[i].isSampled) {
      ++figures.onOthers;
      onOthersSquares += error * error;
    }
    if (!found.estimatedError.empty()) {
      expected += static_cast<double>(found.estimatedError[i]) * static_cast<double>(found.estimatedError[i]);
    }
  }
  const double count = std::max<double>(1, static_cast<double>(figures.receivers));
  figures.rmse = std::sqrt(squares / count);
  figures.penumbraRmse = std::sqrt(penumbraSquares / std::max<double>(1, static_cast<double>(figures.inPenumbra)));
  figures.onOthersRmse = std::sqrt(onOthersSquares / std::max<double>(1, static_cast<double>(figures.onOthers)));
  figures.wrong = static_cast<double>(wrong) / count;
  figures.signedMean = sum / count;
  if (!found.estimatedError.empty()) {
    figures.estimate = std::sqrt(expected / count);
  }
  figures.work = found.work;
  figures.asked = pixels.pixels.size();
  return figures;
}

std::vector<FigureColumn> shadowColumns() {
  std::vector<FigureColumn> columns;
  for (const ShadowColumn& each : allShadowColumns()) {
    columns.push_back(each.column);
  }
  return columns;
}

std::vector<std::optional<double>> shadowFigureRow(const BuiltShadow& built, const ShadowFigures& figures) {
  std::vector<std::optional<double>> row;
  for (const ShadowColumn& each : allShadowColumns()) {
    row.push_back(each.value(built, figures));
  }
  return row;
}

Image<Rgb8> shadowErrorImage(const ShadowPixels& pixels, const std::vector<float>& truth,
                             const std::vector<float>& found, double full) {
  const Rgb8 right(255);
  Image<Rgb8> image(pixels.base.width(), pixels.base.height(), Rgb8(190));
  for (size_t i = 0; i < pixels.pixels.size(); ++i) {
    const ShadowPixel& pixel = pixels.pixels[i];
    if (pixel.isMeasured) {
      const double error = static_cast<double>(found[i]) - static_cast<double>(truth[i]);
      image[pixel.pixel] =
          mixed(right, error < 0 ? kTooDarkColor : kTooLightColor, std::min(1.0, std::abs(error) / full));
    }
  }
  return image;
}

}  // namespace ocelli
