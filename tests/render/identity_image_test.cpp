#include "oc_core/render/identity_image.h"

#include <gmock/gmock.h>

#include <queue>
#include <set>

#include "oc_core/base/random.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

constexpr uint32_t kNone = kNothing;

Image<uint32_t> imageOf(int width, const std::vector<uint32_t>& identities) {
  Image<uint32_t> image(width, static_cast<int>(identities.size()) / width);
  std::copy(identities.begin(), identities.end(), image.begin());
  return image;
}

/// Slow and obvious: pixel by pixel, regions by flooding them.
ObjectSighting bruteForce(const Image<uint32_t>& image, uint32_t object) {
  ObjectSighting sighting{object, 0, 0, {image.width(), image.height()}, {-1, -1}};
  std::set<std::pair<int, int>> seen;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image(x, y) != object) {
        continue;
      }
      ++sighting.pixels;
      sighting.lower = glm::min(sighting.lower, glm::ivec2(x, y));
      sighting.upper = glm::max(sighting.upper, glm::ivec2(x, y));
      sighting.centroid += glm::dvec2(x, y) + 0.5;
      sighting.atBorder |= x == 0 || y == 0 || x == image.width() - 1 || y == image.height() - 1;
      std::queue<std::pair<int, int>> todo;
      if (seen.insert({x, y}).second) {
        ++sighting.regions;
        todo.push({x, y});
      }
      for (; !todo.empty(); todo.pop()) {
        const auto [a, b] = todo.front();
        for (int k = 0; k < 9; ++k) {
          const std::pair<int, int> next(a + k % 3 - 1, b + k / 3 - 1);
          if (image.contains(next.first, next.second) && image(next.first, next.second) == object &&
              seen.insert(next).second) {
            todo.push(next);
          }
        }
      }
    }
  }
  sighting.centroid /= static_cast<double>(sighting.pixels);
  return sighting;
}

TEST(IdentityImage, namesTheObjectOfEachPixel) {
  FragmentImage fragments(3, 1);
  fragments(0, 0).triangle = 2;
  fragments(2, 0).triangle = 0;
  EXPECT_EQ(identityImage(fragments, {kStructure, 9, 7}), imageOf(3, {7, kNone, kStructure}));
  EXPECT_TRUE(identityImage({}, {1}).empty());
}

TEST(IdentityImageDeath, refusesTheObjectsOfAnotherMesh) {
  FragmentImage fragments(1, 1);
  fragments(0, 0).triangle = 2;
  EXPECT_DEATH(identityImage(fragments, {1, 2}), "more triangles");
  EXPECT_DEATH(identityImage(fragments, {}), "more triangles");
}

TEST(IdentityImage, sightingsByHand) {
  // Object 5 in two regions, of which one holds together at a corner; object 3 at the border, in one pixel.
  const Image<uint32_t> image = imageOf(6, {0, 0, 0, 0, 0,     3,  //
                                            0, 5, 0, 0, 0,     0,  //
                                            0, 0, 5, 0, 5,     0,  //
                                            0, 0, 5, 0, kNone, 0,  //
                                            0, 0, 0, 0, 0,     kNone});
  const std::vector<ObjectSighting> found = sightings(image);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], (ObjectSighting{3, 1, 1, {5, 0}, {5, 0}, {5.5, 0.5}, true}));
  EXPECT_EQ(found[1],
            (ObjectSighting{5, 4, 2, {1, 1}, {4, 3}, {(1.5 + 2.5 + 2.5 + 4.5) / 4, (1.5 + 2 * 2.5 + 3.5) / 4}, false}));
  EXPECT_TRUE(sightings({}).empty());
  EXPECT_TRUE(sightings(imageOf(2, {0, 0, kNone, kNone})).empty());
}

TEST(IdentityImage, sightingsAreThoseOfFlooding) {
  Random random(3);
  for (const int width : {1, 2, 17, 40}) {
    for (const unsigned objects : {2u, 3u, 12u}) {
      Image<uint32_t> image(width, 23);
      for (uint32_t& identity : image) {
        identity = random.below(10) == 0 ? kNone : static_cast<uint32_t>(random.below(objects));
      }
      std::set<uint32_t> shown(image.begin(), image.end());
      shown.erase(kStructure);
      shown.erase(kNone);
      const std::vector<ObjectSighting> found = sightings(image);
      ASSERT_EQ(found.size(), shown.size());
      auto object = shown.begin();
      for (const ObjectSighting& sighting : found) {
        ObjectSighting expected = bruteForce(image, *object++);
        EXPECT_LT(glm::distance(sighting.centroid, expected.centroid), 1e-9);  // of sums in the same order
        expected.centroid = sighting.centroid;
        EXPECT_EQ(sighting, expected);
      }
    }
  }
}

TEST(IdentityImage, seesTheObjectsOfAScene) {
  const GuidedScene scene = loadGuidedScene("builtin:boxes");
  const FragmentImage drawn = rasterize(test::crossroads(PinholeCamera(View{}, 180, 120)), scene.mesh);
  const Image<uint32_t> identities = identityImage(drawn, scene.objectOfTriangle);
  size_t objectPixels = 0;
  for (size_t i = 0; i < drawn.size(); ++i) {
    ASSERT_EQ(identities[i] == kNothing, !drawn[i].covered());
    objectPixels += identities[i] != kNothing && identities[i] != kStructure;
  }
  size_t sum = 0;
  for (const ObjectSighting& sighting : sightings(identities)) {
    sum += sighting.pixels;
  }
  EXPECT_GT(sum, 1000u);
  EXPECT_EQ(sum, objectPixels);
}

TEST(IdentityImage, neighbouringIdentitiesDifferInTheImage) {
  std::vector<uint32_t> identities(200);
  for (uint32_t i = 0; i < identities.size(); ++i) {
    identities[i] = i;
  }
  identities.push_back(kNone);
  const Image<Rgb8> colors = identityColors(imageOf(static_cast<int>(identities.size()), identities));
  const auto difference = [&](size_t a, size_t b) { return glm::distance(glm::vec3(colors[a]), glm::vec3(colors[b])); };
  for (size_t i = 1; i < 200; ++i) {
    EXPECT_GT(difference(0, i), 40) << "structure, " << i;
    EXPECT_GT(difference(200, i), 40) << "background, " << i;
    for (size_t k = i + 1; k < std::min<size_t>(i + 14, 200); ++k) {
      EXPECT_GT(difference(i, k), 30) << i << ", " << k;
    }
  }
  EXPECT_EQ(colors[200], Rgb8(0));
}

}  // namespace
}  // namespace ocelli
