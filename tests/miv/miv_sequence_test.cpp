#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/miv/miv_reader.h"
#include "oc_core/miv/miv_writer.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

MivView viewNamed(const std::string& name, bool isPanorama = false) {
  MivView view;
  view.name = name;
  view.isPanorama = isPanorama;
  view.view.eye = {1, 2, 9};
  view.view.centerShift = {0.1f, -0.2f};
  view.color = Image<glm::vec3>(16, 8, glm::vec3(0.25f, 0.5f, 0.75f));
  view.depth = Image<float>(16, 8, 9);
  view.depth(3, 4) = 12;
  view.depth(5, 6) = 0;
  return view;
}

MivSequence sequence() {
  MivSequence sequence;
  sequence.content = "Test";
  sequence.views = {viewNamed("v00"), viewNamed("v01", true)};
  return sequence;
}

std::string readingError(const std::filesystem::path& file) {
  try {
    readMivSequence(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MivSequence, whatIsWrittenIsReadBack) {
  const TemporaryFolder folder;
  MivSequence written = sequence();
  written.unitsPerMetre = 2;
  writeMivSequence(folder / "out", written);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/v00_texture_16x8_yuv420p10le.yuv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/v01_depth_16x8_yuv420p16le.yuv"));
  const MivSequence back = readMivSequence(folder / "out/Test.json", 2);
  EXPECT_EQ(back.content, "Test");
  ASSERT_EQ(back.views.size(), 2u);
  EXPECT_FALSE(back.views[0].isPanorama);
  EXPECT_TRUE(back.views[1].isPanorama);
  const PinholeCamera camera(written.views[0].view, 16, 8);
  const PinholeCamera again(back.views[0].view, 16, 8);
  EXPECT_LT(glm::distance(camera.eye(), again.eye()), 1e-5f);
  EXPECT_LT(glm::distance(camera.forward(), again.forward()), 1e-5f);
  EXPECT_NEAR(camera.focalPixels(), again.focalPixels(), 1e-3);
  EXPECT_LT(glm::distance(camera.centerPixels(), again.centerPixels()), 1e-4f);
  // Of depths in equal steps of 1/z between near and far, in metres.
  const double step = (1 / 4.49 - 1 / 6.01) / 65535;
  for (size_t i = 0; i < written.views[0].depth.size(); ++i) {
    const float depth = written.views[0].depth[i];
    if (depth == 0) {
      EXPECT_EQ(back.views[0].depth[i], 0);
    } else {
      EXPECT_NEAR(2 / back.views[0].depth[i], 2 / depth, step);
    }
  }
}

// The example of TMIV's own test of its reader (SequenceConfig.test.cpp) has these fields.
TEST(MivSequence, hasTheFieldsThatTheTestModelAsksFor) {
  const TemporaryFolder folder;
  writeMivSequence(folder.path(), sequence());
  const nlohmann::json json = nlohmann::json::parse(test::fileBytes(folder / "Test.json"));
  for (const char* name :
       {"BoundingBox_center", "Content_name", "Fps", "Frames_number", "sourceCameraNames", "cameras"}) {
    EXPECT_TRUE(json.contains(name)) << name;
  }
  EXPECT_EQ(json["sourceCameraNames"], nlohmann::json({"v00", "v01"}));
  const nlohmann::json& pinhole = json["cameras"][0];
  for (const char* name :
       {"Name", "Position", "Rotation", "Depth_range", "HasInvalidDepth", "Resolution", "Projection", "Focal",
        "Principle_point", "BitDepthColor", "BitDepthDepth", "ColorSpace", "DepthColorSpace"}) {
    EXPECT_TRUE(pinhole.contains(name)) << name;
  }
  EXPECT_EQ(json["cameras"][1]["Projection"], "Equirectangular");
  EXPECT_EQ(json["cameras"][1]["Hor_range"], nlohmann::json({-180, 180}));
  EXPECT_EQ(json["cameras"][1]["Ver_range"], nlohmann::json({-90, 90}));
}

TEST(MivSequence, whatHasNoSuchFormIsRefused) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::function<void(MivSequence&)>& change) -> std::string {
    MivSequence changed = sequence();
    change(changed);
    try {
      writeMivSequence(folder / "out", changed);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(errorOf([](MivSequence&) {}), "");
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views.clear(); }), HasSubstr("no views"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[1].name = "v00"; }), HasSubstr("two views have this name"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[1].name = "../v"; }), HasSubstr("no name for files"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.content = ""; }), HasSubstr("no name for files"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[0].depth = Image<float>(16, 6, 9); }), HasSubstr("16x6"));
  EXPECT_THAT(errorOf([](MivSequence& s) {
                s.views[0].depth = Image<float>(15, 8, 9);
                s.views[0].color = Image<glm::vec3>(15, 8);
              }),
              HasSubstr("even width"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[0].depth(2, 1) = std::numeric_limits<float>::quiet_NaN(); }),
              HasSubstr("(2, 1)"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[0].depth = Image<float>(16, 8, 0); }), HasSubstr("no depth"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[0].depth(0, 0) = 2000; }), HasSubstr("--metre"));
  EXPECT_THAT(errorOf([](MivSequence& s) { s.views[0].view.target = s.views[0].view.eye; }), HasSubstr("v00"));
}

TEST(MivSequence, damageIsNamed) {
  const TemporaryFolder folder;
  writeMivSequence(folder.path(), sequence());
  const nlohmann::json good = nlohmann::json::parse(test::fileBytes(folder / "Test.json"));
  const auto errorOf = [&](const std::function<void(nlohmann::json&)>& change) {
    nlohmann::json changed = good;
    change(changed);
    return readingError(folder.write("Changed.json", changed.dump(1)));
  };
  EXPECT_EQ(errorOf([](nlohmann::json&) {}), "");
  for (const auto& [name, value] : good.items()) {
    const std::string field = name;
    EXPECT_NE(errorOf([&](nlohmann::json& json) { json.erase(field); }), "") << name;
  }
  for (const auto& [name, value] : good["cameras"][0].items()) {
    const std::string field = name;
    EXPECT_NE(errorOf([&](nlohmann::json& json) { json["cameras"][0].erase(field); }), "") << name;
  }
  EXPECT_THAT(errorOf([](nlohmann::json& json) { json["cameras"][0]["Depth"] = 1; }), HasSubstr("Depth"));
  EXPECT_THAT(errorOf([](nlohmann::json& json) {
                json["cameras"][0]["Depth_range"] = {4, 4};
              }),
              HasSubstr("Depth_range"));
  EXPECT_THAT(errorOf([](nlohmann::json& json) { json["cameras"][0]["Resolution"] = {16, 10}; }), HasSubstr("16x10"));
  folder.write("v00_depth_16x8_yuv420p16le.yuv", "short");
  EXPECT_THAT(readingError(folder / "Test.json"), HasSubstr("it has 5 bytes"));
}

TEST(MivSequence, aFullDiskIsAnErrorAndLeavesNoSequence) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "v01_texture_16x8_yuv420p10le.yuv");
  EXPECT_THROW(writeMivSequence(folder.path(), sequence()), WorkError);
  EXPECT_FALSE(std::filesystem::exists(folder / "Test.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "v00_texture_16x8_yuv420p10le.yuv"));
}

TEST(MivSequence, progressIsTold) {
  const TemporaryFolder folder;
  std::vector<double> told;
  writeMivSequence(folder.path(), sequence(), [&](std::string_view, double fraction) { told.push_back(fraction); });
  EXPECT_EQ(told, (std::vector<double>{0, 0.5}));
}

}  // namespace
}  // namespace ocelli
