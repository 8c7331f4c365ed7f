// `ocelli feeds simulate`: feeds of a scene with walkers, and the truth about them.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"

namespace ocelli {

void addFeedsSimulateCommand(CLI::App& feeds, const CommandContext& context,
                             const FeedsWorkOf<FeedsSimulateChoice>& work) {
  CLI::App& command = *feeds.add_subcommand("simulate", "Make feeds of a scene with walkers, and the truth about them");
  const auto choice = std::make_shared<FeedsSimulateChoice>();
  FeedSimulationOptions& options = choice->options;
  command.add_option("SCENE", options.scene, "A scene with cameras and ways")->capture_default_str();
  command.add_option("-o,--output", choice->output, "The folder")->required()->type_name("FOLDER");
  const auto number = [&](const char* name, double& value, const char* help, double least, double most,
                          const char* unit) {
    command.add_option(name, value, help)->check(numberCheck(least, most))->capture_default_str()->type_name(unit);
  };
  number("--seconds", options.seconds, "How long", 0.1, 36000, "S");
  number("--frames-per-second", options.framesPerSecond, "Of each camera", 1, 240, "F");
  command.add_option("--walkers", options.walkers, "How many people walk there")
      ->check(CLI::Range(size_t{0}, kMaxWalkers))
      ->capture_default_str()
      ->type_name("N");
  command.add_option("--seed", options.seed, "Of the random numbers")
      ->check(CLI::Range(uint64_t{0}, uint64_t{1} << 52U))
      ->capture_default_str()
      ->type_name("N");
  number("--noise", options.noiseLevels, "Standard deviation of the noise, of 255 levels", 0, 50, "LEVELS");
  number("--exposure", options.exposureSwing, "By which share the light of each feed goes up and down", 0, 0.5,
         "SHARE");
  number("--distortion", options.distortion, "Of the lenses: 0 none, 1 usual", 0, 1.5, "SHARE");
  number("--clock-offset", options.maxClockOffset, "By how much clocks differ, at most", 0, 1000, "S");
  number("--dropped", options.droppedShare, "Share of the frames that are lost", 0, 0.9, "SHARE");
  number("--rolling", options.rollingSeconds,
         "Over which the rows of a frame are taken one after the other; 0: all at once", 0, kMaxRollingSeconds, "S");
  command.add_option("--size", choice->size, "Of all feeds and the composed image; as the rig has them by default")
      ->type_name("WxH");
  command.add_option("--masks", options.maskEvery, "Write what is a walker for each so manieth frame, too")
      ->check(CLI::Range(size_t{1}, size_t{1000000}))
      ->type_name("N");
  command.add_option("--freeze", choice->freeze, "A feed that shows nothing new from a time on")
      ->type_name("FEED@SECONDS");
  context.finish(command,
                 "  ocelli feeds simulate -o corridor\n"
                 "  ocelli feeds simulate builtin:courtyard --size 1280x720 --walkers 5 --rolling 0.02 -o court\n"
                 "  ocelli feeds simulate builtin:corridor_t --walkers 6 --seconds 60 --seed 7 --masks 30 -o corridor",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace ocelli
