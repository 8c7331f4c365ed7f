// `ocelli solidity` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr const char* kSmallSolidity = "solidity builtin:doors --size 90x60 --profile test --cell 4in --interior 1 ";

TEST(Solidity, ComparesCamerasAndImagesWithTheGeometry) {
  const TemporaryFolder folder;
  const std::string image = (folder / "two viewers.exr").string();
  ASSERT_EQ(runProgram("ocri build builtin:doors --size 90x60 -o '" + image + "'").exitCode, 0);
  const ProgramResult result =
      runProgram(kSmallSolidity + std::string("--cameras di,'") + image + "' --json '" + (folder / "x.json").string() +
                 "' -o '" + (folder / "pictures").string() + "'");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("hidden light"));
  const auto json = nlohmann::json::parse(fileBytes(folder / "x.json"));
  std::vector<std::string> names;
  for (const auto& row : json["representations"]) {
    names.push_back(row["name"]);
    EXPECT_TRUE(row["interior"]["flip"].is_number());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"visible voxels", "geometry", "di", "two viewers"}));
  for (const char* file : {"reference-opaque", "reference-di", "corner-di-hidden", "corner-two-viewers"}) {
    EXPECT_EQ(readPng(folder / ("pictures/" + std::string(file) + ".png")).width(), 64);
  }
}

TEST(Solidity, PrintsJsonAlone) {
  const ProgramResult result = runProgram(kSmallSolidity + std::string("--cameras di --image-side 20 --json"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(nlohmann::json::parse(result.output)["image_side"], 20);
}

TEST(Solidity, RefusesWhatItCannotMeasure) {
  for (const std::string arguments : {"--cell 0", "--cameras nothing", "--cameras missing.exr", "--image-side -1",
                                      "--profile nothing", "--interior -1", "--cell 100in"}) {
    const ProgramResult result = runProgram(kSmallSolidity + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments << result.error;
    EXPECT_EQ(result.output, "");
  }
}

}  // namespace
}  // namespace ocelli::test
