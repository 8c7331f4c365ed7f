#include "bench/head_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

struct Lean {
  double begin = 0;
  double end = 0;
  glm::dvec3 from{0};
  glm::dvec3 to{0};
};

/// From 0 to 1, with the least change of acceleration.
double minimumJerk(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * x * (10 - 15 * x + 6 * x * x);
}

double between(Random& random, double least, double most) {
  return static_cast<double>(random.inRange(static_cast<float>(least), static_cast<float>(most)));
}

double normal(Random& random) {
  return std::sqrt(-2 * std::log(between(random, 1e-6, 1))) * std::cos(2 * kPi * between(random, 0, 1));
}

}  // namespace

std::vector<EyePose> madeUpHeadPath(uint64_t seed, double seconds, double posesPerSecond) {
  Random random(seed);
  const auto place = [&] {
    return glm::dvec3(between(random, -1, 1), 0.4 + between(random, -0.5, 0.5), 10 + between(random, -0.7, 0.7));
  };
  std::vector<Lean> leans;
  glm::dvec3 at = place();
  for (double t = 0; t < seconds;) {
    const glm::dvec3 to = place();
    // Half a second to one and a half, and a rest.
    const double takes = between(random, 0.5, 1.5);
    leans.push_back({t, t + takes, at, to});
    at = to;
    t += takes + between(random, 0, 0.8);
  }
  struct Sway {
    double hertz;
    double phase;
    glm::dvec3 amplitude;
  };
  std::array<Sway, 4> sways{};
  for (Sway& sway : sways) {
    const double size = between(random, 0.005, 0.03);
    sway = {between(random, 0.3, 2), between(random, 0, 2 * kPi),
            size * glm::dvec3(1, between(random, 0.2, 0.6), between(random, 0.5, 1))};
  }
  std::vector<EyePose> path;
  const auto count = static_cast<int>(seconds * posesPerSecond);
  size_t lean = 0;
  for (int i = 0; i < count; ++i) {
    const double t = i / posesPerSecond;
    while (lean + 1 < leans.size() && leans[lean + 1].begin <= t) {
      ++lean;
    }
    const Lean& now = leans[lean];
    glm::dvec3 eye = now.from + (now.to - now.from) * minimumJerk((t - now.begin) / (now.end - now.begin));
    for (const Sway& sway : sways) {
      eye += sway.amplitude * std::sin(2 * kPi * sway.hertz * t + sway.phase);
    }
    path.push_back({t, glm::vec3(eye)});
  }
  return path;
}

std::vector<EyePose> withTrackerNoise(std::vector<EyePose> path, uint64_t seed, double deviation) {
  Random random(seed);
  for (EyePose& pose : path) {
    pose.eye += glm::vec3(glm::dvec3(normal(random), normal(random), normal(random)) * deviation);
  }
  return path;
}

}  // namespace ocelli
