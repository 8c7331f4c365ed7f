// `ocelli sea info` and `ocelli sea verify`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/output_option.h"
#include "cli/sea_command.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/sea/sea_file.h"
#include "oc_core/sea/sea_summary.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct SeaInfoChoice {
  std::string file;
  std::string json;
};

Json listOf(const glm::dvec3& p) {
  return Json::array({p.x, p.y, p.z});
}

void runInfo(const SeaInfoChoice& choice, const CommandContext& context) {
  const SeaFile sea(choice.file);
  const SeaSummary summary = summaryOf(sea);
  const SeaSettings& settings = sea.settings();
  const Json figures{{"file", choice.file},
                     {"settings", Json::parse(jsonText(settings))},
                     {"images", sea.count()},
                     {"i_nodes", summary.inner},
                     {"most_additions", summary.mostAdditions},
                     {"bytes", sea.fileBytes()},
                     {"i_bytes", summary.innerBytes},
                     {"p_bytes", summary.residualBytes},
                     {"hidden_bytes", summary.hiddenBytes},
                     {"raw_bytes", summary.rawBytes},
                     {"ratio", summary.ratio()},
                     {"proxy_triangles", sea.proxy().mesh().triangles.size()},
                     {"lower", listOf(summary.lower)},
                     {"upper", listOf(summary.upper)},
                     {"spacing", summary.spacing}};
  const uint64_t residuals = sea.count() - summary.inner;
  const std::string hidden =
      settings.hasHidden()
          ? fmt::format("  hidden       {} samples, {:.1f} kB an I-node, {:.2f} % of the file\n", settings.hidden,
                        static_cast<double>(summary.hiddenBytes) / 1e3 /
                            static_cast<double>(std::max<uint64_t>(1, summary.inner)),
                        100 * static_cast<double>(summary.hiddenBytes) / static_cast<double>(sea.fileBytes()))
          : "";
  const std::string table = fmt::format(
      "{}\n  source       {}\n  images       {} of {}x{}, taken {:.3g} apart (median to the nearest)\n"
      "  positions    {:.4g} to {:.4g}, {:.4g} to {:.4g}, {:.4g} to {:.4g}\n"
      "  I-nodes      {}, {}, {:.1f} kB each\n  P-nodes      {}, {}, {:.1f} kB each; {} way, at most {} additions\n{}"
      "  proxy        {} triangles\n  size         {:.2f} MB, {:.1f} : 1, {:.3f} bits a pixel\n",
      choice.file, printableText(settings.source), sea.count(), settings.projection.width, settings.projection.height,
      summary.spacing, summary.lower.x, summary.upper.x, summary.lower.y, summary.upper.y, summary.lower.z,
      summary.upper.z, summary.inner, settings.iCodec,
      static_cast<double>(summary.innerBytes) / 1e3 / static_cast<double>(std::max<uint64_t>(1, summary.inner)),
      residuals, settings.pCodec,
      static_cast<double>(summary.residualBytes) / 1e3 / static_cast<double>(std::max<uint64_t>(1, residuals)),
      nameOf(settings.way), summary.mostAdditions, hidden, sea.proxy().mesh().triangles.size(),
      static_cast<double>(sea.fileBytes()) / 1e6, summary.ratio(), 24 / summary.ratio());
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", table, context);
}

struct SeaVerifyChoice {
  std::string file;
  bool decode = false;
};

void runVerify(const SeaVerifyChoice& choice, const CommandContext& context) {
  const SeaFile sea(choice.file);
  sea.verify(choice.decode, context.progress());
  context.clearProgress();
  context.print(fmt::format("{}: whole, {} images{}\n", choice.file, sea.count(),
                            choice.decode ? ", each of which was decoded" : ""));
}

}  // namespace

void addSeaInfoCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("info", "Print what a sea of images holds");
  const auto choice = std::make_shared<SeaInfoChoice>();
  command.add_option("SEA", choice->file, "The sea")->required()->type_name("FILE.sea");
  addFiguresOption(command, choice->json);
  context.finish(command, "  ocelli sea info museum.sea\n  ocelli sea info museum.sea --json -",
                 [choice, context] { runInfo(*choice, context); });
}

void addSeaVerifyCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("verify", "Check every byte of a sea of images");
  const auto choice = std::make_shared<SeaVerifyChoice>();
  command.add_option("SEA", choice->file, "The sea")->required()->type_name("FILE.sea");
  command.add_flag("--decode", choice->decode, "Decode every image, too");
  context.finish(command, "  ocelli sea verify museum.sea\n  ocelli sea verify --decode museum.sea",
                 [choice, context] { runVerify(*choice, context); });
}

}  // namespace ocelli
