// Packed scenes as the SCENE of each command, against the scene that was packed.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "display_sim/frames/svol_file.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/scene/ply_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using nlohmann::json;

constexpr const char* kSource = "builtin:statues,triangles=60000";

class PackedSceneCommands : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TemporaryFolder>();
    const ProgramResult packed = runProgram(std::string("scene pack ") + kSource + " -q -o " + inQuotes(pack()));
    ASSERT_EQ(packed.exitCode, 0) << packed.error;
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static std::filesystem::path pack() { return *shared_ / "statues.opack"; }
  std::string out(const std::string& name) const { return inQuotes(folder_ / name); }

  /// Runs it with the source and with the packed scene; `-o` and its file are added.
  void runBoth(const std::string& before, const std::string& after, const std::string& extension) const {
    for (const auto& [scene, name] : {std::pair{std::string(kSource), "source"}, {inQuotes(pack()), "packed"}}) {
      const ProgramResult result =
          runProgram(before + " " + scene + " " + after + " -q -o " + out(std::string(name) + extension));
      ASSERT_EQ(result.exitCode, 0) << before << " " << name << ": " << result.error;
    }
  }

  static std::unique_ptr<TemporaryFolder> shared_;
  TemporaryFolder folder_;
};
std::unique_ptr<TemporaryFolder> PackedSceneCommands::shared_;

/// The share of pixels that one of the two images lacks, or that show something more than a fiftieth nearer or farther.
double differentShare(const ReferenceImages& a, const ReferenceImages& b) {
  EXPECT_EQ(a.size(), b.size());
  size_t pixels = 0;
  size_t different = 0;
  for (size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    EXPECT_EQ(a[k].width(), b[k].width());
    EXPECT_EQ(a[k].height(), b[k].height());
    for (size_t i = 0; i < std::min(a[k].t.size(), b[k].t.size()); ++i) {
      pixels += a[k].holds(i) || b[k].holds(i) ? 1 : 0;
      different += a[k].holds(i) != b[k].holds(i) || std::abs(a[k].t[i] - b[k].t[i]) > 0.02f * a[k].t[i] ? 1 : 0;
    }
  }
  return static_cast<double>(different) / static_cast<double>(pixels);
}

TEST_F(PackedSceneCommands, OcriBuildShowsTheSource) {
  for (const char* camera : {"di", "ddoc", "eoc-h", "eoc-hv", "cell", "corners-4", "ldi-4", "spoc", "rppc", "panorama"}) {
    runBoth("ocri build", fmt::format("--camera {} --size 360x240", camera), ".exr");
    const double share =
        differentShare(readReferenceImages(folder_ / "source.exr"), readReferenceImages(folder_ / "packed.exr"));
    std::cout << camera << " " << share << "\n";
  }
}

TEST_F(PackedSceneCommands, RenderShowsTheSource) {
  for (const char* method : {"raster", "points", "hybrid", "raycast"}) {
    runBoth("render", fmt::format("--camera di --size 360x240 --method {}", method), ".png");
    const Image<Rgb8> a = readPng(folder_ / "source.png");
    const Image<Rgb8> b = readPng(folder_ / "packed.png");
    size_t different = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      different += std::abs(a[i].r - b[i].r) + std::abs(a[i].g - b[i].g) + std::abs(a[i].b - b[i].b) > 48 ? 1 : 0;
    }
    std::cout << method << " " << different << " of " << a.size() << "\n";
  }
}

TEST_F(PackedSceneCommands, SlicesLightTheSameSurface) {
  for (const char* options : {"", "--exact", "--undithered", "--antialias"}) {
    runBoth("slice", std::string("--profile test ") + options, ".svol");
    const Volume a = readSvol(folder_ / "source.svol");
    const Volume b = readSvol(folder_ / "packed.svol");
    std::cout << options << " " << a.litVoxels() << " " << b.litVoxels() << " " << (a == b) << "\n";
  }
}

TEST_F(PackedSceneCommands, ProbeOthers) {
  const std::string scene = inQuotes(pack());
  for (const std::string& command : std::vector<std::string>{
           "scene info " + scene, "scene info " + scene + " --json", "scene info " + scene + " --no-fit",
           "scene info " + scene + " --shading none", "scene export " + scene + " -o " + out("a.ply"),
           "evaluate " + scene + " --size 90x60 --profile test --interior 2 --directions 2 --runs 1 --cameras di,ddoc --json " +
               out("e.json"),
           "solidity " + scene + " --profile test", "viewers " + scene + " --profile test",
           "device plan " + scene + " --profile test",
           "present " + scene + " --profile test --device null --seconds 0.4 --json",
           "present " + scene + " --profile test --device null --turn 30 --seconds 0.4 --json",
           "present " + scene + " --profile test --device null --camera ddoc --size 90x60 --seconds 0.4 --json",
           "render " + scene + " --camera comprehensive -o " + out("c.png"),
           "camera plan " + scene + " --camera comprehensive -o " + out("p.png"),
           "ocri build " + scene + " --camera geometry -o " + out("g.exr"),
           "ocri build " + scene + " --viewers 3 --size 90x60 -o " + out("v.exr"),
           "ocri build " + scene + " --construction rays --size 90x60 -o " + out("r.exr"),
           "scene pack " + scene + " -o " + out("again.opack"), "study check " + scene, "observe " + scene + " -o " + out("o.png"),
           "volume info " + scene, "demo " + scene}) {
    const ProgramResult result = runProgram(command);
    std::cout << "$ " << command << "\n-> " << result.exitCode << "\n" << result.output.substr(0, 900) << result.error.substr(0, 500);
  }
}

}  // namespace
}  // namespace ocelli::test
