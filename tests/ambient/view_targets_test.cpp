// Targets that know what a view sees: free_space_target.h and unseen_target.h.
#include <gmock/gmock.h>

#include "oc_core/ambient/free_space_target.h"
#include "oc_core/ambient/unseen_target.h"
#include "tests/ambient/ambient_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

/// The box hides a part of the wall behind it.
class ViewTargets : public testing::Test {
 protected:
  Mesh mesh_ = test::boxBeforeWall();
  RayScene scene_{mesh_};
  PinholeCamera camera_ = smallCamera();
  FragmentImage seen_ = raycast(camera_, mesh_, scene_);
};

TEST_F(ViewTargets, unseenIsWhatIsHiddenOrBeyondTheBorders) {
  const UnseenTarget unseen(scene_, camera_, seen_);
  // The wall straight behind the box, from between them.
  const std::optional<Hit> hidden = unseen.hit({{0, 0, 0}, {0, 0, -5}});
  ASSERT_TRUE(hidden);
  EXPECT_NEAR(hidden->position.z, test::kWallZ, 1e-5f);
  EXPECT_TRUE(unseen.hit({{0, 0, 0}, {0, 0, 5}})) << "the box's back";
  EXPECT_FALSE(unseen.hit({{0, 0, 5}, {0, 0, -5}})) << "its front";
  EXPECT_FALSE(unseen.hit({{0.7f, 0.3f, 5}, {0.7f, 0.3f, -5}})) << "the wall beside it";
  EXPECT_TRUE(unseen.hit({{2.9f, 0, 5}, {2.9f, 0, -5}})) << "the wall beyond the border";
  EXPECT_FALSE(unseen.hit({{9, 0, 5}, {9, 0, -5}})) << "nothing is there";
}

TEST_F(ViewTargets, freeSpaceHasNoSkins) {
  // A skin in front of the wall, where the view sees the wall through it, and a true surface behind.
  Mesh skinned = mesh_;
  test::addQuad(skinned, {0.6f, -0.5f, 0}, {1.1f, -0.5f, 0}, {1.1f, 0.5f, 0}, {0.6f, 0.5f, 0});
  const RayScene rays(skinned);
  const FreeSpaceTarget target(rays, camera_, seen_);
  const RayPath through{{0.8f, 0, 3}, {0.8f, 0, -3}};
  ASSERT_NEAR(rays.hit(through)->position.z, 0, 1e-5f);
  const std::optional<Hit> hit = target.hit(through);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->position.z, test::kWallZ, 1e-4f);
  EXPECT_NEAR(hit->t, 3 - test::kWallZ, 1e-3f);
  // What the view shows, and what it cannot know, stays.
  for (const RayPath& ray :
       {RayPath{{0, 0, 5}, {0, 0, -5}}, RayPath{{0, 0, 0}, {0, 0, -5}}, RayPath{{2.9f, 0, 5}, {2.9f, 0, -5}}}) {
    ASSERT_TRUE(target.hit(ray));
    EXPECT_EQ(target.hit(ray)->t, scene_.hit(ray)->t);
  }
  EXPECT_FALSE(target.hit({{0.8f, 0, 3}, {0.8f, 0, -0.5f}})) << "nothing but the skin";
  EXPECT_FALSE(target.hit({}));
}

TEST_F(ViewTargets, freeSpaceEndsAfterManySkins) {
  Mesh skins;
  for (int i = 0; i < 100; ++i) {
    test::addWall(skins, 1 + 0.01f * static_cast<float>(i), 3);
  }
  const RayScene rays(skins);
  const FreeSpaceTarget target(rays, camera_, seen_);
  EXPECT_FALSE(target.hit({{0.8f, 0, 5}, {0.8f, 0, -3}}));
}

}  // namespace
}  // namespace ocelli
