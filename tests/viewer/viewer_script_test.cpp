#include "display_sim/viewer/viewer_script.h"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

std::string errorOf(const std::string& text) {
  try {
    viewerScriptFromJsonText(text, "script");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The error of a script with this step alone.
std::string errorOfStep(const std::string& step) {
  return errorOf(R"({"steps": [)" + step + "]}");
}

ScriptStep stepOf(const std::string& step) {
  return viewerScriptFromJsonText(R"({"steps": [)" + step + "]}", "script").steps.at(0);
}

TEST(ViewerScript, readsSizeAndScale) {
  const ViewerScript script = viewerScriptFromJsonText(R"({"size": [2560, 1600], "scale": 2, "steps": []})", "script");
  EXPECT_EQ(script.width, 2560);
  EXPECT_EQ(script.height, 1600);
  EXPECT_EQ(script.scale, 2);
  EXPECT_EQ(viewerScriptFromJsonText(R"({"steps": []})", "script").width, 1280);
}

TEST(ViewerScript, readsEveryStep) {
  EXPECT_EQ(std::get<OpenStep>(stepOf(R"({"open": "builtin:fence"})")).source, "builtin:fence");
  EXPECT_EQ(std::get<CameraStep>(stepOf(R"({"camera": "cell"})")).camera, "cell");
  EXPECT_EQ(std::get<DropStep>(stepOf(R"({"drop": "a.ply"})")).file, "a.ply");
  EXPECT_EQ(std::get<TypeStep>(stepOf(R"({"text": "é"})")).text, "é");
  EXPECT_EQ(std::get<MoveStep>(stepOf(R"({"move": [3, 4.5]})")).to, glm::dvec2(3, 4.5));
  EXPECT_EQ(std::get<ClickStep>(stepOf(R"({"click": {"at": [3, 4]}})")).button, PointerButton::kLeft);
  const auto drag = std::get<DragStep>(stepOf(R"({"drag": {"from": [1, 2], "to": [3, 4], "button": "right"}})"));
  EXPECT_EQ(drag.from, glm::dvec2(1, 2));
  EXPECT_EQ(drag.to, glm::dvec2(3, 4));
  EXPECT_EQ(drag.button, PointerButton::kRight);
  EXPECT_EQ(std::get<ScrollStep>(stepOf(R"({"scroll": {"at": [1, 2], "up": -3}})")).up, -3);
  EXPECT_EQ(std::get<ResizeStep>(stepOf(R"({"resize": {"size": [100, 90], "scale": 1.5}})")).scale, 1.5);
  EXPECT_TRUE(std::holds_alternative<WaitStep>(stepOf(R"({"wait": "idle"})")));
  EXPECT_EQ(std::get<SecondsStep>(stepOf(R"({"seconds": 0.5})")).seconds, 0.5);
  EXPECT_EQ(std::get<SaveStep>(stepOf(R"({"save": "a.png"})")).file, "a.png");
  EXPECT_EQ(std::get<SaveEffectStep>(stepOf(R"({"save_effect": "a.png"})")).file, "a.png");
  const auto effect = std::get<EffectStep>(stepOf(R"({"effect": {"name": "reflection", "by": "cell"}})"));
  EXPECT_EQ(effect.name, "reflection");
  EXPECT_EQ(effect.way, "cell");
  EXPECT_EQ(std::get<EffectStep>(stepOf(R"({"effect": {"name": "reflection"}})")).way, "");
  EXPECT_EQ(std::get<TransferStep>(stepOf(R"({"transfer": "ct-bone"})")).nameOrFile, "ct-bone");
  EXPECT_EQ(std::get<IsoStep>(stepOf(R"({"iso": -300.5})")).value, -300.5);
  EXPECT_EQ(std::get<IsoStep>(stepOf(R"({"iso": null})")).value, std::nullopt);
  EXPECT_EQ(std::get<SaveVolumePictureStep>(stepOf(R"({"save_volume": "a.png"})")).file, "a.png");
  EXPECT_EQ(std::get<SaveTransferStep>(stepOf(R"({"save_transfer": "a.json"})")).file, "a.json");
  for (const EffectShown::Content content : kEffectContents) {
    const std::string step = R"({"show": ")" + std::string(nameOf(content)) + R"("})";
    EXPECT_EQ(std::get<ShowStep>(stepOf(step)).content, content);
  }
}

TEST(ViewerScript, keysTakeModifiers) {
  const auto key = std::get<KeyStep>(stepOf(R"({"key": "Shift+Ctrl+PageUp"})"));
  EXPECT_EQ(key.key, Key::kPageUp);
  EXPECT_TRUE(key.modifiers.shift && key.modifiers.control);
  EXPECT_FALSE(key.modifiers.alt);
  EXPECT_FALSE(std::get<KeyStep>(stepOf(R"({"key": "H"})")).modifiers.shift);
}

TEST(ViewerScript, saysWhichStepIsWrongAndWhy) {
  EXPECT_THAT(errorOf(R"({"steps": [{"key": "H"}, {"kay": "H"}]})"), HasSubstr("step 2"));
  EXPECT_THAT(errorOfStep(R"({"kay": "H"})"), HasSubstr("\"kay\" is unknown"));
  EXPECT_THAT(errorOfStep(R"({"key": "Hyper"})"), HasSubstr("\"Hyper\""));
  EXPECT_THAT(errorOfStep(R"({"drag": {"from": [1, 2]}})"), HasSubstr("\"to\" is missing"));
  EXPECT_THAT(errorOfStep(R"({"drag": {"from": [1, 2], "to": [1, 2], "speed": 3}})"),
              HasSubstr("\"speed\" is unknown"));
}

TEST(ViewerScript, refusesHostileValues) {
  for (const char* step : {R"({})",
                           R"([])",
                           R"("H")",
                           R"(null)",
                           R"({"key": "H", "text": "a"})",
                           R"({"key": ""})",
                           R"({"key": "Shift+"})",
                           R"({"key": 5})",
                           R"({"open": ""})",
                           R"({"open": 1})",
                           R"({"move": [1]})",
                           R"({"move": [1, 2, 3]})",
                           R"({"move": [-1, 2]})",
                           R"({"move": [1, 1e300]})",
                           R"({"move": ["a", "b"]})",
                           R"({"seconds": -1})",
                           R"({"seconds": 1e9})",
                           R"({"seconds": null})",
                           R"({"wait": "forever"})",
                           R"({"save": "image.jpg"})",
                           R"({"save": ""})",
                           R"({"save_effect": "image.jpg"})",
                           R"({"effect": "reflection"})",
                           R"({"effect": {"by": "cell"}})",
                           R"({"effect": {"name": ""}})",
                           R"({"effect": {"name": "reflection", "by": ""}})",
                           R"({"effect": {"name": "reflection", "with": "cell"}})",
                           R"({"show": "by"})",
                           R"({"show": 1})",
                           R"({"transfer": ""})",
                           R"({"iso": "high"})",
                           R"({"iso": 1e300})",
                           R"({"save_volume": "a.json"})",
                           R"({"save_transfer": "a.png"})",
                           R"({"drag": 3})",
                           R"({"scroll": {"at": [1, 2], "up": 1e9}})",
                           R"({"scroll": {"up": 1}})",
                           R"({"click": {"at": [1, 2], "button": "none"}})",
                           R"({"resize": {"size": [100.5, 100]}})",
                           R"({"resize": {"size": [1, 1]}})",
                           R"({"resize": {"size": [100000, 100]}})"}) {
    EXPECT_NE(errorOfStep(step), "") << step;
  }
  for (const char* script :
       {"", "[]", "{}", R"({"steps": {}})", R"({"steps": [], "more": 1})", R"({"steps": [], "size": [0, 0]})",
        R"({"steps": [], "size": [1e10, 100]})", R"({"steps": [], "scale": 0})", R"({"steps": [], "scale": 100})"}) {
    EXPECT_NE(errorOf(script), "") << script;
  }
}

TEST(ViewerScript, theSchemaNamesTheStepsThatAreRead) {
  const std::string message = errorOfStep(R"({"no_such_step": 1})");
  std::istringstream list(message.substr(message.find("use one of: ") + 12));
  std::set<std::string> known;
  for (std::string name; list >> name;) {
    known.insert(name.substr(0, name.find(',')));
  }
  const nlohmann::json schema = readJsonFile(OCELLI_VIEWER_SCRIPT_SCHEMA);
  std::set<std::string> described;
  for (const auto& [name, property] : schema.at("$defs").at("step").at("properties").items()) {
    described.insert(name);
  }
  EXPECT_EQ(described, known);
}

/// What $ref stands for, with what stands beside it.
nlohmann::json resolved(const nlohmann::json& schema, const nlohmann::json& property) {
  if (!property.contains("$ref")) {
    return property;
  }
  return schema.at(nlohmann::json::json_pointer(property.at("$ref").get<std::string>().substr(1)));
}

TEST(ViewerScript, theSchemaHasTheLimitsThatAreRead) {
  const nlohmann::json schema = readJsonFile(OCELLI_VIEWER_SCRIPT_SCHEMA);
  const nlohmann::json& steps = schema.at("$defs").at("step").at("properties");
  const auto expectRange = [](const nlohmann::json& numbers, const auto& document) {
    EXPECT_EQ(errorOf(document(numbers.at("minimum"))), "");
    EXPECT_EQ(errorOf(document(numbers.at("maximum"))), "");
    const double least = numbers.at("minimum");
    const double most = numbers.at("maximum");
    EXPECT_NE(errorOf(document(least - 1)), "");
    EXPECT_NE(errorOf(document(most + 1)), "");
  };
  using Json = nlohmann::json;
  const auto stepWith = [](const std::string& name, const Json& value) {
    return Json{{"steps", Json::array({Json{{name, value}}})}}.dump();
  };
  expectRange(schema.at("$defs").at("place").at("items"), [&](const Json& number) {
    return stepWith("move", Json::array({number, 5}));
  });
  expectRange(schema.at("$defs").at("size").at("items"), [](const Json& number) {
    return Json{{"steps", Json::array()}, {"size", {number, 100}}}.dump();
  });
  expectRange(resolved(schema, schema.at("properties").at("scale")), [](const Json& number) {
    return Json{{"steps", Json::array()}, {"scale", number}}.dump();
  });
  expectRange(steps.at("seconds"), [&](const Json& number) { return stepWith("seconds", number); });
  expectRange(steps.at("scroll").at("properties").at("up"), [&](const Json& number) {
    return stepWith("scroll", Json{{"at", {1, 2}}, {"up", number}});
  });
}

TEST(ViewerScript, theSchemaNamesWhatTheEffectPaneShows) {
  const nlohmann::json schema = readJsonFile(OCELLI_VIEWER_SCRIPT_SCHEMA);
  std::vector<std::string> names;
  for (const EffectShown::Content content : kEffectContents) {
    names.emplace_back(nameOf(content));
  }
  EXPECT_EQ(schema.at("$defs").at("step").at("properties").at("show").at("enum").get<std::vector<std::string>>(),
            names);
}

TEST(ViewerScript, theTourIsOne) {
  const ViewerScript tour = readViewerScript(OCELLI_VIEWER_TOUR);
  const auto saves = std::count_if(tour.steps.begin(), tour.steps.end(),
                                   [](const ScriptStep& step) { return std::holds_alternative<SaveStep>(step); });
  EXPECT_GE(saves, 10);
}

TEST(ViewerScript, theOneWithLensesSavesThemAndTheirPicture) {
  const ViewerScript lenses = readViewerScript(OCELLI_VIEWER_LENSES);
  size_t taken = 0;
  for (const ScriptStep& step : lenses.steps) {
    taken |= std::holds_alternative<DragStep>(step) ? 1 : 0;
    taken |= std::holds_alternative<SaveLensPictureStep>(step) ? 2 : 0;
    taken |= std::holds_alternative<SaveCameraStep>(step) ? 4 : 0;
  }
  EXPECT_EQ(taken, 7U);
}

TEST(ViewerScript, theOneThroughEffectsTakesEachStepOfThem) {
  const ViewerScript effects = readViewerScript(OCELLI_VIEWER_EFFECTS);
  size_t taken = 0;
  for (const ScriptStep& step : effects.steps) {
    taken |= std::holds_alternative<EffectStep>(step) ? 1 : 0;
    taken |= std::holds_alternative<ShowStep>(step) ? 2 : 0;
    taken |= std::holds_alternative<SaveEffectStep>(step) ? 4 : 0;
  }
  EXPECT_EQ(taken, 7U);
}

TEST(ViewerScript, theOneWithAVolumeTakesEachStepOfThem) {
  const ViewerScript volume = readViewerScript(OCELLI_VIEWER_VOLUME);
  size_t taken = 0;
  for (const ScriptStep& step : volume.steps) {
    taken |= std::holds_alternative<TransferStep>(step) ? 1 : 0;
    taken |= std::holds_alternative<SaveVolumePictureStep>(step) ? 2 : 0;
    taken |= std::holds_alternative<SaveTransferStep>(step) ? 4 : 0;
  }
  EXPECT_EQ(taken, 7U);
}

TEST(ViewerScript, aMissingFileIsAnError) {
  EXPECT_THROW(readViewerScript("no-such-script.json"), InputError);
}

}  // namespace
}  // namespace ocelli
