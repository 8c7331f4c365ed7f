#include "study/screen/study_run.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"
#include "study/live/live_feed.h"
#include "study/markers/marker_feed.h"
#include "study/screen/calibration_drawing.h"
#include "study/screen/frame_measurement.h"
#include "study/screen/protocol_texts.h"
#include "study/screen/run_devices.h"
#include "study/screen/run_environment.h"
#include "study/screen/session_loop.h"
#include "study/screen/session_plan.h"
#include "study/session/trial_preparation.h"
#include "study/session/utc_time.h"
#include "study/store/program_version.h"
#include "study/store/trial_store.h"

namespace ocelli {
namespace {

constexpr double kCheckSeconds = 2.5;
constexpr double kPacedHertz = 60;  // where the screen has no rate of its own

constexpr const char* kAfterFailure =
    "all trials that were stored before are safe; where the disk is full make room, then: ocelli study resume";

void tell(const StudyRunOptions& options, const std::string& line) {
  if (options.tell) {
    options.tell(line);
  }
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    text += (text.empty() ? "" : "; ") + part;
  }
  return text;
}

std::string textOf(const Monitor& monitor) {
  return fmt::format("{}, {}x{}, {}, {} x {} mm", monitor.name, monitor.width, monitor.height,
                     monitor.refreshHertz > 0 ? fmt::format("{} Hz", monitor.refreshHertz) : "rate unknown",
                     monitor.widthMillimeters, monitor.heightMillimeters);
}

std::vector<Monitor> monitorsHere() {
  try {
    return listMonitors();
  } catch (const GlError& error) {
    // What else the graphics suggest is for commands that need no screen.
    throw WorkError(
        "there is no screen for a subject", "DISPLAY",
        "start it in the desktop session that shows on the subject's monitor; from a terminal elsewhere set "
        "DISPLAY to it first, such as DISPLAY=:0");
  }
}

/// The monitor that is asked for, large enough for the protocol.
Monitor chooseMonitor(const Protocol& protocol, const StudyRunOptions& options) {
  const std::vector<Monitor> monitors = monitorsHere();
  if (options.monitor < 0 || static_cast<size_t>(options.monitor) >= monitors.size()) {
    throw InputError(fmt::format("there are {} monitors, counted from 0", monitors.size()),
                     fmt::format("--monitor {}", options.monitor), "see: ocelli study run --list-monitors");
  }
  Monitor monitor = monitors[static_cast<size_t>(options.monitor)];
  const glm::ivec2 size = options.windowed.value_or(glm::ivec2(monitor.width, monitor.height));
  const ScreenGeometry& wanted = protocol.screen;
  if (size.x < wanted.minWidth || size.y < wanted.minHeight) {
    throw InputError(
        fmt::format("{}x{} pixels are too few, the protocol wants {}x{}", size.x, size.y, wanted.minWidth,
                    wanted.minHeight),
        options.windowed ? "--windowed" : fmt::format("--monitor {} ({})", options.monitor, monitor.name),
        options.windowed ? "give a larger size" : "choose another monitor, or another mode of it (xrandr)");
  }
  if (size.x > monitor.width || size.y > monitor.height) {
    throw InputError(
        fmt::format("{}x{} pixels are more than the monitor has, {}x{}", size.x, size.y, monitor.width, monitor.height),
        "--windowed", "give a smaller size");
  }
  return monitor;
}

GlWindowOptions windowOptions(const Protocol& protocol, const StudyRunOptions& options) {
  GlWindowOptions window;
  window.title = "Ocelli: " + protocol.title;
  window.resizable = false;
  window.scaled = false;
  if (options.windowed) {
    window.width = options.windowed->x;
    window.height = options.windowed->y;
  } else {
    window.monitor = options.monitor;
  }
  return window;
}

/// Throws WorkError where it refuses and nobody insists.
TimingCheck checkWindow(GlWindow& window, const Monitor& monitor, const Protocol& protocol,
                        const StudyRunOptions& options) {
  const std::vector<int64_t> shown = measureFrames(window, kCheckSeconds, protocol.texts);
  TimingExpectation expected;
  expected.monitorHertz = monitor.refreshHertz;
  expected.wantedHertz = protocol.screen.refreshHertz;
  expected.limits = protocol.timing;
  TimingCheck check = checkTiming(measureTiming(shown, protocol.timing.lateFactor), expected);
  if (!check.isGood() && !options.force) {
    check.advice.push_back("for trials without a subject, --force runs all the same and marks every trial");
    throw WorkError(fmt::format("{} ({})", joined(check.problems), describe(check.measured)), "timing check",
                    joined(check.advice));
  }
  return check;
}

/// Says how far it is by tenths.
void prepareImages(GlWindow& window, const Protocol& protocol, const SessionSchedule& schedule,
                   const TrialScreen& screen, const StudyRunOptions& options) {
  int tenths = -1;
  const int64_t began = steadyNow();
  const int prepared = prepareTrials(protocol, schedule, screen, [&](std::string_view stage, double fraction) {
    window.pollTimed(0);  // so that the desktop does not take it for dead
    if (options.interrupted && options.interrupted()) {
      throw WorkError("interrupted", "making images", "start the session again");
    }
    if (const auto now = static_cast<int>(10 * fraction); now > tenths) {
      tenths = now;
      tell(options, fmt::format("images    {}: {} %", stage, 10 * tenths));
    }
  });
  if (prepared > 0) {
    tell(options, fmt::format("images    of {} trials and pages, made in {:.0f} s", prepared,
                              static_cast<double>(steadyNow() - began) / 1e9));
  }
}

/// A database that there is not yet is made last, so that a run which is refused leaves none.
SessionEnding runPlan(std::optional<StudyDatabase> known, const Protocol& protocol, SessionPlan plan,
                      const StudyRunOptions& options) {
  if (!options.screenshots.empty()) {
    std::error_code error;
    std::filesystem::create_directories(options.screenshots, error);
    if (error) {
      throw InputError("the folder cannot be made: " + error.message(), options.screenshots.string(),
                       "choose another one for --screenshots");
    }
  }
  requireDrawable(protocol);
  std::vector<std::unique_ptr<MarkerOutput>> markerOutputs;
  for (const std::string& each : options.markers) {
    markerOutputs.push_back(openMarkerOutput(each));
  }
  RunDevices devices(protocol, options);
  const Monitor monitor = chooseMonitor(protocol, options);
  tell(options, fmt::format("monitor   {}: {}", options.monitor, textOf(monitor)));
  GlWindow window(windowOptions(protocol, options));
  const GlInfo& graphics = window.context().info();
  tell(options, fmt::format("graphics  {}{}", graphics.renderer, graphics.isSoftware ? " (software: slow)" : ""));
  TimingCheck check = checkWindow(window, monitor, protocol, options);
  tell(options,
       fmt::format("timing    {}: {}", check.isGood() ? "good" : "NOT GOOD, forced", describe(check.measured)));
  for (const std::string& problem : check.problems) {
    tell(options, "          " + problem);
  }

  const double pacedHertz = check.verticalSync ? 0 : (monitor.refreshHertz > 0 ? monitor.refreshHertz : kPacedHertz);
  SessionFlowOptions flowOptions;
  const double hertz = pacedHertz > 0 ? pacedHertz : refreshRateOf(check);
  flowOptions.screen = {window.pixelWidth(), window.pixelHeight(), hertz};
  flowOptions.intervalNanoseconds = static_cast<int64_t>(1e9 / (pacedHertz > 0 ? pacedHertz : check.measured.hertz));
  const CalibratedScreen stated{window.pixelWidth(), window.pixelHeight(),
                                protocol.screen.widthMillimeters * window.pixelWidth() / monitor.width,
                                protocol.screen.distanceMillimeters};
  ScreenCalibration calibration;
  std::vector<std::string> deviations;
  if (const std::optional<CalibrationWishes>& wishes = protocol.screen.calibration) {
    calibration = runCalibration(window, *wishes, stated, protocol.texts, options.interrupted);
    deviations = deviationsOf(calibration, stated, wishes->tolerance);
    tell(options, "screen    " + describe(calibration, stated));
    for (const std::string& deviation : deviations) {
      tell(options, "warning   " + deviation);
    }
  }
  // Of a new subject the slot is not known; every slot has trials of each block and view.
  const SessionSchedule likely = scheduleOf(protocol, plan.subject.slot, plan.session.session, plan.session.seed);
  tryTrials(protocol, likely, flowOptions.screen);
  prepareImages(window, protocol, likely, flowOptions.screen, options);
  const std::vector<std::string> slow =
      slowTrials(measureTrials(window, protocol, likely, flowOptions.screen, flowOptions.intervalNanoseconds));
  if (!slow.empty() && !options.force) {
    throw WorkError(joined(slow), "timing check",
                    "use the graphics driver of the maker of the graphics card, a faster card or a smaller mode of the "
                    "screen; for trials without a subject, --force runs all the same and marks every trial");
  }
  for (const std::string& problem : slow) {
    tell(options, "warning   " + problem);
  }
  check.problems.insert(check.problems.end(), slow.begin(), slow.end());
  const bool forced = !check.isGood();
  flowOptions.unstableRefresh = forced;

  if (!known) {
    known.emplace(StudyDatabase::openForSessions(options.database, protocol));
  }
  const StudyDatabase& database = *known;
  if (plan.isNewSubject) {
    plan.subject = known->addSubject(options.subject, SubjectKind::kPerson);
  }
  const std::optional<std::string> change =
      screenChange(database, options.subject, flowOptions.screen, protocol.timing.refreshTolerance);
  const SessionSchedule schedule = scheduleOf(protocol, plan.subject.slot, plan.session.session, plan.session.seed);
  if (schedule != likely) {
    prepareImages(window, protocol, schedule, flowOptions.screen, options);
  }

  RunRecord run;
  run.subject = options.subject;
  run.slot = plan.subject.slot;
  run.session = plan.session.session;
  run.startedUtc = utcNow();
  run.programVersion = programVersion();
  run.station = computerName();
  run.environment =
      jsonText(RunEnvironment{run.programVersion, graphics, monitor, options.monitor, !options.windowed,
                              window.pixelWidth(), window.pixelHeight(), protocol.screen, calibration, pacedHertz});
  run.timingCheck = jsonText(check);
  run.forced = forced;
  TrialStore store(database, protocol, run, schedule);

  LiveOptions liveOptions{options.liveShowsConditions, {}};
  const MarkerFeed* markers = nullptr;
  liveOptions.devices = [&] { return devices.liveDevices(options.markers, markers->counts()); };
  LiveFeed live(store, protocol, schedule, options.live, liveOptions);
  MarkerFeed feed(live, protocol, std::move(markerOutputs));
  markers = &feed;
  SessionFlow flow(protocol, schedule, plan.session.done, flowOptions, feed);
  tell(options,
       fmt::format("session   {} of {} of subject {}, {} trials, {} of them done; slot {}, {} first",
                   plan.session.session, protocol.sessions, options.subject, schedule.trials.size(),
                   plan.session.done.completedTrials.size(), plan.subject.slot, protocol.nameOf(schedule.firstView)));
  for (const std::string& deviation : deviations) {
    flow.report("screen_deviates", deviation);
  }
  if (change) {
    tell(options, "warning   this subject has another screen than in the first trial: " + *change);
    flow.report("screen_changed", *change);
  }
  devices.begin(flow, flowOptions.screen);
  tell(options, "ready. Commands: pause, resume, redo, note TEXT, status, abort, quit, help");

  SessionLoopOptions loop;
  loop.subject = options.subject;
  loop.pacedHertz = pacedHertz;
  loop.hashEvery = options.hashEvery;
  loop.screenshots = options.screenshots;
  loop.interrupted = options.interrupted;
  loop.responses = &devices.responses();
  loop.gaze = devices.gaze();
  int64_t lastShown = 0;
  loop.frameShown = [&](int64_t nanoseconds) {
    lastShown = nanoseconds;
    feed.frameShown(nanoseconds);
    live.frameShown(nanoseconds, flow);
  };
  SessionEnding ending = SessionEnding::kFailed;
  {
    ExperimenterConsole console;
    ending = runSessionLoop(window, protocol, flow, console, loop);
  }
  feed.finish(lastShown);
  for (size_t i = 0; i < options.markers.size(); ++i) {
    const MarkerCounts counts = feed.counts()[i];
    const std::string text = fmt::format("{}: {} sent, {} lost", options.markers[i], counts.sent, counts.lost);
    flow.report("markers", text);
    tell(options, "markers   " + text);
  }
  devices.end(flow);
  live.finish(flow);
  store.flush();
  if (const std::optional<std::string> failure = store.failure()) {
    throw WorkError("the end of the session could not be stored: " + *failure, options.database.string(),
                    kAfterFailure);
  }
  if (ending == SessionEnding::kFailed) {
    throw WorkError("the session had to stop: " + flow.status().failure, options.database.string(), kAfterFailure);
  }
  return ending;
}

void tellProtocol(const Protocol& protocol, const StudyRunOptions& options) {
  tell(options, fmt::format("protocol  {} ({})", protocol.name, protocol.sha256.substr(0, 12)));
  if (const SubjectCatalogue& catalogue = protocol.texts.catalogue(); catalogue.language != kSourceLanguage) {
    tell(options, fmt::format("language  {}{}", catalogue.name,
                              catalogue.isDraft ? ": a DRAFT, nobody whose first language it is has read it yet" : ""));
  }
  std::error_code error;
  const auto space =
      std::filesystem::space(options.database.parent_path().empty() ? "." : options.database.parent_path(), error);
  tell(options,
       fmt::format(
           "database  {}{}", options.database.string(),
           error ? "" : fmt::format(", {:.1f} GB left on its disk", static_cast<double>(space.available) / 1e9)));
}

}  // namespace

SessionEnding runStudy(const Protocol& protocol, const StudyRunOptions& options) {
  std::optional<StudyDatabase> database;
  std::error_code unreadable;
  if (std::filesystem::exists(options.database, unreadable) || unreadable) {
    database.emplace(StudyDatabase::openForSessions(options.database, protocol));
  }
  SessionPlan plan = planNewSession(database ? &*database : nullptr, protocol, options);
  tellProtocol(protocol, options);
  return runPlan(std::move(database), protocol, std::move(plan), options);
}

SessionEnding resumeStudy(const StudyRunOptions& options) {
  const StoredStudy study = StudyDatabase::openForReading(options.database).study();
  const Protocol protocol =
      protocolFromJsonText(study.protocolText, fmt::format("the protocol in {}", options.database.string()));
  StudyDatabase database = StudyDatabase::openForSessions(options.database, protocol);
  tellProtocol(protocol, options);
  SessionPlan plan = planResumedSession(database, protocol, options);
  return runPlan(std::move(database), protocol, std::move(plan), options);
}

std::string monitorList() {
  std::string list;
  int number = 0;
  for (const Monitor& monitor : monitorsHere()) {
    list += fmt::format("{}: {}\n", number++, textOf(monitor));
  }
  return list;
}

}  // namespace ocelli
