// `ocelli device selftest`: test patterns for a display, and the checklist that goes with them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <system_error>

#include "cli/command.h"
#include "cli/device_command.h"
#include "cli/device_selftest_page.h"
#include "cli/device_selftest_show.h"
#include "cli/observer_choice.h"
#include "display_driver/devices/device_kinds.h"
#include "display_sim/frames/svol_file.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

constexpr int kImageSide = 720;
constexpr int kWrongImageSide = 320;

struct SelftestChoice {
  std::vector<std::string> patterns;
  std::string profile = "perspecta";
  bool profileGiven = false;
  std::string device;
  std::string output = "selftest";
};

std::vector<const TestPattern*> chosenPatterns(const std::vector<std::string>& names) {
  std::vector<const TestPattern*> chosen;
  for (const std::string& name : names) {
    testPattern(name);
  }
  // In the order in which to go through them, whatever the order of the options.
  for (const TestPattern& pattern : testPatterns()) {
    if (names.empty() || std::ranges::find(names, pattern.name) != names.end()) {
      chosen.push_back(&pattern);
    }
  }
  return chosen;
}

/// A display of fewer voxels, on which all is quick to observe and small errors are plain to see.
DisplayProfile coarser(DisplayProfile profile) {
  constexpr int kMaxColumns = 192;
  const int factor = (std::max(profile.width, profile.height) + kMaxColumns - 1) / kMaxColumns;
  profile.width = std::max(2, profile.width / factor);
  profile.height = std::max(1, profile.height / factor);
  return profile;
}

std::vector<SelftestImage> imagesOf(const TestPattern& pattern, const Volume& volume,
                                    const std::filesystem::path& folder) {
  constexpr size_t kMaxLit = 2'000'000;
  const size_t lit = volume.litVoxels();
  if (lit == 0) {
    return {};
  }
  return lit <= kMaxLit
             ? writeSelftestImages(volume, folder, pattern.name, kImageSide)
             : writeSelftestImages(pattern.volume(coarser(volume.profile())), folder, pattern.name, kImageSide);
}

void makeSelftestFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", folder.string(), "choose another one with -o");
  }
}

void runOnDevice(const SelftestChoice& choice, const CommandContext& context) {
  const std::vector<const TestPattern*> patterns = chosenPatterns(choice.patterns);
  DeviceOptions options;
  if (choice.profileGiven) {
    options.profile = loadProfile(choice.profile);
  }
  const std::filesystem::path folder = choice.output;
  makeSelftestFolder(folder);
  const std::unique_ptr<Device> device = openDevice(choice.device, options);
  const std::filesystem::path file = folder / "verdicts.csv";
  // After each answer: whatever ends this, nothing that was said is lost.
  const std::vector<PatternVerdict> verdicts =
      showPatterns(patterns, *device, std::cin, context,
                   [&](const std::vector<PatternVerdict>& soFar) { writeVerdicts(file, soFar); });
  writeVerdicts(file, verdicts);
  device->close();
  context.print("\n");
  const auto wrong = std::ranges::count(verdicts, PatternVerdict::kWrong, &PatternVerdict::verdict);
  const auto right = std::ranges::count(verdicts, PatternVerdict::kRight, &PatternVerdict::verdict);
  context.note(fmt::format("wrote {}: {} right, {} wrong, {} not seen", file.string(), right, wrong,
                           std::ssize(verdicts) - right - wrong));
}

void run(const SelftestChoice& choice, const CommandContext& context) {
  if (!choice.device.empty()) {
    runOnDevice(choice, context);
    return;
  }
  const std::vector<const TestPattern*> patterns = chosenPatterns(choice.patterns);
  const DisplayProfile profile = loadProfile(choice.profile);
  checkDefaultEye(profile);
  const std::filesystem::path folder = choice.output;
  makeSelftestFolder(folder);
  std::vector<SelftestSection> sections;
  const Progress progress = context.progress();
  for (const TestPattern* pattern : patterns) {
    report(progress, pattern->title, static_cast<double>(sections.size()) / static_cast<double>(patterns.size()));
    const Volume volume = pattern->volume(profile);
    const std::string file = pattern->name + ".svol";
    writeSvol(folder / file, volume);
    sections.push_back({pattern, file, imagesOf(*pattern, volume, folder),
                        writeWrongImages(*pattern, coarser(profile), folder, kWrongImageSide)});
  }
  const std::filesystem::path page = folder / "index.html";
  writeFile(page, selftestPage(sections, profile, OCELLI_VERSION));
  context.note(fmt::format("wrote {}: {} pattern{} for {}", page.string(), sections.size(),
                           sections.size() == 1 ? "" : "s", profile.name));
}

}  // namespace

void addDeviceSelftest(CLI::App& device, const CommandContext& context) {
  CLI::App& command = *device.add_subcommand(
      "selftest", "Write test patterns for a display, and a checklist with images of how they look when all is right");
  const auto choice = std::make_shared<SelftestChoice>();
  std::string names;
  for (const TestPattern& pattern : testPatterns()) {
    names += (names.empty() ? "" : ", ") + pattern.name;
  }
  command.add_option("--pattern", choice->patterns, "Only these; all where it is not given: " + names)
      ->type_name("NAME");
  const CLI::Option* profile =
      command.add_option("--profile", choice->profile, "The display: a name, or a profile of your own")
          ->type_name("NAME|FILE.json");
  command
      .add_option("--device", choice->device,
                  "Show the patterns there instead, ask how they look, and write the answers to verdicts.csv")
      ->type_name("DEVICE");
  command
      .add_option("-o,--output", choice->output,
                  "Folder for index.html, its images and the volumes, or for the answers")
      ->type_name("FOLDER");
  context.finish(command,
                 "  ocelli device selftest\n"
                 "  ocelli device selftest --profile my_display.json -o checklist\n"
                 "  ocelli device selftest --pattern phase wedges --profile vortex\n"
                 "  ocelli device selftest --device usb",
                 [choice, context, profile] {
                   choice->profileGiven = profile->count() > 0;
                   run(*choice, context);
                 });
}

}  // namespace ocelli
