#include "oc_core/scene/scene_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

using Bytes = std::vector<std::byte>;

Bytes written(const SceneRecord& record) {
  Bytes bytes;
  writeSceneRecord(record,
                   [&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
  return bytes;
}

SceneRecord read(const Bytes& bytes) {
  return sceneFromRecord(bytes, "reader");
}

/// One of everything.
SceneRecord sample() {
  SceneRecord record;
  record.warnings = {"a texture is missing", ""};
  record.textures.push_back({Image<Rgb8>(2, 1, Rgb8(1, 2, 3)), TextureWrap::kMirror, TextureWrap::kClamp});
  TexturedMesh part;
  part.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  part.mesh.colors = {{0, 0.5f, 1}, {1, 1, 1}, {0, 0, 0}};
  part.mesh.triangles = {{0, 1, 2}};
  part.base = TextureLayer{0, {{0, 0}, {1, 0}, {0, 1}}};
  part.emission = {0, 2, 0};
  part.emissive = TextureLayer{0, {{5, 5}, {6, 6}, {7, 7}}};
  part.mask = TextureLayer{0, {{8, 8}, {9, 9}, {1, 1}}};
  part.maskCutoff = 0.75f;
  part.isUnlit = true;
  part.lines = {{0, 2}};
  part.points = {2, 1};
  record.parts = {part, TexturedMesh{}};
  glm::mat4 moved(1);
  moved[3] = {1, 2, 3, 1};
  record.instances = {{0, moved}, {1, glm::mat4(1)}, {0, glm::mat4(1)}};
  return record;
}

/// The same with all that a rig has.
SceneRecord sampleWithRig() {
  SceneRecord record = sample();
  Rig rig;
  rig.warnings = {"something is not played"};
  rig.nodes = {{kNoRigParent, glm::mat4(2)}, {0, glm::mat4(1)}};
  rig.instanceNodes = {1, 0, 1};
  rig.parts.resize(2);
  rig.parts[0].bones = {{1, glm::mat4(3)}, {0, glm::mat4(1)}};
  rig.parts[0].first = {0, 1, 3, 3};
  rig.parts[0].weights = {{0, 1}, {0, 0.25f}, {1, 0.75f}};
  rig.parts[0].morphs = {{{{1, 2, 3}, {0, 0, 0}, {4, 5, 6}}, 0.5f}};
  rig.animations = {{"walk",
                     {{1, RigTarget::kRotation, false, 4, {0, 0.5f}, {0, 0, 0, 1, 1, 0, 0, 0}},
                      {0, RigTarget::kWeights, true, 2, {1}, {7, 8}},
                      {0, RigTarget::kPosition, false, 3, {1}, {7, 8, 9}, {1, 2, 3, 4, 5, 6}}}}};
  record.rig = rig;
  return record;
}

void expectRefused(const Bytes& bytes, const std::string& why) {
  EXPECT_THAT([&] { read(bytes); }, ThrowsMessage<WorkError>(HasSubstr(why)));
}

TEST(SceneRecord, ComesBackAsItWas) {
  const SceneRecord back = read(written(sample()));
  EXPECT_THAT(back.warnings, ElementsAre("a texture is missing", ""));
  ASSERT_EQ(back.textures.size(), 1u);
  EXPECT_EQ(back.textures[0].image.width(), 2);
  EXPECT_EQ(back.textures[0].image(1, 0), Rgb8(1, 2, 3));
  EXPECT_EQ(back.textures[0].wrapU, TextureWrap::kMirror);
  EXPECT_EQ(back.textures[0].wrapV, TextureWrap::kClamp);
  ASSERT_EQ(back.parts.size(), 2u);
  EXPECT_EQ(back.parts[0].mesh.positions, sample().parts[0].mesh.positions);
  EXPECT_EQ(back.parts[0].mesh.colors, sample().parts[0].mesh.colors);
  EXPECT_EQ(back.parts[0].mesh.triangles, sample().parts[0].mesh.triangles);
  EXPECT_EQ(back.parts[0].base->uvs, sample().parts[0].base->uvs);
  EXPECT_EQ(back.parts[0].emission, glm::vec3(0, 2, 0));
  EXPECT_EQ(back.parts[0].emissive->uvs[2], glm::vec2(7, 7));
  EXPECT_EQ(back.parts[0].mask->uvs[1], glm::vec2(9, 9));
  EXPECT_EQ(back.parts[0].maskCutoff, 0.75f);
  EXPECT_TRUE(back.parts[0].isUnlit);
  EXPECT_THAT(back.parts[0].lines, ElementsAre(glm::uvec2(0, 2)));
  EXPECT_THAT(back.parts[0].points, ElementsAre(2, 1));
  EXPECT_FALSE(back.parts[1].base || back.parts[1].emissive || back.parts[1].mask || back.parts[1].isUnlit);
  ASSERT_EQ(back.instances.size(), 3u);
  EXPECT_EQ(back.instances[0].worldFromMesh[3], glm::vec4(1, 2, 3, 1));
  EXPECT_EQ(back.instances[1].mesh, 1u);
}

TEST(SceneRecord, BringsBackTheRig) {
  const Bytes bytes = written(sampleWithRig());
  const SceneRecord back = read(bytes);
  EXPECT_EQ(written(back), bytes);
  EXPECT_FALSE(read(written(sample())).rig);
  ASSERT_TRUE(back.rig);
  EXPECT_THAT(back.rig->warnings, ElementsAre("something is not played"));
  EXPECT_EQ(back.rig->nodes[0].parentFromNode, glm::mat4(2));
  EXPECT_EQ(back.rig->nodes[1].parent, 0u);
  EXPECT_THAT(back.rig->instanceNodes, ElementsAre(1, 0, 1));
  const RigPart& part = back.rig->parts[0];
  EXPECT_EQ(part.bones[0].boneFromMesh, glm::mat4(3));
  EXPECT_THAT(part.first, ElementsAre(0, 1, 3, 3));
  EXPECT_EQ(part.weights[2].weight, 0.75f);
  EXPECT_EQ(part.morphs[0].offsets[2], glm::vec3(4, 5, 6));
  EXPECT_TRUE(back.rig->parts[1].bones.empty());
  const RigAnimation& walk = back.rig->animations[0];
  EXPECT_EQ(walk.name, "walk");
  EXPECT_EQ(walk.seconds(), 1);
  EXPECT_THAT(walk.channels[0].values, ElementsAre(0, 0, 0, 1, 1, 0, 0, 0));
  EXPECT_TRUE(walk.channels[1].steps);
  EXPECT_FALSE(walk.channels[2].steps);
  EXPECT_THAT(walk.channels[2].tangents, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(SceneRecord, RefusesRigsThatCannotBe) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const auto refusedWith = [](const std::function<void(Rig&)>& spoil) {
    SceneRecord record = sampleWithRig();
    spoil(*record.rig);
    EXPECT_THROW(read(written(record)), WorkError);
  };
  refusedWith([](Rig& rig) { rig.nodes[0].parent = 0; });
  refusedWith([](Rig& rig) { rig.nodes[1].parent = 1; });
  refusedWith([](Rig& rig) { rig.nodes[1].parentFromNode[2][1] = kNan; });
  refusedWith([](Rig& rig) { rig.instanceNodes[1] = 2; });
  refusedWith([](Rig& rig) { rig.parts[0].bones[1].node = 2; });
  refusedWith([](Rig& rig) { rig.parts[0].first = {0, 1, 3, 2}; });
  refusedWith([](Rig& rig) { rig.parts[0].first = {0, 4, 3, 3}; });
  refusedWith([](Rig& rig) { rig.parts[0].first = {1, 1, 3, 3}; });
  refusedWith([](Rig& rig) { rig.parts[0].weights[2].bone = 2; });
  refusedWith([](Rig& rig) { rig.parts[0].weights[0].weight = 0.9f; });
  refusedWith([](Rig& rig) { rig.parts[0].weights[0].weight = kNan; });
  refusedWith([](Rig& rig) { rig.parts[0].weights = {{0, 1}, {0, -0.25f}, {1, 1.25f}}; });
  refusedWith([](Rig& rig) { rig.parts[0].morphs[0].weight = kNan; });
  refusedWith([](Rig& rig) { rig.parts[0].morphs[0].offsets[1].x = kNan; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[0].node = 2; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[2].tangents[5] = kNan; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[2].tangents.pop_back(); });
  refusedWith([](Rig& rig) { rig.animations[0].channels[0].target = static_cast<RigTarget>(4); });
  refusedWith([](Rig& rig) { rig.animations[0].channels[0].times = {0.5f, 0.5f}; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[0].times = {-1, 0.5f}; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[0].times = {0, kNan}; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[0].values[3] = kNan; });
  refusedWith([](Rig& rig) { rig.animations[0].channels[1].width = 0; });
  refusedWith([](Rig& rig) { rig.animations[0].channels.clear(); });  // takes no time
}

TEST(SceneRecord, GivesTheMessageOfAFailureAsItIs) {
  Bytes bytes;
  const std::string message = "a.obj: cannot read this\n  try: another one";
  writeFailureRecord(message,
                     [&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
  EXPECT_THAT([&] { read(bytes); }, ThrowsMessage<InputError>(message));
}

TEST(SceneRecord, IsRefusedWhereverItEnds) {
  const Bytes whole = written(sampleWithRig());
  for (size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(read(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), WorkError) << size;
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  expectRefused(longer, "left over");
}

// Each number of 32 bits becomes one that no record of this size can hold.
TEST(SceneRecord, NeverTrustsANumber) {
  const Bytes whole = written(sampleWithRig());
  size_t refused = 0;
  for (size_t at = 0; at + 4 <= whole.size(); ++at) {
    Bytes changed = whole;
    const uint32_t huge = 0xfffffff0;
    std::memcpy(changed.data() + at, &huge, sizeof(huge));
    try {
      read(changed);
    } catch (const WorkError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50u);
}

// The one spelling of a mesh without vertices has no colours: what is read is written back as the same bytes.
TEST(SceneRecord, RefusesColorsOfNoVertices) {
  SceneRecord record;
  record.parts.resize(1);
  Bytes bytes = written(record);
  EXPECT_EQ(written(read(bytes)), bytes);
  // Start, kind, counts of warnings, textures and parts, of vertices and triangles; then what the mesh holds.
  const size_t flags = 8 + 6 * sizeof(uint32_t);
  ASSERT_EQ(bytes[flags], std::byte{0});
  bytes[flags] = std::byte{1};
  expectRefused(bytes, "without vertices has colours");
}

TEST(SceneRecord, RefusesCornersThatAreNotThere) {
  SceneRecord record = sample();
  record.parts[0].mesh.triangles[0].z = 3;
  expectRefused(written(record), "corner");
}

TEST(SceneRecord, RefusesColorsOutOfRange) {
  for (const float bad : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()}) {
    SceneRecord record = sample();
    record.parts[0].mesh.colors[1].y = bad;
    expectRefused(written(record), "colour");
  }
}

TEST(SceneRecord, RefusesWhatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    SceneRecord record = sample();
    record.parts[0].emission.x = bad;
    expectRefused(written(record), "emission");
    record = sample();
    record.parts[0].maskCutoff = bad;
    expectRefused(written(record), "cutoff");
    record = sample();
    record.instances[0].worldFromMesh[2][1] = bad;
    expectRefused(written(record), "no number");
  }
}

TEST(SceneRecord, RefusesTexturesAndMeshesThatAreNotThere) {
  SceneRecord record = sample();
  record.parts[0].emissive->texture = 1;
  expectRefused(written(record), "texture that is not there");
  record = sample();
  record.parts[0].lines[0].y = 3;
  expectRefused(written(record), "line or a point");
  record = sample();
  record.parts[0].points[1] = 3;
  expectRefused(written(record), "line or a point");
  record = sample();
  record.instances[2].mesh = 2;
  expectRefused(written(record), "mesh that is not there");
}

}  // namespace
}  // namespace ocelli
