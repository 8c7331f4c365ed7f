#include "analysis/report/power_report.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/plot/power_plot.h"
#include "analysis/report/report_parts.h"

namespace ocelli {
namespace {

bool isView(const PowerCurve& curve) {
  return curve.test == PowerCurve::Test::kView;
}

bool isPower(const PowerCurve& curve) {
  return curve.question == PowerCurve::Question::kPower;
}

/// "power" or "type-I error" belongs to it.
std::string shortName(const PowerCurve& curve) {
  return fmt::format("{}{}{}", curve.truth, isView(curve) ? "" : ": equivalence", isPower(curve) ? "" : " (errors)");
}

std::string estimateName(const PowerStudy& study, const PowerCurve& curve) {
  return !isView(curve) ? "difference of shares" : effectName(study);
}

void addCurve(ReportDocument& document, const PowerStudy& study, const PowerCurve& curve, size_t number) {
  const std::string shareName = isPower(curve) ? "Power" : "Type-I error";
  ReportTable table{fmt::format("{}: {}", shareName, nameOf(curve)),
                    fmt::format("power-{}", number),
                    {{"Subjects"},
                     {"Analysed"},
                     {"Studies"},
                     {shareName},
                     {"95 % interval"},
                     {fmt::format("Mean {}", estimateName(study, curve))},
                     {"No result"},
                     {"Warnings"}},
                    {}};
  for (const PowerSize& size : curve.sizes) {
    const std::string source =
        fmt::format("{} studies of {} subjects, {}, simulated with seed {}: {} found it", size.found.trials,
                    size.subjects, curve.truth, study.seed, size.found.successes);
    const auto cell = [&](const std::string& text, double value) {
      ReportCell result{text};
      result.source = source;
      result.value = std::isfinite(value) ? std::optional(value) : std::nullopt;
      return result;
    };
    const Estimate share = clopperPearsonShare(size.found);
    table.rows.push_back(
        {ReportCell{std::to_string(size.subjects)}, cell(fmt::format("{:.1f}", size.analysed), size.analysed),
         cell(std::to_string(size.found.trials), size.found.trials),
         cell(fmt::format("{:.1f} %", 100 * share.value), share.value),
         cell(fmt::format("{:.1f} to {:.1f} %", 100 * share.lower, 100 * share.upper), kNotKnown),
         cell(numberText(size.estimate), size.estimate), cell(std::to_string(size.notEstimable), size.notEstimable),
         cell(std::to_string(size.warned), size.warned)});
  }
  document.add(table);
  document.add(ReportParagraph{fmt::format("True {}: {}; {}.", estimateName(study, curve), numberText(curve.trueValue),
                                           answerOf(study, curve))});
}

void addSuppositions(ReportDocument& document, const PowerStudy& study) {
  addHeading(document, 1, "What was supposed", "supposed");
  ReportList list{study.supposed};
  list.items.push_back(study.dropOut > 0
                           ? fmt::format("{:g} % of subjects do not come back after each session", 100 * study.dropOut)
                           : fmt::format("all subjects take part in all {} sessions", study.sessions));
  document.add(list);
  document.add(ReportParagraph{
      "Times are log-normal and end at the limit of the task; answers are right or wrong by logits; errors of "
      "estimates "
      "are normal; subjects and cases "
      "differ normally. Real subjects may differ in other ways: a case that only one view shows, fatigue, guessing. "
      "The numbers are as good as these suppositions: try others."});
  addHeading(document, 1, "How it was done", "how");
  ReportFacts facts;
  facts.facts = {{"Protocol", study.protocolName},
                 {"SHA-256 of the protocol", study.protocolSha256, true},
                 {"Task", study.task},
                 {"Plan", describe(study.plan)},
                 {"Model", study.contrast.empty() ? fmt::format("{}, its term view", study.model)
                                                  : fmt::format("{}, its contrast {}", study.model, study.contrast)},
                 {"Alpha", fmt::format("{:g}, two-sided", study.alpha)},
                 {"Studies", fmt::format("{} of each number of subjects, of each kind", study.simulations)},
                 {"Seed", std::to_string(study.seed)}};
  if (study.bounds) {
    facts.facts.push_back({"Bounds of equivalence",
                           withViewNames(fmt::format("{:g} to {:g} (shares of right answers, @other@ less @reference@)",
                                                     study.bounds->lower, study.bounds->upper),
                                         study.conditions)});
  }
  document.add(facts);
  document.add(ReportExcerpt{
      "For a methods section",
      fmt::format("Power was found by simulation: for each number of subjects, {} studies were drawn with the schedule "
                  "and counterbalancing of the protocol, thinned by the exclusions of the plan, and analysed by its "
                  "model \"{}\"; power is the share of studies in which {} had p <= {:g}. Intervals "
                  "are exact (Clopper and Pearson); the number of subjects for a power of {:g} is interpolated "
                  "linearly between the simulated numbers.",
                  study.simulations, study.model,
                  study.contrast.empty() ? std::string("the effect of the view")
                                         : fmt::format("the contrast \"{}\"", study.contrast),
                  study.alpha, study.power)});
}

}  // namespace

Figure powerStudyFigure(const PowerStudy& study) {
  PowerPlot plot;
  plot.title = fmt::format("Power and type-I error of {} studies by {}", study.task, study.protocolName);
  plot.target = study.power;
  plot.powerLabel = "Studies that find it";
  plot.widthMillimetres = kDoubleColumnMillimetres;
  for (const PowerCurve& curve : study.curves) {
    PowerPlot::Curve line{shortName(curve), {}};
    for (const PowerSize& size : curve.sizes) {
      line.points.push_back({static_cast<double>(size.subjects), intervalOf(clopperPearsonShare(size.found))});
    }
    plot.curves.push_back(line);
  }
  return powerFigure(plot);
}

ReportDocument powerReport(const PowerStudy& study, const std::string& version, const std::string& created) {
  ReportDocument document;
  document.title = "How many subjects a study needs";
  document.subtitle = fmt::format("{}, task {}", study.protocolName, study.task);
  document.marking = "Simulated studies";
  document.version = version;
  document.created = created;
  document.add(ReportNote{NoteKind::kSimulated,
                          "All studies here are simulated, with effects that were supposed: they say nothing about "
                          "people."});
  addHeading(document, 1, "Answer", "answer");
  ReportList answers;
  for (const PowerCurve& curve : study.curves) {
    answers.items.push_back(fmt::format("{}: {}.", nameOf(curve), answerOf(study, curve)));
  }
  document.add(answers);
  for (const std::string& caution : cautionsOf(study)) {
    document.add(ReportNote{NoteKind::kWarning, caution + "."});
  }
  document.add(ReportFigure{
      fmt::format("Share of studies that find what is tested, with 95 % intervals of the simulation; across: {:g}",
                  study.power),
      "figure-power", powerStudyFigure(study)});
  addHeading(document, 1, "Numbers", "numbers");
  document.add(
      ReportParagraph{"Analysed: subjects that the plan's exclusions leave, mean of the studies. No result: studies "
                      "whose model cannot be "
                      "estimated; they found nothing. Warnings: studies whose fit is singular, did not converge or "
                      "lacks a column; they "
                      "count as they came out."});
  for (size_t i = 0; i < study.curves.size(); ++i) {
    addCurve(document, study, study.curves[i], i + 1);
  }
  addSuppositions(document, study);
  return document;
}

}  // namespace ocelli
