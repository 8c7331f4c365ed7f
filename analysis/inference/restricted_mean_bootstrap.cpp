#include "analysis/inference/restricted_mean_bootstrap.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "analysis/inference/restricted_mean.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// The area under the curve of one group, as its trials come in ascending order of time with the numbers of times they
/// were drawn.
class WeighedArea {
 public:
  WeighedArea(double atRisk, double horizon) : atRisk_(atRisk), horizon_(horizon) {}

  void addMoment(double seconds, double events, double trials) {
    if (seconds < horizon_ && events > 0) {
      area_ += survival_ * (seconds - from_);
      survival_ *= (atRisk_ - events) / atRisk_;
      from_ = seconds;
      anyEvent_ = true;
    }
    atRisk_ -= trials;
    isKnown_ = isKnown_ || (trials > 0 && (seconds >= horizon_ || survival_ == 0));
  }

  std::optional<double> total() const {
    return anyEvent_ && isKnown_ ? std::optional(area_ + survival_ * (horizon_ - from_)) : std::nullopt;
  }

 private:
  double atRisk_;
  double horizon_;
  double area_ = 0;
  double survival_ = 1;
  double from_ = 0;
  bool anyEvent_ = false;
  bool isKnown_ = false;  ///< the curve reaches the horizon, or 0
};

/// The difference for numbers of times that trials were drawn. Trials are sorted once, not for each resample.
class WeighedDifference {
 public:
  WeighedDifference(const std::vector<SurvivalTime>& times, const std::vector<bool>& isSecond, double horizon)
      : times_(times), isSecond_(isSecond), horizon_(horizon), order_(times.size()) {
    std::iota(order_.begin(), order_.end(), size_t{0});
    std::sort(order_.begin(), order_.end(), [&](size_t a, size_t b) { return times[a].seconds < times[b].seconds; });
  }

  std::optional<double> operator()(const std::vector<ResampledRow>& rows) const {
    std::vector<double> weights(times_.size());
    std::array<double, 2> atRisk = {0, 0};
    for (const ResampledRow& row : rows) {
      weights[row.row] += 1;
      atRisk[isSecond_[row.row] ? 1 : 0] += 1;
    }
    std::array<WeighedArea, 2> areas = {WeighedArea(atRisk[0], horizon_), WeighedArea(atRisk[1], horizon_)};
    for (size_t i = 0; i < order_.size();) {
      const double seconds = times_[order_[i]].seconds;
      std::array<double, 2> events = {0, 0};
      std::array<double, 2> trials = {0, 0};
      for (; i < order_.size() && times_[order_[i]].seconds == seconds; ++i) {
        const size_t group = isSecond_[order_[i]] ? 1 : 0;
        trials[group] += weights[order_[i]];
        events[group] += times_[order_[i]].observed ? weights[order_[i]] : 0;
      }
      areas[0].addMoment(seconds, events[0], trials[0]);
      areas[1].addMoment(seconds, events[1], trials[1]);
    }
    const std::optional<double> first = areas[0].total();
    const std::optional<double> second = areas[1].total();
    return first && second ? std::optional(*second - *first) : std::nullopt;
  }

 private:
  const std::vector<SurvivalTime>& times_;
  const std::vector<bool>& isSecond_;
  double horizon_;
  std::vector<size_t> order_;
};

}  // namespace

Estimable<BootstrapResult> bootstrapRestrictedMeanDifference(const std::vector<SurvivalTime>& times,
                                                             const std::vector<bool>& isSecond, double horizon,
                                                             const std::vector<int>& subjects,
                                                             const std::vector<int>& cases, const BootstrapPlan& plan) {
  requireArgument(times.size() == isSecond.size() && times.size() == subjects.size(), "lists differ in length",
                  "bootstrapRestrictedMeanDifference");
  // The data themselves say best why not.
  if (const auto once = restrictedMeanDifference(times, isSecond, horizon); !once) {
    return Estimable<BootstrapResult>::impossible(once.reason());
  }
  return bootstrap(subjects, cases, WeighedDifference(times, isSecond, horizon), plan);
}

}  // namespace ocelli
