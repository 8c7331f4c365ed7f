#include "oc_core/window/gui_layer.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/window/gui_style.h"
#include "oc_core/window/system_font.h"

namespace ocelli {
namespace {

constexpr double kMaxOversampledPixels = 40;
constexpr double kOwnFontPixels = 13;  // Dear ImGui's own font is made of dots and stays crisp at multiples of it

// What Dear ImGui does with keys. It has keys of its own for a few of ours alone.
constexpr std::array<std::pair<ImGuiKey, Key>, 21> kKeys{{{ImGuiKey_Tab, Key::kTab},
                                                          {ImGuiKey_LeftArrow, Key::kLeft},
                                                          {ImGuiKey_RightArrow, Key::kRight},
                                                          {ImGuiKey_UpArrow, Key::kUp},
                                                          {ImGuiKey_DownArrow, Key::kDown},
                                                          {ImGuiKey_PageUp, Key::kPageUp},
                                                          {ImGuiKey_PageDown, Key::kPageDown},
                                                          {ImGuiKey_Home, Key::kHome},
                                                          {ImGuiKey_End, Key::kEnd},
                                                          {ImGuiKey_Insert, Key::kInsert},
                                                          {ImGuiKey_Delete, Key::kDelete},
                                                          {ImGuiKey_Backspace, Key::kBackspace},
                                                          {ImGuiKey_Space, Key::kSpace},
                                                          {ImGuiKey_Enter, Key::kEnter},
                                                          {ImGuiKey_Escape, Key::kEscape},
                                                          {ImGuiKey_A, Key::kA},
                                                          {ImGuiKey_C, Key::kC},
                                                          {ImGuiKey_V, Key::kV},
                                                          {ImGuiKey_X, Key::kX},
                                                          {ImGuiKey_Y, Key::kY},
                                                          {ImGuiKey_Z, Key::kZ}}};

// Latin, Greek, Cyrillic, and the signs that captions use: dashes, quotes, arrows, minus and comparisons.
constexpr std::array<ImWchar, 13> kCharacters{0x0020, 0x017F, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x2010,
                                              0x2026, 0x2190, 0x2193, 0x2212, 0x2265, 0};

/// Whether a key does something by itself, besides the text that it types.
bool isCommand(const KeyEvent& event) {
  const bool isLetter = event.key <= Key::kZ;
  return !isLetter || event.modifiers.control;
}

/// What the reader of fonts in Dear ImGui takes; it stops the program at anything else.
bool looksLikeFont(const std::string& bytes) {
  using namespace std::string_view_literals;
  return std::ranges::any_of(std::array{"\0\1\0\0"sv, "true"sv, "OTTO"sv, "ttcf"sv},
                             [&](std::string_view start) { return bytes.starts_with(start); });
}

/// A number of an OpenType font, most significant byte first; 0 beyond its end.
uint32_t numberAt(const std::string& bytes, size_t offset, size_t size) {
  uint32_t number = 0;
  for (size_t i = offset; i < offset + size; ++i) {
    number = number << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
  }
  return number;
}

/// From the top of the tallest letters to the bottom of the lowest, in ems (OpenType: hhea and head); nothing where the
/// font does not say. Dear ImGui takes this height for the size of a font.
std::optional<double> heightInEms(const std::string& bytes, int index) {
  const size_t start = bytes.starts_with("ttcf") ? numberAt(bytes, 12 + 4 * static_cast<size_t>(index), 4) : 0;
  const size_t tables = numberAt(bytes, start + 4, 2);
  double height = 0;
  double em = 0;
  for (size_t i = 0; i < tables; ++i) {
    const size_t entry = start + 12 + 16 * i;
    const size_t table = numberAt(bytes, entry + 8, 4);
    const auto signedAt = [&](size_t offset) { return static_cast<int16_t>(numberAt(bytes, table + offset, 2)); };
    if (entry < bytes.size() && bytes.compare(entry, 4, "hhea") == 0) {
      height = signedAt(4) - signedAt(6);
    } else if (entry < bytes.size() && bytes.compare(entry, 4, "head") == 0) {
      em = numberAt(bytes, table + 18, 2);
    }
  }
  return height > 0 && em > 0 ? std::optional(height / em) : std::nullopt;
}

/// Pairs of first and last, and a 0 at the end.
std::vector<ImWchar> rangesOf(const std::u32string& characters, std::vector<ImWchar> ranges = {}) {
  for (const char32_t character : characters) {
    OC_CHECK(character <= IM_UNICODE_CODEPOINT_MAX, "Dear ImGui has characters of 16 bits");
    ranges.insert(ranges.end(), 2, static_cast<ImWchar>(character));
  }
  ranges.push_back(0);
  return ranges;
}

GuiRenderer makeRenderer(GlContext& context) {
  const GlScope scope(context);
  return GuiRenderer(context);
}

}  // namespace

GuiLayer::GuiLayer(GlContext& context, double contentScale, std::vector<GuiFont> fonts, std::set<char32_t> characters)
    : glContext_(&context),
      renderer_(makeRenderer(context)),
      fonts_(std::move(fonts)),
      characters_(std::move(characters)),
      contentScale_(contentScale) {
  OC_CHECK(!fonts_.empty(), "panels need a font");
  IMGUI_CHECKVERSION();
  ImGuiContext* const before = ImGui::GetCurrentContext();
  context_ = ImGui::CreateContext();
  makeCurrent();
  io().IniFilename = nullptr;
  io().LogFilename = nullptr;
  io().BackendRendererName = "Ocelli";
  io().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io().ConfigWindowsMoveFromTitleBarOnly = true;
  for (const auto& [theirs, ours] : kKeys) {
    io().KeyMap[theirs] = static_cast<int>(ours);
  }
  io().DisplaySize = {0, 0};
  try {
    applyScale();
  } catch (...) {
    ImGui::DestroyContext(context_);
    ImGui::SetCurrentContext(before);
    throw;
  }
}

GuiLayer::~GuiLayer() {
  ImGui::DestroyContext(context_);
}

void GuiLayer::makeCurrent() const {
  ImGui::SetCurrentContext(context_);
}

ImGuiIO& GuiLayer::io() const {
  makeCurrent();
  return ImGui::GetIO();
}

void GuiLayer::handle(const InputEvent& event) {
  events_.push_back(event);
}

bool GuiLayer::wantsPointer() const {
  return io().WantCaptureMouse;
}

bool GuiLayer::wantsKeyboard() const {
  return io().WantCaptureKeyboard;
}

bool GuiLayer::wantsText() const {
  return io().WantTextInput;
}

void GuiLayer::setModifiers(const Modifiers& modifiers) {
  io().KeyShift = modifiers.shift;
  io().KeyCtrl = modifiers.control;
  io().KeyAlt = modifiers.alt;
}

bool GuiLayer::take(const InputEvent& event, Taken& taken) {
  ImGuiIO& state = io();
  if (const auto* resize = std::get_if<ResizeEvent>(&event)) {
    state.DisplaySize = {static_cast<float>(resize->width), static_cast<float>(resize->height)};
    if (resize->contentScale != contentScale_ || resize->pixelsPerUnit != pixelsPerUnit_) {
      contentScale_ = resize->contentScale;
      pixelsPerUnit_ = resize->pixelsPerUnit;
      applyScale();
    }
  } else if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    if (taken.button || taken.scroll) {
      return false;
    }
    state.MousePos = {static_cast<float>(move->x), static_cast<float>(move->y)};
  } else if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    if (taken.button || taken.scroll || taken.command) {
      return false;
    }
    state.MouseDown[static_cast<size_t>(button->button)] = button->pressed;  // in the same order
    setModifiers(button->modifiers);
    taken.button = true;
  } else if (const auto* scroll = std::get_if<ScrollEvent>(&event)) {
    if (taken.button) {
      return false;
    }
    state.MouseWheel += static_cast<float>(scroll->up);
    state.MouseWheelH -= static_cast<float>(scroll->right);
    taken.scroll = true;
  } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
    const auto index = static_cast<size_t>(key->key);
    if (taken.keys[index] || (isCommand(*key) && (taken.text || taken.button))) {
      return false;
    }
    state.KeysDown[index] = key->pressed;
    setModifiers(key->modifiers);
    taken.keys[index] = true;
    taken.command = taken.command || isCommand(*key);
  } else if (const auto* text = std::get_if<TextEvent>(&event)) {
    if (taken.button || taken.command) {
      return false;
    }
    // What arrives as text is text, whatever keys have made it.
    setModifiers({});
    state.AddInputCharacter(text->character);
    taken.text = true;
  }
  return true;
}

void GuiLayer::applyScale() {
  OC_CHECK(contentScale_ > 0 && pixelsPerUnit_ > 0, "a window has a scale");
  applyGuiStyle(lengthScale());
  io().Fonts->Clear();
  loadFonts();
  // Glyphs are made in the framebuffer's pixels, so that they stay crisp, and laid out in screen coordinates.
  io().FontGlobalScale = static_cast<float>(1 / pixelsPerUnit_);
  io().DisplayFramebufferScale = {static_cast<float>(pixelsPerUnit_), static_cast<float>(pixelsPerUnit_)};

  unsigned char* opacity = nullptr;
  int width = 0;
  int height = 0;
  io().Fonts->GetTexDataAsAlpha8(&opacity, &width, &height);
  const GlScope scope(*glContext_);
  fontTexture_ = renderer_.makeFontTexture(width, height, opacity);
  io().Fonts->SetTexID(imageOf(fontTexture_));
  io().Fonts->ClearTexData();
}

std::string* GuiLayer::bytesOf(const SystemFont& font) {
  auto found = fontFiles_.find(font.file);
  if (found == fontFiles_.end()) {
    try {
      found = fontFiles_.emplace(font.file, readFile(font.file)).first;
    } catch (const InputError&) {
      return nullptr;
    }
  }
  return looksLikeFont(found->second) ? &found->second : nullptr;
}

bool GuiLayer::loadSystemFont(const GuiFont& font) {
  const FontCover cover = coverWithFonts(font.weight, characters_);
  bool isFirst = true;
  std::optional<double> ownHeight;
  for (const FontShare& share : cover.shares) {
    std::string* const bytes = bytesOf(share.font);
    if (bytes == nullptr) {
      if (isFirst) {
        return false;
      }
      continue;
    }
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.FontNo = share.font.index;
    config.MergeMode = !isFirst;
    // Large glyphs need no finer placing, and would fill the texture; so would many.
    config.OversampleH = !isFirst || font.pixels * contentScale_ > kMaxOversampledPixels ? 1 : 2;
    const std::optional<double> height = heightInEms(*bytes, share.font.index);
    ownHeight = isFirst ? height : ownHeight;
    // Letters of all fonts are of one size, however much room each leaves around them.
    const double relative = height && ownHeight ? *height / *ownHeight : 1;
    const auto pixels = static_cast<float>(std::round(font.pixels * contentScale_ * relative));
    const std::vector<ImWchar> always(kCharacters.begin(), kCharacters.end() - 1);
    fontRanges_.push_back(rangesOf(share.characters, isFirst ? always : std::vector<ImWchar>()));
    io().Fonts->AddFontFromMemoryTTF(bytes->data(), static_cast<int>(bytes->size()), pixels, &config,
                                     fontRanges_.back().data());
    if (fontName_.empty()) {
      fontName_ = share.font.name;
    }
    isFirst = false;
  }
  return !isFirst;
}

void GuiLayer::loadFonts() {
  ImFontAtlas& atlas = *io().Fonts;
  fontFiles_.clear();
  fontRanges_.clear();
  fontName_.clear();
  if (std::ranges::all_of(fonts_, [&](const GuiFont& font) { return loadSystemFont(font); }) && atlas.Build()) {
    return;
  }
  atlas.Clear();
  fontName_ = "ProggyClean";
  for (const GuiFont& font : fonts_) {
    ImFontConfig config;
    const double scale = std::max(1.0, std::round(contentScale_ * font.pixels / kGuiTextPixels));
    config.SizePixels = static_cast<float>(kOwnFontPixels * scale);
    atlas.AddFontDefault(&config);
  }
}

ImFont* GuiLayer::font(size_t index) const {
  OC_CHECK(index < fonts_.size(), "a font of this layer");
  return io().Fonts->Fonts[static_cast<int>(index)];
}

bool GuiLayer::holds(char32_t character) const {
  const ImVector<ImFont*>& fonts = io().Fonts->Fonts;
  return character <= IM_UNICODE_CODEPOINT_MAX && std::all_of(fonts.begin(), fonts.end(), [&](const ImFont* font) {
           return font->FindGlyphNoFallback(static_cast<ImWchar>(character)) != nullptr;
         });
}

void GuiLayer::beginFrame(double secondsSinceLast) {
  ImGuiIO& state = io();
  const auto isDown = [](bool down) { return down; };
  if (std::ranges::none_of(state.KeysDown, isDown) && std::ranges::none_of(state.MouseDown, isDown)) {
    setModifiers({});
  }
  for (Taken taken; !events_.empty() && take(events_.front(), taken);) {
    events_.pop_front();
  }
  // Dear ImGui needs time to pass.
  state.DeltaTime = static_cast<float>(std::max(secondsSinceLast, 1e-6));
  ImGui::NewFrame();
}

void GuiLayer::endFrame() {
  makeCurrent();
  ImGui::Render();
  const GlScope scope(*glContext_);
  renderer_.draw(*ImGui::GetDrawData());
}

}  // namespace ocelli
