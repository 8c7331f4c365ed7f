#include "analysis/report/flow_section.h"

#include <fmt/format.h>

#include "analysis/plot/flow_diagram.h"
#include "analysis/report/part_guard.h"

namespace ocelli {
namespace {

constexpr size_t kLongestLog = 30;

size_t sized(int count) {
  return static_cast<size_t>(count);
}

}  // namespace

void addFlowSection(ReportWork& work) {
  const SubjectFlow& flow = work.analysis.flow;
  addHeading(work.document, 1, "Flow of subjects", "flow");
  FlowDiagram diagram;
  diagram.title = "Flow of subjects";
  diagram.stages.push_back({"Enrolled", sized(flow.enrolled)});
  if (flow.consented) {
    diagram.stages.push_back({"Agreed to take part", sized(*flow.consented)});
  }
  diagram.stages.push_back({"Began", sized(flow.began)});
  for (const auto& [reason, count] : flow.excluded) {
    diagram.stages.back().lost.push_back({reason, sized(count)});
  }
  diagram.stages.push_back({"Analysed", sized(flow.analysed)});
  for (size_t k = 1; k < flow.analysedWithSessions.size(); ++k) {
    diagram.stages.push_back(
        {fmt::format("Completed {} sessions or more", k + 1), sized(flow.analysedWithSessions[k])});
  }
  addFigure(work, "Subjects, and why some were left out", "figure-flow", [&] { return flowFigure(diagram); });
  if (!flow.consentNote.empty()) {
    work.document.add(ReportNote{NoteKind::kNote, flow.consentNote});
  }
  work.document.add(ReportParagraph{fmt::format("{} trials count, {} were excluded and {} are analysed.", flow.trials,
                                                flow.excludedTrials, flow.analysedTrials)});
  for (const std::string& warning : work.analysis.warnings) {
    work.document.add(ReportNote{NoteKind::kWarning, warning});
  }
  if (work.analysis.excluded.empty()) {
    work.document.add(ReportParagraph{"No subject or session was excluded."});
    return;
  }
  const InSupplement supplement(work.document);
  ReportTable table{
      "Exclusions of subjects and sessions; all rows stand in tables/exclusions.csv",
      "exclusions",
      {{"Subject", "", true}, {"Session", "", true}, {"Rule", "", true}, {"Reason", "", true}, {"Trials"}},
      {}};
  table.isRecord = true;
  for (const ExcludedSubject& excluded : work.analysis.excluded) {
    if (table.rows.size() == kLongestLog) {
      work.document.add(ReportNote{NoteKind::kNote, fmt::format("The table shows {} of {} exclusions.", kLongestLog,
                                                                work.analysis.excluded.size())});
      break;
    }
    table.rows.push_back({ReportCell{excluded.subject},
                          ReportCell{excluded.session ? std::to_string(*excluded.session) : std::string("all")},
                          ReportCell{excluded.rule}, ReportCell{excluded.reason},
                          ReportCell{std::to_string(excluded.trials), "", "tables/exclusions.csv",
                                     static_cast<double>(excluded.trials)}});
  }
  work.document.add(table);
}

}  // namespace ocelli
