#include "cli/shown_output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <system_error>

#include "cli/interrupt.h"
#include "cli/observer_choice.h"
#include "cli/values.h"
#include "display_driver/devices/shown_images.h"
#include "display_sim/observing/frame_sink.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

void makeShownFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", folder.string(), "choose another one");
  }
}

/// "seen.gif" is meant as a file, "run.12" is a folder.
bool looksLikeAFile(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending.size() >= 3 && ending.size() <= 5 && std::isalpha(static_cast<unsigned char>(ending[1])) != 0 &&
         !std::filesystem::is_directory(path);
}

ObserverOptions shownObserver(const ShownChoice& choice, const DisplayProfile& profile) {
  imageSizeFromText(choice.size, "--watch-size");
  if (!choice.from.empty()) {
    pointFromText(choice.from, "--watch-from");
  }
  ObserverChoice observer;
  observer.eye = choice.from;
  observer.size = choice.size;
  const ObserverOptions options = observerOptions(observer, profile);
  checkObserverOptions(options, profile);
  return options;
}

/// Beside `output`, of a name that nobody has.
std::filesystem::path ownRecordBeside(std::filesystem::path output) {
  if (!output.has_filename()) {
    output = output.parent_path();
  }
  std::filesystem::path name;
  for (int i = 0; name.empty() || std::filesystem::exists(name); ++i) {
    name = fmt::format("{}.partial-{}{}.svol", output.string(), getpid(), i == 0 ? "" : fmt::format("-{}", i));
  }
  return name;
}

}  // namespace

void addShownOptions(CLI::App& command, ShownChoice& choice) {
  command
      .add_option(
          "--shown", choice.folder,
          "A folder for what the simulated display showed: shown.svol with its volumes, torn turns included, and "
          "refreshes.csv with what each refresh showed, when, and how far out of phase")
      ->type_name("FOLDER");
  command.add_option("--watch", choice.watch, "What an observer saw of it: an image a refresh")
      ->type_name("FOLDER|FILE.mp4|FILE.webm");
  command.add_option("--watch-from", choice.from, "Where that observer's eye is, in display radii")->type_name("X,Y,Z");
  command.add_option("--watch-size", choice.size, "Of these images, in pixels")->type_name("WIDTHxHEIGHT");
}

std::filesystem::path shownRecord(const ShownChoice& choice) {
  return std::filesystem::path(choice.folder) / "shown.svol";
}

void checkShownOptions(const ShownChoice& choice, const DisplayProfile& profile) {
  if (!choice.given()) {
    return;
  }
  shownObserver(choice, profile);
  if (!isVideo(choice.watch) && looksLikeAFile(choice.watch)) {
    throw InputError("no images are written in this format", "--watch " + choice.watch,
                     "a name that ends in .mp4 or .webm, or one without an ending for a folder of .png files");
  }
}

ShownOutput::ShownOutput(const ShownChoice& choice, const DisplayProfile& profile)
    : choice_(choice), profile_(profile) {
  if (!choice.given()) {
    return;
  }
  checkShownOptions(choice, profile);
  observer_ = shownObserver(choice, profile);
  if (choice.folder.empty()) {
    record_ = ownRecordBeside(choice.watch);
    ownRecord_ = UnfinishedOutput(record_, [] {});
  } else {
    makeShownFolder(choice.folder);
    record_ = shownRecord(choice);
  }
  recorder_.emplace(record_, profile);
}

ShownOutput::~ShownOutput() {
  recorder_.reset();
  if (!record_.empty() && choice_.folder.empty()) {
    ownRecord_.finish([this] {
      std::error_code ignored;
      std::filesystem::remove(record_, ignored);
    });
  }
}

void ShownOutput::finish(const CommandContext& context) {
  if (!recorder_) {
    return;
  }
  recorder_->finish();
  const std::vector<RecordedRefresh>& refreshes = recorder_->refreshes();
  const auto leftOut = std::ranges::count_if(refreshes, [](const RecordedRefresh& r) { return !r.volume; });
  if (leftOut > 0) {
    context.note(
        fmt::format("{} of {} refreshes are missing in the record: the machine could not write so many volumes",
                    leftOut, refreshes.size()));
  }
  if (!choice_.folder.empty()) {
    writeRefreshTable(std::filesystem::path(choice_.folder) / "refreshes.csv", refreshes);
    context.note(fmt::format("wrote {0}/shown.svol and {0}/refreshes.csv", choice_.folder));
  }
  if (choice_.watch.empty()) {
    return;
  }
  const double rate = profile_.refreshHertz();
  const auto sink = isVideo(choice_.watch) ? videoFile(choice_.watch, {observer_.width, observer_.height, rate})
                                           : frameFolder(choice_.watch);
  size_t images = 0;
  runOrLeaveNothing(choice_.watch, context.progress(), [&](const Progress& progress) {
    images = drawShown(record_, refreshes, observer_, rate, *sink, progress);
    sink->finish();
  });
  context.note(fmt::format("wrote {}: {} images", choice_.watch, images));
}

}  // namespace ocelli
