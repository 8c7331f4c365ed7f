#include "cli/shown_output.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <system_error>

#include "cli/interrupt.h"
#include "cli/observer_choice.h"
#include "cli/values.h"
#include "display_driver/sim/shown_pictures.h"
#include "display_sim/frame_sink.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", folder.string(), "choose another one");
  }
}

}  // namespace

void addShownOptions(CLI::App& command, ShownChoice& choice) {
  command
      .add_option(
          "--shown", choice.folder,
          "A folder for what the simulated display showed: shown.svol with its volumes, torn turns included, and "
          "refreshes.csv with what each refresh showed, when, and how far out of phase")
      ->type_name("FOLDER");
  command.add_option("--watch", choice.watch, "What an observer saw of it: a picture a refresh")
      ->type_name("FOLDER|FILE.mp4|FILE.webm");
  command.add_option("--watch-from", choice.from, "Where that observer's eye is, in display radii")->type_name("X,Y,Z");
  command.add_option("--watch-size", choice.size, "Of these pictures, in pixels")->type_name("WIDTHxHEIGHT");
}

ShownOutput::ShownOutput(const ShownChoice& choice, const DisplayProfile& profile)
    : choice_(choice), profile_(profile) {
  if (!choice.given()) {
    return;
  }
  ObserverChoice observer;
  observer.eye = choice.from;
  observer.size = choice.size;
  observer_ = observerOptions(observer, profile);
  checkObserverOptions(observer_, profile);
  folder_ =
      !choice.folder.empty() ? std::filesystem::path(choice.folder) : std::filesystem::path(choice.watch + ".shown");
  makeFolder(folder_);
  recorder_.emplace(folder_ / "shown.svol", profile);
}

ShownOutput::~ShownOutput() {
  recorder_.reset();
  if (!folder_.empty() && choice_.folder.empty()) {
    std::error_code ignored;
    std::filesystem::remove(folder_ / "shown.svol", ignored);
    std::filesystem::remove(folder_, ignored);
  }
}

void ShownOutput::finish(const Frame& frame) {
  if (!recorder_) {
    return;
  }
  recorder_->finish();
  const std::vector<RecordedRefresh>& refreshes = recorder_->refreshes();
  const auto leftOut = std::ranges::count_if(refreshes, [](const RecordedRefresh& r) { return !r.volume; });
  if (leftOut > 0) {
    frame.note(fmt::format("{} of {} refreshes are missing in the record: the machine could not write so many volumes",
                           leftOut, refreshes.size()));
  }
  if (!choice_.folder.empty()) {
    writeRefreshTable(folder_ / "refreshes.csv", refreshes);
    frame.note(fmt::format("wrote {0}/shown.svol and {0}/refreshes.csv", choice_.folder));
  }
  if (choice_.watch.empty()) {
    return;
  }
  const double rate = profile_.refreshHertz();
  const auto sink = isVideo(choice_.watch) ? videoFile(choice_.watch, {observer_.width, observer_.height, rate})
                                           : frameFolder(choice_.watch);
  size_t pictures = 0;
  runOrLeaveNothing(choice_.watch, frame.progress(), [&](const Progress& progress) {
    pictures = drawShown(folder_ / "shown.svol", refreshes, observer_, rate, *sink, progress);
    sink->finish();
  });
  frame.note(fmt::format("wrote {}: {} pictures", choice_.watch, pictures));
}

}  // namespace ocelli
