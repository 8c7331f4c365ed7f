#include "oc_core/remote_measure/remote_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr size_t kDefaultFrames = 900;
constexpr size_t kMaxKeys = 100000;
constexpr double kMaxSeconds = 36000;
constexpr double kTurn = 2 * kPi;

double halfTangent(const View& view) {
  return std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2);
}

/// Turned about `up` and its own right axis by shares of the vertical field of view, and zoomed.
View turned(const View& view, double right, double up, double zoom = 1) {
  const double fov = radiansFromDegrees(view.resolvedFovVerticalDegrees());
  const glm::dvec3 forward = glm::dvec3(view.target) - glm::dvec3(view.eye);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(view.up));
  const glm::dvec3 side = glm::normalize(glm::cross(forward, axis));
  View result = view;
  result.target =
      glm::vec3(glm::dvec3(view.eye) + glm::angleAxis(-right * fov, axis) * (glm::angleAxis(up * fov, side) * forward));
  result.fovVerticalDegrees = degreesFromRadians(2 * std::atan(halfTangent(view) / zoom));
  return result;
}

/// The eye moved by shares of the height of the view at its target, in its own axes; it looks the same way.
View shifted(const View& view, double right, double up, double forward) {
  const glm::dvec3 ahead = glm::dvec3(view.target) - glm::dvec3(view.eye);
  const double unit = 2 * halfTangent(view) * glm::length(ahead);
  const glm::dvec3 front = glm::normalize(ahead);
  const glm::dvec3 side = glm::normalize(glm::cross(front, glm::dvec3(view.up)));
  const glm::vec3 step((side * right + glm::cross(side, front) * up + front * forward) * unit);
  View result = view;
  result.eye += step;
  result.target += step;
  return result;
}

/// From 0 to 1 and back within a period, with rests at neither end.
double wave(double seconds, double period) {
  return (1 - std::cos(kTurn * seconds / period)) / 2;
}
double swing(double seconds, double period) {
  return std::sin(kTurn * seconds / period);
}
/// From 0 to 1 between two moments, with no velocity at either.
double ramp(double seconds, double from, double to) {
  const double t = std::clamp((seconds - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

View panAt(const View& start, double t) {
  return turned(start, 0.2 * swing(t, 7.5), 0.08 * swing(t, 5));
}
View zoomAt(const View& start, double t) {
  return turned(start, 0, 0, std::exp2(wave(t, 7.5)));
}
View lookAroundAt(const View& start, double t) {
  const View moved = shifted(start, 0.02 * swing(t, 9), 0.01 * swing(t, 7), 0.02 * swing(t, 11));
  return turned(moved, 0.15 * swing(t, 7.5), 0.06 * swing(t, 5.5), std::exp2(0.8 * wave(t, 10)));
}
/// Around the target by 20 degrees each way, and nearer, with rests; a turn takes 30 seconds.
View exploreAt(const View& start, double t) {
  const double s = std::fmod(t, 30.0);
  const double angle = 20 * (ramp(s, 2, 6) - 2 * ramp(s, 9, 15) + ramp(s, 22, 26));
  const double nearer = 0.25 * (ramp(s, 16, 19) - ramp(s, 26, 29));
  const glm::dvec3 target(start.target);
  const glm::dvec3 back = glm::dvec3(start.eye) - target;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(start.up));
  View view = start;
  view.eye = glm::vec3(target + glm::angleAxis(radiansFromDegrees(angle), axis) * back * (1 - nearer));
  view.fovVerticalDegrees = start.resolvedFovVerticalDegrees();
  return turned(view, 0.15 * swing(s, 15), 0.05 * swing(s, 10), std::exp2(ramp(s, 19, 21) - ramp(s, 24, 26)));
}

constexpr std::array<RemotePathKind, 4> kPaths{{
    {"pan", "the view turns from side to side, and up and down a little", panAt},
    {"zoom", "the view zooms in by 2 and back, every 7.5 seconds", zoomAt},
    {"look-around", "turns, zooms of up to 1.7, and moves of 2 % of what the view shows, all at once", lookAroundAt},
    {"explore",
     "around the target by 20 degrees each way, a quarter nearer, and zooms, with rests: beyond any one image",
     exploreAt},
}};

struct PathKey {
  double seconds = 0;
  View view;
};

/// What is interpolated of a view.
struct ViewNumbers {
  glm::dvec3 eye, target, up;
  double zoom;

  explicit ViewNumbers(const View& view)
      : eye(view.eye), target(view.target), up(view.up), zoom(-std::log(halfTangent(view))) {}
  ViewNumbers(const glm::dvec3& e, const glm::dvec3& t, const glm::dvec3& u, double z)
      : eye(e), target(t), up(u), zoom(z) {}
  ViewNumbers operator+(const ViewNumbers& o) const {
    return {eye + o.eye, target + o.target, up + o.up, zoom + o.zoom};
  }
  ViewNumbers operator*(double s) const { return {eye * s, target * s, up * s, zoom * s}; }
};

/// Cubic Hermite curves through the keys; the slope at a key is that between its neighbours.
View viewBetween(const std::vector<PathKey>& keys, double seconds) {
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), seconds, [](double t, const PathKey& key) { return t < key.seconds; });
  if (after == keys.begin() || after == keys.end()) {
    View view = (after == keys.begin() ? keys.front() : keys.back()).view;
    view.fovVerticalDegrees = view.resolvedFovVerticalDegrees();
    return view;
  }
  const auto i = static_cast<size_t>(after - keys.begin()) - 1;
  const auto slopeAt = [&](size_t k) {
    const PathKey& a = keys[k == 0 ? 0 : k - 1];
    const PathKey& b = keys[std::min(k + 1, keys.size() - 1)];
    return (ViewNumbers(b.view) + ViewNumbers(a.view) * -1) * (1 / (b.seconds - a.seconds));
  };
  const double length = keys[i + 1].seconds - keys[i].seconds;
  const double t = (seconds - keys[i].seconds) / length;
  const double t2 = t * t;
  const double t3 = t2 * t;
  const ViewNumbers at = ViewNumbers(keys[i].view) * (2 * t3 - 3 * t2 + 1) + slopeAt(i) * (length * (t3 - 2 * t2 + t)) +
                         ViewNumbers(keys[i + 1].view) * (3 * t2 - 2 * t3) + slopeAt(i + 1) * (length * (t3 - t2));
  View view = keys[i].view;
  view.eye = glm::vec3(at.eye);
  view.target = glm::vec3(at.target);
  view.up = glm::vec3(at.up);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(std::exp(-at.zoom)));
  return view;
}

}  // namespace

std::span<const RemotePathKind> remotePaths() {
  return kPaths;
}

RemotePath remotePathFromJson(const std::string& text, const std::string& where, size_t frames,
                              double framesPerSecond) {
  return readAs("oc_core/remote_measure/remote_path.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    std::vector<PathKey> keys;
    fields.forEach("views", 1, kMaxKeys, [&](JsonFields& each) {
      PathKey key;
      key.seconds = each.number("seconds", 0, kMaxSeconds);
      key.view = viewFromJsonText(each.value("view").dump(), each.where());
      if (!keys.empty() && !(key.seconds > keys.back().seconds)) {
        each.fail("seconds", "must be later than that of the view before");
      }
      keys.push_back(key);
    });
    fields.rejectUnknown();
    if (keys.empty()) {
      fields.fail("views", "must have at least one view");
    }
    RemotePath path{where, framesPerSecond, {}};
    const double last = std::floor(keys.back().seconds * framesPerSecond + 1e-6);
    if (last + 1 > static_cast<double>(kMaxPathFrames)) {
      throw InputError("this path has more than 100,000 frames", where, "make it shorter, or give a lower --rate");
    }
    const auto all = static_cast<size_t>(last) + 1;
    const size_t count = frames == 0 ? all : frames;
    for (size_t i = 0; i < count; ++i) {
      path.views.push_back(viewBetween(keys, path.secondsOf(i)));
      validate(path.views.back(), where);
    }
    return path;
  });
}

RemotePath remotePath(const std::string& nameOrFile, const View& start, size_t frames, double framesPerSecond) {
  if (nameOrFile.ends_with(".json")) {
    return remotePathFromJson(readFile(nameOrFile, kMaxTextBytes), nameOrFile, frames, framesPerSecond);
  }
  std::string names;
  for (const RemotePathKind& kind : kPaths) {
    if (nameOrFile == kind.name) {
      RemotePath path{nameOrFile, framesPerSecond, {}};
      const size_t count = frames == 0 ? kDefaultFrames : frames;
      for (size_t i = 0; i < count; ++i) {
        path.views.push_back(kind.at(start, path.secondsOf(i)));
        path.views.back().fovVerticalDegrees = path.views.back().resolvedFovVerticalDegrees();
        validate(path.views.back(), "path " + nameOrFile);
      }
      return path;
    }
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  throw InputError("there is no path \"" + nameOrFile + "\"", "--path",
                   "give a file that ends in .json, or one of: " + names);
}

}  // namespace ocelli
