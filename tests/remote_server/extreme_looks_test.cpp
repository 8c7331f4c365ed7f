// Messages that are allowed, as far as each field may go: drawing them must neither end the program nor make images
// that no client can read.
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/remote/server/scene_draw.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli::test {
namespace {

class ExtremeLooks {
 public:
  explicit ExtremeLooks(uint64_t seed) : random_(seed) {}

  std::string next() {
    std::string look = "{\"type\":\"look\",\"sequence\":1,\"view\":{\"eye\":" + point() + ",\"target\":" + point() +
                       ",\"up\":" + point() + ",\"fov_vertical_degrees\":" + number(1e-4, 178.9) +
                       ",\"z_near\":" + number(1e-6, 1e3) + ",\"z_far\":" + number(1e2, 1e9) + "},\"screen\":[" +
                       std::to_string(16 + random_.below(80)) + "," + std::to_string(16 + random_.below(80)) +
                       "],\"lenses\":[";
    for (size_t i = 0, count = random_.below(9); i < count; ++i) {
      look += (i > 0 ? "," : "") + std::string("{\"center\":[") + number(1e-6, 1) + "," + number(1e-6, 1) +
              "],\"extent\":[" + number(1e-3, 1) + "," + number(1e-3, 1) + "],\"zoom\":" + number(0.1, 64) +
              ",\"transition_width\":" + number(0.01, 100) + "}";
    }
    return look + "]}";
  }

 private:
  /// Of any size between these.
  std::string number(double least, double most) {
    const double share = random_.inRange(0, 1);
    return std::to_string(std::clamp(least * std::pow(most / least, share), least, most));
  }
  std::string point() {
    std::string text;
    for (int i = 0; i < 3; ++i) {
      const char* const sign = random_.below(2) == 0 ? "-" : "";
      text += (i > 0 ? "," : "[") + (random_.below(3) == 0 ? "0" : sign + number(1e-4, 1e4));
    }
    return text + "]";
  }

  Random random_;
};

TEST(ExtremeLooks, AreDrawnOrRefused) {
  const RemoteScene scene(loadScene("builtin:boxes"), "builtin:boxes");
  RemoteSettings settings;
  settings.samples = 1;
  const RemoteDraw draw = sceneDraw(scene, settings);
  ExtremeLooks looks(11);
  size_t drawn = 0;
  size_t refused = 0;
  for (uint32_t id = 1; id <= 150; ++id) {
    const std::string look = looks.next();
    try {
      const auto image = draw(remoteRequestFromJson(look), id, [] { return true; });
      ASSERT_TRUE(image);
      decodeRemoteImage(image->headerJson, image->color, image->depth);
      ++drawn;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()), "") << look;
      ++refused;
    }
  }
  // Both happen: the looks lie on both sides of what is allowed.
  EXPECT_GE(drawn, 40u);
  EXPECT_GE(refused, 5u);
}

TEST(SceneDraw, StopsWhereNobodyWaits) {
  const RemoteScene scene(loadScene("builtin:boxes"), "builtin:boxes");
  RemoteSettings settings;
  settings.samples = 1;
  RemoteRequest request;
  request.screen = {16, 16};
  EXPECT_FALSE(sceneDraw(scene, settings)(request, 1, [] { return false; }));
  EXPECT_TRUE(sceneDraw(scene, settings)(request, 1, [] { return true; }));
}

}  // namespace
}  // namespace ocelli::test
