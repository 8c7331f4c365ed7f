#include "oc_core/window/gui_layer.h"

#include <gmock/gmock.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <functional>

#include "oc_core/gl/gl_api.h"
#include "oc_core/window/gui_style.h"
#include "tests/base/temporary_folder.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using testing::Each;
using Pixel = std::array<uint8_t, 4>;

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr Pixel kBlack{0, 0, 0, 255};

Pixel pixelOf(GuiColor color) {
  return {color.red, color.green, color.blue, 255};
}

/// A layer, and a framebuffer that it draws to, of `kWidth` x `kHeight` screen coordinates.
class Screen {
 public:
  explicit Screen(GlContext& context, double contentScale = 1, double pixelsPerUnit = 1)
      : gui(context, contentScale),
        scope_(context),
        context_(context),
        width_(static_cast<int>(kWidth * pixelsPerUnit)),
        height_(static_cast<int>(kHeight * pixelsPerUnit)),
        color_(makeTexture(context, GL_RGBA8, width_, height_)),
        framebuffer_(makeFramebuffer(context, std::array{color_.id()}, 0)) {
    gui.handle(ResizeEvent{kWidth, kHeight, pixelsPerUnit, contentScale});
  }

  /// Shows frames until no events wait.
  Image<Pixel> show(const std::function<void()>& panels) {
    do {
      const GladGLContext& gl = context_.gl();
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
      const std::array<float, 4> black{0, 0, 0, 1};
      gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, black.data());
      gui.beginFrame(1.0 / 60);
      panels();
      gui.endFrame();
    } while (gui.hasWaitingEvents());
    return readTexture<Pixel>(context_, color_, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE);
  }

  void click(double x, double y) {
    gui.handle(PointerMoveEvent{x, y});
    gui.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
    gui.handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  }
  void press(Key key, Modifiers modifiers = {}) {
    gui.handle(KeyEvent{key, true, modifiers});
    gui.handle(KeyEvent{key, false, modifiers});
  }
  void type(std::u32string_view text) {
    for (const char32_t character : text) {
      gui.handle(TextEvent{character});
    }
  }

  GuiLayer gui;

 private:
  GlScope scope_;
  GlContext& context_;
  int width_;
  int height_;
  GlObject color_;
  GlObject framebuffer_;
};

/// A panel that fills the window, without margins.
void panel(const std::function<void()>& inside) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({kWidth, kHeight});
  ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  inside();
  ImGui::End();
}

class GuiLayerTest : public testing::TestWithParam<GlProvider> {
 protected:
  std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GuiLayerTest, kOffscreenProviders, providerName);

TEST_P(GuiLayerTest, drawsWhereAndInWhatColorItIsTold) {
  Screen screen(*context_);
  const auto image = screen.show([] {
    ImGui::GetBackgroundDrawList()->AddRectFilled({10, 20}, {60, 50}, kGuiAccent.packed());
    ImGui::GetBackgroundDrawList()->AddRectFilled({100, 20}, {160, 50}, IM_COL32(255, 255, 255, 51));
  });
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool accent = x >= 10 && x < 60 && y >= 20 && y < 50;
      const bool fifthOfWhite = x >= 100 && x < 160 && y >= 20 && y < 50;  // of the sRGB value: 51/255 is a fifth
      const Pixel expected = accent ? pixelOf(kGuiAccent) : fifthOfWhite ? Pixel{51, 51, 51, 255} : kBlack;
      ASSERT_EQ(image(x, y), expected) << x << " " << y;
    }
  }
}

TEST_P(GuiLayerTest, drawsTheSameWhateverOthersHaveLeft) {
  const GlScope scope(*context_);
  const GladGLContext& gl = context_->gl();
  // A framebuffer that could convert to sRGB shows the values as they are.
  const GlObject color = makeTexture(*context_, GL_SRGB8_ALPHA8, kWidth, kHeight);
  const GlObject framebuffer = makeFramebuffer(*context_, std::array{color.id()}, 0);
  GuiLayer gui(*context_, 1);
  gui.handle(ResizeEvent{kWidth, kHeight, 1, 1});
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  for (const GLenum on :
       {GL_DEPTH_TEST, GL_CULL_FACE, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_CLIP_DISTANCE0, GL_FRAMEBUFFER_SRGB}) {
    gl.Enable(on);
  }
  gl.Scissor(0, 0, 1, 1);
  gl.CullFace(GL_FRONT_AND_BACK);
  gl.StencilFunc(GL_NEVER, 0, ~0U);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  gl.BlendEquation(GL_FUNC_SUBTRACT);
  gui.beginFrame(1.0 / 60);
  ImGui::GetBackgroundDrawList()->AddRectFilled({10, 20}, {60, 50}, kGuiAccent.packed());
  gui.endFrame();
  const auto image = readTexture<Pixel>(*context_, color, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE);
  EXPECT_EQ(image(12, 22), pixelOf(kGuiAccent));
  EXPECT_EQ(image(35, 35), pixelOf(kGuiAccent));
  EXPECT_EQ(image(57, 47), pixelOf(kGuiAccent));
}

TEST_P(GuiLayerTest, clipsToPanels) {
  Screen screen(*context_);
  const auto image = screen.show([] {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({30, 40}, {70, 60});
    list.AddRectFilled({0, 0}, {kWidth, kHeight}, kGuiAccent.packed());
    list.PopClipRect();
    list.PushClipRect({-20, -20}, {-10, -10});  // outside of the window
    list.AddRectFilled({-100, -100}, {kWidth, kHeight}, kGuiText.packed());
    list.PopClipRect();
  });
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 30 && x < 70 && y >= 40 && y < 60;
      ASSERT_EQ(image(x, y), inside ? pixelOf(kGuiAccent) : kBlack) << x << " " << y;
    }
  }
}

TEST_P(GuiLayerTest, showsTexturesWithRowZeroAtTheTop) {
  const GlScope scope(*context_);
  const GlObject texture = makeTexture(*context_, GL_RGBA8, 2, 2);
  const std::array<Pixel, 4> texels{{{200, 0, 0, 255}, {0, 200, 0, 255}, {0, 0, 200, 255}, {90, 90, 90, 255}}};
  context_->gl().TextureSubImage2D(texture.id(), 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  Screen screen(*context_);
  const auto image = screen.show([&] {
    ImGui::GetBackgroundDrawList()->AddImage(GuiLayer::imageOf(texture), {0, 0}, {kWidth, kHeight});
  });
  EXPECT_EQ(image(5, 5), texels[0]);
  EXPECT_EQ(image(kWidth - 5, 5), texels[1]);
  EXPECT_EQ(image(5, kHeight - 5), texels[2]);
  EXPECT_EQ(image(kWidth - 5, kHeight - 5), texels[3]);
}

TEST_P(GuiLayerTest, buttonIsPressedByThePointer) {
  Screen screen(*context_);
  int pressed = 0;
  const auto panels = [&] {
    panel([&] {
      ImGui::SetCursorPos({100, 100});
      pressed += ImGui::Button("here", {80, 30}) ? 1 : 0;
    });
  };
  screen.show(panels);
  EXPECT_EQ(screen.show(panels)(102, 104), pixelOf(kGuiFieldHovered)) << "the face of a button";
  screen.click(99, 99);  // beside it
  screen.show(panels);
  EXPECT_EQ(pressed, 0);
  EXPECT_TRUE(screen.gui.wantsPointer());
  // All events of a click come between two frames, and none of them is lost.
  screen.click(101, 101);
  screen.click(179, 129);
  screen.show(panels);
  EXPECT_EQ(pressed, 2);
}

TEST_P(GuiLayerTest, keyboardWalksAndPresses) {
  Screen screen(*context_);
  std::array<int, 2> pressed{};
  bool checked = false;
  const auto panels = [&] {
    panel([&] {
      pressed[0] += ImGui::Button("first") ? 1 : 0;
      pressed[1] += ImGui::Button("second") ? 1 : 0;
      ImGui::Checkbox("third", &checked);
    });
  };
  screen.show(panels);
  screen.show(panels);  // a new panel takes the keyboard in its second frame
  screen.press(Key::kDown);
  screen.press(Key::kSpace);
  screen.show(panels);
  EXPECT_TRUE(screen.gui.wantsKeyboard());
  EXPECT_THAT(pressed, testing::ElementsAre(0, 1));
  screen.press(Key::kDown);
  screen.press(Key::kSpace);
  screen.press(Key::kUp);
  screen.press(Key::kUp);
  screen.press(Key::kSpace);
  screen.show(panels);
  EXPECT_THAT(pressed, testing::ElementsAre(1, 1));
  EXPECT_TRUE(checked);
}

TEST_P(GuiLayerTest, takesTextInTheOrderOfItsEvents) {
  Screen screen(*context_);
  std::array<char, 64> text{};
  const auto panels = [&] { panel([&] { ImGui::InputText("name", text.data(), text.size()); }); };
  screen.show(panels);
  EXPECT_FALSE(screen.gui.wantsText());
  screen.click(30, 22);
  screen.show(panels);
  EXPECT_TRUE(screen.gui.wantsText());
  screen.type(U"Grün x");
  screen.press(Key::kBackspace);
  screen.type(U"→9");
  screen.show(panels);
  EXPECT_STREQ(text.data(), "Grün →9");
  // What a keyboard gives for a letter: the key and the text.
  for (int i = 0; i < 2; ++i) {
    screen.gui.handle(KeyEvent{Key::kA, true, {}});
    screen.type(U"a");
    screen.gui.handle(KeyEvent{Key::kA, false, {}});
  }
  screen.show(panels);
  EXPECT_STREQ(text.data(), "Grün →9aa");
  screen.press(Key::kA, {.shift = false, .control = true, .alt = false});  // all of it
  screen.type(U"new");
  screen.show(panels);
  EXPECT_STREQ(text.data(), "new");
}

TEST_P(GuiLayerTest, wheelScrollsWhatIsUnderThePointer) {
  Screen screen(*context_);
  float offset = -1;
  const auto panels = [&] {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({kWidth, kHeight});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
    ImGui::Dummy({10, 1000});
    offset = ImGui::GetScrollY();
    ImGui::End();
  };
  screen.show(panels);
  screen.gui.handle(PointerMoveEvent{50, 50});
  screen.show(panels);
  screen.gui.handle(ScrollEvent{0, -1});
  screen.show(panels);
  screen.show(panels);
  EXPECT_GT(offset, 0);
}

TEST_P(GuiLayerTest, leavesThePointerAndTheKeysToOthersOutsideOfPanels) {
  Screen screen(*context_);
  const auto panels = [&] {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({100, 100});
    ImGui::Begin("panel");
    ImGui::Button("button");
    ImGui::End();
  };
  screen.click(50, 50);
  screen.show(panels);
  screen.show(panels);
  EXPECT_TRUE(screen.gui.wantsPointer());
  EXPECT_TRUE(screen.gui.wantsKeyboard());
  screen.click(200, 200);
  screen.show(panels);
  screen.show(panels);
  EXPECT_FALSE(screen.gui.wantsPointer());
  EXPECT_FALSE(screen.gui.wantsKeyboard());
}

/// The rows and columns that a text covers.
std::array<int, 4> inkBox(const Image<Pixel>& image) {
  std::array<int, 4> box{image.width(), image.height(), 0, 0};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image(x, y)[0] > 60) {
        box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
      }
    }
  }
  return box;
}

int inkRows(const Image<Pixel>& image) {
  return inkBox(image)[3] - inkBox(image)[1] + 1;
}

TEST_P(GuiLayerTest, textGrowsWithTheDensityAndStaysCrisp) {
  const auto text = [] { ImGui::GetBackgroundDrawList()->AddText({20, 20}, kGuiText.packed(), "HIH"); };
  Screen normal(*context_);
  const auto small = normal.show(text);
  EXPECT_THAT(normal.gui.fontName(), testing::Not("ProggyClean")) << "install a font, such as fonts-dejavu-core";
  // A dense screen whose coordinates are pixels, and one whose coordinates are two pixels: the same pixels.
  Screen dense(*context_, 2, 1);
  Screen scaled(*context_, 2, 2);
  const auto large = dense.show(text);
  const auto alsoLarge = scaled.show(text);
  EXPECT_EQ(dense.gui.lengthScale(), 2);
  EXPECT_EQ(scaled.gui.lengthScale(), 1);
  EXPECT_NEAR(inkRows(large), 2 * inkRows(small), 1);  // a row of either may be half covered
  EXPECT_EQ(inkRows(large), inkRows(alsoLarge));
  EXPECT_NEAR(inkBox(alsoLarge)[0] - 40, inkBox(large)[0] - 20, 1);
  // Blurred letters would have no pixel of the full colour.
  EXPECT_THAT(std::vector(large.begin(), large.end()), testing::Contains(pixelOf(kGuiText)));
  EXPECT_THAT(std::vector(alsoLarge.begin(), alsoLarge.end()), testing::Contains(pixelOf(kGuiText)));
}

TEST_P(GuiLayerTest, followsAWindowToAnotherScreen) {
  const auto text = [] { ImGui::GetBackgroundDrawList()->AddText({20, 20}, kGuiText.packed(), "HIH"); };
  Screen fresh(*context_, 1.5, 1);
  const auto expected = fresh.show(text);
  Screen moved(*context_);
  moved.show(text);
  moved.gui.handle(ResizeEvent{kWidth, kHeight, 1, 1.5});
  EXPECT_EQ(moved.show(text), expected);
}

TEST_P(GuiLayerTest, hasAFontWhereTheSystemHasNone) {
  const test::TemporaryFolder folder;
  const auto configuration = folder.write("fonts.conf", "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  setenv("FONTCONFIG_FILE", configuration.c_str(), 1);
  Screen screen(*context_);
  unsetenv("FONTCONFIG_FILE");
  EXPECT_EQ(screen.gui.fontName(), "ProggyClean");
  EXPECT_GT(inkRows(screen.show([] { ImGui::GetBackgroundDrawList()->AddText({20, 20}, ~0U, "HIH"); })), 5);
}

TEST_P(GuiLayerTest, layersLiveBesideEachOther) {
  Screen first(*context_);
  int firstPressed = 0;
  int secondPressed = 0;
  const auto button = [](int& pressed) {
    return [&pressed] { panel([&] { pressed += ImGui::Button("here", {80, 30}) ? 1 : 0; }); };
  };
  {
    Screen second(*context_);
    first.show(button(firstPressed));
    second.show(button(secondPressed));
    second.click(20, 20);
    first.show(button(firstPressed));
    second.show(button(secondPressed));
  }
  EXPECT_EQ(firstPressed, 0);
  EXPECT_EQ(secondPressed, 1);
  first.click(20, 20);
  first.show(button(firstPressed));
  EXPECT_EQ(firstPressed, 1);
}

TEST_P(GuiLayerTest, drawsMoreThanIndicesOf16BitsReach) {
  Screen screen(*context_);
  const auto image = screen.show([] {
    for (int i = 0; i < 40000; ++i) {  // 160,000 corners, the last square alone is elsewhere
      const float left = i == 39999 ? 200 : 10;
      ImGui::GetBackgroundDrawList()->AddRectFilled({left, 10}, {left + 5, 15}, kGuiAccent.packed());
    }
  });
  EXPECT_EQ(image(202, 12), pixelOf(kGuiAccent));
  EXPECT_EQ(image(12, 12), pixelOf(kGuiAccent));
  EXPECT_EQ(image(100, 12), kBlack);
}

TEST_P(GuiLayerTest, writesNoFileAndLeavesNoObject) {
  {
    Screen screen(*context_);
    screen.show([] { panel([] { ImGui::Button("here"); }); });
    EXPECT_GT(context_->liveObjects(), 0);
  }
  EXPECT_EQ(context_->liveObjects(), 0);
  EXPECT_FALSE(std::filesystem::exists("imgui.ini"));
}

TEST_P(GuiLayerTest, aWindowOfNoSizeDrawsNothing) {
  Screen screen(*context_);
  screen.gui.handle(ResizeEvent{0, 0, 1, 1});
  const auto image = screen.show([] { panel([] { ImGui::Button("here"); }); });
  EXPECT_THAT(std::vector(image.begin(), image.end()), Each(kBlack));
}

TEST(GuiLayerDeathTest, aScreenWithoutAScaleIsABug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto context = openTestContext(GlProvider::kOsMesa);
  EXPECT_DEATH(GuiLayer(*context, 0), "a window has a scale");
}

TEST(GuiLayerProvidersTest, drawTheSame) {
  const auto form = [](GlProvider provider) {
    const auto context = openTestContext(provider);
    Screen screen(*context, 1.25);
    bool on = true;
    float value = 0.3F;
    const auto panels = [&] {
      ImGui::SetNextWindowPos({20, 20});
      ImGui::SetNextWindowSize({kWidth - 40, kHeight - 40});
      ImGui::Begin("Camera");
      ImGui::TextUnformatted("Depth discontinuity occlusion camera");
      ImGui::Checkbox("on", &on);
      ImGui::SliderFloat("offset", &value, 0, 1);
      ImGui::Button("build");
      ImGui::End();
    };
    screen.gui.handle(PointerMoveEvent{60, 90});
    screen.show(panels);
    return screen.show(panels);
  };
  const auto onEgl = form(GlProvider::kEgl);
  EXPECT_TRUE(onEgl == form(GlProvider::kOsMesa));
  EXPECT_THAT(std::vector(onEgl.begin(), onEgl.end()), testing::Contains(pixelOf(kGuiAccent)));
}

}  // namespace
}  // namespace ocelli
