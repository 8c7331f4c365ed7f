// How a driver computes what shaders mark as `precise`: the slicer takes operations on doubles for those of the
// processor.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/gl/gl_program.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

constexpr size_t kCount = 1 << 16;

/// An expression of a, b and c in GLSL after the statements `before`, and the same on the CPU.
template <class Real>
struct Operation {
  const char* name;
  const char* before;
  const char* expression;
  Real (*onCpu)(Real a, Real b, Real c);
};

template <class Real>
std::vector<Operation<Real>> sumsAndProducts() {
  return {{"product", "", "a * b", [](Real a, Real b, Real) { return a * b; }},
          {"sum", "", "a + b", [](Real a, Real b, Real) { return a + b; }},
          {"difference", "", "a - b", [](Real a, Real b, Real) { return a - b; }},
          {"product and sum", "", "a * b + c", [](Real a, Real b, Real c) { return a * b + c; }},
          {"two products", "", "a * b - c * c", [](Real a, Real b, Real c) { return a * b - c * c; }},
          {"mix", "", "a + (b - a) * c", [](Real a, Real b, Real c) { return a + (b - a) * c; }},
          {"smaller", "", "min(a, b)", [](Real a, Real b, Real) { return std::min(a, b); }},
          {"larger", "", "max(a, b)", [](Real a, Real b, Real) { return std::max(a, b); }}};
}

/// What OpenGL does not promise, and the slicer needs: quotients and whole parts of doubles, and how they can be kept.
std::vector<Operation<double>> ofDoubles() {
  return {{"quotient", "", "a / b", [](double a, double b, double) { return a / b; }},
          {"clamped", "", "clamp(a / b, 0.0LF, 1.0LF)",
           [](double a, double b, double) { return std::clamp(a / b, 0.0, 1.0); }},
          {"whole part", "", "double(int(a * b))",
           [](double a, double b, double) { return static_cast<double>(static_cast<int>(a * b)); }},
          {"words in an array", "uvec2 kept[3]; for (int k = 0; k < 3; ++k) { kept[k] = unpackDouble2x32(a * k); }",
           "packDouble2x32(kept[abs(int(b)) % 3])",
           [](double a, double b, double) { return a * (std::abs(static_cast<int>(b)) % 3); }},
          {"shared memory", "for (int k = 0; k < 3; ++k) { together[gl_LocalInvocationID.x][k] = a * k; }",
           "together[gl_LocalInvocationID.x][abs(int(b)) % 3]",
           [](double a, double b, double) { return a * (std::abs(static_cast<int>(b)) % 3); }}};
}

/// Numbers as a slicer has them: many are whole, or halves and quarters, the others any. None is 0.
template <class Real>
std::vector<Real> inputs() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1000, 1000);
  std::uniform_int_distribution<int> eighths(-800, 800);
  std::vector<Real> numbers(3 * kCount);
  for (Real& number : numbers) {
    number = static_cast<Real>(random() % 2 == 0 ? any(random) : eighths(random) / 8.0);
    number = number == 0 ? Real{1} : number;
  }
  return numbers;
}

/// They are read from a buffer, so that no compiler knows them.
constexpr const char* kShader = R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { REAL from[]; };
layout(std430, binding = 1) writeonly buffer Out { REAL to[]; };
shared double together[64][3];
void main() {
  uint i = gl_GlobalInvocationID.x;
  REAL a = from[3 * i];
  REAL b = from[3 * i + 1];
  REAL c = from[3 * i + 2];
  BEFORE
  precise REAL value = EXPRESSION;
  to[i] = value;
}
)";

template <class Real>
std::vector<Real> onGpu(GlContext& context, const Operation<Real>& operation, const std::vector<Real>& numbers) {
  const std::string defines = std::string("#define REAL ") + (sizeof(Real) == 8 ? "double" : "float") +
                              "\n#define BEFORE " + operation.before + "\n#define EXPRESSION " + operation.expression +
                              "\n";
  const GladGLContext& gl = context.gl();
  const GlObject program = makeProgram(context, operation.name, {{GL_COMPUTE_SHADER, {kShader}}}, defines);
  const GlObject from = makeBuffer(context, numbers);
  const GlObject to = makeBuffer(context, kCount * sizeof(Real));
  gl.UseProgram(program.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, from.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, to.id());
  gl.DispatchCompute(kCount / 64, 1, 1);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<Real> results(kCount);
  readBuffer(context, to, kCount * sizeof(Real), results.data());
  return results;
}

class GlArithmeticTest : public testing::TestWithParam<GlProvider> {
 protected:
  template <class Real>
  void expectTheCpus(const std::vector<Operation<Real>>& operations) {
    const GlScope scope(*context_);
    const std::vector<Real> numbers = inputs<Real>();
    for (const Operation<Real>& operation : operations) {
      const std::vector<Real> results = onGpu(*context_, operation, numbers);
      size_t differing = 0;
      Real largest = 0;
      for (size_t i = 0; i < kCount; ++i) {
        const Real expected = operation.onCpu(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
        differing += results[i] != expected ? 1 : 0;
        largest = std::max(largest, std::abs(results[i] - expected));
      }
      EXPECT_EQ(differing, 0u) << operation.name << " of " << kCount << ", by up to " << largest;
    }
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlArithmeticTest, kOffscreenProviders, providerName);

TEST_P(GlArithmeticTest, doublesAreTheCpus) {
  expectTheCpus(sumsAndProducts<double>());
  expectTheCpus(ofDoubles());
}
TEST_P(GlArithmeticTest, sumsAndProductsOfFloatsAreTheCpus) {
  expectTheCpus(sumsAndProducts<float>());
}

}  // namespace
}  // namespace ocelli
