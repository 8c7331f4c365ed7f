#include "oc_core/ocri/simplified_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

constexpr SimplifyMethod kMethods[] = {SimplifyMethod::kTopological, SimplifyMethod::kSloppy};

Mesh colouredBall() {
  Mesh ball = makeSphere(60);
  for (const glm::vec3& p : ball.positions) {
    ball.colors.push_back(p * 0.5f + 0.5f);
  }
  return ball;
}

/// Every triangle with vertices of its own.
Mesh soup(const Mesh& mesh) {
  Mesh apart;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto first = static_cast<uint32_t>(apart.positions.size());
    for (int i = 0; i < 3; ++i) {
      apart.positions.push_back(mesh.positions[t[i]]);
      apart.colors.push_back(mesh.colors[t[i]]);
    }
    apart.triangles.emplace_back(first, first + 1, first + 2);
  }
  return apart;
}

TEST(SimplifyMesh, keepsToTheTarget) {
  const Mesh ball = colouredBall();
  for (const SimplifyMethod method : kMethods) {
    const SimplifiedMesh simplified = simplifyMesh(ball, 500, method);
    EXPECT_TRUE(simplified.reachedTarget());
    EXPECT_EQ(simplified.targetTriangles, 500u);
    EXPECT_LE(simplified.mesh.triangles.size(), 500u);
    EXPECT_GT(simplified.mesh.triangles.size(), 100u);
    EXPECT_LT(simplified.mesh.positions.size(), ball.positions.size());
    EXPECT_GT(simplified.error, 0);
    EXPECT_LT(simplified.error, 0.2f) << "of a ball of radius 1";
    EXPECT_NO_THROW(validate(simplified.mesh, "simplified"));
  }
}

TEST(SimplifyMesh, verticesKeepTheirColours) {
  for (const SimplifyMethod method : kMethods) {
    const Mesh mesh = simplifyMesh(colouredBall(), 500, method).mesh;
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      EXPECT_EQ(mesh.colors[i], mesh.positions[i] * 0.5f + 0.5f);
    }
  }
}

TEST(SimplifyMesh, trianglesThatShareNoVertexAreWelded) {
  const Mesh ball = colouredBall();
  const SimplifiedMesh whole = simplifyMesh(ball, 500, SimplifyMethod::kTopological);
  const SimplifiedMesh apart = simplifyMesh(soup(ball), 500, SimplifyMethod::kTopological);
  EXPECT_TRUE(apart.reachedTarget());
  EXPECT_EQ(apart.mesh.triangles.size(), whole.mesh.triangles.size());
}

TEST(SimplifyMesh, aFlatSquareNeedsTwoTriangles) {
  constexpr int kLines = 21;
  Mesh square;
  for (int y = 0; y < kLines; ++y) {
    for (int x = 0; x < kLines; ++x) {
      square.positions.emplace_back(x, y, 0);
    }
  }
  for (uint32_t y = 0; y + 1 < kLines; ++y) {
    for (uint32_t x = 0; x + 1 < kLines; ++x) {
      const uint32_t a = y * kLines + x;
      square.triangles.emplace_back(a, a + 1, a + kLines + 1);
      square.triangles.emplace_back(a, a + kLines + 1, a + kLines);
    }
  }
  const SimplifiedMesh simplified = simplifyMesh(square, 2, SimplifyMethod::kTopological);
  EXPECT_TRUE(simplified.reachedTarget());
  EXPECT_EQ(simplified.mesh.triangles.size(), 2u);
  EXPECT_TRUE(simplified.mesh.colors.empty());
  EXPECT_NEAR(simplified.error, 0, 1e-3f) << "of a side of 20: nothing left the plane";
}

TEST(SimplifyMesh, saysWhenTheTopologyStoodInTheWay) {
  // A board of squares, each of one colour of its own: four vertices lie where four squares meet, and stay.
  Mesh board;
  for (int i = 0; i < 100; ++i) {
    const float x = static_cast<float>(i % 10);
    const float y = static_cast<float>(i / 10);
    test::addQuad(board, {x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0},
                  glm::vec3(static_cast<float>(i) / 100));
  }
  const SimplifiedMesh simplified = simplifyMesh(board, 50, SimplifyMethod::kTopological);
  EXPECT_FALSE(simplified.reachedTarget());
  EXPECT_GT(simplified.mesh.triangles.size(), 100u);
  EXPECT_TRUE(simplifyMesh(board, 50, SimplifyMethod::kSloppy).reachedTarget());
}

TEST(SimplifyMesh, aTargetThatIsMetAlreadyChangesNothing) {
  const Mesh ball = colouredBall();
  for (const SimplifyMethod method : kMethods) {
    const SimplifiedMesh simplified = simplifyMesh(ball, ball.triangles.size(), method);
    EXPECT_EQ(simplified.mesh.triangles.size(), ball.triangles.size());
    EXPECT_EQ(simplified.error, 0);
  }
}

TEST(SimplifyMesh, refusesNothingToSimplifyAndNothingToLeave) {
  for (const SimplifyMethod method : kMethods) {
    EXPECT_THROW(simplifyMesh({}, 10, method), InputError);
    EXPECT_THROW(simplifyMesh(colouredBall(), 0, method), InputError);
    Mesh broken = colouredBall();
    broken.triangles[3].y = 1 << 30;
    EXPECT_THROW(simplifyMesh(broken, 10, method), InputError);
  }
}

}  // namespace
}  // namespace ocelli
