#include "study/screen/run_environment.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ocelli {
namespace {

TEST(RunEnvironment, tellsWhatARunWasMadeWith) {
  RunEnvironment environment;
  environment.programVersion = "9.8.7";
  environment.graphics.renderer = "a \"GPU\" \xff";
  environment.monitor = {"DELL U2412M", 1920, 1200, 60, 0, 0, 518, 324};
  environment.monitorNumber = 1;
  environment.windowWidth = 1920;
  environment.windowHeight = 1200;
  const auto json = nlohmann::json::parse(jsonText(environment));
  EXPECT_EQ(json.at("program_version"), "9.8.7");
  EXPECT_FALSE(json.at("kernel").get<std::string>().empty());
  EXPECT_EQ(json.at("monitor").at("name"), "DELL U2412M");
  EXPECT_EQ(json.at("monitor").at("refresh_hertz"), 60);
  EXPECT_EQ(json.at("window").at("width"), 1920);
  EXPECT_FALSE(json.at("input_times").get<std::string>().empty());
  EXPECT_FALSE(json.at("not_measured").empty());
  EXPECT_TRUE(json.at("paced_hertz").is_null());
}

TEST(RunEnvironment, saysHowFramesAreTimed) {
  RunEnvironment environment;
  const std::string waiting = nlohmann::json::parse(jsonText(environment)).at("frame_times");
  environment.pacedHertz = 60;
  const auto paced = nlohmann::json::parse(jsonText(environment));
  EXPECT_EQ(paced.at("paced_hertz"), 60);
  EXPECT_NE(paced.at("frame_times"), waiting);
  EXPECT_TRUE(paced.at("monitor").at("refresh_hertz").is_null()) << "a monitor that does not say";
}

}  // namespace
}  // namespace ocelli
