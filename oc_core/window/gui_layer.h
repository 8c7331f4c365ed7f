// Panels, forms and texts: Dear ImGui with our own events, fonts, look and drawing. It knows neither who gives the
// events (a window, or a script) nor what the panels are for.
//
//   GuiLayer gui(context, scale);
//   gui.handle(event);                       // as they come; a ResizeEvent first
//   gui.beginFrame(secondsSinceLast);
//   ImGui::Begin(...); ... ImGui::End();     // any functions of Dear ImGui
//   gui.endFrame();                          // into the bound framebuffer, whose row 0 is the top
//
// Lengths given to Dear ImGui are screen coordinates: multiply own ones by lengthScale(). Colours are sRGB values,
// which are written as they are; textures that are shown hold such values too. Nothing is remembered between two runs.
//
// Several layers may live at the same time, all on one thread: Dear ImGui has one current context for the whole
// program, which beginFrame() sets.
#pragma once

#include <bit>
#include <bitset>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/gl/gl_context.h"
#include "oc_core/window/gui_renderer.h"
#include "oc_core/window/gui_style.h"
#include "oc_core/window/system_font.h"

struct ImFont;
struct ImGuiContext;
struct ImGuiIO;

namespace ocelli {

/// Text of one size.
struct GuiFont {
  double pixels = kGuiTextPixels;  ///< at a scale of 1
  FontWeight weight = FontWeight::kRegular;
};

class GuiLayer {
 public:
  /// `contentScale` as in ResizeEvent. The first of the fonts, of which there must be one, is what panels use by
  /// themselves. They hold Latin, Greek and Cyrillic letters and the signs of captions, and of `characters`, which lie
  /// up to U+FFFF, those that any installed font has. Throws GlError.
  GuiLayer(GlContext& context, double contentScale, std::vector<GuiFont> fonts = {GuiFont()},
           std::set<char32_t> characters = {});
  ~GuiLayer();
  GuiLayer(const GuiLayer&) = delete;
  GuiLayer& operator=(const GuiLayer&) = delete;

  /// Takes an event for one of the next frames. Dear ImGui sees one state of each key and button a frame, so events
  /// that would hide each other (press and release) are spread over several frames.
  void handle(const InputEvent& event);
  /// Whether events still wait for a frame.
  bool hasWaitingEvents() const { return !events_.empty(); }

  /// Whether the panels had the pointer, the keyboard or the text that is typed for themselves in the last frame: then
  /// nothing else should follow these events. The keyboard is theirs also while one of them is being navigated.
  bool wantsPointer() const;
  bool wantsKeyboard() const;
  bool wantsText() const;

  void beginFrame(double secondsSinceLast);
  /// Hold a GlScope, with a framebuffer object bound of the size of the window in pixels. Throws GlError.
  void endFrame();

  /// For ImGui::Image(): shows a texture, its row 0 at the top.
  static void* imageOf(const GlObject& texture) { return std::bit_cast<void*>(uintptr_t{texture.id()}); }

  /// Screen coordinates for a length of 1 at 96 dots an inch.
  double lengthScale() const { return contentScale_ / pixelsPerUnit_; }
  /// The font of the system, or "ProggyClean", Dear ImGui's own, where none is found.
  const std::string& fontName() const { return fontName_; }
  /// For the drawing functions of Dear ImGui. Changes with the scale of the window.
  ImFont* font(size_t index) const;
  /// Whether all of the fonts hold it.
  bool holds(char32_t character) const;

 private:
  /// What a frame has taken in so far.
  struct Taken {
    bool button = false;
    bool scroll = false;
    bool text = false;
    bool command = false;  ///< a key that does something by itself: Backspace, Enter, Control with A, ...
    std::bitset<kKeyCount> keys;
  };

  void makeCurrent() const;
  ImGuiIO& io() const;
  /// Whether a frame that has taken so much can take the event as well, and if so, does.
  bool take(const InputEvent& event, Taken& taken);
  void setModifiers(const Modifiers& modifiers);
  void applyScale();
  void loadFonts();
  bool loadSystemFont(const GuiFont& font);
  /// Of a font that is there; nullptr where its file cannot be used.
  std::string* bytesOf(const SystemFont& font);

  GlContext* glContext_;
  ImGuiContext* context_ = nullptr;
  GuiRenderer renderer_;
  GlObject fontTexture_;
  std::vector<GuiFont> fonts_;
  std::set<char32_t> characters_;
  std::map<std::filesystem::path, std::string> fontFiles_;  ///< their bytes
  std::deque<std::vector<unsigned short>> fontRanges_;      ///< ImWchar, as long as the fonts are there
  std::string fontName_;
  std::deque<InputEvent> events_;
  double contentScale_;
  double pixelsPerUnit_ = 1;
};

}  // namespace ocelli
