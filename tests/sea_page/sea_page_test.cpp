// The folder of a page that walks through a sea of images.
#include "oc_core/sea_page/sea_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/jpeg_codec.h"
#include "oc_core/sea_page/embedded_sea_page.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea_page/sample_room.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What stands between the first "(" and the last ")".
std::string argumentOf(const std::string& call) {
  const size_t from = call.find('(') + 1;
  return call.substr(from, call.rfind(')') - from);
}

std::vector<std::byte> bytesOfBase64Text(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const size_t digit = digits.find(c);
    if (digit == std::string::npos) {
      break;
    }
    bits = bits << 6 | static_cast<uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::byte>(bits >> count & 255));
    }
  }
  return bytes;
}

TEST(SeaPageFiles, HoldPlacesAndImages) {
  const TemporaryFolder folder;
  const SeaPage page = test::roomSea();
  std::vector<size_t> asked;
  writeSeaPage(
      page,
      [&](size_t k) {
        asked.push_back(k);
        // Other sizes, whose bytes end anywhere in groups of three.
        return test::roomImage(page.places[k], 64 + static_cast<int>(k), 32);
      },
      folder.path() / "new" / "page");
  const std::filesystem::path written = folder.path() / "new" / "page";
  EXPECT_EQ(asked.size(), page.places.size());
  const auto sea = nlohmann::json::parse(argumentOf(textOf(written / "sea.js")));
  EXPECT_EQ(sea["title"], page.title);
  ASSERT_EQ(sea["places"].size(), page.places.size());
  for (size_t k = 0; k < page.places.size(); ++k) {
    EXPECT_NEAR(sea["places"][k]["eye"][0].get<double>(), page.places[k].eye.x, 1e-7);
    EXPECT_NEAR(sea["places"][k]["eye"][2].get<double>(), page.places[k].eye.z, 1e-7);
    EXPECT_NEAR(sea["places"][k]["forward"][0].get<double>(), page.places[k].forward.x, 1e-7);
    char name[16];
    std::snprintf(name, sizeof name, "%05zu.js", k);
    const std::string script = textOf(written / "images" / name);
    EXPECT_THAT(script, testing::StartsWith("ocelliSea.take(" + std::to_string(k) + ", \"data:image/jpeg;base64,"));
    const size_t from = script.find("base64,") + 7;
    const Image<Rgb8> again = decodeJpeg(bytesOfBase64Text(script.substr(from)), {64 + static_cast<int>(k), 32});
    const Image<Rgb8> truth = test::roomImage(page.places[k], 64 + static_cast<int>(k), 32);
    double worst = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(again[i].y) - truth[i].y));
    }
    EXPECT_LT(worst, 20) << k;  // quality 95, at the edges of the room
  }
}

TEST(SeaPageFiles, AreSeenFromAboveWhateverIsUp) {
  const TemporaryFolder folder;
  SeaPage page = test::roomSea();
  page.proxy.reset();
  for (SeaPagePlace& place : page.places) {  // z is up
    for (glm::dvec3* v : {&place.eye, &place.forward, &place.up}) {
      *v = glm::dvec3(v->x, -v->z, v->y);
    }
  }
  writeSeaPage(
      page, [&](size_t) { return Image<Rgb8>(8, 4, Rgb8(90)); }, folder.path());
  const auto sea = nlohmann::json::parse(argumentOf(textOf(folder.path() / "sea.js")));
  const SeaPage upright = test::roomSea();
  for (size_t k = 0; k < page.places.size(); ++k) {
    for (size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(sea["places"][k]["eye"][axis].get<double>(), upright.places[k].eye[static_cast<int>(axis)], 1e-6);
      EXPECT_NEAR(sea["places"][k]["up"][axis].get<double>(), axis == 1 ? 1 : 0, 1e-6);
    }
  }
}

TEST(SeaPageFiles, RefuseWhatCannotBeShown) {
  const TemporaryFolder folder;
  const auto grey = [](size_t) { return Image<Rgb8>(8, 4, Rgb8(90)); };
  const auto refused = [&](const SeaPage& page, const std::string& what) {
    EXPECT_THAT([&] { writeSeaPage(page, grey, folder.path() / "none"); }, ThrowsMessage<InputError>(HasSubstr(what)));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "none")) << what;
  };
  refused({}, "no places");
  SeaPage page = test::roomSea();
  page.places[3].eye.x = std::nan("");
  refused(page, "place 3");
  page = test::roomSea();
  page.places[4].up = page.places[4].forward;
  refused(page, "place 4");
  page = test::roomSea();
  page.places[5].eye.x = 9;
  refused(page, "place 5");
  page = test::roomSea();
  page.places.resize(2);
  page.places[1].up = {0, -1, 0};
  refused(page, "nothing in common");
  EXPECT_THAT(
      [&] {
        writeSeaPage(
            test::roomSea(), [](size_t) { return Image<Rgb8>(); }, folder.path());
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("place 0"), HasSubstr("no pixels"))));
}

TEST(SeaPageFiles, AskForEachOtherAndNothingElse) {
  std::set<std::string> names{"index.html", "sea.js"};
  std::string all;
  for (const EmbeddedFile& file : embeddedSeaPage()) {
    names.insert(std::string(file.name));
    all += file.bytes;
  }
  std::set<std::string> wanted{"index.html"};
  const std::regex expression(R"re((?:href|src)="([^":]+)")re");
  for (std::sregex_iterator each(all.begin(), all.end(), expression), end; each != end; ++each) {
    wanted.insert((*each)[1].str());
  }
  EXPECT_EQ(names, wanted);
  EXPECT_THAT(all, testing::Not(HasSubstr("http")));
  EXPECT_THAT(all, testing::Not(HasSubstr("fetch(")));
}

}  // namespace
}  // namespace ocelli
