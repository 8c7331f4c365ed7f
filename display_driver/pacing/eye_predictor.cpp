#include "display_driver/pacing/eye_predictor.h"

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// What the line of constant velocity is fitted to.
constexpr std::chrono::milliseconds kFitted{60};

// Display radii; the reference display has one of 0.127 m.
/// Of a head: from 1 to 4 makes little difference (bench/eye_prediction_bench).
constexpr double kAccelerationDensity = 2;  // radii^2 / s^3
/// Standard deviation of what trackers are off by: about a millimetre.
constexpr double kTrackerNoise = 0.008;
/// Of a velocity of which nothing is known.
constexpr double kAnyVelocity = 5;

double secondsBetween(HostTime from, HostTime to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::vector<std::string> eyePredictionNames() {
  return {"none", "velocity", "kalman"};
}

EyePrediction eyePredictionFromName(const std::string& name, const std::string& where) {
  const std::vector<std::string> names = eyePredictionNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError("there is no prediction \"" + name + "\"", where, "use none, velocity or kalman");
  }
  return static_cast<EyePrediction>(found - names.begin());
}

void EyePredictor::Axis::goOn(double seconds) {
  place += velocity * seconds;
  const double q = kAccelerationDensity;
  placeVariance += seconds * (2 * covariance + seconds * (velocityVariance + q * seconds / 3));
  covariance += seconds * (velocityVariance + q * seconds / 2);
  velocityVariance += q * seconds;
}

void EyePredictor::Axis::see(double measured) {
  const double total = placeVariance + kTrackerNoise * kTrackerNoise;
  const double gain = placeVariance / total;
  const double velocityGain = covariance / total;
  const double off = measured - place;
  place += gain * off;
  velocity += velocityGain * off;
  velocityVariance -= velocityGain * covariance;
  covariance *= 1 - gain;
  placeVariance *= 1 - gain;
}

void EyePredictor::add(HostTime time, const glm::vec3& eye) {
  if (!samples_.empty() && time <= samples_.back().time) {
    samples_.back().eye = eye;
    return;
  }
  const bool goesOn = !samples_.empty() && time - samples_.back().time < kMaxPause;
  const double seconds = goesOn ? secondsBetween(samples_.back().time, time) : 0;
  if (!goesOn) {
    samples_.clear();
  }
  for (int i = 0; i < 3; ++i) {
    Axis& axis = axes_[static_cast<size_t>(i)];
    if (goesOn) {
      axis.goOn(seconds);
      axis.see(static_cast<double>(eye[i]));
    } else {
      axis = {.place = static_cast<double>(eye[i]),
              .placeVariance = kTrackerNoise * kTrackerNoise,
              .velocityVariance = kAnyVelocity * kAnyVelocity};
    }
  }
  samples_.push_back({time, eye});
  while (samples_.size() > 2 && samples_.back().time - samples_.front().time > kFitted) {
    samples_.pop_front();
  }
}

/// Of the straight line that fits best (least squares).
glm::dvec3 EyePredictor::velocityOfLine() const {
  double meanTime = 0;
  glm::dvec3 mean(0);
  const auto count = static_cast<double>(samples_.size());
  for (const Sample& sample : samples_) {
    meanTime += secondsBetween(samples_.back().time, sample.time) / count;
    mean += glm::dvec3(sample.eye) / count;
  }
  double spread = 0;
  glm::dvec3 together(0);
  for (const Sample& sample : samples_) {
    const double t = secondsBetween(samples_.back().time, sample.time) - meanTime;
    spread += t * t;
    together += t * (glm::dvec3(sample.eye) - mean);
  }
  return spread > 0 ? together / spread : glm::dvec3(0);
}

std::optional<glm::vec3> EyePredictor::at(HostTime time) const {
  if (samples_.empty()) {
    return std::nullopt;
  }
  const Sample& last = samples_.back();
  if (how_ == EyePrediction::kNone || time <= last.time || time - last.time > kMaxPause || samples_.size() < 2) {
    return last.eye;
  }
  const double ahead = secondsBetween(last.time, std::min(time, last.time + kMaxAhead));
  if (how_ == EyePrediction::kVelocity) {
    return glm::vec3(glm::dvec3(last.eye) + velocityOfLine() * ahead);
  }
  glm::vec3 eye(0);
  for (int i = 0; i < 3; ++i) {
    const Axis& axis = axes_[static_cast<size_t>(i)];
    eye[i] = static_cast<float>(axis.place + axis.velocity * ahead);
  }
  return eye;
}

}  // namespace ocelli
