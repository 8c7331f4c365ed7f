#include "oc_core/gl/gl_context.h"

#include <gmock/gmock.h>

#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/gl/gl_program.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

class GlContextTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, GlContextTest, kOffscreenProviders, providerName);

/// Draws a triangle over the whole of a small image and returns its pixels.
Image<std::array<uint8_t, 4>> drawnOrange(GlContext& context) {
  const GlScope scope(context);
  const GladGLContext& gl = context.gl();
  const GlObject color = makeTexture(context, GL_RGBA8, 3, 2);
  const std::array<uint32_t, 1> colors{color.id()};
  const GlObject framebuffer = makeFramebuffer(context, colors, 0);
  const GlObject vertices = makeVertexArray(context);
  const GlObject program =
      makeProgram(context, "orange",
                  {{GL_VERTEX_SHADER,
                    {"void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0, 1); }"}},
                   {GL_FRAGMENT_SHADER, {"layout(location = 0) out vec4 color; void main() { color = ORANGE; }"}}},
                  "#define ORANGE vec4(1, 0.6, 0, 1)\n");
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.Viewport(0, 0, 3, 2);
  gl.BindVertexArray(vertices.id());
  gl.UseProgram(program.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  return readTexture<std::array<uint8_t, 4>>(context, color, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE);
}

TEST_P(GlContextTest, saysWhatItIs) {
  const auto context = openTestContext(GetParam());
  EXPECT_EQ(context->info().provider, GetParam());
  EXPECT_GE(std::stod(context->info().version), 4.5);
  EXPECT_FALSE(context->info().renderer.empty());
  EXPECT_GE(context->info().maxTextureSize, 16384);  // what OpenGL 4.5 promises
  EXPECT_GE(context->info().maxStorageBytes, 1 << 27);
}

TEST_P(GlContextTest, draws) {
  const auto context = openTestContext(GetParam());
  for (const std::array<uint8_t, 4>& pixel : drawnOrange(*context)) {
    EXPECT_EQ(pixel, (std::array<uint8_t, 4>{255, 153, 0, 255}));
  }
  EXPECT_EQ(context->liveObjects(), 0);
}

TEST_P(GlContextTest, isMadeAndDestroyedAHundredTimes) {
  for (int i = 0; i < 100; ++i) {
    const auto context = openTestContext(GetParam());
    const GlScope scope(*context);
    const GlObject buffer = makeBuffer(*context, 1 << 20);
    EXPECT_EQ(context->liveObjects(), 1);
  }
}

TEST(GlContextTest, providersTakeTurnsOnOneThread) {
  const auto egl = openTestContext(GlProvider::kEgl);
  const auto osMesa = openTestContext(GlProvider::kOsMesa);
  const GlScope scope(*egl);
  const auto onOsMesa = drawnOrange(*osMesa);
  EXPECT_EQ(drawnOrange(*egl), onOsMesa);
  egl->check("drawing");  // is the current one again
}

}  // namespace
}  // namespace ocelli
