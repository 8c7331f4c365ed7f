// The work of `ocelli feeds calibrate`.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

void writeCalibrationSheet(const FeedsSheetChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  SheetContents contents{{}, choice.tags, choice.tagMillimetres};
  if (!choice.board.empty() || choice.tags.empty()) {
    contents.board = boardFromText(choice.board.empty() ? kUsualBoard : choice.board);
  }
  writeFile(choice.output, calibrationSheetPdf(contents, paperFromText(choice.paper)));
  context.note("wrote " + choice.output + ": print it at 100 % and measure its ruler");
}

void calibrateLensCommand(const FeedsLensChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  if (choice.setup.empty() != choice.feed.empty()) {
    throw InputError("--setup and --feed go together", "feeds calibrate lens", "give both, or neither");
  }
  const CalibrationBoard board = boardFromText(choice.board);
  FeedSetup setup;
  if (!choice.setup.empty()) {
    setup = readFeedSetup(choice.setup);
    if (setup.feedIndex(choice.feed) < 0) {
      throw InputError("there is no feed \"" + choice.feed + "\"", choice.setup, "use the name of one of its feeds");
    }
  }
  const LensCalibration result = calibrateLensFrom(choice.views, board, context.progress());
  context.clearProgress();
  if (choice.setup.empty()) {
    writeFile(choice.output, jsonText(result.lens));
  } else {
    Feed& feed = setup.feeds[static_cast<size_t>(setup.feedIndex(choice.feed))];
    if (feed.width != result.width || feed.height != result.height) {
      throw InputError(fmt::format("the views have {}x{} pixels, and feed \"{}\" has {}x{}", result.width,
                                   result.height, feed.name, feed.width, feed.height),
                       choice.views, "take views of the board with the size of the feed");
    }
    feed.lens = result.lens;
    writeFeedSetup(setup, choice.output);
  }
  context.print(fmt::format(
      "  focal        {:.2f} x {:.2f} pixels, known to {:.2f} %\n  center       {:.2f}, {:.2f}\n"
      "  error        {:.3f} pixels RMS\n  views        {}, and {} left out\n"
      "  covered      {:.0f} % of the image\n  tilt         {:.0f} degrees between views\n",
      result.lens.focal.x, result.lens.focal.y, 100 * result.focalSpread, result.lens.center.x, result.lens.center.y,
      result.rmsPixels, result.views, result.viewsLeftOut, 100 * result.coveredShare, result.maxTiltDegrees));
  for (const std::string& warning : result.warnings) {
    context.note("warning: " + warning);
  }
  context.note("wrote " + choice.output);
}

void calibratePosesCommand(const FeedsPoseChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  FeedSetup setup = readFeedSetup(choice.setup);
  const PoseCalibration result =
      calibratePoses(setup, readKnownPlaces(choice.places), choice.places, choice.options, context.progress());
  context.clearProgress();
  std::string table =
      fmt::format("  {:<12} {:>5} {:>7} {:>11} {:>11}  worst at\n", "feed", "tags", "points", "RMS pixels", "worst");
  std::string failed;
  size_t failures = 0;
  for (const FeedCalibration& feed : result.feeds) {
    if (feed.failure.empty()) {
      table += fmt::format("  {:<12} {:>5} {:>7} {:>11.3f} {:>11.3f}  {}\n", feed.feed, feed.tags, feed.points,
                           feed.rmsPixels, feed.maxPixels, feed.worst);
      continue;
    }
    table += fmt::format("  {:<12} {:>5}  no pose\n", feed.feed, feed.tags);
    failed += (failures++ > 0 ? "\n" : "") + feed.failure;
  }
  context.print(table);
  for (const std::string& warning : result.warnings) {
    context.note("warning: " + warning);
  }
  if (failures < result.feeds.size()) {
    writeFeedSetup(setup, choice.output);
    context.note("wrote " + choice.output);
  }
  if (failures > 0) {
    throw WorkError(fmt::format("{} of {} feeds have no new pose", failures, result.feeds.size()), choice.setup,
                    "do what is said of each, and run the same again", failed);
  }
}

void checkPosesCommand(const FeedsCheckChoice& choice, const CommandContext& context) {
  const FeedSetup setup = readFeedSetup(choice.setup);
  std::string table = fmt::format("  {:<12} {:>5} {:>13}\n", "feed", "tags", "median pixels");
  std::string moved;
  size_t seen = 0;
  const KnownPlaces places = choice.places.empty() ? setup.places : readKnownPlaces(choice.places);
  if (places.tags.empty()) {
    throw InputError(
        "there are no places of tags", choice.places.empty() ? choice.setup : choice.places,
        "give --places PLACES.json, or run `ocelli feeds calibrate pose`, which writes them into the setup");
  }
  for (const PoseCheck& check : checkPoses(setup, places, choice.movedPixels, {})) {
    seen += check.tags;
    const std::string median = check.tags > 0 ? fmt::format("{:.2f}", check.medianPixels) : "unknown";
    table += fmt::format("  {:<12} {:>5} {:>13}\n", check.feed, check.tags, median);
    if (check.hasMoved) {
      moved += (moved.empty() ? "" : "; ") + check.message;
    } else if (!check.message.empty()) {
      context.note("warning: " + check.message);
    }
  }
  context.print(table);
  if (!moved.empty()) {
    throw WorkError(moved, choice.setup, "put cameras back, or run `ocelli feeds calibrate pose` for new poses");
  }
  if (seen == 0) {
    throw WorkError("nothing was checked: no camera sees a tag", choice.setup,
                    "put tags back to their places where cameras see them, and take care of the light");
  }
}

}  // namespace ocelli
