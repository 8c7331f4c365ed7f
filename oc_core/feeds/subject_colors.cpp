#include "oc_core/feeds/subject_colors.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr float kMinSeen = 150;       ///< cells of a part that tell its colours
constexpr float kKept = 0.985f;       ///< of what was seen, from frame to frame: half of it in 1.5 s
constexpr float kEverywhere = 0.15f;  ///< the share of colours that were not seen yet
constexpr float kMaxLikeness = 2.5f;  ///< a colour alone tells no more than that
constexpr float kMinHue = 0.15f;      ///< shares of red or green of all light: below and above there is hardly any
constexpr float kMaxHue = 0.6f;
constexpr float kDark = 36;  ///< of 3 * 255: so dark that noise is all hue there is

}  // namespace

uint16_t SubjectColors::binOf(const Rgb8& color) {
  const float sum = static_cast<float>(color.r) + static_cast<float>(color.g) + static_cast<float>(color.b);
  const auto hueBin = [&](float value) {
    const float share = (value + kDark / 3) / (sum + kDark);
    return std::clamp(static_cast<int>((share - kMinHue) / (kMaxHue - kMinHue) * kHueBins), 0, kHueBins - 1);
  };
  const int light = std::min(kLightBins - 1, static_cast<int>(std::sqrt(sum / 765) * kLightBins));
  return static_cast<uint16_t>((light * kHueBins + hueBin(color.r)) * kHueBins + hueBin(color.g));
}

size_t SubjectColors::partAt(float height) {
  return height < 0.48f ? 0 : (height < 0.85f ? 1 : 2);
}

void SubjectColors::add(size_t part, uint16_t bin) {
  Part& of = parts_[part];
  if (of.counts.empty()) {
    of.counts.assign(kBins, 0);
  }
  // Neighbours count, too, so that noise and light from another side do not make a colour a new one.
  const int light = bin / (kHueBins * kHueBins);
  const int red = bin / kHueBins % kHueBins;
  const int green = bin % kHueBins;
  const auto addAt = [&](int l, int r, int g, float weight) {
    if (l >= 0 && l < kLightBins && r >= 0 && r < kHueBins && g >= 0 && g < kHueBins) {
      of.counts[static_cast<size_t>((l * kHueBins + r) * kHueBins + g)] += weight;
    }
  };
  addAt(light, red, green, 0.4f);
  for (const int step : {-1, 1}) {
    addAt(light + step, red, green, 0.1f);
    addAt(light, red + step, green, 0.1f);
    addAt(light, red, green + step, 0.1f);
  }
  of.sum += 1;
}

bool SubjectColors::isKnown() const {
  return parts_[1].sum >= kMinSeen;
}

void SubjectColors::forget() {
  for (Part& part : parts_) {
    if (part.sum > kMinSeen) {
      for (float& count : part.counts) {
        count *= kKept;
      }
      part.sum *= kKept;
    }
  }
}

float SubjectColors::likeness(size_t part, uint16_t bin) const {
  const Part& of = parts_[part];
  if (of.sum < kMinSeen) {
    return 0;
  }
  const float seen = (1 - kEverywhere) * of.counts[bin] / of.sum * static_cast<float>(kBins);
  // Most colours never occur: what is there at all is some tenth of them.
  constexpr float kUsual = 8;
  return std::clamp(std::log((seen + kEverywhere * kUsual) / kUsual), -kMaxLikeness, kMaxLikeness);
}

float SubjectColors::likenessOf(const SubjectColors& other) const {
  float sum = 0;
  float all = 0;
  for (size_t part = 0; part < kParts; ++part) {
    const std::vector<float>& counts = other.parts_[part].counts;
    for (size_t bin = 0; bin < counts.size(); ++bin) {
      if (counts[bin] > 0) {
        sum += counts[bin] * likeness(part, static_cast<uint16_t>(bin));
        all += counts[bin];
      }
    }
  }
  return all > 0 ? sum / all : 0;
}

}  // namespace ocelli
