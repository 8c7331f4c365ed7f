// A script that someone's walk is read from: what a person would do, and pictures in between.
//
//   {"size": [1280, 720], "steps": [{"choose": "portal"}, {"walk": {"forward": 4}}, {"save": "door.png"}]}
//
// explore_script.schema.json lists every step. Time is the script's own, 30 frames a second, so the same script gives
// the same pictures.
//
// A step is a row of a table: its name, and a function that reads it and gives what it does. Some (keys, clicks) need a
// window.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/base/registry.h"
#include "oc_core/explore/explorer.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

class JsonFields;

inline constexpr double kExploreFramesPerSecond = 30;

/// Where the files of a script go.
struct ExploreFiles {
  std::filesystem::path folder = ".";
  std::function<void(const std::filesystem::path& path)> wrote{};  ///< told of each; may be empty
};

/// What a script is played to.
class ExploreSession {
 public:
  explicit ExploreSession(ExploreFiles files = {}) : files_(std::move(files)) {}
  virtual ~ExploreSession() = default;

  /// Of the script that is played: what its steps read is named from there.
  std::filesystem::path scriptFolder{};

  virtual Explorer& explorer() = 0;
  /// One frame: time passes by 1 / kExploreFramesPerSecond, and the picture is shown, and recorded where that is on.
  virtual void showFrame(const WalkInput& input) = 0;
  /// What a person does with keys and the pointer; frames that show it follow. Throws InputError where there is no
  /// window.
  virtual void give(const InputEvent& event);
  /// What a person sees now, without time passing.
  virtual Image<Rgb8> picture() = 0;
  /// A file that the script names, in the folder that the user gave; its folder is made.
  std::filesystem::path pathOf(const std::string& file) const;
  /// Told of each file that was written.
  void wrote(const std::filesystem::path& path) const;
  /// Frames go to a video, or to a folder of images. Throws as those do.
  virtual void startRecording(const std::filesystem::path& path) = 0;
  virtual void stopRecording() = 0;

 private:
  ExploreFiles files_;
};

using ExploreStep = std::function<void(ExploreSession& session)>;

struct ExploreStepKind {
  std::string name;  ///< the field that a step has
  std::string meaning;
  /// Reads the field, and others that belong to it. Throws InputError.
  std::function<ExploreStep(JsonFields& fields)> read;
};

/// Further rows may be added by the program.
Registry<ExploreStepKind>& exploreStepKinds();

struct ExploreScript {
  int width = 1280;
  int height = 720;
  std::filesystem::path folder{};  ///< that the script lies in
  struct Step {
    std::string where;  ///< in messages
    ExploreStep play;
  };
  std::vector<Step> steps;
};

/// Throws InputError naming the step and the field that is missing, unknown or out of range.
ExploreScript exploreScriptFromJsonText(const std::string& text, const std::string& where);
ExploreScript readExploreScript(const std::filesystem::path& path);

/// Plays it. InputError of a step names its place in the script.
void play(const ExploreScript& script, ExploreSession& session);

}  // namespace ocelli
