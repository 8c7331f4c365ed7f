// `ocelli feeds evaluate`: simulated feeds beside the graph camera's own rendering.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"
#include "oc_core/base/json_document.h"
#include "oc_core/feeds_measure/evaluate_feeds.h"

namespace ocelli {
namespace {

struct FeedsEvaluateChoice {
  std::string folder;
  std::string pictures;
  FeedsEvaluationOptions options;
  std::string json;
};

std::string rowOf(const std::string& name, const std::array<size_t, kWalkerFates>& fates) {
  std::string row = fmt::format("  {:<8}", name);
  for (const size_t count : fates) {
    row += fmt::format(" {:>9}", count);
  }
  return row + "\n";
}

void runFeedsEvaluate(FeedsEvaluateChoice choice, const CommandContext& context) {
  checkFiguresOutput(choice.json);
  choice.options.pictures = choice.pictures;
  const FeedsEvaluation result = evaluateFeeds(choice.folder, choice.options, context.progress());
  context.clearProgress();
  std::string table = fmt::format("  {:<8}", "walker");
  std::array<size_t, kWalkerFates> sums{};
  nlohmann::ordered_json fates;
  for (size_t i = 0; i < kWalkerFates; ++i) {
    const auto fate = static_cast<WalkerFate>(i);
    table += fmt::format(" {:>9}", nameOf(fate));
    sums[i] = result.count(fate);
    fates[nameOf(fate)] = sums[i];
  }
  table += "\n";
  for (size_t w = 0; w < result.walkers.size(); ++w) {
    table += rowOf(std::to_string(w + 1), result.walkers[w]);
  }
  table += rowOf("all", sums);
  table += fmt::format(
      "\n  seen once    {:.2f} % of walkers and frames, or fading\n  PSNR         {:.2f} dB over {} "
      "frames\n  speed        {:.1f} ms a frame, without reading feeds and comparing\n",
      100 * result.rightShare(), result.psnrDecibels, result.frames, 1e3 * result.run.meanFrameSeconds);
  const nlohmann::ordered_json figures{{"frames", result.frames},
                                       {"walkers", result.walkers.size()},
                                       {"fates", fates},
                                       {"right_share", result.rightShare()},
                                       {"psnr_db", result.psnrDecibels},
                                       {"mean_frame_seconds", result.run.meanFrameSeconds}};
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", table, context);
}

}  // namespace

void addFeedsEvaluateCommand(CLI::App& feeds, const CommandContext& context) {
  CLI::App& command = *feeds.add_subcommand(
      "evaluate", "Compare the image of simulated feeds with the graph camera's own rendering of the scene");
  const auto choice = std::make_shared<FeedsEvaluateChoice>();
  command.add_option("FOLDER", choice->folder, "What `ocelli feeds simulate` wrote")->required()->type_name("FOLDER");
  command.add_option("--seconds", choice->options.seconds, "How much of it; all by default")
      ->check(numberCheck(1e-3, 1e9))
      ->type_name("S");
  command.add_option("--pictures", choice->pictures, "A folder for pictures of errors: composed beside rendered")
      ->type_name("FOLDER");
  addFiguresOption(command, choice->json);
  context.finish(command, "  ocelli feeds evaluate corridor --pictures errors --json figures.json",
                 [choice, context] { runFeedsEvaluate(*choice, context); });
}

}  // namespace ocelli
