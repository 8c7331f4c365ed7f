#include "bench/simulated_study.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "study/protocol/schedule.h"

namespace ocelli {
namespace {

/// Of a simple term, before means are taken off.
double valueOf(const Trial& trial, const std::string& term) {
  if (term == "view") {
    return trial.view == TrialView::kOther ? 0.5 : -0.5;
  }
  if (term == "moving") {
    return trial.moving.value() ? 0.5 : -0.5;
  }
  if (term == "duplicates") {
    return trial.duplicateColors.value() ? 0.5 : -0.5;
  }
  return term == "exposure" ? trial.exposureSeconds.value() : trial.session;
}

/// View and other factors stay -0.5 and 0.5; numbers are less their mean.
std::vector<double> columnOf(const std::vector<Trial>& trials, const std::string& term) {
  std::vector<double> column;
  if (const size_t colon = term.find(':'); colon != std::string::npos) {
    column = columnOf(trials, term.substr(0, colon));
    const std::vector<double> second = columnOf(trials, term.substr(colon + 1));
    for (size_t i = 0; i < column.size(); ++i) {
      column[i] *= second[i];
    }
    return column;
  }
  for (const Trial& trial : trials) {
    column.push_back(valueOf(trial, term));
  }
  if (term == "session" || term == "exposure") {
    const double mean = std::accumulate(column.begin(), column.end(), 0.0) / static_cast<double>(column.size());
    for (double& value : column) {
      value -= mean;
    }
  }
  return column;
}

std::vector<size_t> numbersOf(const std::vector<std::string>& labels, size_t& count) {
  std::map<std::string, size_t> numbers;
  std::vector<size_t> result;
  for (const std::string& label : labels) {
    result.push_back(numbers.try_emplace(label, numbers.size()).first->second);
  }
  count = numbers.size();
  return result;
}

std::vector<double> normals(size_t count, double deviation, RandomNumbers& numbers) {
  std::vector<double> values(count);
  for (double& value : values) {
    value = deviation * numbers.normal();
  }
  return values;
}

/// With the Laplace transform exp(-s^index): hazards that are proportional for each subject are so over all subjects
/// too, with `index` times the log ratio (Hougaard 1986). Drawn as Chambers, Mallows and Stuck 1976 do.
double stableFrailty(double index, RandomNumbers& numbers) {
  if (index >= 1) {
    return 1;
  }
  const double u = std::numbers::pi * numbers.uniform();
  const double w = -std::log(1 - numbers.uniform());
  return std::sin(index * u) / std::pow(std::sin(u), 1 / index) *
         std::pow(std::sin((1 - index) * u) / w, (1 - index) / index);
}

double probabilityOf(double logit) {
  return 1 / (1 + std::exp(-logit));
}

class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  double value() const { return sum_ / count_; }

 private:
  double sum_ = 0;
  double count_ = 0;
};

/// E min(T, limit) of a log-normal T.
double limitedMean(double mean, double deviation, double limit) {
  const auto normal = [](double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; };
  const double z = (std::log(limit) - mean) / deviation;
  return std::exp(mean + deviation * deviation / 2) * normal(z - deviation) + limit * (1 - normal(z));
}

/// Over a normal logit.
double meanProbability(double logit, double deviation) {
  constexpr int kPoints = 400;
  double sum = 0;
  double weights = 0;
  for (int i = 0; i <= kPoints; ++i) {
    const double z = 16.0 * i / kPoints - 8;
    const double weight = std::exp(-z * z / 2);
    sum += weight * probabilityOf(logit + deviation * z);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

std::vector<int> sessionsOf2010() {
  std::vector<int> sessions(25, 3);
  sessions.insert(sessions.end(), 20, 1);
  return sessions;
}

std::vector<Trial> plannedTrials(const Protocol& protocol, const std::string& task, const std::vector<int>& sessions) {
  std::vector<Trial> trials;
  for (size_t subject = 0; subject < sessions.size(); ++subject) {
    for (int session = 1; session <= sessions[subject]; ++session) {
      for (const TrialPlan& plan : scheduleOf(protocol, static_cast<int>(subject), session, protocol.seed).trials) {
        if (plan.task != task) {
          continue;
        }
        const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(plan.block)];
        const CaseInfo info = block.task->caseInfo(plan.caseIndex);
        Trial trial;
        trial.trialId = static_cast<int64_t>(trials.size());
        trial.subject = fmt::format("s{:03}", subject);
        trial.session = session;
        trial.planIndex = plan.index;
        trial.blockIndex = plan.block;
        trial.block = block.name;
        trial.task = plan.task;
        trial.caseIndex = plan.caseIndex;
        trial.caseLabel = info.label;
        trial.view = plan.view == TrialView::kOther ? TrialView::kOther : TrialView::kReference;
        trial.simulated = true;
        trial.moving = info.moving;
        trial.exposureSeconds = info.exposureSeconds;
        trial.objects = info.objects;
        trial.duplicateColors = info.duplicateColors;
        trials.push_back(trial);
      }
    }
  }
  return trials;
}

SimulatedStudy::SimulatedStudy(std::vector<Trial> planned, SimulatedTruth truth)
    : trials_(std::move(planned)), truth_(std::move(truth)), predictor_(trials_.size(), truth_.average) {
  std::vector<std::string> subjects;
  std::vector<std::string> items;
  for (const Trial& trial : trials_) {
    subjects.push_back(trial.subject);
    items.push_back(trial.item());
  }
  subjects_ = numbersOf(subjects, subjectCount_);
  items_ = numbersOf(items, itemCount_);
  for (const auto& [term, effect] : truth_.effects) {
    const std::vector<double> column = columnOf(trials_, term);
    for (size_t i = 0; i < column.size(); ++i) {
      predictor_[i] += effect * column[i];
    }
  }
}

std::vector<Trial> SimulatedStudy::draw(RandomNumbers& numbers) const {
  std::vector<Trial> trials = trials_;
  const std::vector<double> subjects = normals(subjectCount_, truth_.ofSubjects, numbers);
  const std::vector<double> subjectViews = normals(subjectCount_, truth_.ofSubjectViews, numbers);
  const std::vector<double> items = normals(itemCount_, truth_.ofItems, numbers);
  const std::vector<double> errors = normals(itemCount_, truth_.ofErrors, numbers);
  // Without them the numbers of a seed are those of studies that do not know them.
  const std::vector<double> itemViews =
      truth_.ofItemViews > 0 ? normals(itemCount_, truth_.ofItemViews, numbers) : std::vector<double>(itemCount_);
  std::vector<double> frailties(subjectCount_);
  for (double& frailty : frailties) {
    frailty = stableFrailty(truth_.frailty, numbers);
  }
  for (size_t i = 0; i < trials.size(); ++i) {
    Trial& trial = trials[i];
    const size_t subject = subjects_[i];
    const double predictor = predictor_[i] + subjects[subject] + items[items_[i]] +
                             (subjectViews[subject] + itemViews[items_[i]]) * valueOf(trial, "view");
    if (truth_.outcome == SimulatedOutcome::kAnswers) {
      const bool right = numbers.uniform() < probabilityOf(predictor);
      const bool tooMany = numbers.uniform() < probabilityOf(errors[items_[i]]);
      const int expected = trial.objects.value_or(1);
      trial.correct = right;
      trial.expected = std::to_string(expected);
      trial.answer = std::to_string(right ? expected : expected + (tooMany ? 1 : -1));
      continue;
    }
    const double seconds = truth_.outcome == SimulatedOutcome::kTimes
                               ? std::exp(predictor + truth_.ofTrials * numbers.normal())
                               : -std::log(1 - numbers.uniform()) / (std::exp(predictor) * frailties[subject]);
    trial.censored = seconds >= truth_.limitSeconds;
    trial.responseSeconds = std::min(seconds, truth_.limitSeconds);
    trial.longestSeconds = truth_.limitSeconds;
  }
  return trials;
}

std::vector<double> SimulatedStudy::probabilities() const {
  // The view's column is -0.5 or 0.5.
  const double deviation = std::hypot(std::hypot(truth_.ofSubjects, truth_.ofSubjectViews / 2),
                                      std::hypot(truth_.ofItems, truth_.ofItemViews / 2));
  std::map<double, double> known;
  std::vector<double> probabilities;
  for (const double predictor : predictor_) {
    const auto [place, isNew] = known.try_emplace(predictor, 0);
    if (isNew) {
      place->second = meanProbability(predictor, deviation);
    }
    probabilities.push_back(place->second);
  }
  return probabilities;
}

double SimulatedStudy::shareDifference() const {
  const std::vector<double> right = probabilities();
  std::vector<std::array<Mean, 2>> bySubject(subjectCount_);
  for (size_t i = 0; i < trials_.size(); ++i) {
    bySubject[subjects_[i]][trials_[i].view == TrialView::kOther].add(right[i]);
  }
  Mean difference;
  for (const std::array<Mean, 2>& views : bySubject) {
    difference.add(views[1].value() - views[0].value());
  }
  return difference.value();
}

double SimulatedStudy::limitedMeanDifference() const {
  const double deviation = std::hypot(std::hypot(truth_.ofSubjects, truth_.ofSubjectViews / 2),
                                      std::hypot(truth_.ofItems, truth_.ofItemViews / 2), truth_.ofTrials);
  std::array<Mean, 2> means{};
  for (size_t i = 0; i < trials_.size(); ++i) {
    means[trials_[i].view == TrialView::kOther].add(limitedMean(predictor_[i], deviation, truth_.limitSeconds));
  }
  return means[1].value() - means[0].value();
}

TrialList listOf(const std::vector<Trial>& trials) {
  TrialList list;
  for (const Trial& trial : trials) {
    list.push_back(&trial);
  }
  return list;
}

}  // namespace ocelli
