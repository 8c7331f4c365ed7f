// How long the end of a trial takes to be on the disk, and how long the caller is held up, against appending the same
// rows to a CSV file with fsync().
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>

#include "oc_core/base/error.h"
#include "oc_core/base/sha256.h"
#include "study/session/utc_time.h"
#include "study/store/trial_store.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Choice {
  std::string folder = ".";
  int trials = 500;
  int frames = 900;  ///< of a trial: 15 s at 60 Hz
};

/// What is still to be stored when a trial ends: the log of half a second, or of the whole trial.
constexpr int kFramesSinceFlush = 30;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Spread {
  double median = 0;
  double p99 = 0;
  double longest = 0;
};

Spread spreadOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<size_t>(share * static_cast<double>(times.size() - 1))];
  };
  return {at(0.5), at(0.99), times.back()};
}

std::vector<FrameRecord> framesOfTrial(int count) {
  std::vector<FrameRecord> frames;
  for (int i = 0; i < count; ++i) {
    frames.push_back({i, 4 * i, 16'683'350LL * i, {3.0 / (i + 1), 0.1 * i, 0.01 * i}, {}});
  }
  return frames;
}

TrialRecord recordOf(const TrialPlan& plan, int frames) {
  TrialRecord record;
  record.plan = plan;
  record.info.label = "location 3";
  record.startedUtc = record.endedUtc = utcNow();
  record.outcome.answer = record.outcome.expected = "object";
  record.outcome.correct = true;
  record.outcome.responseTicks = 3600;
  record.outcome.measures = {{"path_length_m", 31.4159}, {"clicks", 1}};
  record.timing = {frames, 0, 16'683'350, 16'900'000, TimingVerdict::kGood};
  return record;
}

struct Times {
  Spread commit;  ///< milliseconds from the call to the acknowledgement
  Spread csv;     ///< milliseconds to append the same rows, and fsync()
  Spread call;    ///< microseconds for which a call holds the caller up
};

/// A table as other programs keep it: a line at a time is on the disk.
class CsvFile {
 public:
  explicit CsvFile(fs::path path)
      : path_(std::move(path)), descriptor_(open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {}
  ~CsvFile() { close(descriptor_); }
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  void append(int number, std::span<const FrameRecord> frames) const {
    std::string rows = fmt::format("{},find,location 3,object,object,1,15,{}\n", number, utcNow());
    for (const FrameRecord& frame : frames) {
      rows += fmt::format("{},{},{},{},{},{},{}\n", number, frame.frame, frame.tick, frame.shownNanoseconds,
                          frame.pose.x, frame.pose.z, frame.pose.headingRadians);
    }
    if (write(descriptor_, rows.data(), rows.size()) < 0 || fsync(descriptor_) != 0) {
      throw WorkError("cannot write", path_.string(), "another folder");
    }
  }

 private:
  fs::path path_;
  int descriptor_;
};

/// Store and file in turns, so that whatever else the disk does hits both.
Times measureTrials(const fs::path& file, const Choice& choice, int framesAtEnd) {
  Protocol protocol;
  protocol.name = "bench";
  protocol.text = "{}";
  protocol.sha256 = sha256(protocol.text);
  protocol.blocks.resize(1);
  StudyDatabase database = StudyDatabase::openForSessions(file, protocol);
  RunRecord run;
  run.subject = database.addSubject("bench", SubjectKind::kGenerator).id;
  run.kind = SubjectKind::kGenerator;
  TrialStore store(database, protocol, run, SessionSchedule{});
  const CsvFile csv(fs::path(file).replace_extension(".csv"));
  const std::vector<FrameRecord> frames = framesOfTrial(choice.frames);
  const std::span<const FrameRecord> all(frames);
  const auto before = static_cast<size_t>(choice.frames - framesAtEnd);
  std::vector<double> commits;
  std::vector<double> appends;
  std::vector<double> calls;
  const auto timed = [&](const auto& call) {
    const Clock::time_point start = Clock::now();
    call();
    calls.push_back(1000 * millisecondsSince(start));
  };
  const auto handOver = [&](int number, std::span<const FrameRecord> records) {
    for (size_t first = 0; first < records.size(); first += 30) {
      timed([&] { store.frames(number, records.subspan(first, std::min<size_t>(30, records.size() - first))); });
    }
  };
  for (int number = 0; number < choice.trials; ++number) {
    TrialPlan plan;
    plan.index = number;
    plan.task = "find";
    timed([&] { store.trialBegins(number, plan, 1); });
    handOver(number, all.first(before));
    store.flush();
    handOver(number, all.subspan(before));
    std::promise<void> stored;
    const TrialRecord record = recordOf(plan, choice.frames);
    Clock::time_point start = Clock::now();
    timed([&] { store.trialEnds(number, record, [&] { stored.set_value(); }); });
    stored.get_future().wait();
    commits.push_back(millisecondsSince(start));

    start = Clock::now();
    csv.append(number, all.subspan(before));
    appends.push_back(millisecondsSince(start));
  }
  store.flush();
  if (const std::optional<std::string> failure = store.failure()) {
    throw WorkError(*failure, file.string(), "another folder");
  }
  return {spreadOf(commits), spreadOf(appends), spreadOf(calls)};
}

std::string fileSystemOf(const fs::path& folder) {
  struct statfs info {};
  if (statfs(folder.c_str(), &info) != 0) {
    return "unknown";
  }
  switch (static_cast<unsigned>(info.f_type)) {
    case 0xef53:
      return "ext4";
    case 0x01021994:
      return "tmpfs (memory)";
    case 0x9123683e:
      return "btrfs";
    case 0x58465342:
      return "xfs";
    default:
      return fmt::format("type {:x}", static_cast<unsigned>(info.f_type));
  }
}

void measure(const Choice& choice) {
  const fs::path folder = fs::path(choice.folder) / "ocelli_store_bench";
  fs::remove_all(folder);
  fs::create_directories(folder);
  fmt::print("{} trials of {} frames, file system {}\n\n", choice.trials, choice.frames, fileSystemOf(folder));
  fmt::print("{:<58}{:>9}{:>9}{:>9}\n", "", "median", "p99", "longest");
  for (const int framesAtEnd : {std::min(kFramesSinceFlush, choice.frames), choice.frames}) {
    const Times times = measureTrials(folder / fmt::format("{}.db", framesAtEnd), choice, framesAtEnd);
    const auto row = [](const std::string& what, const Spread& spread) {
      fmt::print("{:<58}{:>9.3f}{:>9.3f}{:>9.3f}\n", what, spread.median, spread.p99, spread.longest);
    };
    row(fmt::format("store: end of a trial with {} frames to the disk, ms", framesAtEnd), times.commit);
    row("CSV: the same rows appended, fsync(), ms", times.csv);
    fmt::print("{:<58}{:>9.2f}{:>9.2f}\n", "store / CSV", times.commit.median / times.csv.median,
               times.commit.p99 / times.csv.p99);
    row("store: a call holds its caller up, us", times.call);
    fmt::print("\n");
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Commits of trials against appending to a CSV file.", "study_store_bench");
  program.add_option("--folder", choice.folder, "Where to write")->capture_default_str();
  program.add_option("--trials", choice.trials, "How many")->check(CLI::Range(100, 100000))->capture_default_str();
  program.add_option("--frames", choice.frames, "Of a trial")->check(CLI::Range(30, 100000))->capture_default_str();
  CLI11_PARSE(program, argumentCount, arguments);
  try {
    ocelli::measure(choice);
    return 0;
  } catch (const ocelli::Error& error) {
    fmt::print(stderr, "study_store_bench: error: {}\n", error.what());
    return 1;
  }
}
