#include "analysis/tables/paper_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "analysis/dataset/form_item.h"
#include "analysis/dataset/protocol_facts.h"
#include "analysis/tables/neutral_tables.h"
#include "analysis/tables/published_values.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

constexpr int kPublishedSessions = 3;
constexpr const char* kFirstSession = "Trials of the first session of all subjects.";

/// As the protocol plans, or else as many as there are.
int sessionsOf(const Dataset& data) {
  int sessions = 1;
  for (const DataSource& source : data.sources) {
    if (!source.protocolText.empty()) {
      return protocolFacts(source.protocolText, source.path).sessions;
    }
  }
  for (const Session& session : data.sessions) {
    sessions = std::max(sessions, session.number);
  }
  return sessions;
}

const char* objectsName(bool moving) {
  return moving ? "moving" : "stationary";
}

/// A row's cells for either view, and what the text has.
using CellOf = std::function<Cell(std::string name, const TrialList& trials)>;

class PaperTables {
 public:
  PaperTables(const AnalysisData& analysis, const PaperTableOptions& options)
      : analysis_(analysis),
        options_(options),
        isOfPaper_(isOfRosen2010(analysis.data)),
        sessions_(isOfPaper_ ? kPublishedSessions : sessionsOf(analysis.data)),
        completed_(completedSessions(analysis.data)) {
    for (const Trial& trial : analysis.data.trials) {
      byTask_[trial.task].push_back(&trial);
    }
  }

  std::vector<Table> all() {
    std::vector<Table> tables{subjects(),    findMeans(),    timeouts(), table71(),     figure75(), countMeans(),
                              table72Left(), table72Right(), table73(),  countErrors(), paths(),    survey()};
    if (!isOfPaper_) {
      makeNeutral(tables, conditions());
    }
    return tables;
  }

 private:
  Table subjects() const;
  Table findMeans() const;
  Table timeouts() const;
  Table table71() const;
  Table figure75() const;
  Table countMeans() const;
  Table table72Left() const;
  Table table72Right() const;
  Table table73() const;
  Table countErrors() const;
  Table paths() const;
  Table survey() const;

  template <class Keep>
  TrialList trialsOf(const char* task, const Keep& keep) const {
    TrialList list;
    if (const auto found = byTask_.find(task); found != byTask_.end()) {
      std::copy_if(found->second.begin(), found->second.end(), std::back_inserter(list),
                   [&](const Trial* trial) { return keep(*trial); });
    }
    return list;
  }
  static TrialList ofView(const TrialList& trials, TrialView view) {
    TrialList list;
    std::copy_if(trials.begin(), trials.end(), std::back_inserter(list),
                 [&](const Trial* trial) { return trial->view == view; });
    return list;
  }
  bool cameToAllSessions(const Trial& trial) const {
    const auto found = completed_.find(trial.subject);
    return found != completed_.end() && found->second >= sessions_;
  }
  std::string allSessions() const {
    return sessions_ == kPublishedSessions ? "three sessions"
           : sessions_ == 1                ? "one session"
                                           : fmt::format("{} sessions", sessions_);
  }
  /// Whether some trial of the task, or what the text tells, has such objects.
  CellOf meanTime() const {
    return [timeouts = options_.timeouts](std::string name, const TrialList& trials) {
      return meanTimeCell(std::move(name), trials, timeouts);
    };
  }
  std::string timeoutNote() const {
    if (options_.timeouts == TimeoutsInMeans::kRemoved) {
      return fmt::format("Means are of searches that ended in time{}.", isOfPaper_ ? ", as in the text" : "");
    }
    return fmt::format("Searches whose time ran out count as if the object had been found then{}.",
                       isOfPaper_ ? "; the text leaves them out" : "");
  }

  const ViewConditions& conditions() const { return analysis_.data.conditions; }
  /// Columns of cells, whose names may hold marks of view conditions.
  void setColumns(Table& table, const std::vector<std::string>& marked) const {
    table.shownNames = marked;
    table.cellNames.clear();
    for (const std::string& name : marked) {
      table.cellNames.push_back(withViewNames(name, conditions()));
    }
  }

  /// Either view, and what the text has.
  void addViews(TableRow& row, const std::string& name, const TrialList& trials, const CellOf& cellOf,
                const PublishedPair& published) const {
    for (const TrialView view : kViews) {
      const std::string cellName = fmt::format("{}/{}", name, conditions().nameOf(view));
      row.cells.push_back(cellOf(cellName, ofView(trials, view)));
      row.cells.push_back(publishedCell(fmt::format("{}/published", cellName), published.of(view),
                                        row.cells.back().unit, "as the text reports it"));
    }
  }
  /// After addViews(): by how much the other view is faster, and the text's.
  static void addFasterBy(TableRow& row, const std::string& name, std::optional<double> published) {
    row.cells.push_back(lessByCell(fmt::format("{}/faster", name), row.cells[0], row.cells[2]));
    row.cells.push_back(
        publishedCell(fmt::format("{}/faster/published", name), published, "%", "as the text reports it"));
  }

  /// Two rows, of stationary and moving objects.
  Table byObjects(const char* name, const char* title, const char* task, const CellOf& cellOf,
                  const std::function<PublishedPair(bool moving)>& published) const;
  /// Rows of sessions 1 to 3 of subjects who completed three, for stationary and moving objects.
  Table bySession(const char* name, const char* title, const char* task, const CellOf& cellOf,
                  const std::function<PublishedPair(bool moving, int session)>& published) const;

  const AnalysisData& analysis_;
  PaperTableOptions options_;
  bool isOfPaper_;
  int sessions_;  ///< of whom completed them tables by session tell
  std::map<std::string, int> completed_;
  std::map<std::string, TrialList> byTask_{};
};

const std::vector<std::string> kViewColumns{"@reference@", "published", "@other@", "published"};
const std::vector<std::string> kTimeColumns{"@reference@", "published",         "@other@",
                                            "published",   "@other@ faster by", "published"};

Table PaperTables::subjects() const {
  Table table{"subjects", "Section 7.4.1: subjects", {"step"}, {"subjects", "published"}, {}};
  const SubjectFlow& flow = analysis_.flow;
  const auto add = [&](const std::string& head, const std::string& name, std::optional<int> count,
                       const std::string& missing, std::optional<double> published, std::vector<std::string> ids) {
    Cell cell;
    cell.name = fmt::format("subjects/{}", name);
    cell.from = Cell::From::kSubjects;
    cell.decimals = 0;
    cell.missing = missing;
    cell.meaning = fmt::format("subjects who {}", head);
    cell.subjects = std::move(ids);
    if (count) {
      cell.value = *count;
    }
    Cell fromText = publishedCell(fmt::format("subjects/{}/published", name), published, "", "as the text reports it");
    fromText.decimals = 0;
    table.rows.push_back({{head}, {std::move(cell), std::move(fromText)}});
  };
  std::vector<std::string> all;
  for (const Subject& subject : analysis_.data.subjects) {
    all.push_back(subject.id);
  }
  add("are in the files", "enrolled", flow.enrolled, "", std::nullopt, all);
  std::set<std::string> agreed;
  for (const Consent& consent : analysis_.data.consents) {
    if (consent.agreed) {
      agreed.insert(consent.subject);
    } else {
      agreed.erase(consent.subject);
    }
  }
  add("agreed to take part", "consented", flow.consented, flow.consentNote, std::nullopt,
      flow.consented ? std::vector<std::string>(agreed.begin(), agreed.end()) : std::vector<std::string>());
  std::set<std::string> analysed;
  for (const Trial& trial : analysis_.data.trials) {
    analysed.insert(trial.subject);
  }
  std::set<std::string> began = analysed;
  for (const LeftOutRow& row : analysis_.data.leftOut) {
    if (row.table == LeftOutRow::Table::kTrial && analysis_.data.findSubject(row.subject) != nullptr) {
      began.insert(row.subject);
    }
  }
  add("ended a trial", "began", flow.began, "", 47, {began.begin(), began.end()});
  const size_t sessions = std::max(flow.completedSessions.size(), static_cast<size_t>(sessions_));
  for (size_t k = 1; k <= sessions; ++k) {
    std::vector<std::string> ids;
    for (const auto& [subject, completed] : completed_) {
      if (completed >= static_cast<int>(k)) {
        ids.push_back(subject);
      }
    }
    const bool isKnown = analysis_.data.endingsAreKnown;
    const std::optional<int> count = isKnown ? std::optional(static_cast<int>(ids.size())) : std::nullopt;
    add(fmt::format("completed {} session{}", k, k == 1 ? "" : "s or more"), fmt::format("completed-{}", k), count,
        isKnown ? "" : "tables do not tell how sessions ended", k == 3 ? std::optional(25.0) : std::nullopt,
        std::move(ids));
  }
  std::map<std::string, int> taken;
  for (const auto& [reason, count] : flow.excluded) {
    std::vector<std::string> ids;
    for (const ExcludedSubject& excluded : analysis_.excluded) {
      if (!excluded.session && excluded.reason == reason) {
        ids.push_back(excluded.subject);
      }
    }
    const int before = taken[namePart(reason)]++;
    add(fmt::format("were excluded: {}", reason),
        fmt::format("excluded-{}{}", namePart(reason), before > 0 ? fmt::format("-{}", before + 1) : ""), count, "",
        std::nullopt, std::move(ids));
  }
  add("are analysed", "analysed", flow.analysed, "", 45, {analysed.begin(), analysed.end()});
  return table;
}

Table PaperTables::byObjects(const char* name, const char* title, const char* task, const CellOf& cellOf,
                             const std::function<PublishedPair(bool)>& published) const {
  Table table{name, title, {"objects"}, {}, {}, {kFirstSession}};
  setColumns(table, kViewColumns);
  for (const bool moving : {false, true}) {
    const TrialList trials =
        trialsOf(task, [&](const Trial& trial) { return trial.session == 1 && trial.moving == moving; });
    TableRow row{{objectsName(moving)}, {}};
    addViews(row, fmt::format("{}/{}", name, objectsName(moving)), trials, cellOf, published(moving));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table PaperTables::bySession(const char* name, const char* title, const char* task, const CellOf& cellOf,
                             const std::function<PublishedPair(bool, int)>& published) const {
  Table table{name, title, {"objects", "session"}, {}, {}, {fmt::format("Subjects who completed {}.", allSessions())}};
  setColumns(table, kViewColumns);
  for (const bool moving : {false, true}) {
    for (int session = 1; session <= sessions_; ++session) {
      const TrialList trials = trialsOf(task, [&](const Trial& trial) {
        return trial.session == session && trial.moving == moving && cameToAllSessions(trial);
      });
      TableRow row{{objectsName(moving), fmt::format("{}", session)}, {}};
      addViews(row, fmt::format("{}/{}/session-{}", name, objectsName(moving), session), trials, cellOf,
               published(moving, session));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table PaperTables::findMeans() const {
  Table table =
      byObjects("section-7.4.2", "Section 7.4.2: time to find objects", "find", meanTime(), publishedFindSeconds);
  setColumns(table, kTimeColumns);
  table.notes.push_back(timeoutNote());
  for (const bool moving : {false, true}) {
    addFasterBy(table.rows[moving ? 1 : 0], fmt::format("section-7.4.2/{}", objectsName(moving)),
                publishedFindImprovement(moving));
  }
  return table;
}

Table PaperTables::timeouts() const {
  Table table =
      byObjects("time-outs", "Section 7.4.2: searches whose time ran out", "find", timeoutShareCell, publishedTimeouts);
  if (isOfPaper_) {
    table.notes.emplace_back(
        "The text gives 33 searches for stationary objects, in either view; 7 and 1 for moving ones.");
  }
  return table;
}

Table PaperTables::table71() const {
  Table table =
      bySession("table-7.1", "Table 7.1: time to find objects, by session", "find", meanTime(), publishedTable71);
  setColumns(table, kTimeColumns);
  table.notes.push_back(timeoutNote());
  size_t row = 0;
  for (const bool moving : {false, true}) {
    for (int session = 1; session <= sessions_; ++session) {
      addFasterBy(table.rows[row++], fmt::format("table-7.1/{}/session-{}", objectsName(moving), session),
                  publishedImprovement71(moving, session));
    }
  }
  return table;
}

Table PaperTables::figure75() const {
  Table table{"figure-7.5",
              "Figure 7.5: time to find objects, by case",
              {"objects", "case"},
              {},
              {},
              {kFirstSession, timeoutNote()}};
  setColumns(table, {"@reference@", "@other@", "@other@ faster by", "published", "@reference@ time over",
                     "@other@ time over"});
  std::map<std::tuple<bool, int, int>, TrialList> cases;  // of moving, block, case
  for (const Trial* trial : trialsOf("find", [](const Trial& t) { return t.session == 1 && t.moving.has_value(); })) {
    cases[{*trial->moving, trial->blockIndex, trial->caseIndex}].push_back(trial);
  }
  std::map<std::string, int> taken;
  for (const auto& [key, trials] : cases) {
    const auto& [moving, block, index] = key;
    std::string name = fmt::format("figure-7.5/{}/{}", objectsName(moving), namePart(trials.front()->caseLabel));
    const int before = taken[name]++;
    name += before > 0 ? fmt::format("-{}", before + 1) : "";
    const TrialList ofReference = ofView(trials, TrialView::kReference);
    const TrialList ofOther = ofView(trials, TrialView::kOther);
    const ViewCondition& reference = conditions().of(TrialView::kReference);
    const ViewCondition& other = conditions().of(TrialView::kOther);
    TableRow row{{objectsName(moving), trials.front()->caseLabel}, {}};
    row.cells.push_back(meanTimeCell(fmt::format("{}/{}", name, reference.name), ofReference, options_.timeouts));
    row.cells.push_back(meanTimeCell(fmt::format("{}/{}", name, other.name), ofOther, options_.timeouts));
    row.cells.push_back(lessByCell(fmt::format("{}/faster", name), row.cells[0], row.cells[1]));
    row.cells.push_back(publishedCell(fmt::format("{}/faster/published", name),
                                      publishedImprovement75(moving, index + 1), "%", "as the text reports it"));
    row.cells.push_back(timeoutShareCell(fmt::format("{}/{}/time-over", name, reference.name), ofReference));
    row.cells.push_back(timeoutShareCell(fmt::format("{}/{}/time-over", name, other.name), ofOther));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table PaperTables::countMeans() const {
  return byObjects("section-7.4.3", "Section 7.4.3: counts that are right", "count", rightShareCell, publishedCounts);
}

Table PaperTables::table72Left() const {
  Table table{"table-7.2-left", "Table 7.2, left: counts that are right, by exposure", {"objects", "exposure"}, {}, {},
              {kFirstSession}};
  setColumns(table, kViewColumns);
  for (const bool moving : {false, true}) {
    std::set<double> exposures{5, 10, 20};
    for (const Trial* trial : trialsOf("count", [](const Trial& t) { return t.exposureSeconds.has_value(); })) {
      exposures.insert(*trial->exposureSeconds);
    }
    for (const double exposure : exposures) {
      const TrialList trials = trialsOf("count", [&](const Trial& trial) {
        return trial.session == 1 && trial.moving == moving && trial.exposureSeconds == exposure;
      });
      TableRow row{{objectsName(moving), fmt::format("{:g} s", exposure)}, {}};
      addViews(row, fmt::format("table-7.2-left/{}/{}-s", objectsName(moving), exposure), trials, rightShareCell,
               publishedTable72(moving, exposure));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table PaperTables::table72Right() const {
  Table table{"table-7.2-right", "Table 7.2, right: counts that are right, by colours", {"objects", "colours"}, {}, {},
              {kFirstSession}};
  setColumns(table, kViewColumns);
  for (const bool moving : {false, true}) {
    for (const bool duplicates : {true, false}) {
      const TrialList trials = trialsOf("count", [&](const Trial& trial) {
        return trial.session == 1 && trial.moving == moving && trial.duplicateColors == duplicates;
      });
      const char* colors = duplicates ? "duplicate" : "unique";
      TableRow row{{objectsName(moving), colors}, {}};
      addViews(row, fmt::format("table-7.2-right/{}/{}", objectsName(moving), colors), trials, rightShareCell,
               publishedTable72(moving, duplicates));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table PaperTables::table73() const {
  return bySession("table-7.3", "Table 7.3: counts that are right, by session", "count", rightShareCell,
                   publishedTable73);
}

Table PaperTables::countErrors() const {
  Table table{"count-errors",
              "Counts: objects too many, or too few (not in the text)",
              {"objects"},
              {},
              {},
              {"Trials of all sessions. Counts that were not given in time have no error."}};
  setColumns(table, {kReferenceMark, kOtherMark});
  for (const bool moving : {false, true}) {
    const TrialList trials = trialsOf("count", [&](const Trial& trial) { return trial.moving == moving; });
    TableRow row{{objectsName(moving)}, {}};
    for (const TrialView view : kViews) {
      row.cells.push_back(meanErrorCell(
          fmt::format("count-errors/{}/{}", objectsName(moving), conditions().nameOf(view)), ofView(trials, view)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table PaperTables::paths() const {
  Table table{"section-7.4.4", "Section 7.4.4: paths that are recognised", {"subjects", "session"}, {}, {}};
  setColumns(table, kViewColumns);
  const TrialList first = trialsOf("path", [](const Trial& trial) { return trial.session == 1; });
  TableRow all{{"all", "1"}, {}};
  addViews(all, "section-7.4.4/all", first, rightShareCell, publishedPaths(0));
  table.rows.push_back(std::move(all));
  for (int session = 1; session <= sessions_; ++session) {
    const TrialList trials =
        trialsOf("path", [&](const Trial& trial) { return trial.session == session && cameToAllSessions(trial); });
    TableRow row{{fmt::format("completed {}", allSessions()), fmt::format("{}", session)}, {}};
    addViews(row, fmt::format("section-7.4.4/session-{}", session), trials, rightShareCell, publishedPaths(session));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The answers to a question of the text, 1 for the reference to 5 for the other view. Where no protocol says the
/// scale, whole numbers from 1 to 5 are taken to be on it.
struct TextAnswers {
  std::vector<double> numbers{};
  std::vector<RowRef> rows{};
  std::string missing = "no answers";  ///< why there are none
};

TextAnswers textAnswers(const std::vector<ItemAnswers>& items, const std::string& question) {
  constexpr int kSteps = 5;
  TextAnswers result;
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const ItemAnswers& each) { return each.item.name == question; });
  if (found == items.end()) {
    return result;
  }
  const FormItem& item = found->item;
  if (item.isInProtocol() && (item.steps() != kSteps || !item.comparesViews())) {
    result.missing = "asked on another scale";
    return result;
  }
  for (const ItemAnswers::Answer& answer : found->answers) {
    const std::optional<double> number =
        item.isInProtocol() ? answer.place : numberFromText<double>(answer.row->answer);
    if (!number || *number < 1 || *number > kSteps || *number != std::floor(*number)) {
      result = {};
      result.missing = "on a scale that is not known";
      return result;
    }
    result.numbers.push_back(item.lastFavors == TrialView::kReference ? kSteps + 1 - *number : *number);
    result.rows.push_back({answer.row->source, answer.row->answerId});
  }
  return result;
}

Table PaperTables::survey() const {
  Table table{
      "section-7.4.5",
      withViewLabels("Section 7.4.5: which view was easier, 1 for the @reference@ to 5 for the @other@", conditions()),
      {"question"},
      {"mean", "published"},
      {},
      {"The last answer of each subject; answers that are none of the options are left out."}};
  const std::vector<ItemAnswers> items = answersToForm(analysis_.data, "survey");
  for (const char* question : {"easier_find", "easier_count", "easier_path"}) {
    const TextAnswers answers = textAnswers(items, question);
    Cell cell;
    cell.name = fmt::format("section-7.4.5/{}", namePart(question));
    cell.decimals = 2;
    cell.from = Cell::From::kAnswers;
    cell.meaning = fmt::format("mean answer to \"{}\" of the survey", question);
    cell.rows = answers.rows;
    cell.denominator = static_cast<int64_t>(cell.rows.size());
    if (answers.numbers.empty()) {
      cell.missing = answers.missing;
    } else {
      cell.value = std::accumulate(answers.numbers.begin(), answers.numbers.end(), 0.0) /
                   static_cast<double>(answers.numbers.size());
    }
    Cell fromText =
        publishedCell(fmt::format("{}/published", cell.name), publishedSurvey(question), "", "as the text reports it");
    const char* words = question == std::string("easier_find")    ? "to find the object"
                        : question == std::string("easier_count") ? "to count the objects"
                                                                  : "to recognise the path";
    table.rows.push_back({{words}, {std::move(cell), std::move(fromText)}});
  }
  return table;
}

}  // namespace

std::vector<Table> paperTables(const AnalysisData& analysis, const PaperTableOptions& options) {
  return analysis.data.conditions.isPair() ? PaperTables(analysis, options).all() : std::vector<Table>{};
}

}  // namespace ocelli
