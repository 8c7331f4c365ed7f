#include "oc_core/depth_views/views_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_document.h"
#include "oc_core/depth_views/views_fields.h"
#include "tests/base/schema_agreement.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

nlohmann::json oneView() {
  return nlohmann::json::parse(
      R"({"format": 1, "views": [{"color": "a.png", "depth": "a_depth.png", "near": 1, "far": 20,
    "view": {"eye": [0, 0, 10], "fov_vertical_degrees": 12}}]})");
}

std::string errorOf(const std::string& text) {
  try {
    viewsFromJsonText(text, "views.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string errorOf(const nlohmann::json& json) {
  return errorOf(json.dump(1));
}

TEST(ViewsFile, theSchemaIsThatOfTheRows) {
  const std::string text = viewsSchemaText();
  if (readFile(OCELLI_VIEWS_SCHEMA) != text) {
    const auto path = std::filesystem::temp_directory_path() / "views.schema.json";
    writeFile(path, text);
    FAIL() << "oc_core/depth_views/views.schema.json is not what the rows say: " << path << " is";
  }
}

TEST(ViewsFile, theSchemaSaysWhatTheReaderTakes) {
  test::SchemaAgreement{readJsonFile(OCELLI_VIEWS_SCHEMA), [](const std::string& text) { return errorOf(text); },
                        oneView()}
      .check();
}

TEST(ViewsFile, theSchemaSaysWhatTheReaderTakesOfAView) {
  test::SchemaAgreement{readJsonFile(OCELLI_VIEWS_SCHEMA).at("properties").at("views").at("items"),
                        [](const std::string& text) {
                          nlohmann::json file = oneView();
                          file["views"][0] = nlohmann::json::parse(text);
                          // So that "near" and "far" of the view may be anything.
                          nlohmann::json& view = file["views"][0];
                          if (view.contains("near") && view["near"].is_number() && view["near"] != 1) {
                            view["far"] = std::min(1e6, std::max(1e6, view["near"].get<double>()));
                            if (view["near"] == 1e6) {
                              return std::string();
                            }
                          }
                          if (view.contains("far") && view["far"].is_number() && view["far"] == 1e-6) {
                            return std::string();
                          }
                          return errorOf(file);
                        },
                        oneView()["views"][0]}
      .check();
}

TEST(ViewsFile, whatIsWrittenIsReadBack) {
  View view;
  view.eye = {1, 2, 9};
  view.fovVerticalDegrees = 33;
  const std::vector<ListedView> views{{"left", "l.png", "l_depth.png", view, {&depthScales()[1], 2, 30}},
                                      {"right", "r.png", "r_depth.png", View{}, {&depthScales()[1], 3, 40}}};
  const std::vector<ListedView> back = viewsFromJsonText(viewsJsonText(views), "views.json");
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name, "left");
  EXPECT_EQ(back[0].view, view);
  EXPECT_EQ(back[1].depthFile, "r_depth.png");
  EXPECT_EQ(back[1].levels.scale, &depthScales()[1]);
  EXPECT_EQ(back[1].levels.near, 3);
  EXPECT_EQ(back[1].levels.far, 40);
}

TEST(ViewsFile, namesAndRangesHaveDefaults) {
  nlohmann::json json = oneView();
  json["near"] = 2;
  json["far"] = 50;
  json["views"][0].erase("near");
  json["views"][0].erase("far");
  const std::vector<ListedView> views = viewsFromJsonText(json.dump(), "views.json");
  EXPECT_EQ(views[0].name, "a");
  EXPECT_EQ(views[0].levels.near, 2);
  EXPECT_EQ(views[0].levels.far, 50);
  EXPECT_EQ(views[0].levels.scale, &depthScales()[0]);
}

TEST(ViewsFile, filesLieInTheFolder) {
  for (const char* file : {"../a.png", "/etc/a.png", "sub/a.png", "..", ".", ""}) {
    nlohmann::json json = oneView();
    json["views"][0]["color"] = file;
    EXPECT_THAT(errorOf(json), HasSubstr("\"color\"")) << file;
  }
}

TEST(ViewsFile, mistakesAreNamed) {
  nlohmann::json json = oneView();
  json["views"][0]["near"] = 20;
  EXPECT_THAT(errorOf(json), HasSubstr("\"near\" must be less than \"far\""));
  json = oneView();
  json["views"][0].erase("far");
  EXPECT_THAT(errorOf(json), HasSubstr("\"far\""));
  json = oneView();
  json["views"].push_back(json["views"][0]);
  EXPECT_THAT(errorOf(json), HasSubstr("an earlier view"));
  json = oneView();
  json["views"][0]["view"]["target"] = {0, 0, 10};
  EXPECT_THAT(errorOf(json), HasSubstr("the eye of the view is at its target"));
  json = oneView();
  json["views"][0]["pose"] = 1;
  EXPECT_THAT(errorOf(json), HasSubstr("pose"));
  json = oneView();
  json["views"][0].erase("view");
  EXPECT_THAT(errorOf(json), HasSubstr("\"view\""));
  EXPECT_THAT(errorOf(std::string(R"({"format": 1, "views": []})")), HasSubstr("\"views\""));
  EXPECT_NE(errorOf(std::string("{")), "");
  EXPECT_NE(errorOf(std::string("[]")), "");
}

}  // namespace
}  // namespace ocelli
