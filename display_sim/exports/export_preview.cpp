#include "display_sim/exports/export_preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "display_sim/exports/export_apng.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/observing/tone.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr double kTiltRadians = 0.2;
/// Light of the far side of the display, against 1 of the near side: so that front and back are told apart.
constexpr double kFarLight = 0.35;
/// Around what is lit.
constexpr double kMargin = 1.05;
constexpr size_t kTurnImages = 60;
constexpr uint16_t kTurnMilliseconds = 83;
constexpr size_t kMaxImages = 120;
constexpr double kSwayRadians = 0.35;
/// Browsers slow down what is shorter.
constexpr double kMinMilliseconds = 20;
/// Partial images that are added in their order, so that sums do not depend on the threads.
constexpr size_t kParts = 4;

class Projection {
 public:
  Projection(const DisplayProfile& profile, const PreviewView& view, int pixels)
      : sweep_(profile), turn_(view.turnRadians), middle_(pixels / 2.0), scale_(pixels / 2.0 / view.reachRadii) {}

  void add(const Volume& volume, int slice, Image<glm::vec3>& image) const {
    // A cell is longest along its arc, where points at most two pixels apart stand for it.
    const int points = static_cast<int>(std::ceil(sweep_.stepRadians() * scale_ / 2));
    std::vector<glm::dvec2> directions;  // to the right, and towards the viewer
    for (int i = 0; i < points; ++i) {
      const double angle = (slice + (i + 0.5) / points - 0.5) * sweep_.stepRadians() + turn_;
      directions.emplace_back(std::cos(angle), std::sin(angle));
    }
    const double unit = 1.0 / (points * volume.fullLevel());
    forEachLevel(volume, slice, [&](int column, int row, const Rgb8& levels) {
      const double r = sweep_.columnRadius(column);
      const double y = sweep_.rowCenterY(row) * std::cos(kTiltRadians);
      for (const glm::dvec2& direction : directions) {
        const double depth = (1 + r * direction.y) / 2;
        const double light = unit * std::abs(r) * (kFarLight + (1 - kFarLight) * depth);
        splat(image, middle_ + scale_ * r * direction.x,
              middle_ - scale_ * (y - r * direction.y * std::sin(kTiltRadians)),
              glm::vec3(levels) * static_cast<float>(light));
      }
    });
  }

 private:
  /// To the four pixels whose centres are around the point.
  static void splat(Image<glm::vec3>& image, double u, double v, const glm::vec3& light) {
    const int left = static_cast<int>(std::floor(u - 0.5));
    const int top = static_cast<int>(std::floor(v - 0.5));
    const auto right = static_cast<float>(u - 0.5 - left);
    const auto down = static_cast<float>(v - 0.5 - top);
    const auto give = [&](int x, int y, float share) {
      if (image.contains(x, y)) {
        image(x, y) += light * share;
      }
    };
    give(left, top, (1 - right) * (1 - down));
    give(left + 1, top, right * (1 - down));
    give(left, top + 1, (1 - right) * down);
    give(left + 1, top + 1, right * down);
  }

  SweepGeometry sweep_;
  double turn_;
  double middle_;
  double scale_;
};

/// One image of the animation.
struct Shot {
  size_t frame = 0;
  double turnRadians = 0;
  uint16_t milliseconds = 0;
};

std::vector<Shot> turnAround() {
  std::vector<Shot> shots(kTurnImages);
  for (size_t i = 0; i < shots.size(); ++i) {
    shots[i] = {0, 2 * kPi * static_cast<double>(i) / static_cast<double>(shots.size()), kTurnMilliseconds};
  }
  return shots;
}

std::vector<Shot> play(const SvolReader& reader) {
  const std::vector<SvolFrame>& frames = reader.frames();
  const uint64_t end = frames.front().timeMicroseconds + reader.durationMicroseconds();
  std::vector<Shot> shots(std::min(frames.size(), kMaxImages));
  for (size_t i = 0; i < shots.size(); ++i) {
    shots[i].frame = i * frames.size() / shots.size();
    shots[i].turnRadians =
        kSwayRadians * std::sin(2 * kPi * static_cast<double>(i) / static_cast<double>(shots.size()));
  }
  for (size_t i = 0; i < shots.size(); ++i) {
    const uint64_t next = i + 1 < shots.size() ? frames[shots[i + 1].frame].timeMicroseconds : end;
    const double milliseconds = static_cast<double>(next - frames[shots[i].frame].timeMicroseconds) / 1000;
    shots[i].milliseconds = static_cast<uint16_t>(std::clamp(std::round(milliseconds), kMinMilliseconds, 65535.0));
  }
  return shots;
}

bool isLit(const Image<glm::vec3>& light) {
  return std::ranges::any_of(light, [](const glm::vec3& pixel) { return pixel != glm::vec3(0); });
}

}  // namespace

double previewReach(const Volume& volume) {
  const SweepGeometry sweep(volume.profile());
  std::vector<double> reaches(static_cast<size_t>(volume.slices()), 0.0);
  parallelFor(reaches.size(), 1, [&](size_t begin, size_t end) {
    for (size_t slice = begin; slice < end; ++slice) {
      forEachLitVoxel(volume, static_cast<int>(slice), [&](int column, int row) {
        const double r = std::abs(sweep.columnRadius(column));
        const double y = std::abs(sweep.rowCenterY(row));
        const double upwards = y * std::cos(kTiltRadians) + r * std::sin(kTiltRadians);
        reaches[slice] = std::max({reaches[slice], r, upwards});
      });
    }
  });
  return *std::ranges::max_element(reaches);
}

Image<glm::vec3> projectedLight(const Volume& volume, const PreviewView& view, int pixels) {
  const Projection projection(volume.profile(), view, pixels);
  std::array<Image<glm::vec3>, kParts> parts;
  parallelChunks(static_cast<size_t>(volume.slices()), kParts, [&](size_t part, size_t begin, size_t end) {
    parts[part] = Image<glm::vec3>(pixels, pixels, glm::vec3(0));
    for (size_t slice = begin; slice < end; ++slice) {
      projection.add(volume, static_cast<int>(slice), parts[part]);
    }
  });
  for (size_t part = 1; part < kParts; ++part) {
    for (size_t i = 0; i < parts[0].size(); ++i) {
      parts[0][i] += parts[part][i];
    }
  }
  return std::move(parts[0]);
}

void exportPreview(const std::filesystem::path& path, SvolReader& reader, const PreviewOptions& options,
                   const Progress& progress) {
  constexpr int kMinPixels = 16;
  constexpr int kMaxPixels = 2048;
  if (options.pixels < kMinPixels || options.pixels > kMaxPixels) {
    throw InputError("a preview has 16 to 2048 pixels a side", path.string(), "change its size");
  }
  requireFrame(reader, 0);
  if (reader.damage()) {
    throw *reader.damage();
  }
  const std::vector<Shot> shots = reader.frames().size() == 1 ? turnAround() : play(reader);
  ApngWriter writer(path, options.pixels, options.pixels, static_cast<uint32_t>(shots.size()));
  SvolPlayer player(reader);
  double reach = 0;
  for (const Shot& shot : shots) {
    report(progress, "measuring", static_cast<double>(&shot - shots.data()) / static_cast<double>(shots.size()));
    if (&shot == shots.data() || shot.frame != 0) {
      player.seek(shot.frame);
      reach = std::max(reach, previewReach(player.volume()));
    }
  }
  reach = reach > 0 ? reach * kMargin : 1;
  // One for all images, or they would flicker.
  double gain = 0;
  for (size_t i = 0; i < shots.size(); ++i) {
    report(progress, "drawing", static_cast<double>(i) / static_cast<double>(shots.size()));
    player.seek(shots[i].frame);
    Image<glm::vec3> light = projectedLight(player.volume(), {shots[i].turnRadians, reach}, options.pixels);
    if (gain == 0 && isLit(light)) {
      gain = automaticGain(light);
    }
    applyTone(light, {.gain = gain, .curve = ToneCurve::kClip, .gamma = 1});
    writer.add(srgbFromLinear(light), shots[i].milliseconds);
  }
  writer.finish();
  report(progress, "drawing", 1);
}

}  // namespace ocelli
