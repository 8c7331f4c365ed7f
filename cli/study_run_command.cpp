// `ocelli study run` and `ocelli study resume`: a session with a subject, at this computer.
#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/gl_drawing.h"
#include "cli/interrupt.h"
#include "cli/study_command.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "study/gaze/gaze_input.h"
#include "study/responses/response_input.h"
#ifdef OCELLI_WITH_OPENGL
#include "study/screen/study_run.h"
#endif
#ifdef OCELLI_WITH_LIVE_PAGE
#include "study/live/server/live_server.h"
#endif

namespace ocelli {
namespace {

struct RunChoice {
  std::string protocol;
  std::string database;
  std::string subject;
  int session = 0;  ///< from 1; 0 where none is given
  int monitor = 0;
  std::string windowed;
  bool listMonitors = false;
  bool force = false;
  bool anyTime = false;
  int hashFrames = 0;
  std::optional<uint64_t> seed;
  std::string screenshots;
  std::vector<std::string> markers;
  std::vector<std::string> responses;
  double debounce = kUsualDebounceMilliseconds;
  std::string gaze;
  std::optional<int> live;
  bool liveConditions = false;
};

#ifdef OCELLI_WITH_OPENGL
/// Throws for a session that ended before its end.
void tellEnding(SessionEnding ending, const RunChoice& choice, const CommandContext& context) {
  const std::string where = "session of " + choice.subject;
  const std::string resume =
      "go on with it: ocelli study resume --db " + choice.database + " --subject " + choice.subject;
  switch (ending) {
    case SessionEnding::kCompleted:
      context.print("the session is complete\n");
      return;
    case SessionEnding::kUnwell:
      throw WorkError("the subject felt unwell, and ended it", where,
                      "see to the subject first. What was done is stored; if they want to, " + resume);
    case SessionEnding::kAborted:
      throw WorkError("it was ended before its end", where, "what was done is stored; " + resume);
    case SessionEnding::kDeclined:
      throw WorkError("the subject did not consent", where, "nothing is to be done");
    case SessionEnding::kFailed:
      throw WorkError("it had to stop, since nothing could be stored any more", where,
                      "what was done before is stored; " + resume);
  }
}

StudyRunOptions optionsOf(const RunChoice& choice, const CommandContext& context) {
  StudyRunOptions options;
  options.database = choice.database;
  options.subject = choice.subject;
  if (choice.session != 0) {
    options.session = choice.session;
  }
  options.monitor = choice.monitor;
  if (!choice.windowed.empty()) {
    const ImageSize size = imageSizeFromText(choice.windowed, "--windowed");
    options.windowed = glm::ivec2(size.width, size.height);
  }
  options.force = choice.force;
  options.anyTime = choice.anyTime;
  options.hashEvery = choice.hashFrames;
  options.seed = choice.seed;
  options.screenshots = choice.screenshots;
  options.markers = choice.markers;
  options.responses = choice.responses;
  options.debounceMilliseconds = choice.debounce;
  options.gaze = choice.gaze;
  options.liveShowsConditions = choice.liveConditions;
  options.interrupted = [] { return InterruptGuard::interrupted(); };
  options.tell = [context](const std::string& line) { context.note(line); };
  return options;
}

/// A session, with its page where one is asked for.
template <class Run>
void runWithPage(const RunChoice& choice, const CommandContext& context, const Run& run) {
  StudyRunOptions options = optionsOf(choice, context);
  if (!choice.live) {
    tellEnding(run(options), choice, context);
    return;
  }
#ifdef OCELLI_WITH_LIVE_PAGE
  options.live = std::make_shared<LiveBoard>();
  const LiveServer server(*choice.live, [board = options.live] { return board->json(); });
  context.note("page      " + server.address());
  tellEnding(run(options), choice, context);
#else
  throw InputError("this program was built without the page of a session", "--live",
                   "build it with -DOCELLI_WITH_LIVE_PAGE=ON (docs/install.md)");
#endif
}

void run(const RunChoice& choice, const CommandContext& context) {
  if (choice.listMonitors) {
    context.print(monitorList());
    return;
  }
  const auto require = [](const std::string& value, const std::string& name, const std::string& what) {
    if (value.empty()) {
      throw InputError("is missing", name, "give " + what);
    }
  };
  require(choice.protocol, "PROTOCOL", "a protocol file, such as protocols/short.json");
  require(choice.database, "--db", "the database of the study; it is made where there is none");
  require(choice.subject, "--subject", "a pseudonymous id, such as S01");
  const Protocol protocol = readProtocol(choice.protocol);
  const InterruptGuard guard;
  runWithPage(choice, context, [&](const StudyRunOptions& options) { return runStudy(protocol, options); });
}

void resume(const RunChoice& choice, const CommandContext& context) {
  const InterruptGuard guard;
  runWithPage(choice, context, [](const StudyRunOptions& options) { return resumeStudy(options); });
}
#else
void run(const RunChoice&, const CommandContext&) {
  failWithoutOpenGl();
}
void resume(const RunChoice&, const CommandContext&) {
  failWithoutOpenGl();
}
#endif

CLI::Option* addDatabaseOption(CLI::App& command, RunChoice& choice) {
  return command.add_option("--db", choice.database, "Database of the study")->type_name("FILE.db");
}

CLI::Option* addSubjectOption(CLI::App& command, RunChoice& choice) {
  return command.add_option("--subject", choice.subject, "Pseudonymous id of the subject")->type_name("ID");
}

void addScreenOptions(CLI::App& command, RunChoice& choice) {
  command.add_option("--monitor", choice.monitor, "Monitor to fill")->type_name("N");
  command.add_option("--windowed", choice.windowed, "In a window of this size, for a look at it by the experimenter")
      ->type_name("WxH");
  command.add_flag("--force", choice.force, "Run although the timing is not good, and mark every trial");
  command.add_flag("--any-time", choice.anyTime, "Although the time between two sessions has not passed");
  command.add_option("--hash-frames", choice.hashFrames, "Store the hash of every Nth image of a trial; 0 for none")
      ->check(CLI::Range(0, 100000))
      ->type_name("N");
  command
      .add_option("--screenshots", choice.screenshots, "Keep an image of each screen that comes; frames are late then")
      ->type_name("DIR");
  command
      .add_option("--markers", choice.markers,
                  "Tell other devices of trials and answers at the frames that show them; may be given several times: "
                  "udp:HOST:PORT, serial:DEVICE[,BAUD], file:PATH")
      ->type_name("OUTPUT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option(
          "--responses", choice.responses,
          "What subjects answer with besides keyboard and mouse; may be given several times: " + responseDeviceForms())
      ->type_name("DEVICE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--debounce", choice.debounce,
                  "Milliseconds within which a key that changes again bounces, and counts once; 0 for none")
      ->check(CLI::Range(0.0, 100.0))
      ->type_name("MS")
      ->capture_default_str();
  command.add_option("--gaze", choice.gaze, "Record where the subject looks, from an eye tracker: " + gazeInputForms())
      ->type_name("INPUT");
  command
      .add_option("--live", choice.live,
                  "Show the session to the experimenter on a page at this port of 127.0.0.1; 0 takes a free one")
      ->check(CLI::Range(0, 65535))
      ->type_name("PORT");
  command.add_flag("--live-conditions", choice.liveConditions,
                   "The page tells the condition of each trial, which is hidden otherwise");
}

}  // namespace

void addStudyRunCommands(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("run", "Run a session with a subject, at this computer");
  const auto choice = std::make_shared<RunChoice>();
  command.add_option("protocol", choice->protocol, "Protocol of the study")->type_name("PROTOCOL.json");
  addDatabaseOption(command, *choice);
  addSubjectOption(command, *choice);
  command.add_option("--session", choice->session, "Session of a subject who was here before, from 2 on")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  addScreenOptions(command, *choice);
  command.add_option("--seed", choice->seed, "Seed of the order of trials, instead of the protocol's")->type_name("N");
  command.add_flag("--list-monitors", choice->listMonitors, "Print the monitors, and do nothing else");
  context.finish(command,
                 "  ocelli study run --list-monitors\n"
                 "  ocelli study run protocols/short.json --db study.db --subject S01\n"
                 "  ocelli study run protocols/short.json --db trial.db --subject test --windowed 1280x800 --force",
                 [choice, context] { run(*choice, context); });

  CLI::App& again =
      *study.add_subcommand("resume", "Go on with a session that was broken off, or begin the subject's next one");
  const auto resumed = std::make_shared<RunChoice>();
  addDatabaseOption(again, *resumed)->required();
  addSubjectOption(again, *resumed)->required();
  addScreenOptions(again, *resumed);
  context.finish(again, "  ocelli study resume --db study.db --subject S01",
                 [resumed, context] { resume(*resumed, context); });
}

}  // namespace ocelli
