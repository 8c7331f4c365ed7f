#include "analysis/report/learning_change.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

namespace ocelli {
namespace {

double slopeOf(const std::map<int, double>& means) {
  const auto count = static_cast<double>(means.size());
  double meanX = 0;
  double meanY = 0;
  for (const auto& [session, mean] : means) {
    meanX += session / count;
    meanY += mean / count;
  }
  double squares = 0;
  double products = 0;
  for (const auto& [session, mean] : means) {
    squares += (session - meanX) * (session - meanX);
    products += (session - meanX) * (mean - meanY);
  }
  return products / squares;
}

}  // namespace

BlockHalves::BlockHalves(const TrialList& trials) {
  using Part = std::tuple<int, int, TrialView>;  // session, block, view
  std::map<Part, std::map<std::string, TrialList>> parts;
  for (const Trial* trial : trials) {
    parts[{trial->session, trial->blockIndex, trial->view}][trial->subject].push_back(trial);
  }
  std::map<std::pair<std::string, TrialView>, std::array<TrialList, 2>> items;
  for (auto& [part, subjects] : parts) {
    size_t complete = 0;
    for (const auto& [subject, own] : subjects) {
      complete = std::max(complete, own.size());
    }
    for (auto& [subject, own] : subjects) {
      if (own.size() < complete) {
        continue;
      }
      std::sort(own.begin(), own.end(), [](const Trial* a, const Trial* b) { return a->planIndex < b->planIndex; });
      for (size_t i = 0; i < complete / 2; ++i) {
        const Trial* late = own[complete - 1 - i];
        items[{own[i]->item(), own[i]->view}][0].push_back(own[i]);
        items[{late->item(), late->view}][1].push_back(late);
      }
    }
  }
  for (const auto& [item, lists] : items) {
    if (lists[0].empty() || lists[1].empty()) {
      continue;
    }
    for (size_t half = 0; half < 2; ++half) {
      for (const Trial* trial : lists[half]) {
        halves_[trial] = half == 0 ? BlockHalf::kFirst : BlockHalf::kSecond;
      }
    }
  }
}

TrialValues BlockHalves::valuesOf(const TrialValues& values, BlockHalf half) const {
  TrialValues some;
  std::copy_if(values.begin(), values.end(), std::back_inserter(some), [&](const TrialValue& value) {
    const auto known = halves_.find(value.trial);
    return known != halves_.end() && known->second == half;
  });
  return some;
}

TrialValues valuesOfSession(const TrialValues& values, int session) {
  TrialValues some;
  std::copy_if(values.begin(), values.end(), std::back_inserter(some),
               [&](const TrialValue& value) { return value.trial->session == session; });
  return some;
}

SubjectNumbers sessionSlopes(const TrialValues& values) {
  std::map<int, TrialValues> bySession;
  for (const TrialValue& value : values) {
    bySession[value.trial->session].push_back(value);
  }
  std::map<std::string, std::map<int, double>> means;
  for (const auto& [session, some] : bySession) {
    for (const auto& [subject, mean] : subjectMeans(some).bySubject) {
      means[subject][session] = mean;
    }
  }
  SubjectNumbers slopes;
  for (const auto& [subject, own] : means) {
    if (own.size() > 1) {
      slopes.bySubject[subject] = slopeOf(own);
    }
  }
  for (const TrialValue& value : values) {
    if (slopes.bySubject.contains(value.trial->subject)) {
      slopes.trials.push_back(value.trial);
    }
  }
  return slopes;
}

SubjectNumbers halfDifferences(const TrialValues& values, const BlockHalves& halves) {
  return subjectDifferences(subjectMeans(halves.valuesOf(values, BlockHalf::kFirst)),
                            subjectMeans(halves.valuesOf(values, BlockHalf::kSecond)));
}

}  // namespace ocelli
