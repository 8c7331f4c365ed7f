// Runs on a virtual screen (xvfb-run), where CMake found one.
#include "display_driver/picture_device/quilt_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "display_driver/picture_device/picture_devices.h"
#include "oc_core/base/error.h"
#include "oc_core/window/monitors.h"
#include "tests/base/temporary_folder.h"
#include "tests/window/x_server.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;
using Rgb = std::array<uint8_t, 3>;
constexpr double kPatience = 5;  // seconds that a busy X server may take; a working one needs milliseconds

const std::string kDisplay = R"({"name": "tiny", "columns": 2, "rows": 2, "width": 64, "height": 48, "aspect": 1.25})";
constexpr std::array<Rgb, 4> kTiles{{{200, 10, 20}, {30, 180, 40}, {50, 60, 160}, {140, 150, 160}}};

std::string write(const test::TemporaryFolder& folder, const std::string& name, const std::string& text) {
  return folder.write(name, text).string();
}

/// Each tile of one colour.
Image<Rgb8> tiles(const QuiltDisplay& display) {
  Image<Rgb8> quilt(display.width, display.height);
  for (int view = 0; view < display.viewCount(); ++view) {
    const glm::ivec2 origin = tileOriginOf(display, view);
    const Rgb& color = kTiles[static_cast<size_t>(view)];
    for (int y = 0; y < display.tileHeight(); ++y) {
      for (int x = 0; x < display.tileWidth(); ++x) {
        quilt(origin.x + x, origin.y + y) = Rgb8(color[0], color[1], color[2]);
      }
    }
  }
  return quilt;
}

/// Whether the screen comes to have these pixels.
void expectOnScreen(PictureDevice& device, test::XServer& server,
                    const std::vector<std::pair<glm::ivec2, Rgb>>& wanted) {
  std::vector<Rgb> seen;
  std::vector<Rgb> all;
  for (const auto& [place, color] : wanted) {
    all.push_back(color);
  }
  const auto start = Clock::now();
  while (std::chrono::duration<double>(Clock::now() - start).count() < kPatience) {
    device.wait(0.02);
    seen.clear();
    for (const auto& [place, color] : wanted) {
      seen.push_back(server.screenPixel(place.x, place.y));
    }
    if (seen == all) {
      return;
    }
  }
  EXPECT_THAT(seen, testing::ElementsAreArray(all));
}

TEST(QuiltWindowText, saysWhichDisplayAndWhere) {
  const test::TemporaryFolder folder;
  const std::string panel = write(folder, "visual.json",
                                  R"({"pitch": 50, "slope": -7, "center": 0.1, "DPI": 324, "screenW": 1536,
                                      "screenH": 2048, "viewCone": 53})");
  const QuiltWindowOptions plain = quiltWindowOptionsFromText("portrait");
  EXPECT_EQ(plain.display, loadQuiltDisplay("portrait"));
  EXPECT_FALSE(plain.monitor);
  const QuiltWindowOptions all = quiltWindowOptionsFromText("go,monitor=1,calibration=" + panel);
  EXPECT_EQ(all.monitor, 1);
  EXPECT_EQ(all.display.coneDegrees, 53);
  ASSERT_TRUE(all.calibration);
  EXPECT_EQ(all.calibration->width, 1536);
  EXPECT_EQ(quiltWindowOptionsFromText("go,calibration=" + panel + ",cone=30").display.coneDegrees, 30);
  EXPECT_EQ(quiltWindowOptionsFromText("go,cone=30,calibration=" + panel).display.coneDegrees, 30);
}

TEST(QuiltWindowText, whatIsWrongIsNamed) {
  const auto message = [](const std::string& text) {
    try {
      quiltWindowOptionsFromText(text);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message("huge"), HasSubstr("portrait"));
  EXPECT_THAT(message(""), HasSubstr("portrait"));
  EXPECT_THAT(message("go,screen=1"), AllOf(HasSubstr("screen=1"), HasSubstr("monitor=N")));
  EXPECT_THAT(message("go,monitor"), HasSubstr("monitor"));
  EXPECT_THAT(message("go,monitor=two"), HasSubstr("two"));
  EXPECT_THAT(message("go,monitor=1.5"), HasSubstr("1.5"));
  EXPECT_THAT(message("go,cone=500"), HasSubstr("cone"));
}

TEST(PictureDevices, areFoundByName) {
  EXPECT_TRUE(isPictureDevice("quilt:portrait"));
  EXPECT_TRUE(isPictureDevice("quilt"));
  EXPECT_FALSE(isPictureDevice("quilts:portrait"));
  EXPECT_FALSE(isPictureDevice("sim"));
  EXPECT_THROW(openPictureDevice("nowhere"), InputError);
  EXPECT_THROW(registerPictureDevice({"quilt", "", "", [](const std::string&) { return nullptr; }}), InputError);
  EXPECT_THROW(registerPictureDevice({"a:b", "", "", [](const std::string&) { return nullptr; }}), InputError);
}

class QuiltWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) {
      GTEST_SKIP() << "there is no display: install xvfb and xauth, and configure again";
    }
  }
  test::TemporaryFolder folder_;
};

TEST_F(QuiltWindowTest, showsTheQuiltOverTheWholeMonitor) {
  const Monitor monitor = listMonitors().at(0);
  const auto device = openPictureDevice("quilt:" + write(folder_, "tiny.json", kDisplay) + ",monitor=0");
  test::XServer server;
  device->show(tiles(device->display()));
  const glm::ivec2 size(monitor.width, monitor.height);
  // View 0 lies at the bottom left.
  expectOnScreen(*device, server,
                 {{{5, size.y - 6}, kTiles[0]},
                  {{size.x - 6, size.y - 6}, kTiles[1]},
                  {{5, 5}, kTiles[2]},
                  {{size.x - 6, 5}, kTiles[3]},
                  {{size.x / 2 - 30, size.y / 2 - 30}, kTiles[2]}});
}

TEST_F(QuiltWindowTest, showsTheDotsOfThePanelPixelForPixel) {
  const Monitor monitor = listMonitors().at(0);
  const std::string calibration = "{\"pitch\": 47.3, \"slope\": -6.1, \"center\": 0.27, \"DPI\": 338, \"screenW\": " +
                                  std::to_string(monitor.width) + ", \"screenH\": " + std::to_string(monitor.height) +
                                  "}";
  const std::string file = write(folder_, "visual.json", calibration);
  const auto device =
      openPictureDevice("quilt:" + write(folder_, "tiny.json", kDisplay) + ",monitor=0,calibration=" + file);
  const Image<Rgb8> quilt = tiles(device->display());
  const Image<Rgb8> panel = panelPicture(quilt, device->display(), readCalibration(file));
  test::XServer server;
  device->show(quilt);
  std::vector<std::pair<glm::ivec2, Rgb>> wanted;
  for (const glm::ivec2& at : {glm::ivec2(0, 0), glm::ivec2(101, 7), glm::ivec2(640, 511), glm::ivec2(641, 511),
                               glm::ivec2(642, 511), glm::ivec2(monitor.width - 1, monitor.height - 1)}) {
    const Rgb8& c = panel(at.x, at.y);
    wanted.push_back({at, {c.r, c.g, c.b}});
  }
  expectOnScreen(*device, server, wanted);
}

TEST_F(QuiltWindowTest, escapeEndsIt) {
  const auto device = openPictureDevice("quilt:" + write(folder_, "tiny.json", kDisplay) + ",monitor=0");
  test::XServer server;
  device->show(tiles(device->display()));
  EXPECT_TRUE(device->wait(0.1));
  constexpr unsigned long kEscapeSymbol = 0xff1b;
  bool open = true;
  const auto start = Clock::now();
  while (open && std::chrono::duration<double>(Clock::now() - start).count() < kPatience) {
    server.pressKey(kEscapeSymbol, true);
    server.pressKey(kEscapeSymbol, false);
    open = device->wait(0.05);
  }
  EXPECT_FALSE(open);
}

TEST_F(QuiltWindowTest, aMonitorThatIsNotThereIsNamed) {
  EXPECT_THROW(openPictureDevice("quilt:" + write(folder_, "tiny.json", kDisplay) + ",monitor=99"), InputError);
}

}  // namespace
}  // namespace ocelli
