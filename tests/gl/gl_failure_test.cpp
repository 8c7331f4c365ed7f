// What cannot be done says what, where and what to do next, and leaves nothing behind.
#include <gmock/gmock.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <string>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/shared_library.h"
#include "oc_core/window/gl_report.h"
#include "oc_core/window/gl_window.h"
#include "oc_core/window/gui_layer.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The message of the GlError that `work` throws.
std::string messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const GlError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// What every message holds: a next step, and the way without a GPU.
auto says(const std::string& what, const std::string& where) {
  return AllOf(HasSubstr(what), HasSubstr(where), HasSubstr("\n  try: "), HasSubstr("without OpenGL, on the CPU"));
}

/// Opens nothing: its functions are those that a test gives.
class FakePlatform final : public GlPlatform {
 public:
  FakePlatform(bool current, Function getString) : current_(current), getString_(getString) {}

  bool makeCurrent() override { return current_; }
  void release() override {}
  Function function(const char* name) const override {
    return std::string(name) == "glGetString" ? getString_ : nullptr;
  }

 private:
  bool current_;
  Function getString_;
};

std::string messageOfFake(bool current, GlPlatform::Function getString) {
  return messageOf([&] { GlContext(GlProvider::kWindow, std::make_unique<FakePlatform>(current, getString)); });
}

TEST(GlFailureTest, aDriverBelow45IsNamedWithItsVersion) {
  const auto getString = +[](GLenum) -> const GLubyte* { return reinterpret_cast<const GLubyte*>("3.3 (Core) Old"); };
  EXPECT_THAT(messageOfFake(true, reinterpret_cast<GlPlatform::Function>(getString)),
              says("OpenGL 4.5 is needed, and this driver has \"3.3 (Core) Old\"", "window"));
}

TEST(GlFailureTest, aDriverWithoutFunctionsIsNone) {
  EXPECT_THAT(messageOfFake(true, nullptr), says("none that could be loaded", "window"));
}

TEST(GlFailureTest, aContextThatCannotBeMadeCurrentSaysSo) {
  EXPECT_THAT(messageOfFake(false, nullptr), says("cannot be made current", "window"));
}

TEST(GlFailureTest, aLibraryThatIsNotInstalledIsNamed) {
  EXPECT_THAT(messageOf([] { SharedLibrary("libNoSuchEGL.so.1", "libegl1"); }),
              says("install libegl1", "libNoSuchEGL"));
}

TEST(GlFailureTest, aLibraryWithoutAFunctionIsNamed) {
  const SharedLibrary library("libm.so.6", "libc6");
  EXPECT_NE(library.get<double(double)>("cos"), nullptr);
  EXPECT_EQ(library.find("glNoSuchFunction"), nullptr);
  EXPECT_THAT(messageOf([&] { library.get<void()>("glNoSuchFunction"); }), says("glNoSuchFunction", "libm.so.6"));
}

TEST(GlFailureTest, anUnknownProviderIsAnInputError) {
  EXPECT_THROW(openGlContext("vulkan", "--gl"), InputError);
}

/// The environment of the drivers, which they read once: each of these runs in a process of its own.
class GlEnvironmentDeathTest : public testing::Test {
 protected:
  GlEnvironmentDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  /// Ends the process with the message of what opening a context throws.
  [[noreturn]] static void openAndEnd(const std::function<void()>& open) {
    std::fputs(messageOf(open).c_str(), stderr);
    std::_Exit(0);
  }
};

constexpr const char* kOnTheCpu = "without OpenGL, on the CPU";

TEST_F(GlEnvironmentDeathTest, everyProviderRefusesADriverBelow45) {
  setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
  for (const GlProvider provider : {GlProvider::kEgl, GlProvider::kOsMesa}) {
    EXPECT_EXIT(openAndEnd([&] { openGlContext(provider); }), testing::ExitedWithCode(0),
                AllOf(HasSubstr("OpenGL 4.5"), HasSubstr(nameOf(provider)), HasSubstr(kOnTheCpu)));
  }
  EXPECT_EXIT(openAndEnd([] { openOffscreenContext(); }), testing::ExitedWithCode(0),
              AllOf(HasSubstr("neither EGL nor OSMesa"), HasSubstr("OpenGL 4.5"), HasSubstr("ocelli doctor"),
                    HasSubstr(kOnTheCpu)));
  unsetenv("MESA_GL_VERSION_OVERRIDE");
}

TEST_F(GlEnvironmentDeathTest, eglWithoutADriverSaysWhatToInstall) {
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
  EXPECT_EXIT(openAndEnd([] { openGlContext(GlProvider::kEgl); }), testing::ExitedWithCode(0),
              AllOf(HasSubstr("EGL: it has no driver"), HasSubstr("install libgl1-mesa-dri"), HasSubstr(kOnTheCpu)));
  // The next provider takes its place.
  EXPECT_EXIT(std::fputs(nameOf(openOffscreenContext()->info().provider), stderr); std::_Exit(0);
              , testing::ExitedWithCode(0), "OSMesa");
  unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
}

TEST_F(GlEnvironmentDeathTest, withoutADisplayThereIsNoWindow) {
  const char* display = std::getenv("DISPLAY");
  const std::string before = display != nullptr ? display : "";
  unsetenv("DISPLAY");
  EXPECT_EXIT(openAndEnd([] { GlWindow({}); }), testing::ExitedWithCode(0),
              AllOf(HasSubstr("no display"), HasSubstr("set DISPLAY"), HasSubstr("--offscreen"), HasSubstr(kOnTheCpu)));
  setenv("DISPLAY", ":987", 1);
  EXPECT_EXIT(openAndEnd([] { GlWindow({}); }), testing::ExitedWithCode(0),
              AllOf(HasSubstr("no display"), HasSubstr("DISPLAY=:987"), HasSubstr("--offscreen")));
  display != nullptr ? setenv("DISPLAY", before.c_str(), 1) : unsetenv("DISPLAY");
}

/// The errors of its context do not end the test: they are what is tested.
class GlFailureOnTest : public testing::TestWithParam<GlProvider> {
 protected:
  std::unique_ptr<GlContext> context_ = openGlContext(GetParam());
  GlScope scope_{*context_};
  std::string provider_ = nameOf(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlFailureOnTest, kOffscreenProviders, providerName);

GLenum GLAD_API_PTR reportReset() {
  return GL_INNOCENT_CONTEXT_RESET;
}

TEST_P(GlFailureOnTest, aLostContextIsReportedByWhateverComesNext) {
  {
    GuiLayer gui(*context_, 1);
    const GlObject before = makeBuffer(*context_, 16);
    context_->functions().GetGraphicsResetStatus = reportReset;
    const auto isLost = says("context is lost", provider_);
    std::array<char, 16> bytes{};
    EXPECT_THAT(messageOf([&] { makeBuffer(*context_, 16); }), isLost);
    EXPECT_THAT(messageOf([&] { makeTexture(*context_, GL_RGBA8, 4, 4); }), isLost);
    EXPECT_THAT(messageOf([&] { readBuffer(*context_, before, bytes.size(), bytes.data()); }), isLost);
    EXPECT_THAT(messageOf([&] { GuiLayer(*context_, 1); }), isLost);
  }
  EXPECT_EQ(context_->liveObjects(), 0);
}

thread_local int errorsToReport = 0;

GLenum GLAD_API_PTR reportOutOfMemory() {
  return errorsToReport-- > 0 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

TEST_P(GlFailureOnTest, aFullGpuIsReported) {
  context_->functions().GetError = reportOutOfMemory;
  errorsToReport = 2;
  EXPECT_THAT(messageOf([&] { makeBuffer(*context_, 1 << 20); }), says("not enough memory", provider_));
  errorsToReport = 1;
  EXPECT_THAT(messageOf([&] { makeTexture(*context_, GL_RGBA8, 64, 64); }), says("not enough memory", "64x64"));
  EXPECT_EQ(context_->liveObjects(), 0);
  EXPECT_EQ(makeBuffer(*context_, 16).id() != 0, true) << "what fits works on";
}

TEST_P(GlFailureOnTest, whatIsLargerThanTheGpuAllowsIsRefusedBeforeItIsTried) {
  const GlInfo& info = context_->info();
  const auto tooMuch = static_cast<size_t>(info.maxStorageBytes) + 1;
  EXPECT_THAT(messageOf([&] { makeBuffer(*context_, tooMuch); }),
              says(std::to_string(info.maxStorageBytes >> 20) + " MiB", provider_));
  EXPECT_THAT(messageOf([&] { makeTexture(*context_, GL_R8, info.maxTextureSize + 1, 1); }),
              says(std::to_string(info.maxTextureSize + 1) + "x1", provider_));
  EXPECT_THAT(messageOf([&] { makeTexture(*context_, GL_R8, 1, info.maxTextureSize + 1); }),
              says("1x" + std::to_string(info.maxTextureSize + 1), provider_));
  EXPECT_THAT(messageOf([&] { makeTextureLayers(*context_, GL_R8, 1, 1, info.maxTextureLayers + 1); }),
              says(std::to_string(info.maxTextureLayers + 1) + " layers", provider_));
  EXPECT_EQ(context_->liveObjects(), 0);
}

TEST_P(GlFailureOnTest, aFramebufferThatNobodyCanDrawToIsRefused) {
  const GlObject wrong = makeTexture(*context_, GL_RGB9_E5, 4, 4);  // no format that OpenGL 4.5 draws to
  EXPECT_THAT(messageOf([&] { makeFramebuffer(*context_, std::array{wrong.id()}, 0); }),
              says("cannot draw", provider_));
}

TEST_P(GlFailureOnTest, aShaderThatDoesNotCompileShowsTheLog) {
  EXPECT_THAT(messageOf([&] {
                makeProgram(*context_, "broken", {{GL_VERTEX_SHADER, {"void main() { gl_Position = noSuchName; }"}}});
              }),
              AllOf(says("does not compile", "shader broken"), HasSubstr(provider_), HasSubstr("noSuchName")));
  EXPECT_EQ(context_->liveObjects(), 0);
}

TEST_P(GlFailureOnTest, stagesThatDoNotFitShowTheLog) {
  EXPECT_THAT(messageOf([&] {
                makeProgram(*context_, "unfit",
                            {{GL_VERTEX_SHADER, {"void helper(); void main() { helper(); }"}},
                             {GL_FRAGMENT_SHADER, {"out vec4 color; void main() { color = vec4(1); }"}}});
              }),
              says("does not link", "shader unfit"));
  EXPECT_EQ(context_->liveObjects(), 0);
}

TEST_P(GlFailureOnTest, aRefusedCallIsNamed) {
  context_->gl().Enable(0);
  EXPECT_THAT(messageOf([&] { context_->check("testing"); }),
              AllOf(says("GL_INVALID_ENUM", provider_), HasSubstr("testing")));
  context_->check("testing again");  // told once
}

TEST(GlReportTest, tellsOfEveryProviderInTurn) {
  const std::vector<GlProviderReport> reports = reportGlProviders();
  ASSERT_EQ(reports.size(), 3);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(reports[i].provider, (std::array{GlProvider::kEgl, GlProvider::kOsMesa, GlProvider::kWindow})[i]);
    EXPECT_NE(reports[i].info.has_value(), !reports[i].error.empty()) << "either works, or says why not";
    EXPECT_THAT(packagesOf(reports[i].provider), testing::Contains(HasSubstr("lib")));
  }
  ASSERT_TRUE(reports[0].info.has_value()) << reports[0].error;
  ASSERT_TRUE(reports[1].info.has_value()) << reports[1].error;
  EXPECT_EQ(reports[0].info->renderer, openTestContext(GlProvider::kEgl)->info().renderer);
}

}  // namespace
}  // namespace ocelli
