#include "analysis/report/methods_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/inference/holm.h"

namespace ocelli {
namespace {

Estimable<double> pValueOf(const ReportWork& work, const Hypothesis& hypothesis) {
  for (const TestOutcome& outcome : work.outcomes) {
    if (outcome.model == hypothesis.model && outcome.term == hypothesis.term) {
      return outcome.pValue;
    }
  }
  return Estimable<double>::impossible("its model was not fitted");
}

/// The first cell of the table of a model, whose rows are those of the whole model.
std::vector<std::string> cellsOf(const ReportOrigins& origins, const std::string& model) {
  for (const Table& table : origins.tables) {
    if (table.name == model) {
      return {table.rows.front().cells.front().name};
    }
  }
  return {};
}

}  // namespace

void addHypotheses(ReportWork& work) {
  const AnalysisPlan& plan = work.analysis.plan;
  addHeading(work.document, 1, "Hypotheses", "hypotheses");
  if (!plan.isRegistered()) {
    work.document.add(ReportNote{NoteKind::kWarning,
                                 "No plan was registered: these hypotheses and families are defaults, so that their "
                                 "tests confirm nothing."});
  }
  std::vector<std::string> leftOut;
  for (HypothesisFamily family : plan.families) {
    std::erase_if(family.hypotheses, [&](const std::string& name) {
      const Hypothesis* hypothesis = plan.findHypothesis(name);
      const PlannedModel* model = hypothesis ? plan.findModel(hypothesis->model) : nullptr;
      const bool isLeftOut = model && !work.isWanted(model->task);
      if (isLeftOut) {
        leftOut.push_back(name);
      }
      return isLeftOut;
    });
    if (family.hypotheses.empty()) {
      continue;
    }
    std::vector<double> pValues;
    std::vector<std::string> reasons;
    for (const std::string& name : family.hypotheses) {
      const Hypothesis* hypothesis = plan.findHypothesis(name);
      const Estimable<double> p =
          hypothesis ? pValueOf(work, *hypothesis) : Estimable<double>::impossible("the plan does not say what it is");
      pValues.push_back(p ? *p : kNotKnown);
      reasons.push_back(p ? "" : p.reason());
    }
    const std::vector<double> adjusted = family.holm ? holmAdjusted(pValues) : pValues;
    ReportTable table{
        fmt::format("Family {}, {}", family.name, family.holm ? "corrected by Holm's method" : "not corrected"),
        fmt::format("family-{}", family.name),
        {{"Hypothesis", "", true}, {"Statement", "", true}, {"p"}, {"Adjusted p"}, {"Result", "", true}},
        {}};
    OriginTable origins(work.document.origins, table.id, table.caption, {"p", "adjusted"});
    for (size_t i = 0; i < pValues.size(); ++i) {
      const Hypothesis* hypothesis = plan.findHypothesis(family.hypotheses[i]);
      const bool known = std::isfinite(pValues[i]);
      const std::string source =
          hypothesis ? fmt::format("p value of {} in model {}",
                                   hypothesis->term.empty() ? "the test" : hypothesis->term, hypothesis->model)
                     : "";
      const std::string origin =
          known ? origins.addRow(family.hypotheses[i], source,
                                 {{}, Cell::From::kCells, cellsOf(work.document.origins, hypothesis->model)}, "",
                                 {pValues[i], adjusted[i]})
                : "";
      const auto cell = [&](double p, const char* number) {
        ReportCell result{!known      ? std::string("-")
                          : p < 0.001 ? std::string("< 0.001")
                                      : fmt::format("{:.3f}", p),
                          origin.empty() ? "" : fmt::format("{}/{}", origin, number), known ? source : ""};
        if (known) {
          result.value = p;
        }
        return result;
      };
      table.rows.push_back(
          {ReportCell{family.hypotheses[i]}, ReportCell{hypothesis ? hypothesis->statement : ""}, cell(pValues[i], "p"),
           cell(adjusted[i], "adjusted"),
           ReportCell{!known ? fmt::format("cannot be tested: {}", reasons[i])
                             : std::string(adjusted[i] < plan.alpha ? "supported" : "not supported")}});
    }
    origins.finish();
    work.document.add(table);
  }
  if (!leftOut.empty()) {
    work.document.add(ReportNote{
        NoteKind::kNote,
        fmt::format("Left out with their tasks, and not counted in corrections: {}.", fmt::join(leftOut, ", "))});
  }
}

void addMethods(ReportWork& work, const std::string& version) {
  const AnalysisPlan& plan = work.analysis.plan;
  addHeading(work.document, 1, "Methods", "methods");
  work.document.add(ReportExcerpt{
      "Methods",
      fmt::format("We analysed {} trials of {} subjects with Ocelli {}; {}. {} Within families of hypotheses p values "
                  "were corrected by Holm's method at a level of {}. SHA-256 of the data: {}.{}",
                  work.analysis.flow.analysedTrials, work.analysis.flow.analysed, version, describe(plan),
                  fmt::join(work.methods, " "), plan.alpha, work.analysis.dataSha256,
                  work.analysis.data.isSimulated() ? " Subjects were simulated." : "")});
}

}  // namespace ocelli
