// `ocelli sea evaluate`: a sea beside the images that it was made of, and beside other ways to store them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/number_check.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/sea_command.h"
#include "oc_core/base/json_document.h"
#include "oc_core/sea_input/sea_input.h"
#include "oc_core/sea_measure/sea_measure.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct SeaEvaluateChoice {
  std::string file;
  SceneChoice source;
  SeaMeasureOptions options;
  int samples = 2;
  std::string json;
};

std::string peerLine(const SeaPeerResult& peer, double seaBytes) {
  if (!peer.missing.empty()) {
    return fmt::format("  {:<6} {}\n", peer.name, peer.missing);
  }
  const std::string time = peer.secondsPerImage > 0 ? fmt::format("{:.0f} ms", 1e3 * peer.secondsPerImage) : "";
  return fmt::format("  {:<6} {:>9.1f} kB {:>7.2f} x {:>9.4f} {:>9}\n", peer.name, peer.bytesPerImage / 1e3,
                     peer.bytesPerImage / seaBytes, peer.flip, time);
}

void runEvaluate(const SeaEvaluateChoice& choice, const CommandContext& context) {
  checkFiguresOutput(choice.json);
  const SeaFile sea(choice.file);
  const SeaInput input = openSeaSource(choice.source.source.empty() ? sea.settings().source : choice.source.source,
                                       choice.source.options, sea, choice.samples, context.progress());
  const SeaMeasureResult result = measureSea(sea, *input.source, choice.options, context.progress());
  context.clearProgress();
  const SeaErrors& errors = result.errors;
  Json peers = Json::array();
  std::string table = fmt::format(
      "{}\n  compared     {} images of {}\n  FLIP         {:.4f} in the mean, {:.4f} at most\n"
      "  SSIM         {:.4f} in the mean, {:.4f} at least\n  PSNR         {:.2f} dB\n  size         {:.1f} kB an "
      "image, "
      "{:.1f} : 1\n  at random    {:.0f} images a second, {:.1f} ms for one alone\n",
      choice.file, errors.images, sea.count(), errors.flip, errors.mostFlip, errors.ssim, errors.leastSsim,
      errors.psnrDecibels, result.bytesPerImage / 1e3, result.ratio, result.imagesPerSecond,
      1e3 * result.secondsPerImage);
  if (!result.peers.empty()) {
    table += fmt::format("\n  {:<6} {:>12} {:>9} {:>9} {:>9}\n", "peer", "an image", "of ours", "FLIP", "at random");
  }
  for (const SeaPeerResult& peer : result.peers) {
    table += peerLine(peer, result.bytesPerImage);
    peers.push_back({{"name", peer.name},
                     {"missing", peer.missing},
                     {"quality", peer.quality},
                     {"bytes_per_image", peer.bytesPerImage},
                     {"flip", peer.flip},
                     {"ssim", peer.ssim},
                     {"seconds_per_image", peer.secondsPerImage}});
  }
  const Json figures{{"images", errors.images},
                     {"flip", errors.flip},
                     {"most_flip", errors.mostFlip},
                     {"ssim", errors.ssim},
                     {"least_ssim", errors.leastSsim},
                     {"psnr_db", errors.psnrDecibels},
                     {"bytes_per_image", result.bytesPerImage},
                     {"ratio", result.ratio},
                     {"images_per_second", result.imagesPerSecond},
                     {"seconds_per_image", result.secondsPerImage},
                     {"peers", peers}};
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", table, context);
}

}  // namespace

void addSeaEvaluateCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand(
      "evaluate", "Compare a sea with the images that it was made of, and with other ways to store them");
  const auto choice = std::make_shared<SeaEvaluateChoice>();
  command.add_option("SEA", choice->file, "The sea")->required()->type_name("FILE.sea");
  addSceneOption(command, choice->source, context);
  SeaMeasureOptions& options = choice->options;
  command.add_option("--images", options.images, "How many images are compared")
      ->check(numberCheck(1, 1e6))
      ->capture_default_str()
      ->type_name("N");
  command.add_option("--timed", options.timed, "How many images are had at random, to take the time")
      ->check(numberCheck(1, 1e6))
      ->capture_default_str()
      ->type_name("N");
  command.add_option("--run", options.run, "How many images in a row become video")
      ->check(numberCheck(2, 1e5))
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--peers", options.peers, "Measure these at equal FLIP, too: jpeg, jxl, webp; x265, av1 (by ffmpeg)")
      ->delimiter(',')
      ->type_name("NAME,...");
  command.add_option("--samples", choice->samples, "Of a scene: samples a side of each pixel, as it was built")
      ->check(CLI::Range(1, 8))
      ->capture_default_str()
      ->type_name("N");
  addFiguresOption(command, choice->json);
  context.finish(command,
                 "  ocelli sea evaluate museum.sea\n"
                 "  ocelli sea evaluate museum.sea --peers jpeg,jxl,x265,av1 --json figures.json",
                 [choice, context] { runEvaluate(*choice, context); });
}

}  // namespace ocelli
