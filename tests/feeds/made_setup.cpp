#include "tests/feeds/made_setup.h"

namespace ocelli::test {
namespace {

constexpr double kHigh = 2.8;

Feed feedAt(const std::string& name, double focal, const glm::dvec3& eye, const glm::dvec3& target) {
  Feed feed;
  feed.name = name;
  feed.source = name + ".mkv";
  feed.lens = {{focal, focal * 1.01}, {318.5, 243}, -0.12, 0.03, 4e-4, -3e-4, 0.001};
  feed.pose = {eye, target, {0, 1, 0}};
  return feed;
}

}  // namespace

FeedSetup tSetup() {
  FeedSetup setup;
  setup.feeds = {feedAt("stem", 620, {0, 2.2, 5}, {0, 1.3, -2.4}), feedAt("left", 700, {5, 2.3, -1.2}, {-1, 1.3, -1.2}),
                 feedAt("right", 700, {-5, 2.3, -1.2}, {1, 1.3, -1.2})};
  const glm::dvec3 up(0, kHigh, 0);
  const auto face = [&](double x) {
    const glm::dvec3 corner(x, 0, 0);
    const glm::dvec3 middle(0, 0, -2.4);
    return std::array{corner, corner + up, middle + up, middle};
  };
  setup.frusta = {{"stem", "", {}}, {"left", "stem", face(-1.2)}, {"right", "stem", face(1.2)}};
  setup.output = {320, 240, 42, {0, 1.3, -2.4}};
  return setup;
}

FeedSetup chainSetup() {
  FeedSetup setup = tSetup();
  setup.feeds.push_back(feedAt("beyond", 650, {-3.5, 2, -1}, {-9, 1.2, -1.3}));
  setup.frusta.push_back({"beyond", "left", {{{-5, 0, 0}, {-5, kHigh, 0}, {-5, kHigh, -2.4}, {-5, 0, -2.4}}}});
  return setup;
}

}  // namespace ocelli::test
