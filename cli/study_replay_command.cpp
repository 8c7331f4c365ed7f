// `ocelli study replay`: trials again, from their logs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/command.h"
#include "cli/study_command.h"
#include "cli/study_renderer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "study/replay/gaze_trail.h"
#include "study/replay/path_plan.h"
#include "study/replay/stored_replay.h"

namespace ocelli {
namespace {

struct ReplayChoice {
  std::string database;
  std::string subject;
  int session = 1;
  int trial = 0;
  bool all = false;
  bool practice = false;
  std::string frames;
  int every = 1;
  std::string plan;
  bool window = false;
  double speed = 1;
  std::string renderer = "raster";
};

std::string textOf(const ReplaySummary& summary) {
  std::string text = fmt::format("{} trials: poses identical in {}, outcomes identical in {}\n", summary.trials,
                                 summary.posesSame, summary.outcomesSame);
  text += fmt::format("{} of {} frames have the pose of the log", summary.framesSame, summary.frames);
  text += summary.hashes > 0 ? fmt::format("; pixels identical in {} of {} frames that were compared\n",
                                           summary.hashesSame, summary.hashes)
                             : "; pixels not compared\n";
  if (summary.withoutLog > 0) {
    text += fmt::format("{} trials have no log to replay\n", summary.withoutLog);
  }
  for (const std::string& difference : summary.differences) {
    text += "different: ";
    text += difference;
    text += '\n';
  }
  return text;
}

void writeFrames(const ReplayChoice& choice, const ReplayStudy& study, const TrialRow& trial,
                 const CommandContext& context) {
  const std::filesystem::path folder = choice.frames;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw WorkError(fmt::format("the folder cannot be made: {}", failed.message()), choice.frames,
                    "name a folder that you may write to");
  }
  const ViewPainter paint = framePainter(choice.renderer);
  const TrialLog log = study.logOf(trial);
  int64_t written = 0;
  ReplayOptions options;
  options.onFrame = [&](const FrameRecord& record, const TrialRun& run) {
    if (record.frame % choice.every == 0) {
      Image<Rgb8> image = paint(run.layout(), log.record.screen);
      drawGaze(image, gazeTrail(log.gaze, record.shownNanoseconds));
      writePng(folder / fmt::format("frame_{:06}.png", record.frame), image);
      ++written;
    }
    report(context.progress(), "drawing frames",
           static_cast<double>(record.frame) / static_cast<double>(std::max<size_t>(log.frames.size(), 1)));
  };
  replayTrial(study.blockOf(trial), log, options);
  context.note(fmt::format("wrote {} frames to {}", written, choice.frames));
}

void writePlanOf(const ReplayChoice& choice, const ReplayStudy& study, const TrialRow& trial,
                 const CommandContext& context) {
  PathPlan plan = pathPlanOf(study.blockOf(trial), study.logOf(trial), study.nameOf(trial));
  plan.simulated = trial.simulated ? "a simulated subject" : "";
  writePathPlan(choice.plan, plan);
  context.note("wrote " + choice.plan);
}

void replay(const ReplayChoice& choice, const CommandContext& context) {
  if (!choice.all && (choice.subject.empty() || choice.trial == 0)) {
    throw InputError("nothing says which trial", "--subject, --trial", "give both, or --all for all trials");
  }
  if (choice.all && (!choice.frames.empty() || !choice.plan.empty() || choice.window)) {
    throw InputError("frames, plans and windows are of one trial", "--all",
                     "name the trial by --subject and --trial instead");
  }
  if (!choice.plan.empty()) {
    checkWritable(choice.plan);
  }
  const ReplayStudy study(choice.database);
  TrialChoice which;
  which.subject = choice.subject;
  which.withPractice = choice.practice;
  if (!choice.all) {
    which.session = choice.session;
    which.trial = choice.trial - 1;
  }
  const std::vector<TrialRow> trials = study.trials(which);
  const ReplaySummary summary = study.check(trials, viewPainters(choice.renderer), context.progress());
  if (!choice.frames.empty()) {
    writeFrames(choice, study, trials.back(), context);
  }
  if (!choice.plan.empty()) {
    writePlanOf(choice, study, trials.back(), context);
  }
  if (choice.window) {
    const TrialRow& trial = trials.back();
    showInWindow(study.blockOf(trial), study.logOf(trial), study.protocol().controls,
                 {study.nameOf(trial), choice.speed});
  }
  context.print(textOf(summary));
  if (!summary.allSame()) {
    throw WorkError("replays differ from the log", choice.database,
                    "was the file changed, or written by a version of the program whose tasks were others?");
  }
}

}  // namespace

void addStudyReplayCommand(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("replay", "Do trials again from their logs, and compare or show them");
  const auto choice = std::make_shared<ReplayChoice>();
  command.add_option("--db", choice->database, "The database")->type_name("FILE")->required();
  command.add_option("--subject", choice->subject, "Whose trials")->type_name("ID");
  command.add_option("--session", choice->session, "Which session, from 1")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--trial", choice->trial, "Which trial of its schedule, from 1; its last attempt")
      ->check(CLI::Range(1, 100000))
      ->type_name("K");
  command.add_flag("--all", choice->all, "All trials, of all subjects or of one: compare them with their logs");
  command.add_flag("--practice", choice->practice, "With --all: those of the practice as well");
  command.add_option("--frames", choice->frames, "Write each frame as a PNG into this folder")->type_name("DIR");
  command.add_option("--every", choice->every, "With --frames: only one of so many")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--plan", choice->plan, "Write a plan of the path over the maze, SVG or PNG")->type_name("FILE");
  command.add_flag("--window", choice->window, "Show it in a window, as fast as it was; Escape closes it");
  command.add_option("--speed", choice->speed, "With --window: so many times as fast")
      ->check(CLI::Range(0.05, 100.0))
      ->capture_default_str();
  addRendererOption(command, choice->renderer);
  context.finish(command,
                 "  ocelli study replay --db study.sqlite --all\n"
                 "  ocelli study replay --db study.sqlite --subject P07 --session 2 --trial 14 --plan path.svg\n"
                 "  ocelli study replay --db study.sqlite --subject P07 --trial 3 --window\n"
                 "  ocelli study replay --db study.sqlite --subject P07 --trial 3 --frames frames --every 6",
                 [choice, context] { replay(*choice, context); });
}

}  // namespace ocelli
