// `ocelli volume`: look into a .svol file, check it, and turn it into files of other programs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_option.h"
#include "cli/volume_export_command.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_join.h"
#include "display_sim/frames/svol_metadata.h"
#include "display_sim/frames/svol_summary.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/printable_text.h"

namespace ocelli {
namespace {

constexpr double kMicroseconds = 1e6;

uint64_t rawBytes(const SvolReader& reader, const SvolSummary& summary) {
  return summary.frames.size() * reader.profile().volumeBytes();
}

double seconds(uint64_t microseconds) {
  return static_cast<double>(microseconds) / kMicroseconds;
}

const char* stateOf(const SvolReader& reader, const SvolSummary& summary) {
  if (summary.damage) {
    return "damaged";
  }
  switch (reader.ending()) {
    case SvolEnding::kFinished:
      return "whole";
    case SvolEnding::kUnfinished:
      return "unfinished";
    case SvolEnding::kDamaged:
      return "damaged";
  }
  return "";
}

std::string frameTable(const std::vector<SvolFrameSummary>& frames) {
  std::string text = fmt::format("{:>7} {:>12} {:>6} {:>12} {:>6} {:>6} {:>6} {:>10}\n", "frame", "seconds", "kind",
                                 "bytes", "dark", "whole", "delta", "unchanged");
  for (size_t k = 0; k < frames.size(); ++k) {
    const SvolFrameSummary& frame = frames[k];
    text += fmt::format("{:>7} {:>12.6f} {:>6} {:>12} {:>6} {:>6} {:>6} {:>10}\n", k, seconds(frame.timeMicroseconds),
                        frame.key ? "key" : "delta", frame.bytes, frame.slices[0], frame.slices[1], frame.slices[2],
                        frame.slices[3]);
  }
  return text;
}

std::string sizes(const SvolReader& reader, const SvolSummary& summary) {
  const uint64_t raw = rawBytes(reader, summary);
  if (raw == 0) {
    return fmt::format("{}, without a whole frame", reader.fileBytes());
  }
  return fmt::format("{} of {} uncompressed ({:.1f}x)", reader.fileBytes(), raw,
                     static_cast<double>(raw) / static_cast<double>(reader.fileBytes()));
}

std::string infoAsText(const std::string& path, const SvolReader& reader, const SvolSummary& summary) {
  const DisplayProfile& profile = reader.profile();
  const size_t count = summary.frames.size();
  std::string text = fmt::format(
      "{}\n  display     {}, radius {:g} m, {:g} rpm, {:g} refreshes a second\n"
      "  slices      {} of {}x{}, {} bit{} a channel\n"
      "  frames      {}, of which {} need{} no other; {:.6g} s\n",
      path, printableText(profile.name), profile.radiusMetres, profile.rotationsPerMinute, profile.refreshHertz(),
      profile.storedSlices(), profile.width, profile.height, profile.colorBitsPerChannel,
      profile.colorBitsPerChannel == 1 ? "" : "s", count, summary.keyFrames, summary.keyFrames == 1 ? "s" : "",
      seconds(summary.durationMicroseconds));
  if (summary.litVoxels) {
    text += fmt::format("  lit voxels  {}{}\n", *summary.litVoxels, count > 1 ? " in the first frame" : "");
  }
  text += fmt::format("  bytes       {}\n", sizes(reader, summary));
  for (const auto& [name, value] : svol::metadataFields(reader.metadata())) {
    text += fmt::format("  {:<11} {}\n", printableText(name), printableText(value));
  }
  if (summary.damage) {
    text += fmt::format("  damaged     {}\n", summary.damage->what());
  } else if (reader.ending() == SvolEnding::kUnfinished) {
    text +=
        fmt::format("  unfinished  {} bytes follow the last whole frame\n", reader.fileBytes() - reader.wholeBytes());
  }
  return text;
}

std::string infoAsJson(const SvolReader& reader, const SvolSummary& summary, bool withFrames) {
  nlohmann::ordered_json json = {{"profile", nlohmann::ordered_json::parse(jsonText(reader.profile()))},
                                 {"metadata", nlohmann::ordered_json::parse(reader.metadata(), nullptr, true, true)},
                                 {"state", stateOf(reader, summary)},
                                 {"slices", reader.profile().storedSlices()},
                                 {"frames", summary.frames.size()},
                                 {"key_frames", summary.keyFrames},
                                 {"seconds", seconds(summary.durationMicroseconds)},
                                 {"lit_voxels", nullptr},
                                 {"file_bytes", reader.fileBytes()},
                                 {"plane_bytes", rawBytes(reader, summary)}};
  if (summary.litVoxels) {
    json["lit_voxels"] = *summary.litVoxels;
  }
  for (size_t k = 0; withFrames && k < summary.frames.size(); ++k) {
    const SvolFrameSummary& frame = summary.frames[k];
    json["frame_table"].push_back({{"seconds", seconds(frame.timeMicroseconds)},
                                   {"key", frame.key},
                                   {"bytes", frame.bytes},
                                   {"dark", frame.slices[0]},
                                   {"whole", frame.slices[1]},
                                   {"delta", frame.slices[2]},
                                   {"unchanged", frame.slices[3]}});
  }
  return textOfJson(json, 2) + "\n";
}

void addVolumeInfo(CLI::App& parent, const CommandContext& context) {
  struct Choice {
    std::string path;
    bool json = false;
    bool frames = false;
  };
  CLI::App& command = *parent.add_subcommand("info", "Show what a volume or a recording holds");
  const auto choice = std::make_shared<Choice>();
  command.add_option("VOLUME", choice->path, "A volume or a recording (.svol)")->required();
  command.add_flag("--frames", choice->frames, "Add a table of all frames");
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  context.finish(command,
                 "  ocelli volume info teapot.svol\n"
                 "  ocelli volume info recording.svol --frames",
                 [choice, context] {
                   SvolReader reader(choice->path);
                   const SvolSummary summary = summarizeSvol(reader, context.progress());
                   context.print(choice->json ? infoAsJson(reader, summary, choice->frames)
                                              : infoAsText(choice->path, reader, summary) +
                                                    (choice->frames ? frameTable(summary.frames) : ""));
                 });
}

void runVerify(const std::string& path, const CommandContext& context) {
  SvolReader reader(path);
  verifySvol(reader, context.progress());
  const size_t count = reader.frames().size();
  const std::string frames =
      fmt::format("{} frame{} of {} slices", count, count == 1 ? "" : "s", reader.layout().slices);
  if (reader.ending() == SvolEnding::kUnfinished) {
    throw WorkError(
        fmt::format("unfinished: {} are whole, and {} bytes follow", frames, reader.fileBytes() - reader.wholeBytes()),
        path, count > 0 ? "`ocelli volume join --salvage` makes a finished file of it" : "write the file again");
  }
  context.print(fmt::format("{}: {}, all whole\n", path, frames));
}

void addVerify(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand(
      "verify",
      "Check every byte of a file; exit code 2 if it is damaged, 1 if it is whole as far as it goes but unfinished");
  const auto path = std::make_shared<std::string>();
  command.add_option("VOLUME", *path, "A volume or a recording (.svol)")->required();
  context.finish(command, "  ocelli volume verify teapot.svol", [path, context] { runVerify(*path, context); });
}

void addJoin(CLI::App& parent, const CommandContext& context) {
  struct Choice {
    std::vector<std::string> sources;
    std::string output;
    JoinOptions options;
  };
  CLI::App& command = *parent.add_subcommand("join", "Make one recording of volumes and recordings");
  const auto choice = std::make_shared<Choice>();
  command.add_option("VOLUMES", choice->sources, "Volumes and recordings (.svol) for one display, in their order")
      ->required();
  command
      .add_option("--fps", choice->options.framesPerSecond,
                  "Files a second: how long the last frame of each is shown; by default for one refresh of the display")
      ->type_name("RATE");
  command.add_flag("--salvage", choice->options.salvage,
                   "Of unfinished and damaged files, take the frames up to the first that cannot be read");
  addOutputOption(command, choice->output, "Where the recording goes", {".svol"});
  context.finish(
      command,
      "  ocelli volume join a.svol b.svol c.svol --fps 12 -o film.svol\n"
      "  ocelli volume join killed.svol --salvage -o whole.svol",
      [choice, context] {
        const std::vector<std::filesystem::path> sources(choice->sources.begin(), choice->sources.end());
        JoinResult result;
        runOrLeaveNothing(choice->output, context.progress(), [&](const Progress& progress) {
          result = joinSvol(sources, choice->output, choice->options, progress);
        });
        for (const std::filesystem::path& path : result.incomplete) {
          context.note(fmt::format("{} is not whole: what can be read was taken", path.string()));
        }
        context.note(fmt::format("wrote {}: {} frame{}", choice->output, result.frames, result.frames == 1 ? "" : "s"));
      });
}

}  // namespace

void addVolumeCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("volume", "Look into .svol files, check them, export them, join them");
  command.require_subcommand(1);
  addVolumeInfo(command, context);
  addVerify(command, context);
  addVolumeExport(command, context);
  addJoin(command, context);
}

}  // namespace ocelli
