#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/explore/explore_shown_camera.h"
#include "oc_core/explore/explore_steps.h"

namespace ocelli {
namespace {

constexpr double kMaxPixel = 32768;
constexpr size_t kMaxText = 4096;

std::string readFileName(JsonFields& fields, const std::string& name, const std::vector<std::string>& endings) {
  const std::string file = fields.shortText(name, kMaxText);
  std::string known;
  for (const std::string& ending : endings) {
    if (file.ends_with(ending)) {
      return file;
    }
    known += (known.empty() ? "" : " or ") + ending;
  }
  fields.fail(name, "must be a file that ends in " + known);
}

ExploreStep readChoose(JsonFields& fields) {
  std::vector<std::string> names;
  for (const LiveConstructorRow& row : liveConstructors()) {
    names.emplace_back(row.name);
  }
  const std::string name = fields.choice("choose", names);
  return [=](ExploreSession& session) {
    session.explorer().choose(name);
    session.showFrame({});
  };
}

ExploreStep readPick(JsonFields& fields) {
  const std::vector<double> pixel = fields.numbers("pick", 2, 0, kMaxPixel);
  return [=](ExploreSession& session) {
    Explorer& explorer = session.explorer();
    if (!explorer.pick(glm::dvec2(pixel[0], pixel[1]))) {
      const char* means = explorer.chosen().clickMeans;
      throw InputError("there is nothing to pick at that pixel", "",
                       *means == '\0' ? "choose a constructor that takes clicks" : std::string("click ") + means);
    }
    session.showFrame({});
  };
}

ExploreStep readOption(JsonFields& fields) {
  JsonFields inner = fields.inner("option");
  const std::string name = inner.shortText("name", kMaxText);
  const double value = inner.number("value", -1e9, 1e9);
  inner.rejectUnknown();
  return [=](ExploreSession& session) {
    session.explorer().setOption(name, value);
    session.showFrame({});
  };
}

ExploreStep readCamera(JsonFields& fields) {
  const std::string camera = fields.shortText("camera", kMaxText);
  return [=](ExploreSession& session) {
    const auto& named = cameraConstructors();
    const bool isName = std::ranges::any_of(named, [&](const CameraConstructor& each) { return camera == each.name; });
    showCamera(session.explorer(), isName ? camera : (session.scriptFolder / camera).string());
    session.showFrame({});
  };
}

ExploreStep readSave(JsonFields& fields) {
  const std::string file = readFileName(fields, "save", {".png"});
  return [=](ExploreSession& session) {
    const std::filesystem::path path = session.pathOf(file);
    writePng(path, session.picture());
    session.wrote(path);
  };
}

ExploreStep readSaveCamera(JsonFields& fields) {
  const std::string file = readFileName(fields, "save_camera", {".json"});
  return [=](ExploreSession& session) {
    const std::filesystem::path path = session.pathOf(file);
    writeFile(path, std::visit([](const auto& camera) { return jsonText(camera); }, session.explorer().frame().camera));
    session.wrote(path);
  };
}

ExploreStep readRecord(JsonFields& fields) {
  const std::string file = readFileName(fields, "record", {".mp4", ".webm"});
  return [=](ExploreSession& session) { session.startRecording(session.pathOf(file)); };
}

ExploreStep readStopRecording(JsonFields& fields) {
  const bool stop = fields.boolean("stop_recording", true);
  return [=](ExploreSession& session) {
    if (stop) {
      session.stopRecording();
    }
  };
}

ExploreStep readExpect(JsonFields& fields) {
  const std::string text = fields.shortText("expect", kMaxText);
  return [=](ExploreSession& session) {
    std::string notes;
    for (const ExploreNote& note : session.explorer().frame().notes) {
      if (note.text.find(text) != std::string::npos) {
        return;
      }
      notes += (notes.empty() ? "" : "; ") + note.text;
    }
    throw InputError(fmt::format("the state \"{}\" is expected, and is: {}", text, notes.empty() ? "none" : notes), "",
                     "change what is expected, or what was done before");
  };
}

}  // namespace

std::vector<ExploreStepKind> exploreChoiceSteps() {
  return {
      {"choose", "a constructor of cameras", readChoose},
      {"pick", "a pixel of the image that is clicked", readPick},
      {"option", "an option of the constructor, and its value", readOption},
      {"camera", "a camera's name, or a JSON file beside the script, shown as it is", readCamera},
      {"save", "an image of what is seen", readSave},
      {"save_camera", "the camera of this moment, as --camera takes it", readSaveCamera},
      {"record", "from here on every frame goes to a video", readRecord},
      {"stop_recording", "ends that video", readStopRecording},
      {"expect", "words of a state that must hold; otherwise the script fails", readExpect},
  };
}

}  // namespace ocelli
