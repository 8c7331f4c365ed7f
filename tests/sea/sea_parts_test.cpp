// Parts of seas: directions, residuals, proxies as bytes, settings, neighbours, refined poses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/sea/direction_table.h"
#include "oc_core/sea/pose_refinement.h"
#include "oc_core/sea/proxy_bytes.h"
#include "oc_core/sea/residual.h"
#include "oc_core/sea/sea_between.h"
#include "oc_core/sea/sea_settings.h"
#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

using test::RoomImages;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(DirectionTable, HasTheDirectionsOfTheProjection) {
  const SeaProjection panorama{.width = 48, .height = 24};
  const SeaProjection pinhole{SeaProjectionKind::kPinhole, 40, 30, {35, 33}, {19, 16}};
  for (const SeaProjection& projection : {panorama, pinhole}) {
    const DirectionTable table(projection, {2 * projection.width, 2 * projection.height, 0.25f, 0.5f});
    for (int row = 0; row < 2 * projection.height; ++row) {
      for (int column = 0; column < 2 * projection.width; ++column) {
        const glm::vec3 expected = projection.direction(glm::vec2(column, row) * 0.5f + 0.25f);
        ASSERT_LT(glm::distance(table(column, row), expected), 1e-6f) << column << " " << row;
      }
    }
  }
}

TEST(Residual, GivesTheImageBackToWithinOne) {
  Random random(1);
  Image<Rgb8> image(40, 30);
  Image<Rgb8> predicted(40, 30);
  for (size_t i = 0; i < image.size(); ++i) {
    image[i] = Rgb8(random.below(256), i % 2 == 0 ? 255 : 0, 17);
    predicted[i] = Rgb8(random.below(256), i % 2 == 0 ? 0 : 255, 17);
  }
  Image<Rgb8> again = predicted;
  addResidual(again, residualOf(image, predicted));
  for (size_t i = 0; i < image.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(std::abs(int{again[i][c]} - int{image[i][c]}), 1);
    }
  }
  EXPECT_EQ(residualOf(image, image), Image<Rgb8>(40, 30, Rgb8(128)));
}

TEST(Residual, EverySumIsWhatItShouldBe) {
  // All pairs of bytes, and a rest that fills no vector.
  Image<Rgb8> predicted(256, 86);
  Image<Rgb8> residual(256, 86);
  uint8_t* known = &predicted.data()->r;
  uint8_t* more = &residual.data()->r;
  for (int i = 0; i < 3 * 256 * 86; ++i) {
    known[i] = static_cast<uint8_t>(i);
    more[i] = static_cast<uint8_t>(i >> 8);
  }
  addResidual(predicted, residual);
  for (int i = 0; i < 3 * 256 * 86; ++i) {
    ASSERT_EQ(known[i], std::clamp((i & 255) + 2 * ((i >> 8 & 255) - 128), 0, 255)) << i;
  }
}

TEST(Residual, EnergyIsTheMeanDifferenceOfLuminance) {
  const Image<Rgb8> grey(8, 8, Rgb8(100));
  EXPECT_DOUBLE_EQ(residualEnergy(grey, grey), 0);
  EXPECT_NEAR(residualEnergy(grey, Image<Rgb8>(8, 8, Rgb8(90))), 10, 1e-9);
  EXPECT_NEAR(residualEnergy(grey, Image<Rgb8>(8, 8, Rgb8(100, 110, 100))), 5.87, 1e-9);
}

TEST(ProxyBytes, GiveTheMeshBackOnAGrid) {
  const Mesh room = test::roomProxy();
  const Mesh again = proxyFromBytes(proxyBytes(room, "room"), "room");
  ASSERT_EQ(again.positions.size(), room.positions.size());
  ASSERT_EQ(again.triangles.size(), room.triangles.size());
  for (size_t i = 0; i < room.positions.size(); ++i) {
    EXPECT_LT(glm::distance(again.positions[i], room.positions[i]), 5 / 65535.0f);
  }
  EXPECT_EQ(proxyBytes(again, "again"), proxyBytes(room, "room")) << "what is stored stays as it is";
  EXPECT_TRUE(proxyFromBytes(proxyBytes(Mesh{}, "none"), "none").empty());
}

TEST(ProxyBytes, RefuseWhatIsNone) {
  const std::vector<uint8_t> bytes = proxyBytes(test::roomProxy(), "room");
  EXPECT_THROW(proxyFromBytes({}, "x"), InputError);
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(proxyFromBytes({bytes.data(), size}, "x"), InputError) << size;
  }
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::vector<uint8_t> damaged = bytes;
    damaged[random.below(damaged.size())] = static_cast<uint8_t>(random.below(256));
    try {
      const Mesh mesh = proxyFromBytes(damaged, "damaged");
      for (const glm::uvec3& triangle : mesh.triangles) {
        ASSERT_LT(std::max({triangle.x, triangle.y, triangle.z}), mesh.positions.size());
      }
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("damaged"));
    }
  }
}

TEST(SeaSettings, ComeBackFromTheirText) {
  SeaSettings settings;
  settings.source = "builtin:museum \"x\"";
  settings.projection = {SeaProjectionKind::kPinhole, 640, 480, {500.5, 501}, {320, 239.5}};
  settings.way = SeaWay::kIndirect;
  settings.spacing = 7;
  settings.iCodec = settings.pCodec = "png";
  settings.pQuality = 33.5;
  settings.refinement = "bobyqa";
  EXPECT_EQ(seaSettingsFromJson(jsonText(settings), "x"), settings);
}

TEST(SeaSettings, AreRefusedByField) {
  const auto changed = [](const std::string& from, const std::string& to) {
    SeaSettings settings;
    settings.iCodec = settings.pCodec = "png";
    std::string text = jsonText(settings);
    text.replace(text.find(from), from.size(), to);
    return [text] { seaSettingsFromJson(text, "x.sea"); };
  };
  EXPECT_THAT(changed("\"i_codec\": \"png\"", "\"i_codec\": \"gif\""), ThrowsMessage<InputError>(HasSubstr("gif")));
  EXPECT_THAT(changed("\"direct\"", "\"sideways\""), ThrowsMessage<InputError>(HasSubstr("way")));
  EXPECT_THAT(changed("\"i_spacing\": 4", "\"i_spacing\": -1"), ThrowsMessage<InputError>(HasSubstr("i_spacing")));
  EXPECT_THAT(changed("\"width\": 1024", "\"width\": 4"), ThrowsMessage<InputError>(HasSubstr("8 to 16383")));
  EXPECT_THAT(changed("\"none\"", "\"gauss\""), ThrowsMessage<InputError>(HasSubstr("gauss")));
  EXPECT_THAT(changed("\"source\"", "\"sauce\""), ThrowsMessage<InputError>(HasSubstr("source")));
}

TEST(NearestNeighbors, CountByHowNearTheyAre) {
  const std::vector<glm::dvec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {5, 0, 5}};
  const auto at = [&](const glm::dvec3& place) { return nearestNeighbors(positions, place); };
  const std::vector<SeaNeighbor> own = at({1, 0, 0});
  EXPECT_EQ(own[0].image, 1u);
  EXPECT_GT(own[0].weight, 1 - 1e-6);
  const std::vector<SeaNeighbor> between = at({0.4, 0, 0.1});
  ASSERT_EQ(between.size(), 3u);
  EXPECT_EQ(between[0].image, 0u);
  EXPECT_EQ(between[1].image, 1u);
  EXPECT_NEAR(between[0].weight + between[1].weight + between[2].weight, 1, 1e-12);
  EXPECT_GT(between[0].weight, between[1].weight);
  EXPECT_GT(between[1].weight, between[2].weight);
}

TEST(NearestNeighbors, NoneBeginsSuddenly) {
  Random random(5);
  std::vector<glm::dvec3> positions;
  for (int i = 0; i < 40; ++i) {
    positions.emplace_back(random.inRange(0, 4), 0, random.inRange(0, 4));
  }
  std::vector<double> before(positions.size(), -1);
  for (int step = 0; step <= 4000; ++step) {
    std::vector<double> weights(positions.size(), 0);
    for (const SeaNeighbor& neighbor : nearestNeighbors(positions, {step / 1000.0, 0, 1.9})) {
      weights[neighbor.image] = neighbor.weight;
    }
    for (size_t i = 0; i < weights.size() && before[0] >= 0; ++i) {
      EXPECT_LT(std::abs(weights[i] - before[i]), 0.05) << step << " " << i;
    }
    before = weights;
  }
}

TEST(NearestNeighbors, FewImagesDo) {
  const std::vector<glm::dvec3> one{{3, 0, 0}};
  const std::vector<SeaNeighbor> found = nearestNeighbors(one, {0, 0, 0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].weight, 1);
  EXPECT_EQ(nearestNeighbors(std::vector<glm::dvec3>{{1, 0, 0}, {-1, 0, 0}}, {0, 0, 0}).size(), 2u);
}

TEST(PoseRefinement, FindsWhereAnImageWasTakenIndeed) {
  const SeaProjection projection{.width = 128, .height = 128};
  const SeaPose reference{{-0.1, 0, 0.1}, glm::dquat(1, 0, 0, 0)};
  const SeaPose truth{{0.12, 0.03, -0.05}, glm::angleAxis(0.03, glm::normalize(glm::dvec3(1, 2, 0.5)))};
  const RoomImages images({reference, truth}, projection);
  const SeaProxy room(test::roomProxy());
  const WarpReference from(images.image(0), projection);
  const Image<Rgb8> target = images.image(1);
  // What was measured of it is off by some centimetres and two degrees.
  const SeaPose measured{{0.09, 0, 0}, glm::dquat(1, 0, 0, 0)};
  const PoseComparison comparison{room, projection, from, reference, target, measured};
  for (const char* name : {"bobyqa", "subplex"}) {
    const PoseOffset found = refinedPose(comparison, requirePoseRefinement(name, "x"), 0.2);
    const SeaPose refined = movedBy(measured, found.translation, found.rotation);
    EXPECT_LT(comparisonEnergy(comparison, found), comparisonEnergy(comparison, {}) / 2) << name;
    EXPECT_LT(glm::distance(refined.position, truth.position), 0.5 * glm::distance(measured.position, truth.position))
        << name;
  }
  const PoseOffset none = refinedPose(comparison, requirePoseRefinement("none", "x"), 0.2);
  EXPECT_EQ(none.translation, glm::dvec3(0));
}

TEST(PoseRefinement, NamesWhatThereIs) {
  EXPECT_THAT([] { requirePoseRefinement("gauss", "--refine"); },
              ThrowsMessage<InputError>(testing::AllOf(HasSubstr("gauss"), HasSubstr("bobyqa"))));
}

}  // namespace
}  // namespace ocelli
