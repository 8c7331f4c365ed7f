#include "oc_core/labels/label_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/drawing/text_outline.h"

namespace ocelli {
namespace {

SceneLabel labelOf(const std::string& text, const glm::vec3& position = glm::vec3(0)) {
  SceneLabel label;
  label.position = position;
  label.text = text;
  return label;
}

Mesh meshOf(const SceneLabel& label, const LabelLook& look = {}) {
  return meshOfLabels({label}, look, "here");
}

constexpr float kFloatRounding = 1e-5f;

// "H" is as high as a capital letter, and symmetric.
TEST(LabelMesh, HasItsMiddleAtItsPlaceAndItsSize) {
  SceneLabel label = labelOf("H", {1, 2, 3});
  label.size = 0.5;
  label.color = {1, 0.5f, 0};
  const Mesh mesh = meshOf(label);
  const Box box = boundsOf(mesh);
  EXPECT_NEAR(box.lower.y, 1.75f, kFloatRounding);
  EXPECT_NEAR(box.upper.y, 2.25f, kFloatRounding);
  EXPECT_NEAR((box.lower.x + box.upper.x) / 2, 1, 0.01f);  // the sides of a letter need not be alike
  EXPECT_EQ(box.lower.z, 3);
  EXPECT_EQ(box.upper.z, 3);
  EXPECT_GT(box.size().x, 0.25f);
  EXPECT_LT(box.size().x, 0.75f);
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  EXPECT_EQ(mesh.color(0), label.color);
}

// The order of corners is that of a surface seen from where the label is read.
TEST(LabelMesh, FacesWhereItIsRead) {
  for (const glm::vec3& facing : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -2), glm::vec3(3, 0, 0), glm::vec3(0, 1, 0),
                                  glm::vec3(0, -1, 0), glm::vec3(1, 2, -3)}) {
    SceneLabel label = labelOf("F1");
    label.facing = facing;
    const Mesh mesh = meshOf(label);
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec3 normal =
          glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
      EXPECT_GT(glm::dot(glm::normalize(normal), glm::normalize(facing)), 0.999f);
    }
  }
}

/// Where the ink of "L" stands, whose foot is at the lower right of its middle.
glm::vec3 footOfL(const glm::vec3& facing) {
  SceneLabel label = labelOf("L");
  label.facing = facing;
  label.size = 2;
  const Mesh mesh = meshOf(label);
  glm::vec3 sum(0);
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const double own = glm::length(
        glm::dvec3(glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x])));
    sum += static_cast<float>(own) * (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
    area += own;
  }
  return sum / static_cast<float>(area);
}

TEST(LabelMesh, StandsUpright) {
  // From the front, from the right, from above and from below: its ink is in the lower half.
  EXPECT_LT(footOfL({0, 0, 1}).y, -0.05f);
  EXPECT_LT(footOfL({1, 0, 0}).y, -0.05f);
  EXPECT_GT(footOfL({0, 1, 0}).z, 0.05f);
  EXPECT_LT(footOfL({0, -1, 0}).z, -0.05f);
}

TEST(LabelMesh, IsReadFromLeftToRight) {
  /// Where the letter, which is higher than the dot, stands along an axis.
  const auto letterAlong = [](const glm::vec3& facing, glm::length_t axis) {
    SceneLabel label = labelOf("H.");
    label.facing = facing;
    const Mesh mesh = meshOf(label);
    float highest = 0;
    float at = 0;
    for (const glm::vec3& p : mesh.positions) {
      if (p.y > highest) {
        highest = p.y;
        at = p[axis];
      }
    }
    return at;
  };
  EXPECT_LT(letterAlong({0, 0, 1}, 0), 0) << "the letter is on the left of the dot";
  EXPECT_GT(letterAlong({0, 0, -1}, 0), 0);
  EXPECT_GT(letterAlong({1, 0, 0}, 2), 0) << "who looks along -x has z on the left";
}

TEST(LabelMesh, HasLinesBelowEachOther) {
  SceneLabel label = labelOf("H\nH\nH");
  label.size = 1;
  const Box box = boundsOf(meshOf(label));
  EXPECT_NEAR(box.lower.y, -box.upper.y, kFloatRounding);
  EXPECT_NEAR(box.size().y, 1 + 2 * 1.7f, kFloatRounding);
}

TEST(LabelMesh, HoldsLettersOfManyLanguages) {
  const auto outlines = [](const char* text) {
    const std::vector<GlyphOutline> glyphs = textOutlines(text, Face::kSansBold);
    EXPECT_EQ(glyphs.size(), 1u) << text;
    return glyphs.empty() ? 0 : glyphs[0].size();
  };
  EXPECT_EQ(outlines("l"), 1u);
  EXPECT_EQ(outlines("i"), 2u);
  EXPECT_EQ(outlines("o"), 2u);
  EXPECT_EQ(outlines("\u00f6"), 4u);
  EXPECT_TRUE(textOutlines("  ", Face::kSansBold).empty());
}

TEST(LabelMesh, SaysWhereNothingIsDrawn) {
  EXPECT_THROW(meshOf(labelOf("\u00a0")), InputError);
}

}  // namespace
}  // namespace ocelli
