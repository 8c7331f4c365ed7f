#include "oc_core/feeds/subject_memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/feeds/place_telling.h"
#include "oc_core/feeds/subject_places.h"

namespace ocelli {
namespace {

constexpr double kPortraitOpen = 0.8;   ///< so much of a body's cells is open where it is remembered,
constexpr double kPortraitShare = 0.3;  ///< and so much is seen that can be nobody else's
constexpr double kHidden = 0.9;         ///< where less is open, somebody hides a part
constexpr double kMinShownCells = 40;   ///< of the mask: less of a body is not shown
constexpr double kMaxOwnSeconds = 2;    ///< an older portrait stands behind those of other feeds
constexpr double kMaxSeconds = 5;       ///< later on subjects may have been taken for each other
constexpr double kMaxResizing = 2.5;    ///< a portrait from so much nearer or farther off is none

struct BodyScale {
  glm::dvec2 middle;  ///< feed pixels
  double pixelsPerMetre;
};

std::optional<BodyScale> scaleOf(const Feed& feed, const glm::dvec3& place, double height) {
  const glm::dvec3 middle = place + glm::dvec3(0, height / 2, 0);
  const glm::dvec3 side = feed.pose.right() * 0.25;
  const auto at = feedPixelOf(feed, middle);
  const auto left = feedPixelOf(feed, middle - side);
  const auto right = feedPixelOf(feed, middle + side);
  if (!at || !left || !right) {
    return std::nullopt;
  }
  return BodyScale{*at, glm::length(*right - *left) / (2 * glm::length(side))};
}

/// The box of the cells that show a subject.
struct PortraitBox {
  glm::ivec2 lower{std::numeric_limits<int>::max()};
  glm::ivec2 upper{0};

  void add(const glm::ivec2& cell) {
    lower = glm::min(lower, cell);
    upper = glm::max(upper, cell + 1);
  }
  bool isEmpty() const { return upper.x <= lower.x; }
};

/// Of each subject.
std::vector<PortraitBox> boxesOf(const Image<uint16_t>& who, size_t subjects) {
  std::vector<PortraitBox> boxes(subjects);
  for (int y = 0; y < who.height(); ++y) {
    for (int x = 0; x < who.width(); ++x) {
      if (const uint16_t label = who(x, y); label != SubjectCells::kNobody) {
        boxes[label - 1u].add({x, y});
      }
    }
  }
  return boxes;
}

/// The cells and pixels of a box that show a subject, by its index plus 1.
SubjectPortrait cutOut(const Image<uint16_t>& who, uint16_t label, const PortraitBox& box, const Image<Rgb8>& frame) {
  SubjectPortrait portrait;
  const glm::ivec2 cells = box.upper - box.lower;
  portrait.scale = maskScaleOf(frame.width());
  portrait.corner = box.lower * portrait.scale;
  portrait.cells = Image<uint8_t>(cells.x, cells.y);
  for (int y = 0; y < cells.y; ++y) {
    for (int x = 0; x < cells.x; ++x) {
      portrait.cells(x, y) = who(box.lower.x + x, box.lower.y + y) == label ? 1 : 0;
    }
  }
  portrait.pixels = Image<Rgb8>(cells.x * portrait.scale, cells.y * portrait.scale);
  for (int y = 0; y < portrait.pixels.height(); ++y) {
    const Rgb8* const from = frame.data() + frame.index(portrait.corner.x, portrait.corner.y + y);
    std::copy(from, from + portrait.pixels.width(), portrait.pixels.data() + portrait.pixels.index(0, y));
  }
  return portrait;
}

/// Levels in the light of the background.
std::array<std::array<uint8_t, 256>, 3> unlit(const glm::dvec3& light) {
  std::array<std::array<uint8_t, 256>, 3> levels{};
  for (int channel = 0; channel < 3; ++channel) {
    for (size_t level = 0; level < 256; ++level) {
      levels[static_cast<size_t>(channel)][level] =
          static_cast<uint8_t>(std::lround(std::min(255.0, static_cast<double>(level) / light[channel])));
    }
  }
  return levels;
}

/// The portrait of a subject by a feed, or the latest by any where that is old; null where all are too old.
const SubjectPortrait* latest(const std::vector<SubjectPortraits>& portraits, size_t feed, uint64_t subject,
                              double seconds) {
  const SubjectPortrait* const own = portraits[feed].of(subject);
  const SubjectPortrait* best = own;
  for (const SubjectPortraits& other : portraits) {
    const SubjectPortrait* const each = other.of(subject);
    best = each != nullptr && (best == nullptr || each->seconds > best->seconds) ? each : best;
  }
  if (own != nullptr && own->seconds >= seconds - kMaxOwnSeconds) {
    return own;
  }
  return best != nullptr && best->seconds >= seconds - kMaxSeconds ? best : nullptr;
}

}  // namespace

const SubjectPortrait* SubjectPortraits::of(uint64_t subject) const {
  const auto found = portraits_.find(subject);
  return found == portraits_.end() ? nullptr : &found->second;
}

void SubjectPortraits::look(const SubjectTracks& tracks, const Image<Rgb8>& frame, const glm::dvec3& light,
                            double seconds) {
  const std::vector<PortraitBox> boxes = boxesOf(tracks.cells(feed_).who, tracks.count());
  std::map<uint64_t, SubjectPortrait> kept;
  for (size_t i = 0; i < tracks.count(); ++i) {
    const uint64_t number = tracks.number(i);
    if (auto known = portraits_.extract(number)) {
      kept.insert(std::move(known));
    }
    const BodySight* const sight = tracks.sight(feed_, i);
    if (sight == nullptr || !isSeen(*sight) || sight->open < kPortraitOpen * sight->inImage ||
        sight->seenAlone < kPortraitShare * sight->inImage) {
      continue;
    }
    const auto scale = scaleOf(graph_.setup().feeds[feed_], tracks.place(i), tracks.height(i));
    const auto label = static_cast<uint16_t>(i + 1);
    if (const PortraitBox& box = boxes[i]; scale && !box.isEmpty()) {
      SubjectPortrait& portrait = kept[number];
      portrait = cutOut(tracks.cells(feed_).who, label, box, frame);
      portrait.feed = feed_;
      portrait.seconds = seconds;
      portrait.light = light;
      portrait.middle = scale->middle;
      portrait.pixelsPerMetre = scale->pixelsPerMetre;
    }
  }
  portraits_ = std::move(kept);
}

void HiddenSubjects::show(const SubjectPortrait& portrait, const glm::dvec2& middle, double pixelsPerMetre,
                          double distance) {
  const double ratio = portrait.pixelsPerMetre / pixelsPerMetre;
  if (ratio > kMaxResizing || ratio < 1 / kMaxResizing) {
    return;
  }
  const Feed& feed = graph_.feedOf(frustum_);
  const glm::dvec2 lower = middle + (glm::dvec2(portrait.corner) - portrait.middle) / ratio;
  const glm::dvec2 upper = lower + glm::dvec2(portrait.pixels.width(), portrait.pixels.height()) / ratio;
  const glm::ivec2 size(feed.width, feed.height);
  shown_.push_back({&portrait, middle, ratio, distance, glm::clamp(glm::ivec2(glm::floor(lower)), glm::ivec2(0), size),
                    glm::clamp(glm::ivec2(glm::ceil(upper)), glm::ivec2(0), size)});
}

void HiddenSubjects::update(const SubjectTracks& tracks, const std::vector<SubjectPortraits>& portraits,
                            double seconds) {
  shown_.clear();
  const size_t feed = graph_.feedIndexOf(frustum_);
  for (size_t i = 0; i < tracks.count(); ++i) {
    const BodySight* const sight = tracks.sight(feed, i);
    if (sight == nullptr || sight->open >= kHidden * sight->inImage || sight->inImage < kMinShownCells ||
        shareEntered(graph_, frustum_, tracks.place(i)) <= 0.5) {
      continue;
    }
    const SubjectPortrait* const portrait = latest(portraits, feed, tracks.number(i), seconds);
    if (const auto scale = scaleOf(graph_.feedOf(frustum_), tracks.place(i), tracks.height(i)); portrait && scale) {
      show(*portrait, scale->middle, scale->pixelsPerMetre,
           glm::length(tracks.place(i) - graph_.feedOf(frustum_).pose.eye));
    }
  }
  std::sort(shown_.begin(), shown_.end(), [](const Shown& a, const Shown& b) { return a.distance > b.distance; });
}

std::optional<glm::ivec2> HiddenSubjects::Shown::source(const glm::ivec2& pixel) const {
  const glm::dvec2 from = portrait->middle + ratio * (glm::dvec2(pixel) + 0.5 - middle);
  const glm::ivec2 at = glm::ivec2(glm::floor(from)) - portrait->corner;
  if (!portrait->pixels.contains(at.x, at.y) || portrait->cells(at.x / portrait->scale, at.y / portrait->scale) == 0) {
    return std::nullopt;
  }
  return at;
}

const Image<Rgb8>& HiddenSubjects::in(const Image<Rgb8>& background) {
  if (shown_.empty() || background.empty()) {
    return background;
  }
  image_ = background;
  for (const Shown& shown : shown_) {
    const auto levels = unlit(shown.portrait->light);
    for (int y = shown.lower.y; y < shown.upper.y; ++y) {
      for (int x = shown.lower.x; x < shown.upper.x; ++x) {
        if (const auto at = shown.source({x, y})) {
          const Rgb8& pixel = shown.portrait->pixels(at->x, at->y);
          image_(x, y) = {levels[0][pixel.r], levels[1][pixel.g], levels[2][pixel.b]};
        }
      }
    }
  }
  return image_;
}

std::optional<PortraitPixel> HiddenSubjects::at(const glm::ivec2& pixel) const {
  for (auto shown = shown_.rbegin(); shown != shown_.rend(); ++shown) {
    if (const auto at = shown->source(pixel)) {
      return PortraitPixel{shown->portrait->feed, shown->portrait->seconds, shown->portrait->corner + *at};
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
