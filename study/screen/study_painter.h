// Draws what a session shows, whatever it is, and tells what the mouse does to it. Keys are the session's own.
//
//   StudyPainter painter(context, screen, controls);
//   painter.handle(event);                              // as they come
//   const StudyFrame frame = painter.draw(flow.screen());
//   window.present(painter.framebuffer(), ...);
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "oc_core/gl/gl_object.h"
#include "oc_core/image/png_file.h"
#include "study/screen/study_canvas.h"
#include "study/session/session_flow.h"

namespace ocelli {

struct StudyFrame {
  std::optional<FormAction> action{};  ///< what was clicked
  std::optional<Key> key{};            ///< of a button that was clicked and does what this key does
  std::optional<uint64_t> pixelHash{};
};

class StudyPainter {
 public:
  /// The context must outlive it. `characters` are those of the texts (protocol_texts.h) besides those of Europe;
  /// `texts` are those of the language. Throws GlError.
  StudyPainter(GlContext& context, const TrialScreen& screen, const Controls& controls,
               const std::set<char32_t>& characters = {}, const SubjectTexts& texts = SubjectTexts());
  ~StudyPainter();
  StudyPainter(const StudyPainter&) = delete;
  StudyPainter& operator=(const StudyPainter&) = delete;

  /// Positions are pixels of the screen.
  void handle(const InputEvent& event);
  /// `hash` asks for that of a trial's views (trial_painter.h). Hold a GlScope, here and below. Throws GlError.
  StudyFrame draw(const SessionScreen& screen, double secondsSinceLast = 1.0 / 60, bool hash = false);
  /// Clicks that a frame has not taken yet.
  bool hasWaitingEvents() const;

  /// Whether a text is shown as it is written.
  bool canShow(const std::string& text) const;

  const GlObject& framebuffer() const;
  Image<Rgb8> image() const;
  const std::vector<TextBox>& textBoxes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What a screen is, in a word: "page", "consent", "form", "trial", "pause"; for the names of images.
const char* kindOf(const SessionScreen& screen);
/// Whether another screen is shown than before, so that an image of each can be kept: another page, form or kind, or
/// another prompt of a trial.
std::string identityOf(const SessionScreen& screen);

}  // namespace ocelli
