// `ocelli study simulate`: whole studies with simulated subjects.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "cli/command.h"
#include "cli/study_command.h"
#include "cli/study_renderer.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "study/protocol/protocol.h"
#include "study/store/study_database.h"
#include "study/subject/simulate_together.h"

namespace ocelli {
namespace {

struct SimulateChoice {
  std::string protocol;
  std::string database;
  int subjects = 1;
  uint64_t seed = 1;
  std::string kind = "observer";
  std::string sessions;
  std::string renderer = "raster";
  std::string frame = "640x400";
  double hertz = 60;
  std::string first = "sim-";
  std::string effects;
  std::string factors;
  bool hashFrames = false;
};

void simulate(const SimulateChoice& choice, const CommandContext& context) {
  const Protocol protocol = readProtocol(choice.protocol);
  if (!isSubjectId(choice.first + "0001")) {
    throw InputError("subjects cannot be named like that: \"" + choice.first + "0001\"", "--first",
                     "use letters, digits, - and _");
  }
  const bool generates = choice.kind == "generator";
  if (!generates && !choice.effects.empty()) {
    throw InputError("effects are for the generator", "--effects", "add --kind generator, or leave it out");
  }
  if (generates && !choice.factors.empty()) {
    throw InputError("factors are for observers", "--factors", "leave it out, or leave out --kind generator");
  }
  const ImageSize size = imageSizeFromText(choice.frame, "--frame");
  if (!std::isfinite(choice.hertz)) {
    throw InputError("this is no rate", "--hertz", "give frames a second, such as 60");
  }
  SimulationPlan plan;
  plan.sessions = choice.sessions.empty()
                      ? std::vector<int>(static_cast<size_t>(choice.subjects), protocol.sessions)
                      : sessionsFromText(choice.sessions, choice.subjects, protocol.sessions, "--sessions");
  plan.seed = choice.seed;
  plan.kind = generates ? SubjectKind::kGenerator : SubjectKind::kObserver;
  plan.idPrefix = choice.first;
  plan.effects = choice.effects.empty() ? GeneratorEffects{} : readGeneratorEffects(choice.effects);
  plan.factors = choice.factors.empty() ? FactorMeans{} : readFactorMeans(choice.factors);
  checkConditions(plan.effects, protocol, choice.effects);
  plan.screen = {size.width, size.height, choice.hertz};
  plan.renderer = choice.renderer;
  plan.makeRenderer = [renderer = choice.renderer] { return studyRenderer(renderer); };
  plan.hashFrames = choice.hashFrames;
  const SimulationResult result =
      simulateTogether(protocol, choice.database, plan, context.ranks(), context.progress());
  context.note(fmt::format("{}: {} simulated subjects, {} sessions simulated, {} there before; {} trials in all",
                           choice.database, choice.subjects, result.sessions, result.sessionsBefore, result.trials));
}

}  // namespace

void addStudySimulateCommand(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("simulate", "Run a study with simulated subjects, as fast as it goes");
  const auto choice = std::make_shared<SimulateChoice>();
  command.add_option("PROTOCOL", choice->protocol, "The protocol of the study")->required();
  command.add_option("--db", choice->database, "The database; it is made where there is none")
      ->type_name("FILE")
      ->required();
  command.add_option("--subjects", choice->subjects, "How many")->check(CLI::Range(1, 9999))->capture_default_str();
  command.add_option("--seed", choice->seed, "All that is random comes of it")->capture_default_str();
  command
      .add_option("--kind", choice->kind,
                  "observer: sees identity images of what is shown; generator: draws outcomes from known effects")
      ->check(CLI::IsMember({"observer", "generator"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--sessions", choice->sessions,
                  "How many sessions for how many subjects, such as 3x25,1x20; all of the protocol where not given")
      ->type_name("SPEC");
  addRendererOption(command, choice->renderer);
  command.add_option("--frame", choice->frame, "Size of the observers' screen, pixels")
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  command.add_option("--hertz", choice->hertz, "Its frames a second")
      ->check(CLI::Range(10.0, 500.0))
      ->capture_default_str();
  command.add_option("--first", choice->first, "What ids of subjects begin with, before the number")
      ->type_name("TEXT")
      ->capture_default_str();
  command.add_option("--effects", choice->effects, "JSON file with the generator's effects")->type_name("FILE");
  command
      .add_option("--factors", choice->factors,
                  "JSON file with means of what observers can do, such as {\"place_error_degrees\": 1}")
      ->type_name("FILE");
  command.add_flag("--hash-frames", choice->hashFrames,
                   "Store a hash of the pixels of each image that an observer looks at, for replays to compare");
  context.finishShared(
      command,
      "  ocelli study simulate protocols/short.json --db trial.sqlite --subjects 4 --seed 1\n"
      "  ocelli study simulate protocols/rosen2010.json --db simulated.sqlite --subjects 45 --seed 7 "
      "--sessions 3x25,1x20\n"
      "  ocelli study simulate protocols/rosen2010.json --db known.sqlite --subjects 200 --kind generator",
      [choice, context] { simulate(*choice, context); });
}

}  // namespace ocelli
