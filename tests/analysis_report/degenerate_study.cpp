#include "tests/analysis_report/degenerate_study.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/base/failure.h"
#include "analysis/report/json_report.h"
#include "analysis/report/report_files.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/tables/paper_tables.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_report/report_reading.h"

namespace ocelli::test {
namespace {

constexpr double kLimit = 60;
constexpr double kLongLimit = 2e9;

enum class Times { kDrawn, kAlike, kNearlyAlike, kTiny, kHuge, kZero, kTwoValues, kBySubject, kByView, kAbsurd };
constexpr std::array kTimes{"drawn", "alike",      "nearly alike", "tiny",    "huge",
                            "zero",  "two values", "by subject",   "by view", "absurd"};
enum class Right { kDrawn, kAll, kNone, kOneWrong, kByView, kBySubject };
constexpr std::array kRights{"drawn", "all right", "all wrong", "one wrong", "by view", "by subject"};
enum class Censoring { kByLimit, kAll, kNone, kOneView };
constexpr std::array kCensorings{"by the limit", "all", "none", "of one view"};
enum class Views { kBoth, kOne, kBySubject, kByCase };
constexpr std::array kViews{"both", "one", "by subject", "by case"};

struct Block {
  const char* name;
  const char* task;
  bool moving;
};
constexpr std::array<Block, 5> kBlocks{{{"find stationary", "find", false},
                                        {"find moving", "find", true},
                                        {"count stationary", "count", false},
                                        {"count moving", "count", true},
                                        {"path", "path", false}}};

class Maker {
 public:
  explicit Maker(int number) : random_(20100517, static_cast<uint64_t>(number)), number_(number) {}

  DegenerateStudy make() {
    subjects_ = happens(0.03) ? 0 : 1 + below(12);
    sessions_ = 1 + below(3);
    cases_ = 1 + below(4);
    times_ = oneOf<Times>(kTimes.size(), 0.4);
    right_ = oneOf<Right>(kRights.size(), 0.4);
    censoring_ = oneOf<Censoring>(kCensorings.size(), 0.6);
    views_ = oneOf<Views>(kViews.size(), 0.7);
    dropped_ = happens(0.3) ? 0.5 : 0;
    lost_ = happens(0.3) ? 0.3 : happens(0.1) ? 0.9 : 0;
    missing_ = happens(0.3) ? 0.3 : happens(0.1) ? 1 : 0;
    hasTask_ = {!happens(0.1), !happens(0.3), !happens(0.15), !happens(0.3), !happens(0.15)};
    addSource();
    for (int s = 0; s < subjects_; ++s) {
      addSubject(s);
    }
    plan_ = defaultPlan();
    plan_.bootstrapSamples = 100;
    plan_.findTimeouts = kTimeoutTreatments[below(3)];
    DegenerateStudy study;
    study.name = fmt::format(
        "{}: {} subjects, {} sessions, {} cases, times {}, answers {}, time-outs {}, views {}, dropped {}, lost {}, "
        "missing {}, {}",
        number_, subjects_, sessions_, cases_, kTimes[static_cast<size_t>(times_)],
        kRights[static_cast<size_t>(right_)], kCensorings[static_cast<size_t>(censoring_)],
        kViews[static_cast<size_t>(views_)], dropped_, lost_, missing_, nameOf(plan_.findTimeouts));
    study.data = std::move(data_);
    study.plan = std::move(plan_);
    return study;
  }

 private:
  bool happens(double chance) { return random_.uniform() < chance; }
  int below(int count) { return static_cast<int>(random_.below(static_cast<uint64_t>(count))); }
  /// The first with that chance, else any.
  template <class Kind>
  Kind oneOf(size_t count, double first) {
    return happens(first) ? Kind{} : static_cast<Kind>(random_.below(count));
  }

  void addSource() {
    DataSource source;
    source.path = "degenerate";
    source.form = DataSource::Form::kCsv;  // without logs of walks
    source.protocolName = happens(0.5) ? "rosen2010" : "other";
    if (!happens(0.2)) {
      source.protocolText = kWholeProtocol;
      source.protocolSha256 = std::string(64, 'a');
    }
    data_.sources.push_back(source);
  }

  void addSubject(int index) {
    Subject subject;
    subject.id = fmt::format("S{}", index + 1);
    subject.key = fmt::format("key {}", index);
    subject.kind = SubjectKind::kPerson;
    subject.slot = index;
    data_.subjects.push_back(subject);
    data_.consents.push_back({0, subject.id, 1, true});
    slowness_ = 0.4 * random_.normal();
    for (int session = 1; session <= sessions_; ++session) {
      if (session > 1 && happens(dropped_)) {
        break;
      }
      addSession(subject.id, index, session);
    }
    addSurvey(subject.id);
  }

  void addSession(const std::string& subject, int index, int number) {
    Session session;
    session.subject = subject;
    session.number = number;
    if (happens(0.9)) {
      session.ending = SessionEnding::kCompleted;
    } else if (happens(0.5)) {
      session.ending = SessionEnding::kAborted;
    }
    session.runs = 1;
    session.forced = happens(0.03);
    data_.sessions.push_back(session);
    if (happens(0.03)) {
      data_.sessions.push_back(session);  // twice
    }
    int plan = 0;
    for (size_t b = 0; b < kBlocks.size(); ++b) {
      const int cases = hasTask_[b] ? cases_ : 0;
      for (int i = 0; i < 2 * cases; ++i) {
        const bool graph = viewOf(index, i);
        if (views_ == Views::kBoth || i % 2 == 0) {
          addTrial(subject, index, number, b, i / 2, graph, plan++);
        }
      }
    }
  }

  bool viewOf(int subject, int place) const {
    switch (views_) {
      case Views::kBoth:
        return (place + place / 2 + subject) % 2 == 0;
      case Views::kOne:
        return number_ % 2 == 0;
      case Views::kBySubject:
        return subject % 2 == 0;
      case Views::kByCase:
        return place / 2 % 2 == 0;
    }
    return false;
  }

  double secondsOf(int subject, int caseIndex, bool graph) {
    switch (times_) {
      case Times::kDrawn:
        return std::exp(2.5 + slowness_ + 0.2 * caseIndex - (graph ? 0.4 : 0) + 0.5 * random_.normal());
      case Times::kAlike:
        return 7;
      case Times::kNearlyAlike:
        return std::nextafter(7.0, happens(0.5) ? 8 : 6);
      case Times::kTiny:
        return 1e-9 * (1 + below(3));
      case Times::kHuge:
        return 1e9 - below(3);
      case Times::kZero:
        return happens(0.5) ? 0 : 1 + random_.uniform();
      case Times::kTwoValues:
        return happens(0.5) ? 5 : 10;
      case Times::kBySubject:
        return 5 + subject;
      case Times::kByView:
        return graph ? 5 : 10;
      case Times::kAbsurd:
        return happens(0.3) ? 1e-9 : happens(0.4) ? 1e9 : 10 * random_.uniform();
    }
    return 0;
  }

  bool isRight(int subject, bool graph) {
    switch (right_) {
      case Right::kDrawn:
        return happens(0.7);
      case Right::kAll:
        return true;
      case Right::kNone:
        return false;
      case Right::kOneWrong:
        return !data_.trials.empty();
      case Right::kByView:
        return graph;
      case Right::kBySubject:
        return subject % 2 == 0;
    }
    return true;
  }

  void addTrial(const std::string& subject, int index, int session, size_t block, int caseIndex, bool graph, int plan) {
    const double seconds = secondsOf(index, caseIndex, graph);
    const bool right = isRight(index, graph);
    if (happens(lost_)) {
      return;
    }
    Trial trial;
    trial.trialId = static_cast<int64_t>(data_.trials.size()) + 1;
    trial.subject = subject;
    trial.session = session;
    trial.planIndex = plan;
    trial.blockIndex = static_cast<int>(block);
    trial.block = kBlocks[block].name;
    trial.task = kBlocks[block].task;
    trial.caseIndex = caseIndex;
    trial.caseLabel = fmt::format("location {}", caseIndex + 1);
    trial.view = graph ? TrialView::kOther : TrialView::kReference;
    trial.subjectKind = SubjectKind::kPerson;
    trial.moving = kBlocks[block].moving;
    trial.frames = 100;
    trial.droppedFrames = happens(0.05) ? 3 : 0;
    trial.timingVerdict = TimingVerdict::kGood;
    trial.responseSeconds = seconds;
    trial.correct = right;
    trial.expected = "there";
    trial.answer = right ? "there" : "";
    if (trial.task == "find") {
      search(trial, graph);
    } else if (trial.task == "count") {
      trial.exposureSeconds = caseIndex % 2 == 0 ? 5 : 10;
      trial.objects = 3 + caseIndex;
      trial.duplicateColors = caseIndex >= 2;
      trial.expected = std::to_string(*trial.objects);
      trial.answer = right ? trial.expected : happens(0.1) ? "many" : std::to_string(*trial.objects - 1);
    }
    forget(trial);
    data_.trials.push_back(trial);
  }

  void search(Trial& trial, bool graph) const {
    const bool isOut = censoring_ == Censoring::kAll || (censoring_ == Censoring::kOneView && graph) ||
                       (censoring_ == Censoring::kByLimit && *trial.responseSeconds >= kLimit && number_ % 2 == 0);
    // Times beyond the limit would be left out.
    const bool isLong = times_ == Times::kHuge || times_ == Times::kAbsurd;
    trial.longestSeconds = isLong && number_ % 3 > 0 ? kLongLimit : kLimit;
    trial.censored = isOut;
    if (isOut) {
      trial.responseSeconds = *trial.longestSeconds;
      trial.correct = false;
      trial.answer.clear();
    }
  }

  void forget(Trial& trial) {
    if (happens(missing_))
      trial.correct.reset();
    if (happens(missing_))
      trial.censored.reset();
    if (happens(missing_))
      trial.responseSeconds.reset();
    if (happens(missing_))
      trial.moving.reset();
    if (happens(missing_))
      trial.exposureSeconds.reset();
    if (happens(missing_))
      trial.duplicateColors.reset();
    if (happens(missing_))
      trial.longestSeconds.reset();
  }

  void addSurvey(const std::string& subject) {
    const int kind = number_ % 4;  // nobody answers, some do, all the middle, other scales
    for (const char* field : {"easier_find", "easier_count"}) {
      if (kind == 0 || (kind == 1 && happens(0.5))) {
        continue;
      }
      const std::string answer = kind == 2 ? "3" : kind == 3 && happens(0.3) ? "9" : std::to_string(1 + below(5));
      const auto id = static_cast<int64_t>(data_.answers.size()) + 1;
      data_.answers.push_back({0, id, subject, 1, "survey", field, answer, false});
    }
  }

  RandomNumbers random_;
  int number_;
  Dataset data_{};
  AnalysisPlan plan_{};
  int subjects_ = 0;
  int sessions_ = 1;
  int cases_ = 1;
  Times times_{};
  Right right_{};
  Censoring censoring_{};
  Views views_{};
  double dropped_ = 0;  ///< share of subjects who do not come again
  double lost_ = 0;     ///< share of trials that are not there
  double missing_ = 0;  ///< share of values
  std::array<bool, kBlocks.size()> hasTask_{};
  double slowness_ = 0;
};

}  // namespace

DegenerateStudy degenerateStudy(int number) {
  return Maker(number).make();
}

std::vector<std::string> problemsOfReport(const DegenerateStudy& study) {
  std::vector<std::string> problems;
  const auto end = failureOf([&] {
    const AnalysisData analysis = applyPlan(study.data, study.plan);
    const std::vector<Table> tables = paperTables(analysis);
    const StudyReportOptions options{{}, "1.2.3"};
    const ReportDocument document = studyReport(analysis, tables, options);
    problems = document.failures;
    const nlohmann::json report = nlohmann::json::parse(jsonReport(document));
    for (const char* id : {"design", "flow", "paper", "find", "navigation", "count", "path", "learning", "completers",
                           "survey", "hypotheses", "methods"}) {
      if (elementOf(report, id).is_null()) {
        problems.push_back(fmt::format("there is no section {}", id));
      }
    }
    const std::vector<std::string> dishonest = dishonestNumbers(report);
    problems.insert(problems.end(), dishonest.begin(), dishonest.end());
    for (const ReportFile& file : reportFiles(document)) {
      const std::vector<std::string> none =
          file.name.ends_with(".pdf") ? std::vector<std::string>() : numbersThatAreNone(file.bytes);
      problems.insert(problems.end(), none.begin(), none.end());
    }
    tableFiles(analysis, document, options, true);
  });
  if (end) {
    problems.push_back(fmt::format("there is no report: {}", *end));
  }
  return problems;
}

}  // namespace ocelli::test
