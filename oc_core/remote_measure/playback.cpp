#include "oc_core/remote_measure/playback.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr double kTimeRounding = 1e-9;

/// The view at a frame is the one that is wanted then.
bool isWanted(const RemotePath& path, const std::vector<ShownView>& shown, size_t frame) {
  const ShownView& now = shown[frame];
  return now.frame && now.isCovered && path.views[*now.frame] == path.views[frame];
}

}  // namespace

std::vector<double> lagsOf(const RemotePath& path, const std::vector<ShownView>& shown) {
  OC_CHECK(shown.size() == path.views.size(), "a playback has each frame of its path");
  std::vector<double> lags(shown.size());
  size_t lastCovered = 0;
  for (size_t k = 0; k < shown.size(); ++k) {
    if (shown[k].frame && shown[k].isCovered) {
      lastCovered = *shown[k].frame;
    }
    lags[k] = isWanted(path, shown, k) ? 0 : path.secondsOf(k) - path.secondsOf(lastCovered);
  }
  return lags;
}

StallFigures stallsOf(const RemotePath& path, const std::vector<ShownView>& shown, bool onlyCovered) {
  OC_CHECK(shown.size() == path.views.size(), "a playback has each frame of its path");
  StallFigures figures;
  size_t since = 0;
  const auto end = [&](size_t frame) {
    const double seconds = path.secondsOf(frame - since);
    if (seconds > kMaxStillSeconds + kTimeRounding) {
      figures.longestSeconds = std::max(figures.longestSeconds, seconds);
      figures.totalSeconds += seconds;
      ++figures.count;
    }
    since = frame;
  };
  for (size_t k = 0; k < shown.size(); ++k) {
    const bool isCovered = shown[k].frame && shown[k].isCovered;
    const bool isOther = isCovered && (k == 0 || shown[k] != shown[k - 1]);
    if (isOther || isWanted(path, shown, k) || (onlyCovered && !isCovered)) {
      end(k);
    }
  }
  end(shown.size());
  return figures;
}

double viewsPerSecond(const RemotePath& path, const std::vector<ShownView>& shown) {
  size_t views = 0;
  std::optional<size_t> last;
  for (const ShownView& each : shown) {
    views += each.frame && each.frame != last;
    last = each.frame;
  }
  return static_cast<double>(views) / path.seconds();
}

double coveredShare(const std::vector<ShownView>& shown) {
  size_t pictures = 0;
  size_t covered = 0;
  for (const ShownView& each : shown) {
    pictures += each.frame.has_value();
    covered += each.frame && each.isCovered;
  }
  return pictures > 0 ? static_cast<double>(covered) / static_cast<double>(pictures) : 0;
}

}  // namespace ocelli
