#include "cli/feeds_demo.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/feeds_program.h"
#include "display_driver/demo/demo_folder.h"
#include "oc_core/base/child_process.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kFeedsDemoSeconds = 120;  ///< after which a step is given up; it takes seconds

void runFeedsStep(const std::filesystem::path& program, std::vector<std::string> words) {
  words.insert(words.begin(), {"--quiet", "feeds"});
  const ChildEnd end = runChild({program, words, kFeedsDemoSeconds}, [] {});
  if (end.how != ChildEnd::How::kExited || end.code != 0) {
    throw WorkError(fmt::format("`{}` failed: {}", fmt::join(words, " "), end.messages), program.string(),
                    "run it by hand: ocelli feeds");
  }
}

/// Of a folder of images, the one with the last name.
std::filesystem::path lastImageIn(const std::filesystem::path& folder) {
  std::filesystem::path last;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    last = std::max(last, entry.path());
  }
  return last;
}

DemoScene feedsScene(const std::filesystem::path& program, const std::filesystem::path& folder) {
  const DemoFolder images(folder, "feeds");
  const std::filesystem::path work = folder / "feeds" / "work";
  const std::string setup = (work / "setup.json").string();
  runFeedsStep(program, {"simulate", "builtin:corridor_t", "--seconds", "1", "--frames-per-second", "10", "--size",
                         "480x480", "-o", work.string()});
  runFeedsStep(program, {"run", setup, "--no-labels", "--frames-per-second", "5", "-o", (work / "composed").string()});
  runFeedsStep(program, {"panes", setup, "-o", (work / "panes.png").string()});
  DemoScene scene;
  scene.title = "A T of corridors, by three video cameras";
  scene.source = "ocelli feeds simulate builtin:corridor_t";
  scene.rows.push_back(
      {"Watch corridors",
       "A graph camera made of video feeds shows both branches of the corridors in one image that goes on around the "
       "corners. Who stands before the part of a branch that its feed shows is erased from it, and whom he hides "
       "is shown as a camera saw that one last; pieces may stay where bodies overlap.",
       {images.write("panes", readPng(work / "panes.png"), "Panes", "Each feed by itself: who is where takes thought."),
        images.write("composed", readPng(lastImageIn(work / "composed")), "Graph camera",
                     "One continuous image of the same feeds.")}});
  std::error_code ignored;  // what stays behind does no harm
  std::filesystem::remove_all(work, ignored);
  return scene;
}

}  // namespace

std::optional<DemoScene> runFeedsDemo(const std::filesystem::path& folder, const CommandContext& context) {
  try {
    return feedsScene(findOwnProgram(feedsProgram()), folder);
  } catch (const WorkError& error) {
    context.note(fmt::format("no graph camera from video: {}", error.what()));
    return std::nullopt;
  }
}

}  // namespace ocelli
