#include "analysis/inference/log_rank.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// Adds what one stratum observed and expected.
class Comparison {
 public:
  explicit Comparison(size_t groups)
      : observed_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(groups))),
        expected_(observed_),
        variance_(Eigen::MatrixXd::Zero(observed_.size(), observed_.size())) {}

  /// `times` of one stratum, each with the index of its group.
  void add(std::vector<std::pair<SurvivalTime, size_t>> times) {
    // From the last time to the first, the groups at risk only grow.
    std::sort(times.begin(), times.end(),
              [](const auto& a, const auto& b) { return a.first.seconds > b.first.seconds; });
    Eigen::VectorXd atRisk = Eigen::VectorXd::Zero(observed_.size());
    for (size_t i = 0; i < times.size();) {
      Eigen::VectorXd events = Eigen::VectorXd::Zero(observed_.size());
      const double seconds = times[i].first.seconds;
      for (; i < times.size() && times[i].first.seconds == seconds; ++i) {
        const auto group = static_cast<Eigen::Index>(times[i].second);
        atRisk[group] += 1;
        events[group] += times[i].first.observed ? 1 : 0;
      }
      addMoment(atRisk, events);
    }
  }

  const Eigen::VectorXd& observed() const { return observed_; }
  const Eigen::VectorXd& expected() const { return expected_; }

  /// The statistic, and how many independent differences it is made of.
  std::pair<double, int> chiSquared() const {
    const Eigen::VectorXd difference = observed_ - expected_;
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(variance_);
    return {difference.dot(decomposition.solve(difference)), static_cast<int>(decomposition.rank())};
  }

 private:
  void addMoment(const Eigen::VectorXd& atRisk, const Eigen::VectorXd& events) {
    const double all = atRisk.sum();
    const double ended = events.sum();
    const Eigen::VectorXd share = atRisk / all;
    observed_ += events;
    expected_ += ended * share;
    if (all > 1) {
      const double factor = ended * (all - ended) / (all - 1);
      variance_ += factor * (Eigen::MatrixXd(share.asDiagonal()) - share * share.transpose());
    }
  }

  Eigen::VectorXd observed_;
  Eigen::VectorXd expected_;
  Eigen::MatrixXd variance_;
};

}  // namespace

Estimable<LogRankTest> logRankTest(const std::vector<SurvivalTime>& times, const std::vector<int>& groups,
                                   const std::vector<int>& strata) {
  checkTimes(times, "logRankTest");
  requireArgument(groups.size() == times.size(), "groups and trials differ in number", "logRankTest");
  requireArgument(strata.empty() || strata.size() == times.size(), "strata and trials differ in number", "logRankTest");
  LogRankTest test;
  std::map<int, size_t> indices;
  for (const int label : groups) {
    indices.emplace(label, 0);
  }
  for (auto& [label, index] : indices) {
    index = test.groups.size();
    test.groups.push_back({label, 0, 0, 0});
  }
  if (test.groups.size() < 2) {
    return Estimable<LogRankTest>::impossible("there is only one group");
  }
  std::map<int, std::vector<std::pair<SurvivalTime, size_t>>> byStratum;
  for (size_t i = 0; i < times.size(); ++i) {
    const size_t group = indices.at(groups[i]);
    byStratum[strata.empty() ? 0 : strata[i]].emplace_back(times[i], group);
    ++test.groups[group].trials;
  }
  Comparison comparison(test.groups.size());
  for (const auto& [label, members] : byStratum) {
    comparison.add(members);
  }
  for (size_t i = 0; i < test.groups.size(); ++i) {
    test.groups[i].observed = comparison.observed()[static_cast<Eigen::Index>(i)];
    test.groups[i].expected = comparison.expected()[static_cast<Eigen::Index>(i)];
  }
  const auto [statistic, rank] = comparison.chiSquared();
  if (rank + 1 < static_cast<int>(test.groups.size())) {
    return Estimable<LogRankTest>::impossible(
        "a group was never at risk together with others when an event came, or there was none");
  }
  test.chiSquared = chiSquaredEstimate(statistic, rank);
  return test;
}

}  // namespace ocelli
