#include "analysis/report/apparatus_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/dataset/run_screen.h"

namespace ocelli {
namespace {

constexpr const char* kUnknown = "not known";
using SessionKey = std::pair<std::string, int>;  ///< subject and number

std::string withUnit(const std::optional<double>& value, const char* unit) {
  return value ? fmt::format("{:.6g} {}", *value, unit) : kUnknown;
}

std::string percentText(double share) {
  return share > 0 && share < 0.00005 ? std::string("< 0.01 %") : fmt::format("{:.2f} %", 100 * share);
}

/// "dropped frames" of "dropped_frames".
std::string verdictWords(const std::string& name) {
  std::string words = name.empty() ? kUnknown : name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// "good 40, refused 2"; the largest first.
std::string countsText(const std::map<std::string, int64_t>& counts) {
  std::vector<std::pair<std::string, int64_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> parts;
  for (const auto& [name, count] : sorted) {
    parts.push_back(fmt::format("{} {}", verdictWords(name), count));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Frames of some trials.
struct Frames {
  int64_t trials = 0;
  int64_t frames = 0;
  int64_t dropped = 0;
  std::map<std::string, int64_t> verdicts{};

  void add(const Trial& trial) {
    ++trials;
    frames += trial.frames;
    dropped += trial.droppedFrames;
    ++verdicts[trial.timingVerdict ? nameOf(*trial.timingVerdict) : ""];
  }
  std::optional<double> droppedShare() const {
    return frames > 0 ? std::optional<double>(static_cast<double>(dropped) / static_cast<double>(frames))
                      : std::nullopt;
  }
};

/// What is alike in the sessions on one screen.
struct Screen {
  std::string monitor;
  std::string resolution;
  std::string size;
  std::string refresh;
  std::string pixelsPerDegree;

  auto operator<=>(const Screen&) const = default;
};

ReportCell shareCell(const std::optional<double>& share) {
  return {share ? percentText(*share) : std::string(kUnknown), "", "dropped_frames and frames of final_trial", share};
}

ReportCell countCell(int64_t count) {
  return {std::to_string(count), "", "", static_cast<double>(count)};
}

class Apparatus {
 public:
  explicit Apparatus(ReportWork& work) : work_(work) {
    for (const Trial& trial : work.analysis.data.trials) {
      bySession_[{trial.subject, trial.session}].add(trial);
      all_.add(trial);
      firstTrials_.try_emplace({trial.subject, trial.session}, &trial);
    }
    for (const Run& run : work.analysis.data.runs) {
      if (bySession_.contains({run.subject, run.session})) {
        runs_.push_back(&run);
      }
    }
    for (const DataSource& source : work.analysis.data.sources) {
      if (!wanted_ && !source.protocolText.empty()) {
        const ProtocolFacts facts = protocolFacts(source.protocolText, source.path);
        wanted_ = facts.screen;
        timing_ = facts.timing;
      }
    }
  }

  void add() {
    addFacts();
    if (!runs_.empty()) {
      addScreens();
    }
    addSessions();
    const InSupplement supplement(work_.document);
    addSubjects();
  }

 private:
  void addFacts();
  void addScreens();
  void addSessions();
  void addSubjects();
  Screen screenOfRun(const Run& run) const;
  std::vector<std::string> unknowns() const;

  ReportWork& work_;
  std::vector<const Run*> runs_{};
  std::map<SessionKey, Frames> bySession_{};
  std::map<SessionKey, const Trial*> firstTrials_{};
  Frames all_{};
  std::optional<StatedScreen> wanted_{};
  TimingLimits timing_{};
};

/// As the monitor says; where it does not, as the trials had it.
Screen Apparatus::screenOfRun(const Run& run) const {
  const RunScreen stored = screenOf(run);
  const Trial& trial = *firstTrials_.at({run.subject, run.session});
  Screen screen;
  screen.monitor = stored.simulated         ? std::string("none: simulated")
                   : stored.monitor.empty() ? kUnknown
                                            : stored.monitor;
  std::optional<double> width = stored.widthPixels;
  if (width && stored.heightPixels) {
    screen.resolution = fmt::format("{:g} x {:g}", *width, *stored.heightPixels);
  } else if (trial.screenWidth && trial.screenHeight) {
    screen.resolution = fmt::format("{} x {}", *trial.screenWidth, *trial.screenHeight);
    width = static_cast<double>(*trial.screenWidth);
  } else {
    screen.resolution = kUnknown;
  }
  screen.size = stored.widthMillimeters && stored.heightMillimeters
                    ? fmt::format("{:g} x {:g}", *stored.widthMillimeters, *stored.heightMillimeters)
                    : std::string(kUnknown);
  const std::optional<double> hertz = stored.refreshHertz ? stored.refreshHertz : trial.refreshHertz;
  screen.refresh = hertz ? fmt::format("{:.6g}", *hertz) : std::string(kUnknown);
  const bool hasAngle = width && stored.widthMillimeters && wanted_ && wanted_->distanceMillimeters.value_or(0) > 0;
  // In the middle of the screen.
  screen.pixelsPerDegree = hasAngle ? fmt::format("{:.1f}", *width / *stored.widthMillimeters *
                                                                *wanted_->distanceMillimeters * std::numbers::pi / 180)
                                    : std::string(kUnknown);
  return screen;
}

std::vector<std::string> Apparatus::unknowns() const {
  std::set<std::string> missing;
  for (const Run* run : runs_) {
    const RunScreen stored = screenOf(*run);
    missing.insert(stored.notMeasured.begin(), stored.notMeasured.end());
    if (!stored.simulated && !(stored.widthMillimeters && stored.heightMillimeters)) {
      missing.insert("size of some screens");
    }
    if (!stored.simulated && !stored.refreshHertz) {
      missing.insert("refresh rate that some screens say they have");
    }
    if (stored.verdict.empty()) {
      missing.insert("check of the timing before some sessions");
    }
  }
  if (runs_.empty()) {
    missing.insert("screens: the data hold no runs");
  }
  missing.insert("distance from which subjects really looked");
  return {missing.begin(), missing.end()};
}

void Apparatus::addFacts() {
  ReportFacts facts;
  const bool distance = wanted_ && wanted_->distanceMillimeters;
  facts.facts.push_back(
      {"Viewing distance",
       distance ? fmt::format("{:g} mm, as the protocol asks", *wanted_->distanceMillimeters) : std::string(kUnknown)});
  if (wanted_ && wanted_->widthMillimeters && wanted_->heightMillimeters) {
    facts.facts.push_back(
        {"Screen asked for",
         fmt::format("{:g} x {:g} mm, {}", *wanted_->widthMillimeters, *wanted_->heightMillimeters,
                     wanted_->refreshHertz ? withUnit(wanted_->refreshHertz, "Hz") : std::string("any refresh rate"))});
  }
  std::map<std::string, int64_t> checks;
  std::set<std::string> graphics;
  int64_t forced = 0;
  double worstJitter = -1;
  for (const Run* run : runs_) {
    const RunScreen stored = screenOf(*run);
    ++checks[stored.verdict];
    forced += run->forced ? 1 : 0;
    worstJitter = std::max(worstJitter, stored.jitterShare.value_or(-1));
    if (!stored.graphics.empty()) {
      graphics.insert(stored.graphics + (stored.softwareRendered ? " (in software)" : ""));
    }
  }
  std::string checkText = runs_.empty() ? kUnknown : fmt::format("{} (runs)", countsText(checks));
  if (forced > 0) {
    checkText += fmt::format("; {} runs were started although it refused", forced);
  }
  if (worstJitter >= 0) {
    checkText += fmt::format("; intervals between frames scatter by at most {}", percentText(worstJitter));
  }
  facts.facts.push_back({"Timing check before", checkText});
  facts.facts.push_back({"Timing of trials", all_.trials == 0 ? std::string("no trials")
                                                              : fmt::format("{} (trials)", countsText(all_.verdicts))});
  const std::optional<double> share = all_.droppedShare();
  facts.facts.push_back(
      {"Dropped frames", share ? fmt::format("{} of {} frames: intervals longer than {:g} times that of the screen",
                                             percentText(*share), all_.frames, timing_.lateFactor)
                               : std::string("not known: no frames were logged")});
  if (!graphics.empty()) {
    facts.facts.push_back({"Graphics", fmt::format("{}", fmt::join(graphics, "; "))});
  }
  facts.facts.push_back({"Not measured", fmt::format("{}", fmt::join(unknowns(), "; "))});
  work_.document.add(facts);
}

void Apparatus::addScreens() {
  struct Used {
    std::set<SessionKey> sessions{};
    std::set<std::string> stations{};
    double least = INFINITY;  ///< measured hertz
    double most = 0;
  };
  std::map<Screen, Used> screens;
  for (const Run* run : runs_) {
    Used& used = screens[screenOfRun(*run)];
    used.sessions.insert({run->subject, run->session});
    if (!run->station.empty()) {
      used.stations.insert(run->station);
    }
    if (const std::optional<double> hertz = screenOf(*run).measuredHertz) {
      used.least = std::min(used.least, *hertz);
      used.most = std::max(used.most, *hertz);
    }
  }
  ReportTable table{
      "Screens of the analysed sessions; pixels per degree in the middle of the screen, at the distance that "
      "the protocol asks for",
      "screens",
      {{"Monitor", "", true},
       {"Computer", "", true},
       {"Resolution (px)"},
       {"Size (mm)"},
       {"Refresh (Hz)"},
       {"Measured (Hz)"},
       {"px per degree"},
       {"Sessions"}},
      {}};
  table.isRecord = true;
  for (const auto& [screen, used] : screens) {
    const std::string measured = used.most <= 0 ? kUnknown
                                 : used.most - used.least < 0.005
                                     ? fmt::format("{:.2f}", used.most)
                                     : fmt::format("{:.2f} to {:.2f}", used.least, used.most);
    table.rows.push_back(
        {ReportCell{screen.monitor},
         ReportCell{used.stations.empty() ? std::string(kUnknown) : fmt::format("{}", fmt::join(used.stations, ", "))},
         ReportCell{screen.resolution}, ReportCell{screen.size}, ReportCell{screen.refresh}, ReportCell{measured},
         ReportCell{screen.pixelsPerDegree}, countCell(static_cast<int64_t>(used.sessions.size()))});
  }
  work_.document.add(table);
}

void Apparatus::addSessions() {
  std::map<int, Frames> byNumber;
  std::map<int, std::vector<double>> shares;  // of subjects
  std::map<int, int64_t> subjects;
  for (const Trial& trial : work_.analysis.data.trials) {
    byNumber[trial.session].add(trial);
  }
  for (const auto& [session, frames] : bySession_) {
    ++subjects[session.second];
    if (const std::optional<double> share = frames.droppedShare()) {
      shares[session.second].push_back(*share);
    }
  }
  ReportTable table{
      "Dropped frames by session",
      "dropped-frames",
      {{"Session"}, {"Subjects"}, {"Trials"}, {"Frames"}, {"Dropped"}, {"Median of subjects"}, {"Most of a subject"}},
      {}};
  table.isRecord = true;
  for (const auto& [number, frames] : byNumber) {
    std::vector<double>& list = shares[number];
    std::sort(list.begin(), list.end());
    const size_t half = list.size() / 2;
    const std::optional<double> median =
        list.empty() ? std::nullopt
                     : std::optional<double>(list.size() % 2 == 1 ? list[half] : (list[half - 1] + list[half]) / 2);
    table.rows.push_back({ReportCell{std::to_string(number)}, countCell(subjects[number]), countCell(frames.trials),
                          countCell(frames.frames), shareCell(frames.droppedShare()), shareCell(median),
                          shareCell(list.empty() ? std::nullopt : std::optional<double>(list.back()))});
  }
  if (!table.rows.empty()) {
    work_.document.add(table);
  }
}

void Apparatus::addSubjects() {
  std::map<SessionKey, const Run*> lastRuns;
  for (const Run* run : runs_) {
    const Run*& last = lastRuns[{run->subject, run->session}];
    last = last == nullptr || last->number <= run->number ? run : last;
  }
  ReportTable table{"Timing by subject and session",
                    "dropped-frames-by-subject",
                    {{"Subject", "", true},
                     {"Session"},
                     {"Trials"},
                     {"Frames"},
                     {"Dropped"},
                     {"Trials by verdict", "", true},
                     {"Check before", "", true}},
                    {}};
  table.isRecord = true;
  for (const auto& [session, frames] : bySession_) {
    const auto run = lastRuns.find(session);
    const std::string check = verdictWords(run == lastRuns.end() ? "" : screenOf(*run->second).verdict);
    table.rows.push_back({ReportCell{session.first}, ReportCell{std::to_string(session.second)},
                          countCell(frames.trials), countCell(frames.frames), shareCell(frames.droppedShare()),
                          ReportCell{countsText(frames.verdicts)},
                          ReportCell{run != lastRuns.end() && run->second->forced ? check + ", forced" : check}});
  }
  if (!table.rows.empty()) {
    work_.document.add(table);
  }
}

}  // namespace

void addApparatus(ReportWork& work) {
  addHeading(work.document, 1, "Apparatus", "apparatus");
  Apparatus(work).add();
}

}  // namespace ocelli
