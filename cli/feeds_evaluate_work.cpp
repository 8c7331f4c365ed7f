// The work of `ocelli feeds evaluate`.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/output_option.h"
#include "oc_core/base/json_document.h"
#include "oc_core/feeds_measure/errors_page.h"

namespace ocelli {
namespace {

std::string rowOf(const std::string& name, const std::array<size_t, kWalkerFates>& fates) {
  std::string row = fmt::format("  {:<8}", name);
  for (const size_t count : fates) {
    row += fmt::format(" {:>9}", count);
  }
  return row + "\n";
}

std::string stitcherRow(const FeedsEvaluationOptions& options, const StitcherFigures& stitcher) {
  if (options.stitchEvery == 0) {
    return "";
  }
  if (!hasStitcher()) {
    return "  stitcher     not built: OCELLI_WITH_STITCHER (docs/install.md)\n";
  }
  return fmt::format(
      "  stitcher     a picture of {} of {} frames, {} with all feeds; walkers in them: {} in the part of one feed, {} "
      "of "
      "several, {} of none; {:.0f} ms a frame\n",
      stitcher.pictures, stitcher.frames, stitcher.picturesOfAll, stitcher.seenOnce, stitcher.seenTwice,
      stitcher.notSeen, 1e3 * stitcher.meanSeconds());
}

}  // namespace

void evaluateFeedsCommand(const FeedsEvaluateChoice& choice, const CommandContext& context) {
  checkFiguresOutput(choice.json);
  FeedsEvaluationOptions options = choice.options;
  options.pictures = choice.page;
  options.setup = choice.setup;
  const FeedsEvaluation result = evaluateFeeds(choice.folder, options, context.progress());
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
      "\n  seen once    {:.2f} % of walkers and frames, or fading; {:.2f} % are seen by the right camera at that "
      "time\n  PSNR       "
      "  {:.2f} dB over {} "
      "frames\n  seams        {:.1f} levels more than rendered, {:.1f} beside them; over {:g} at {:.1f} %\n  speed     "
      "   {:.1f} ms a frame, without reading feeds and comparing\n",
      100 * result.rightShare(), 100 * result.possibleShare(), result.psnrDecibels, result.frames, result.seams.levels,
      result.seams.insideLevels, kSeamLevels, 100 * result.seams.visibleShare(), 1e3 * result.run.meanFrameSeconds);
  table += stitcherRow(options, result.stitcher);
  nlohmann::ordered_json figures{{"frames", result.frames},
                                 {"walkers", result.walkers.size()},
                                 {"fates", fates},
                                 {"right_share", result.rightShare()},
                                 {"possible_share", result.possibleShare()},
                                 {"psnr_db", result.psnrDecibels},
                                 {"seam_levels", result.seams.levels},
                                 {"seam_levels_beside", result.seams.insideLevels},
                                 {"seam_visible_share", result.seams.visibleShare()},
                                 {"mean_frame_seconds", result.run.meanFrameSeconds}};
  if (result.stitcher.frames > 0) {
    figures["stitcher"] = {{"frames", result.stitcher.frames},
                           {"pictures", result.stitcher.pictures},
                           {"pictures_of_all_feeds", result.stitcher.picturesOfAll},
                           {"seen_once", result.stitcher.seenOnce},
                           {"seen_in_several_feeds", result.stitcher.seenTwice},
                           {"not_seen", result.stitcher.notSeen},
                           {"mean_frame_seconds", result.stitcher.meanSeconds()}};
  }
  if (!choice.page.empty()) {
    writeErrorsPage(result, "Errors of " + choice.folder, choice.page);
    context.note("wrote " + choice.page + "/index.html");
  }
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", table, context);
}

}  // namespace ocelli
