#include "oc_core/relief/relief_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ReliefKinds, namesAreChecked) {
  for (const char* name : {"height-field", "height-field-64", "layered-4", "di", "spoc", "cell", "eoc-h", "ldi-2"}) {
    EXPECT_NO_THROW(checkReliefKind(name)) << name;
  }
  for (const char* name : {"height-field-0", "height-field-x", "layered-0", "layered-17", "relief"}) {
    EXPECT_THAT([&] { checkReliefKind(name); }, ThrowsMessage<InputError>(HasSubstr("for relief tiles"))) << name;
  }
  EXPECT_THAT([] { checkReliefKind("geometry"); }, ThrowsMessage<InputError>(HasSubstr("has no image")));
}

TEST(ReliefKinds, keepToTheirTexels) {
  constexpr size_t kTexels = 30'000;
  for (const char* name : {"height-field", "di", "spoc", "cell"}) {
    const BuiltRelief built = buildReliefObject(name, test::table(), kTexels);
    const double most = name == std::string("cell") ? 1.2 : 1.0;
    EXPECT_LE(static_cast<double>(built.object->texels()), most * kTexels) << name;
    EXPECT_GT(built.object->texels(), kTexels / 2) << name;
    EXPECT_LE(built.object->samples(), built.object->texels()) << name;
    EXPECT_GT(built.object->texelSize(), 0) << name;
    EXPECT_EQ(built.name, name);
  }
}

TEST(ReliefKinds, emptyFlatAndTinyObjects) {
  Mesh flat;
  flat.positions = {{-0.7f, 0, -0.7f}, {0.7f, 0, -0.7f}, {0.7f, 0, 0.7f}, {-0.7f, 0, 0.7f}};
  flat.triangles = {{0, 2, 1}, {0, 3, 2}};
  RayCost cost;
  const StraightRay down = test::rayBetween({0.1f, 2, 0.1f}, {0.1f, 0, 0.1f});
  for (const char* name : {"height-field", "layered-2", "di", "spoc", "cell"}) {
    const BuiltRelief empty = buildReliefObject(name, Mesh{}, 100);
    EXPECT_TRUE(empty.object->bounds().empty()) << name;
    EXPECT_FALSE(empty.object->meet(down, cost)) << name;
    const BuiltRelief thin = buildReliefObject(name, flat, 1600);
    const auto found = thin.object->meet(down, cost);
    ASSERT_TRUE(found) << name;
    EXPECT_NEAR(test::placeOn(down, *found).y, 0, 1e-3f) << name;
    // Images of one pixel, or nearly.
    const BuiltRelief tiny = buildReliefObject(name, test::redBox(), 1);
    EXPECT_LE(tiny.object->texels(), 64u) << name;
    tiny.object->meet(down, cost);
  }
}

}  // namespace
}  // namespace ocelli
