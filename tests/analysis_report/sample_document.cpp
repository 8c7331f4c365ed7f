#include "tests/analysis_report/sample_document.h"

#include <fmt/format.h>

#include <limits>

#include "analysis/plot/axis.h"
#include "tests/analysis_plot/sample_figures.h"

namespace ocelli {
namespace {

ReportCell number(const std::string& text, const std::string& id, double value, const std::string& source) {
  return {text, id, source, value};
}

ReportTable smallTable() {
  ReportTable table;
  table.caption =
      "Average time to find objects for subjects who took part in three sessions, beside the published values.";
  table.id = "table-7-1";
  table.columns = {{"Session"},       {"ppc", "Stationary"}, {"gc", "Stationary"}, {"n", "Stationary"},
                   {"ppc", "Moving"}, {"gc", "Moving"},      {"n", "Moving"}};
  const double ppc[] = {19.7, 15.7, 14.3};
  const double gc[] = {12.9, 10.9, 9.2};
  for (int session = 1; session <= 3; ++session) {
    const std::string source =
        fmt::format("SELECT avg(response_s) FROM final_trial WHERE task = 'find' AND session = {}", session);
    const auto cell = [&](const std::string& name, double value, int decimals) {
      return number(numberText(value, decimals), fmt::format("t71-s{}-{}", session, name), value, source);
    };
    table.rows.push_back({{fmt::format("Session {}", session)},
                          cell("ppc", ppc[session - 1], 1),
                          cell("gc", gc[session - 1], 1),
                          cell("n", 25, 0),
                          cell("moving-ppc", ppc[session - 1] * 0.6, 1),
                          cell("moving-gc", gc[session - 1] * 0.7, 1),
                          cell("moving-n", 25, 0)});
  }
  table.rows[0][1].footnote = "33 trials ran out of time and count with 60 s.";
  table.rows[2][4].footnote = "One trial without an answer is left out.";
  table.rows[1][2].emphasised = true;
  return table;
}

ReportTable longTable() {
  ReportTable table;
  table.caption = "Every exclusion, row by row.";
  table.columns = {{"Trial"}, {"Subject"}, {"Task"}, {"Session"}, {"View"}, {"Response, s"}, {"Why", "", true}};
  for (int i = 1; i <= 70; ++i) {
    const std::string source = fmt::format("trial.id = {}", i);
    table.rows.push_back(
        {number(fmt::format("{}", i), fmt::format("excluded-{}", i), i, source),
         {fmt::format("S{:03}", i % 45)},
         {i % 3 == 0 ? "count" : "find"},
         {fmt::format("{}", 1 + i % 3)},
         {i % 2 == 0 ? "ppc" : "gc"},
         number(fmt::format("{:.2f}", 0.37 * i), "", 0.37 * i, source),
         {i % 7 == 0 ? "The session was broken off before its survey, and the plan excludes such sessions"
                     : "More than five frames were dropped"}});
  }
  return table;
}

ReportTable wideTable() {
  ReportTable table;
  table.caption = "Mixed model of log times: every coefficient.";
  table.columns = {{"Coefficient"}};
  for (const char* name : {"Estimate", "Standard error", "Lower", "Upper", "t", "Degrees of freedom", "p", "p, Holm",
                           "Ratio", "Ratio, lower", "Ratio, upper", "Bootstrap, lower", "Bootstrap, upper"}) {
    table.columns.push_back({name});
  }
  for (const char* name : {"(Intercept)", "view gc", "session", "view gc x session"}) {
    std::vector<ReportCell> row{{name}};
    for (size_t i = 1; i < table.columns.size(); ++i) {
      row.push_back(number(numberText(-0.4137 * static_cast<double>(i), 4), "", -0.4137 * static_cast<double>(i),
                           "linear mixed model, 1,048 rows of find"));
    }
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

ReportDocument sampleDocument() {
  ReportDocument document;
  document.title = "Graph camera against pinhole camera: finding, counting and matching paths";
  document.subtitle = "Analysis of the study \u201cmaze-2026\u201d, 47 subjects, three sessions";
  document.marking = "Simulated subjects";
  document.version = "0.1.0";
  document.created = "2026-03-01T12:00:00Z";
  document.add(ReportHeading{1, "Design and data"});
  document.add(
      ReportNote{NoteKind::kSimulated, "All rows come from simulated observers. They say nothing about people."});
  document.add(
      ReportParagraph{"Each subject saw every case in both views, in an order that was balanced over subjects. A trial "
                      "of finding ended "
                      "after 60 s, and counts as censored there. Nothing that follows was looked at before the plan "
                      "was fixed: its digest "
                      "stands below, beside that of the data."});
  document.add(ReportFacts{{{"Program", "Ocelli 0.1.0"},
                            {"Seed", "20260301"},
                            {"Plan", "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08", true},
                            {"Data", "60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752", true},
                            {"Denominators", "find: 520 trials of 45 subjects; count: 450; path: 225"}}});
  const std::vector<SampleFigure> figures = sampleFigures();
  const auto figure = [&](const std::string& name) {
    for (const SampleFigure& sample : figures) {
      if (sample.name == name) {
        return sample.figure;
      }
    }
    return Figure{};
  };
  document.add(ReportFigure{"The way of the subjects through the study.", "flow", figure("flow")});
  document.add(ReportHeading{1, "Finding"});
  document.add(ReportHeading{2, "Times"});
  document.add(
      ReportParagraph{"The published values were computed without the trials that ran out of time; so are these."});
  document.add(smallTable());
  document.add(
      ReportFigure{"Times of all cases, both views. Small marks are trials; large ones are means with 95 % intervals.",
                   "cases", figure("cases")});
  document.add(ReportFigure{"Still searching, by the time since the start. Bands are pointwise 95 % intervals.",
                            "survival", figure("survival")});
  document.add(ReportHeading{3, "What the model assumes"});
  document.add(
      ReportList{{"Log times are normal around what is fitted.", "Subjects and cases differ by random amounts.",
                  "Censored trials are as long as they were watched, and no longer, which the linear model does "
                  "not know: see the accelerated failure time model for that."}});
  document.add(wideTable());
  document.add(ReportFigure{"Residuals of the mixed model.", "check", figure("check")});
  document.add(ReportFigure{"The ratio of times under other choices.", "forest", figure("forest")});
  document.add(
      ReportNote{NoteKind::kNotEstimable,
                 "The interaction of view and session cannot be estimated because only one session has trials of "
                 "both views."});
  document.add(ReportNote{NoteKind::kWarning, "The fit is singular: the variance of cases was estimated as 0."});
  document.add(ReportNote{NoteKind::kNote, "A ratio below 1 says that the graph camera is faster."});
  document.add(ReportHeading{1, "Counting, paths and survey"});
  for (const char* name : {"accuracy", "errors", "learning", "paired", "strip", "ratings", "heat", "power"}) {
    document.add(ReportFigure{figure(name).title + ".", name, figure(name)});
  }
  document.add(ReportHeading{1, "Exclusions"});
  document.add(longTable());
  document.add(ReportHeading{1, "Methods"});
  document.add(ReportExcerpt{"Methods paragraph",
                             "Times to find were modelled by a linear mixed model on the logarithm, with view, session "
                             "and their interaction as "
                             "fixed effects and random intercepts of subjects and cases, fitted by restricted maximum "
                             "likelihood. Intervals are of "
                             "95 %; degrees of freedom after Satterthwaite. P values were corrected after Holm within "
                             "each family of the plan."});
  return document;
}

ReportDocument hostileDocument() {
  const std::string attack =
      "</title></style></script><script>alert(1)</script><img src=\"http://a.example/x\" onerror='x'>\" autofocus "
      "url(http://a.example) & \x01\xFF\xC3( ]]> --> {0} %s";
  ReportDocument document;
  document.title = attack;
  document.subtitle = attack;
  document.marking = attack;
  document.version = attack;
  Figure figure = sampleFigures().back().figure;
  figure.title = attack;
  figure.description = attack;
  figure.drawing.text("label", {5, 12}, attack, {});
  document.add(ReportHeading{1, attack, attack});
  document.add(ReportHeading{2, attack, attack});
  document.add(ReportParagraph{attack});
  document.add(ReportList{{attack, ""}});
  document.add(ReportFacts{{{attack, attack, true}, {"", ""}}});
  document.add(ReportNote{NoteKind::kSimulated, attack});
  document.add(ReportExcerpt{attack, attack});
  document.add(ReportTable{attack,
                           attack,
                           {{attack, attack}, {attack, attack, true}},
                           {{{attack, attack, attack, 1, attack}, {attack, "b", attack, std::nullopt, attack, true}},
                            {{"", "", "", std::numeric_limits<double>::quiet_NaN()}}}});
  document.add(ReportFigure{attack, attack, figure});
  return document;
}

}  // namespace ocelli
