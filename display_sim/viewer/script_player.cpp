#include "display_sim/viewer/script_player.h"

#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

constexpr int kDragMoves = 4;
constexpr int kMaxFrames = 1000;  // that a step may take to settle; a few are enough

/// Draws frames, `seconds` apart, until `isDone()`. Throws WorkError where that never comes.
template <class IsDone>
void showUntil(Viewer& viewer, double seconds, const IsDone& isDone) {
  for (int frame = 0; frame < kMaxFrames; ++frame) {
    viewer.update(seconds);
    viewer.draw();
    if (isDone()) {
      return;
    }
  }
  throw WorkError(fmt::format("the viewer has not come to rest after {} frames", kMaxFrames), "a script",
                  "leave out steps to find the one that keeps it busy");
}

/// The characters of a UTF-8 text; other bytes stand for themselves.
std::u32string charactersOf(const std::string& text) {
  std::u32string characters;
  for (size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
    char32_t character = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (size_t k = 1; k < length && i + k < text.size(); ++k) {
      character = character << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    }
    characters.push_back(character);
    i += length;
  }
  return characters;
}

}  // namespace

ScriptPlayer::ScriptPlayer(Viewer& viewer, std::filesystem::path folder,
                           std::function<void(const std::string& file)> saved)
    : viewer_(viewer), folder_(std::move(folder)), saved_(std::move(saved)) {}

void ScriptPlayer::play(const ViewerScript& script) {
  play(ResizeStep{script.width, script.height, script.scale});
  const size_t count = script.steps.size();
  for (size_t i = 0; i < count; ++i) {
    play(script.steps[i]);
    const size_t left = count - i - 1;
    if (viewer_.wantsClose() && left > 0) {
      throw InputError(fmt::format("step {} closed the viewer; {} left", i + 1,
                                   left == 1 ? "1 step is" : fmt::format("{} steps are", left)),
                       "the script", "let it be the last step");
    }
  }
}

void ScriptPlayer::play(const ScriptStep& step) {
  std::visit([this](const auto& each) { perform(each); }, step);
}

void ScriptPlayer::give(const std::vector<InputEvent>& events) {
  for (const InputEvent& event : events) {
    viewer_.handle(event);
    showFrames();
  }
}

void ScriptPlayer::showFrames() {
  showUntil(viewer_, kScriptFrameSeconds, [this] { return !viewer_.hasWaitingEvents(); });
}

void ScriptPlayer::settle() {
  showUntil(viewer_, 0, [this] { return !viewer_.isSettling(); });
}

void ScriptPlayer::press(const glm::dvec2& at, PointerButton button, bool pressed) {
  give({PointerMoveEvent{at.x, at.y}, PointerButtonEvent{button, pressed, {}}});
}

void ScriptPlayer::perform(const OpenStep& step) {
  viewer_.open(step.source);
  showFrames();
}

void ScriptPlayer::perform(const CameraStep& step) {
  viewer_.choose(step.camera);
  showFrames();
}

void ScriptPlayer::perform(const DropStep& step) {
  give({DropEvent{{step.file}}});
}

void ScriptPlayer::perform(const KeyStep& step) {
  give({KeyEvent{step.key, true, step.modifiers}, KeyEvent{step.key, false, step.modifiers}});
}

void ScriptPlayer::perform(const TypeStep& step) {
  for (const char32_t character : charactersOf(step.text)) {
    give({TextEvent{character}});
  }
}

void ScriptPlayer::perform(const MoveStep& step) {
  give({PointerMoveEvent{step.to.x, step.to.y}});
}

void ScriptPlayer::perform(const ClickStep& step) {
  press(step.at, step.button, true);
  press(step.at, step.button, false);
}

void ScriptPlayer::perform(const DragStep& step) {
  press(step.from, step.button, true);
  for (int i = 1; i <= kDragMoves; ++i) {
    const glm::dvec2 at = step.from + (step.to - step.from) * (static_cast<double>(i) / kDragMoves);
    give({PointerMoveEvent{at.x, at.y}});
  }
  press(step.to, step.button, false);
}

void ScriptPlayer::perform(const ScrollStep& step) {
  give({PointerMoveEvent{step.at.x, step.at.y}, ScrollEvent{0, step.up}});
}

void ScriptPlayer::perform(const ResizeStep& step) {
  give({ResizeEvent{step.width, step.height, 1, step.scale}});
}

void ScriptPlayer::perform(const WaitStep&) {
  do {
    viewer_.waitUntilMade();
    viewer_.update(0);
  } while (viewer_.isMaking());
  showFrames();
  settle();
}

void ScriptPlayer::perform(const SecondsStep& step) {
  const int frames = static_cast<int>(std::ceil(step.seconds / kScriptFrameSeconds - 1e-9));
  for (int i = 1; i < frames; ++i) {  // the last one is shown
    viewer_.update(kScriptFrameSeconds);
  }
  showFrames();
}

void ScriptPlayer::perform(const EffectStep& step) {
  viewer_.chooseEffect(step.name, step.way);
  showFrames();
}

void ScriptPlayer::perform(const ShowStep& step) {
  viewer_.chooseEffectContent(step.content);
  showFrames();
}

void ScriptPlayer::perform(const SaveStep& step) {
  viewer_.waitForPictures();
  settle();  // a panel that has just opened is laid out in its first frame, and shows in the next
  write(step.file, viewer_.screenshot());
}

void ScriptPlayer::perform(const SaveEffectStep& step) {
  viewer_.waitForPictures();
  write(step.file, viewer_.effectPicture());
}

void ScriptPlayer::perform(const SaveLensPictureStep& step) {
  viewer_.waitForPictures();
  write(step.file, viewer_.lensPicture());
}

void ScriptPlayer::perform(const SaveCameraStep& step) {
  const std::filesystem::path path = pathOf(step.file);
  OutputFile file(path);
  file.write(viewer_.lensFile());
  file.commit();
  tell(path);
}

void ScriptPlayer::perform(const TransferStep& step) {
  viewer_.chooseTransfer(step.nameOrFile);
  showFrames();
}

void ScriptPlayer::perform(const IsoStep& step) {
  viewer_.chooseIso(step.value);
  showFrames();
}

void ScriptPlayer::perform(const SaveVolumePictureStep& step) {
  viewer_.waitForPictures();
  write(step.file, viewer_.volumePicture());
}

void ScriptPlayer::perform(const SaveTransferStep& step) {
  const std::filesystem::path path = pathOf(step.file);
  viewer_.saveTransferTo(path);
  tell(path);
}

std::filesystem::path ScriptPlayer::pathOf(const std::string& file) const {
  std::filesystem::path path = folder_ / file;
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  return path;
}

void ScriptPlayer::tell(const std::filesystem::path& path) const {
  if (saved_) {
    saved_(path.string());
  }
}

void ScriptPlayer::write(const std::string& file, const Image<Rgb8>& image) {
  const std::filesystem::path path = pathOf(file);
  writePng(path, image);
  tell(path);
}

}  // namespace ocelli
