// What a program may not register. What it may is registered by the programs in examples/, which tests/house runs: a
// row that stays would be one too many for the other tests of this program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/ocri/cast_representation.h"

namespace ocelli {
namespace {

RepresentationKind meshKind(const char* name) {
  return {.name = name, .description = "a mesh", .mesh = [](const Mesh& mesh, size_t) { return mesh; }};
}

std::string refusalOf(RepresentationKind kind) {
  try {
    registerRepresentation(std::move(kind));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RegisterRepresentation, namesThatAreTakenAreRefused) {
  const size_t before = representationKinds().size();
  for (const RepresentationKind& kind : representationKinds()) {
    EXPECT_THAT(refusalOf(meshKind(kind.name)), testing::HasSubstr(kind.name));
  }
  // "di" answers to "ppc", and "ldi-4" to all of "ldi-1" to "ldi-16".
  for (const char* name : {"ppc", "ldi-1", "ldi-16"}) {
    EXPECT_THAT(refusalOf(meshKind(name)), testing::HasSubstr(name));
  }
  // It would answer to "corners-4" and "corners-8".
  RepresentationKind corners = meshKind("corners-2");
  corners.maxCount = 8;
  EXPECT_THAT(refusalOf(corners), testing::HasSubstr("corners-2"));
  EXPECT_EQ(representationKinds().size(), before);
}

TEST(RegisterRepresentation, namesOfFilesAreRefused) {
  EXPECT_THAT(refusalOf(meshKind("mine.json")), testing::HasSubstr("mine.json"));
  EXPECT_NE(refusalOf(meshKind("")), "");
}

TEST(RegisterRepresentation, aRowHasImagesOrAMesh) {
  RepresentationKind neither = meshKind("neither");
  neither.mesh = {};
  EXPECT_THAT(refusalOf(neither), testing::HasSubstr("neither"));
  RepresentationKind both = castRepresentation("both", "", [](const RepresentationInputs& in) { return in.reference; });
  both.mesh = meshKind("").mesh;
  EXPECT_THAT(refusalOf(both), testing::HasSubstr("both"));
}

TEST(FindRepresentation, tellsTheRowAndTheNumber) {
  for (const RepresentationKind& kind : representationKinds()) {
    EXPECT_EQ(findRepresentation(kind.name)->kind, &kind) << kind.name;
  }
  EXPECT_EQ(findRepresentation("ppc")->kind, findRepresentation("di")->kind);
  EXPECT_EQ(findRepresentation("ldi-7")->kind, findRepresentation("ldi-4")->kind);
  EXPECT_EQ(findRepresentation("ldi-7")->count, 7);
  EXPECT_EQ(findRepresentation("di")->count, 0);
  EXPECT_FALSE(findRepresentation("ldi-17"));
  EXPECT_FALSE(findRepresentation(""));
}

}  // namespace
}  // namespace ocelli
