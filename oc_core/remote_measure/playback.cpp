#include "oc_core/remote_measure/playback.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr double kTimeRounding = 1e-9;

}  // namespace

std::vector<double> lagsOf(const RemotePath& path, const std::vector<ShownView>& shown) {
  OC_CHECK(shown.size() == path.views.size(), "a playback has each frame of its path");
  std::vector<double> lags(shown.size());
  std::optional<size_t> lastCovered;
  for (size_t k = 0; k < shown.size(); ++k) {
    if (!shown[k].frame) {
      continue;
    }
    if (shown[k].isCovered) {
      lastCovered = *shown[k].frame;
    }
    // Before anything was covered, since the first picture.
    const size_t since = lastCovered.value_or(*shown[k].frame);
    const bool isWanted = shown[k].isCovered && path.views[*shown[k].frame] == path.views[k];
    if (!lastCovered) {
      lastCovered = since;
    }
    lags[k] = isWanted ? 0 : path.secondsOf(k) - path.secondsOf(since);
  }
  return lags;
}

StallFigures stallsOf(const RemotePath& path, const std::vector<ShownView>& shown, bool onlyCovered) {
  const std::vector<double> lags = lagsOf(path, shown);
  StallFigures figures;
  size_t run = 0;
  for (size_t k = 0; k <= lags.size(); ++k) {
    const bool stalls =
        k < lags.size() && lags[k] > kMaxLagSeconds + kTimeRounding && (!onlyCovered || shown[k].isCovered);
    if (stalls) {
      ++run;
      continue;
    }
    if (run > 0) {
      const double seconds = path.secondsOf(run);
      figures.longestSeconds = std::max(figures.longestSeconds, seconds);
      figures.totalSeconds += seconds;
      ++figures.count;
      run = 0;
    }
  }
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
