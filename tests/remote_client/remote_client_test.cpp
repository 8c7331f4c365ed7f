#include "oc_core/remote/client/remote_client.h"

#include <gtest/gtest.h>

#include "tests/remote_client/client_scenes.h"

namespace ocelli {
namespace {

constexpr glm::ivec2 kClientScreen{64, 36};
constexpr double kFrame = 1.0 / 60;

/// Twice as wide as the view, with a middle of 2x.
ImageCover planOf(const View& view) {
  View wide = view;
  wide.fovVerticalDegrees =
      degreesFromRadians(2 * std::atan(2 * std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2)));
  return {PinholeCamera(wide, 2 * kClientScreen.x, 2 * kClientScreen.y), clientLayout(2)};
}

/// A wall at a depth of 10 that fills the image.
ReferenceImage imageFor(const View& view) {
  const ImageCover plan = planOf(view);
  ReferenceImage image = blankReferenceImage("gpc", plan.reference.view(), 2 * kClientScreen.x, 2 * kClientScreen.y);
  image.layout = clientLayout(2);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image.set(x, y, 10, glm::vec3(0.5f));
    }
  }
  return image;
}

/// A client that holds the image of its first view since `arrival`; asked for at 0.
RemoteClient holding(const View& view, double arrival, const ClientRule& rule = {}) {
  RemoteClient client(kClientScreen, planOf, rule);
  const auto wish = client.look(view, 0);
  EXPECT_TRUE(wish && wish->view == view);
  client.receive(wish->sequence, imageFor(view), true, arrival);
  return client;
}

TEST(RemoteClient, asksFirstForWhatItSees) {
  RemoteClient client(kClientScreen, planOf);
  EXPECT_EQ(client.choose(clientView(20)).image, nullptr);
  EXPECT_EQ(client.draw(clientView(20)), Image<Rgb8>(kClientScreen.x, kClientScreen.y));
  const auto wish = client.look(clientView(20), 0);
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->sequence, 1u);
  for (int frame = 1; frame < 120; ++frame) {
    EXPECT_FALSE(client.look(clientView(20), frame * kFrame)) << "one request is enough for a view that rests";
  }
}

TEST(RemoteClient, isQuietWhereItsImageServes) {
  RemoteClient client = holding(clientView(20), 0.1);
  for (int frame = 10; frame < 200; ++frame) {
    EXPECT_FALSE(client.look(clientView(20), frame * kFrame));
    EXPECT_TRUE(client.choose(clientView(20)).load.isCovered());
  }
  EXPECT_NEAR(client.tripSeconds(), 0.1, 1e-9);
}

// The view turns by 2 degrees a second. The image reaches to tan(h) = 2 tan(10) beyond its middle, the view to 10
// degrees beyond its own: 0.95 of the reach is where tan(10 + turned) = 0.95 * 2 tan(10). It asks when it will be there
// after the trip and `aheadSeconds`.
TEST(RemoteClient, asksAheadInTime) {
  const double trip = 0.5;
  ClientRule rule;
  rule.limits.leastDetail = 0.1;  // the reach alone ends what is covered
  RemoteClient client = holding(clientView(20), trip, rule);
  const double rate = 2;
  const double end = degreesFromRadians(std::atan(1.9 * std::tan(radiansFromDegrees(10)))) - 10;
  std::optional<ImageWish> wish;
  double now = 1;
  double turned = 0;
  for (; !wish && now < 10; now += kFrame) {
    turned = rate * (now - 1);
    wish = client.look(clientTurned(clientView(20), 0, turned), now);
  }
  ASSERT_TRUE(wish);
  const double ahead = rate * (trip + client.rule().aheadSeconds);
  EXPECT_NEAR(turned, end - ahead, 2 * rate * kFrame);
  // For where it will be then: the motion of the last tenth of a second goes on.
  const glm::vec3 forward = glm::normalize(wish->view.target - wish->view.eye);
  EXPECT_NEAR(degreesFromRadians(std::asin(forward.y)), turned + ahead, 0.05);
  // On it goes without another request, as the one under way will do, up to where that ends.
  for (double later = now; later < now + 0.5; later += kFrame) {
    EXPECT_FALSE(client.look(clientTurned(clientView(20), 0, rate * (later - 1)), later));
  }
}

TEST(RemoteClient, asksForWhereItRests) {
  RemoteClient client = holding(clientView(20), 0.1);
  const View beside = movedEye(clientView(20), {0.05f, 0, 0});
  std::optional<ImageWish> wish;
  double now = 1;
  for (; !wish && now < 3; now += kFrame) {
    wish = client.look(beside, now);
  }
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->view, beside);
  EXPECT_NEAR(now, 1 + client.rule().motionSeconds + client.rule().restSeconds, 0.15);
  EXPECT_FALSE(client.look(beside, now + 1));
}

TEST(RemoteClient, asksNoMoreThanItMay) {
  RemoteClient client = holding(clientView(20), 0.1);
  double last = -10;
  // So fast that nothing covers it.
  for (double now = 1; now < 6; now += kFrame) {
    if (client.look(clientTurned(clientView(20), 0, 60 * std::sin(now)), now)) {
      EXPECT_GE(now - last, client.rule().pauseSeconds - 1e-9);
      last = now;
    }
  }
  EXPECT_GT(last, 1);
}

TEST(RemoteClient, makesDoWithSoManyImages) {
  ClientRule rule;
  rule.maxRequests = 2;
  RemoteClient client(kClientScreen, planOf, rule);
  size_t wishes = 0;
  for (double now = 0; now < 6; now += kFrame) {
    if (const auto wish = client.look(clientTurned(clientView(20), 0, 10 * now), now)) {
      ++wishes;
      client.receive(wish->sequence, imageFor(wish->view), true, now);
    }
  }
  EXPECT_EQ(wishes, 2u);
}

TEST(RemoteClient, drawsFromTheImageThatServesBest) {
  ClientRule rule;
  rule.maxImages = 2;
  RemoteClient client(kClientScreen, planOf, rule);
  const View left = clientTurned(clientView(20), -15, 0);
  const View right = clientTurned(clientView(20), 15, 0);
  client.receive(1, imageFor(left), true, 1);
  client.receive(2, imageFor(right), true, 2);
  EXPECT_EQ(client.choose(left).image->sequence, 1u);
  EXPECT_EQ(client.choose(right).image->sequence, 2u);
  // The one that was drawn from longest ago goes.
  client.look(left, 3);
  client.receive(3, imageFor(clientView(20)), true, 4);
  EXPECT_EQ(client.heldImages(), 2u);
  EXPECT_EQ(client.choose(left).image->sequence, 1u);
  EXPECT_EQ(client.choose(right).image->sequence, 3u);
}

// As the page does it (oc_core/remote/page/look_planner.js): an image of the view's own eye that covers it is exact,
// even where another one has less of a load.
TEST(RemoteClient, prefersAnImageOfTheViewsOwnEye) {
  RemoteClient client(kClientScreen, planOf);
  const View view = clientView(20);
  const View turned = clientTurned(view, 0, 7);
  const View beside = movedEye(view, {0.01f, 0, 0});
  const auto loadOf = [&](const View& at) {
    return coverLoad(ImageCover(imageFor(at)), view, kClientScreen, client.rule().limits);
  };
  ASSERT_TRUE(loadOf(turned).isExact());
  ASSERT_TRUE(loadOf(beside).isCovered());
  ASSERT_FALSE(loadOf(beside).isExact());
  ASSERT_LT(loadOf(beside).whole(), loadOf(turned).whole());
  client.receive(1, imageFor(turned), true, 1);
  client.receive(2, imageFor(beside), true, 2);
  EXPECT_EQ(client.choose(view).image->sequence, 1u);
  // Beyond what the first one reaches, the other one serves.
  EXPECT_EQ(client.choose(clientTurned(view, 0, -5)).image->sequence, 2u);
}

TEST(RemoteClient, servesViewsFromElsewhereOnceDepthIsThere) {
  RemoteClient client(kClientScreen, planOf);
  const View view = clientView(20);
  const View beside = movedEye(view, {0.05f, 0, 0});
  const auto wish = client.look(view, 0);
  client.receive(wish->sequence, imageFor(view), false, 0.2);
  EXPECT_TRUE(client.choose(view).load.isCovered());
  EXPECT_FALSE(client.choose(beside).load.isCovered());
  client.receive(wish->sequence, imageFor(view), true, 0.7);
  EXPECT_TRUE(client.choose(beside).load.isCovered());
  EXPECT_NEAR(client.tripSeconds(), 0.7, 1e-9);
  EXPECT_EQ(client.heldImages(), 1u);
}

}  // namespace
}  // namespace ocelli
