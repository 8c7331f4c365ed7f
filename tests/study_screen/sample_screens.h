// A screen of each kind, as a session shows them, for tests of what draws them.
#pragma once

#include <map>
#include <memory>

#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/worlds/maze_file.h"
#include "study/outline/questionnaire.h"
#include "study/session/session_pages.h"
#include "study/session/session_screen.h"
#include "tests/study_outline/question_examples.h"

namespace ocelli::test {

/// A crossing with an orange sphere and a blue cube in sight of who comes in from the south.
inline Maze sampleMaze() {
  return mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   | |   |",
    "+ +-+ +-+ +",
    "|         |",
    "+ +-+ +-+ +",
    "|   | |   |",
    "+-+-+ +-+-+"],
    "landmarks": [
      {"row": 1, "column": 2, "shape": "sphere", "color": "orange", "east": -0.2, "south": 0},
      {"row": 0, "column": 2, "shape": "cube", "color": "blue", "east": 0.1, "south": 0}]})",
                          "sample");
}

inline PinholeCamera sampleEye(const Maze& maze, int width, int height) {
  View view;
  view.eye = maze.centerOf({2, 2}) + glm::vec3(0, 1.6f, 1);
  view.target = view.eye + glm::vec3(0, 0, -1);
  view.fovVerticalDegrees = 55;
  view.zNear = 0.05f;
  view.zFar = 100;
  return {view, width, height};
}

inline GraphCamera sampleGraphCamera(const Maze& maze, int width, int height) {
  SceneGuides guides;
  guides.maze = maze;
  PortalOptions options = portalCurve("band");
  options.bentBeyond = 1;
  return buildPortalCamera(options, guides, sampleEye(maze, width, height));
}

/// The parts that screens point at.
struct SampleStudy {
  StudyScene scene{sampleMaze()};
  ProtocolForm form{
      "demographics",
      "About you",
      "Your answers are kept under your number alone.",
      {{"age_band", "How old are you?", {"18-24", "25-34", "35-44", "45-54", "55 or older"}, {}},
       {"experience",
        "How much experience do you have with walking through 3D scenes, such as games?",
        {"1", "2", "3", "4", "5"},
        {"none", "very much"}},
       {"vision", "Is your vision normal, if need be with glasses or lenses?", {"yes", "no"}, {}},
       {"colors", "Can you tell colours apart?", {"yes", "not all of them", "I would rather not say"}, {}},
       {"hand", "Which hand holds the mouse?", {"right", "left"}, {}}}};
  std::map<std::string, std::vector<ProtocolForm>> questionnaires;  ///< by language
  ProtocolForm kinds{"kinds", "Questions of all kinds", "", {}};
  std::vector<std::string> consent;

  SampleStudy() {
    for (const SubjectCatalogue& language : subjectCatalogues()) {
      for (const std::string& name : questionnaireNames()) {
        questionnaires[language.language].push_back(findQuestionnaire(name, language.language)->form);
      }
    }
    for (const std::string& example : questionExamples()) {
      kinds.fields.push_back(questionExample(example));
    }
    for (int i = 1; i <= 7; ++i) {
      consent.push_back(
          "You are invited to take part in a study of how people find their way in scenes on a screen. You will walk "
          "through mazes, count objects and tell paths apart. It takes about forty minutes, with breaks. You may stop "
          "at any time, without giving a reason and without any disadvantage.");
    }
  }

  PixelRect stage(const TrialScreen& screen) const {
    const double top = promptHeight(screen);
    return {0, top, static_cast<double>(screen.width), screen.height - top};
  }

  PageScreen instructions(const std::string& image) const {
    return {"Find the object",
            {"An object is hidden in a maze. Walk until you see it, then click on it.",
             "In this part the view bends around corners: at each side corridor you see what lies in it.",
             "You have 60 seconds. Be as quick as you can."},
            image,
            {},
            {},
            0,
            "Enter: begin practice"};
  }
  ConsentScreen consentScreen() const { return {{"Consent to take part", consent}}; }
  FormScreen formScreen(bool missing) const {
    const std::vector<QuestionEntry> entries{{{1}}, {{3}}, {}, {}, {{0}}};
    return {&form, itemsOf(form.fields), entries, missing ? 2 : 1, missing};
  }
  /// Questions of all kinds, half of them filled in.
  FormScreen kindsScreen(bool missing, int focus) const {
    FormScreen screen{&kinds, itemsOf(kinds.fields), {}, focus, missing};
    Random random(5);
    for (size_t i = 0; i < screen.items.size(); ++i) {
      const FormField& field = screen.fieldOf(i);
      screen.entries.push_back(i % 2 == 0 ? questionKind(field.kind).atRandom(field, random) : QuestionEntry());
    }
    screen.entries[5].typed = "7777";  // more than it may be
    return screen;
  }
  PageScreen feedback(bool good) const {
    return {good ? "Right" : "Not right",
            {good ? "You found the object in 8.4 seconds." : "You counted 5 objects. There were 6."},
            {},
            good,
            {},
            0,
            "Enter: go on"};
  }
  PageScreen rest(double wait) const {
    return {"Time for a break",
            {"Look away from the screen for a while and rest your eyes."},
            {},
            {},
            SessionProgress{31, 86, 1, 5},
            wait,
            "Enter: go on"};
  }
  PageScreen end() const {
    return {"Thank you", {"You have done all of this session.", "Please tell the experimenter."}, {}, {}, {}, 0, ""};
  }
  PageScreen unwell() const {
    return {"Do you feel unwell?",
            {"You may stop at any time, without giving a reason."},
            {},
            {},
            {},
            0,
            "Enter: end the session    Escape: go on with it"};
  }
  PageScreen call() const {
    return {"Please call the experimenter",
            {"You have done all trials of the practice."},
            {},
            {},
            {},
            0,
            "Experimenter: Enter goes on with the trials"};
  }
  PauseScreen pause() const { return {"The experimenter will be with you in a moment. Your data are safe."}; }
  TrialScreenView finding(const TrialScreen& screen, TrialView view, bool patch = false) const {
    TrialScreenView trial;
    trial.layout.scene = &scene;
    const PixelRect place = stage(screen);
    const int width = static_cast<int>(place.width);
    const int height = static_cast<int>(place.height);
    if (view == TrialView::kOther) {
      trial.layout.views.emplace_back(place, sampleGraphCamera(scene.maze(), width, height));
    } else {
      trial.layout.views.emplace_back(place, sampleEye(scene.maze(), width, height));
    }
    trial.layout.prompt = "Find this object and click on it";
    trial.layout.targetObject = 0;
    trial.layout.pointer = place.center() + glm::dvec2(40, -30);
    trial.showsPatch = patch;
    trial.patchWhite = patch;
    return trial;
  }
  TrialScreenView counting(const TrialScreen& screen) const {
    TrialScreenView trial;
    trial.layout.prompt = "How many objects did you see?";
    const PixelRect place = stage(screen);
    for (int i = 0; i < 7; ++i) {
      const double side = std::floor(place.width / 14);
      trial.layout.choices.push_back({{place.left + side * (1.5 + 1.6 * i), place.center().y - side / 2, side, side},
                                      std::to_string(i + 2),
                                      static_cast<Key>(static_cast<int>(Key::k2) + i),
                                      i == 3});
    }
    trial.layout.pointer = place.center() + glm::dvec2(0, 80);
    return trial;
  }
  TrialScreenView matching(const TrialScreen& screen) const {
    TrialScreenView trial;
    trial.layout.prompt = "Which of these paths did you walk?";
    const PixelRect place = stage(screen);
    const double side = std::floor(place.width / 4);
    for (int i = 0; i < 3; ++i) {
      const PixelRect map{place.left + side * (0.25 + 1.25 * i), place.top + place.height * 0.2, side, side};
      const double turn = i < 2 ? 3 : -3;
      const double turned = i == 0 ? -1 : 1;
      trial.layout.maps.push_back(
          {map, {{0, 9}, {0, 3}, {6 * turned, 3}, {6 * turned, 3 + turn}, {9 * turned, 3 + turn}, {9 * turned, 12}}});
      trial.layout.choices.push_back(
          {map, std::to_string(i + 1), static_cast<Key>(static_cast<int>(Key::k1) + i), i == 1});
    }
    return trial;
  }

  /// Right after 8 seconds, or out of time.
  static TrialOutcome outcome(bool right) {
    TrialOutcome of;
    of.correct = right;
    of.censored = !right;
    of.responseTicks = 8 * kTicksPerSecond;
    return of;
  }
  /// What a session says by itself, in a language; with the questionnaires.
  std::vector<std::pair<std::string, SessionScreen>> ofLanguage(const SubjectTexts& texts,
                                                                const TrialScreen& screen) const {
    const SessionProgress progress{31, 86, 1, 5};
    const std::string language = texts.catalogue().language;
    std::vector<std::pair<std::string, SessionScreen>> screens{
        {"ready", readyPage(texts, texts.say("trial", {{"number", "12"}, {"total", "86"}}), texts.say("prompt_count"),
                            progress)},
        {"right", feedbackPage(texts, outcome(true))},
        {"wrong", feedbackPage(texts, outcome(false))},
        {"break_wait", breakPage(texts, progress, 38.2)},
        {"break", breakPage(texts, progress, 0)},
        {"call", callPage(texts, SubjectKind::kPerson)},
        {"unwell", unwellPage(texts)},
        {"end", lastPage(texts, texts.say("stopped"), {texts.say("stopped_storing"), texts.say("call_experimenter")})},
        {"declined", lastPage(texts, texts.say("thanks"), {texts.say("declined"), texts.say("call_experimenter")})},
        {"pause", PauseScreen{texts.say("paused_keyboard")}},
        {"form", formScreen(true)},
        {"kinds", kindsScreen(true, 2)},
        {"consent", consentScreen()}};
    for (const ProtocolForm& each : questionnaires.at(language)) {
      FormScreen asked{&each, itemsOf(each.fields), {}, 1, true};
      asked.entries.resize(asked.items.size());
      screens.emplace_back(each.name, asked);
    }
    TrialScreenView find = finding(screen, TrialView::kReference);
    find.layout.prompt = texts.say("prompt_find");
    screens.emplace_back("find", find);
    TrialScreenView path = matching(screen);
    path.layout.prompt = texts.say("prompt_which_path");
    screens.emplace_back("path", path);
    for (const char* image : {"path_maps", "controls"}) {
      PageScreen page = instructions(image);
      page.title = texts.say("prompt_find");
      page.paragraphs = {texts.say("prompt_find"), texts.say("unwell_may_stop")};
      page.action = "Enter: " + texts.say("begin");
      screens.emplace_back(std::string("page_") + image, page);
    }
    return screens;
  }

  std::vector<std::pair<std::string, SessionScreen>> all(const TrialScreen& screen) const {
    std::vector<std::pair<std::string, SessionScreen>> screens{
        {"consent", consentScreen()},
        {"form", formScreen(false)},
        {"form_missing", formScreen(true)},
        {"kinds", kindsScreen(false, 2)},
        {"kinds_missing", kindsScreen(true, 5)},
        {"kinds_end", kindsScreen(true, 9)},
        {"text", PageScreen{"Welcome", {consent[0], consent[1], consent[2]}, {}, {}, {}, 0, "Enter: go on"}},
        {"right", feedback(true)},
        {"wrong", feedback(false)},
        {"break_wait", rest(38.2)},
        {"break", rest(0)},
        {"end", end()},
        {"unwell", unwell()},
        {"call", call()},
        {"pause", pause()},
        {"find_ppc", finding(screen, TrialView::kReference)},
        {"find_gc", finding(screen, TrialView::kOther, true)},
        {"total", counting(screen)},
        {"path", matching(screen)}};
    for (const char* image : {"find_ppc", "find_gc", "count_ppc", "count_gc", "path_maps", "controls"}) {
      screens.emplace_back(std::string("page_") + image, instructions(image));
    }
    return screens;
  }
};

}  // namespace ocelli::test
