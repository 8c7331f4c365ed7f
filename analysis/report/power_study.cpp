#include "analysis/report/power_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/response_scale.h"

namespace ocelli {
namespace {

using Place = NeededSubjects::Place;

std::string boundText(const NeededSubjects& needed) {
  switch (needed.place) {
    case Place::kAtMost:
      return fmt::format("{:.0f} or fewer", needed.subjects);
    case Place::kAbout:
      return fmt::format("{:.0f}", std::ceil(needed.subjects - 1e-9));
    case Place::kMoreThan:
      return fmt::format("more than {:.0f}", needed.subjects);
  }
  return "";
}

std::string errorText(const PowerStudy& study, const PowerCurve& curve) {
  Share all;
  for (const PowerSize& size : curve.sizes) {
    all.successes += size.found.successes;
    all.trials += size.found.trials;
  }
  const Estimate share = clopperPearsonShare(all);
  return fmt::format(
      "{:.1f} % of all studies find it though it is not there (95 % interval {:.1f} to {:.1f} %; alpha {:g} %)",
      100 * share.value, 100 * share.lower, 100 * share.upper, 100 * study.alpha);
}

/// Of the plan: which tests beside this one share its alpha.
void addCorrections(const PowerStudy& study, std::vector<std::string>& cautions) {
  for (const HypothesisFamily& family : study.plan.families) {
    if (!family.holm || family.hypotheses.size() < 2) {
      continue;
    }
    for (const std::string& name : family.hypotheses) {
      const Hypothesis* hypothesis = study.plan.findHypothesis(name);
      const PlannedModel* model = hypothesis == nullptr ? nullptr : study.plan.findModel(hypothesis->model);
      if (model == nullptr || model->task != study.task) {
        continue;
      }
      const bool isView = model->name == study.model && hypothesis->term == "view";
      const bool isEquivalence = study.bounds && model->kind == ModelKind::kEquivalence;
      if (isView || isEquivalence) {
        cautions.push_back(
            fmt::format("The plan tests \"{}\" with {} others in the family \"{}\" by Holm's correction, and the power "
                        "here is that "
                        "of the test alone, at alpha {:g}: at {:.3g} it holds whatever the others give",
                        name, family.hypotheses.size() - 1, family.name, study.alpha,
                        study.plan.alpha / static_cast<double>(family.hypotheses.size())));
      }
    }
  }
}

/// The same of a contrast.
void addCorrectionOfContrast(const PowerStudy& study, std::vector<std::string>& cautions) {
  const std::vector<PlannedContrast>& contrasts = study.plan.contrasts;
  const auto tested = std::find_if(contrasts.begin(), contrasts.end(),
                                   [&](const PlannedContrast& each) { return each.name == study.contrast; });
  if (tested == contrasts.end()) {
    return;
  }
  const auto inFamily = std::count_if(contrasts.begin(), contrasts.end(),
                                      [&](const PlannedContrast& each) { return each.family == tested->family; });
  if (inFamily > 1) {
    cautions.push_back(fmt::format(
        "The plan tests \"{}\" with {} others in the family \"{}\" by Holm's correction, and the power here "
        "is that of the test alone, at alpha {:g}: at {:.3g} it holds whatever the others give",
        tested->name, inFamily - 1, tested->family, study.alpha, study.plan.alpha / static_cast<double>(inFamily)));
  }
}

}  // namespace

std::vector<PowerPoint> pointsOf(const PowerCurve& curve) {
  std::vector<PowerPoint> points;
  for (const PowerSize& size : curve.sizes) {
    points.push_back({size.subjects, size.found});
  }
  return points;
}

std::string effectName(const PowerStudy& study) {
  const PlannedModel* model = study.plan.findModel(study.model);
  return responseScale(model == nullptr ? PlannedModel{"", "", ModelKind::kBinomialMixed} : *model, study.unit).one;
}

std::string nameOf(const PowerCurve& curve) {
  return fmt::format("{}, {}", curve.truth,
                     !curve.contrast.empty()                 ? fmt::format("test of {}", curve.contrast)
                     : curve.test == PowerCurve::Test::kView ? std::string("test of the view")
                                                             : std::string("test of equivalence"));
}

std::string answerOf(const PowerStudy& study, const PowerCurve& curve) {
  if (curve.question == PowerCurve::Question::kFalseAlarm) {
    return errorText(study, curve);
  }
  const SubjectsForPower needed = subjectsForPower(pointsOf(curve), study.power);
  const std::string fewest = boundText(needed.fewest);
  const std::string most = boundText(needed.most);
  const std::string interval = fmt::format("95 % interval of the simulation: {}",
                                           fewest == most ? fewest : fmt::format("{} to {}", fewest, most));
  if (needed.estimate.place == Place::kMoreThan) {
    return fmt::format("a power of {:g} is not reached with {:.0f} subjects ({})", study.power,
                       needed.estimate.subjects, interval);
  }
  return fmt::format("a power of {:g} takes {} subjects ({})", study.power, describe(needed.estimate), interval);
}

std::vector<std::string> cautionsOf(const PowerStudy& study) {
  std::vector<std::string> cautions;
  for (const PowerCurve& curve : study.curves) {
    int notEstimable = 0;
    int studies = 0;
    std::string reason;
    for (const PowerSize& size : curve.sizes) {
      notEstimable += size.notEstimable;
      studies += size.found.trials;
      reason = reason.empty() ? size.reason : reason;
      // One of all sizes is above alpha by chance in 1 of 40 analyses at most (Bonferroni).
      const double level = 1 - 0.05 / static_cast<double>(curve.sizes.size());
      const Estimate share = clopperPearsonShare(size.found, level);
      if (curve.question == PowerCurve::Question::kFalseAlarm && share.lower > study.alpha) {
        cautions.push_back(fmt::format(
            "With {} subjects, {:.1f} % of studies find what is not there ({}), more than alpha: their power "
            "looks better than it is",
            size.subjects, 100 * share.value, nameOf(curve)));
      }
    }
    if (notEstimable > 0) {
      cautions.push_back(
          fmt::format("{} of {} studies had no result ({}), which counts as nothing found; the first: {}", notEstimable,
                      studies, nameOf(curve), reason));
    }
  }
  addCorrections(study, cautions);
  addCorrectionOfContrast(study, cautions);
  return cautions;
}

}  // namespace ocelli
