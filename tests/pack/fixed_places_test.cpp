// Places that parts of a scene have in common are fixed in all of them until the parts are put together.
#include "oc_core/pack/fixed_places.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "oc_core/pack/sorted_triangles.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

/// As a scene of many parts: each with a few cells of the plan.
ScenePlan dividedPlan(const MeshSource& source) {
  ScenePlan plan = planOf(source, "scene");
  const auto cells = static_cast<uint32_t>(plan.partOfCell.size());
  constexpr uint32_t kLeaves = 16;
  plan.parts.clear();
  // Four parts of four, and the whole.
  std::vector<uint32_t> inner;
  std::vector<uint32_t> leafOf(kLeaves);
  for (uint32_t i = 0; i < kLeaves; ++i) {
    leafOf[i] = static_cast<uint32_t>(plan.parts.size());
    plan.parts.push_back({i * (cells / kLeaves), (i + 1) * (cells / kLeaves), 0, 0, {}});
    if (i % 4 == 3) {
      inner.push_back(static_cast<uint32_t>(plan.parts.size()));
      plan.parts.push_back({0, 0, 0, 0, {leafOf[i - 3], leafOf[i - 2], leafOf[i - 1], leafOf[i]}});
    }
  }
  plan.parts.push_back({0, cells, 0, 0, inner});
  for (uint32_t cell = 0; cell < cells; ++cell) {
    plan.partOfCell[cell] = leafOf[cell / (cells / kLeaves)];
  }
  uint64_t placed = 0;
  std::map<uint32_t, uint64_t> counts;
  source.forEachPart([&](const Mesh& mesh) {
    for (const glm::uvec3& t : mesh.triangles) {
      ++counts[plan.partOf(plan.cellOf(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]))];
    }
  });
  for (const auto& [part, count] : counts) {
    plan.parts[part].triangles = count;
    plan.parts[part].firstTriangle = placed;
    placed += count;
  }
  return plan;
}

TEST(FixedPlaces, HoldAllThatPartsShareAsLongAsTheyAreApart) {
  const TemporaryFolder folder;
  for (const size_t triangles : {size_t{500}, size_t{30'000}}) {
    const Mesh ball = test::bumpyBall(triangles);
    const MeshSource source(ball);
    const ScenePlan plan = dividedPlan(source);
    const SortedPaths paths{folder / "triangles", folder / "places"};
    sortTriangles(source, plan, paths, [](double) {});
    std::map<PlaceBits, std::set<uint32_t>> users;
    std::map<uint32_t, std::vector<FixedPlace>> fixedIn;
    for (uint32_t part = 0; part < plan.parts.size(); ++part) {
      if (plan.parts[part].children.empty()) {
        PartTriangles read = readPartTriangles(paths, plan, part);
        for (const glm::vec3& p : read.triangles.positions) {
          users[placeBits(p)].insert(part);
        }
        fixedIn[part] = std::move(read.fixed);
      } else {
        std::vector<FixedPlace> together;
        for (const uint32_t child : plan.parts[part].children) {
          together.insert(together.end(), fixedIn[child].begin(), fixedIn[child].end());
        }
        fixedIn[part] = fixedAbove(plan, part, together);
      }
    }
    size_t shared = 0;
    for (const auto& [place, parts] : users) {
      if (parts.size() < 2) {
        continue;
      }
      ++shared;
      for (const uint32_t part : parts) {
        EXPECT_TRUE(placesOf(fixedIn[part]).contains(place));
      }
      for (uint32_t part = 0; part < plan.parts.size(); ++part) {
        const std::vector<uint32_t>& children = plan.parts[part].children;
        const auto inside = std::ranges::count_if(children, [&](uint32_t child) { return parts.contains(child); });
        if (inside > 0 && inside < static_cast<std::ptrdiff_t>(parts.size()) && part + 1 < plan.parts.size()) {
          EXPECT_TRUE(placesOf(fixedIn[part]).contains(place));
        }
      }
    }
    EXPECT_GT(shared, 50U);
    // All of the scene fixes nothing, and parts not much more than they share.
    EXPECT_TRUE(fixedIn.rbegin()->second.empty());
    size_t fixed = 0;
    for (const auto& [part, places] : fixedIn) {
      fixed += plan.parts[part].children.empty() ? placesOf(places).places().size() : 0;
    }
    EXPECT_LT(fixed, 6 * shared);
  }
}

TEST(FixedPlaces, ForEverIsForEver) {
  const Mesh ball = test::bumpyBall(500);
  const MeshSource source(ball);
  const ScenePlan plan = dividedPlan(source);
  const FixedPlace always{{1, 2, 3}, FixedPlace::kForEver};
  EXPECT_EQ(fixedAbove(plan, static_cast<uint32_t>(plan.parts.size() - 1), {{{1, 2, 3}, 0}, always, always}),
            std::vector<FixedPlace>{always});
}

}  // namespace
}  // namespace ocelli
