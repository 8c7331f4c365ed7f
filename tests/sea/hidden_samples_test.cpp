// What an I-node does not see and its P-nodes do: gathered, stored, looked up, and what it saves.
#include "oc_core/sea/hidden_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/sea/hidden_bytes.h"
#include "oc_core/sea/hidden_gathering.h"
#include "oc_core/sea/residual.h"
#include "oc_core/sea/sea_build.h"
#include "oc_core/sea/sea_file.h"
#include "oc_core/sea/sea_summary.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

using test::aroundThePillar;
using test::fileBytes;
using test::meanDifference;
using test::RoomImages;
using test::roomProxy;
using test::settingsOf;
using test::TemporaryFolder;
using test::wallPoints;

const ColorCodec& png() {
  return *findColorCodec("png");
}

class HiddenSamplesTest : public testing::Test {
 protected:
  SeaCamera camera(uint32_t image) const { return {images_.projection(), images_.poses()[image]}; }

  /// Of image 0, for all others.
  HiddenSamples gathered(size_t fewest = 1) const {
    HiddenViews views;
    views.poses = {images_.poses().begin() + 1, images_.poses().end()};
    views.image = [&](size_t view) { return images_.image(static_cast<uint32_t>(view) + 1); };
    views.fewest = fewest;
    return gatherHiddenSamples(proxy_, camera(0), wallPoints(0.02f), views);
  }
  /// Image 0 as image `target` sees it.
  PartialImage warped(uint32_t target) const {
    return warpedOver(proxy_, WarpReference(images_.image(0), images_.projection()), images_.poses()[0], camera(target),
                      4);
  }

  RoomImages images_{aroundThePillar(), {.width = 192, .height = 96}};
  SeaProxy proxy_{roomProxy()};
};

TEST_F(HiddenSamplesTest, FillWhatAWarpLeavesOpenWithWhatIsThere) {
  const HiddenSamples hidden = gathered();
  ASSERT_FALSE(hidden.layers.empty());
  for (uint32_t target = 1; target < images_.poses().size(); ++target) {
    const PartialImage before = warped(target);
    PartialImage filled = before;
    addHidden(filled, proxy_, camera(target), camera(0), hidden);
    // The slow reference: a ray to each point, and the pattern there.
    const Image<Rgb8> truth = images_.image(target);
    size_t open = 0;
    size_t known = 0;
    double difference = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
      if (before.isKnown[i] != 0) {
        EXPECT_EQ(filled.image[i], before.image[i]) << "what is known stays";
        continue;
      }
      ++open;
      if (filled.isKnown[i] != 0) {
        ++known;
        for (int c = 0; c < 3; ++c) {
          difference += std::abs(int{filled.image[i][c]} - int{truth[i][c]}) / 3.0;
        }
      }
    }
    ASSERT_GT(open, 20u) << target;
    // What is left is seen at its edge, and at the sides of the pillar that no point was chosen on.
    EXPECT_GT(known, open / 2) << target << " of " << open;
    // Pixels of 2 degrees, of a pattern that changes by up to 20 steps from one to the next, interpolated twice.
    EXPECT_LT(difference / static_cast<double>(known), 8) << target;
  }
}

TEST_F(HiddenSamplesTest, AreNeitherSeenByTheINodeNorByFewerImagesThanAskedFor) {
  const HiddenSamples hidden = gathered();
  const size_t all = hidden.cellCount();
  for (const HiddenLayer& layer : hidden.layers) {
    for (int y = 0; y < layer.level.height(); ++y) {
      for (int x = 0; x < layer.level.width(); ++x) {
        if (layer.level(x, y) == 0) {
          continue;
        }
        // Along the ray of some pixel of the cell something is nearer.
        const glm::vec3 eye(images_.poses()[0].position);
        float nearest = 1;
        for (int i = 0; i < 16; ++i) {
          const glm::vec2 pixel(4 * x + i % 4, 4 * y + i / 4);
          const glm::vec3 direction = images_.projection().direction(pixel + 0.5f);
          const SightLine line{eye, eye + direction * 100.0f};
          float share = 0;
          proxy_.rays().meet({&line, 1}, {&share, 1});
          nearest = std::min(nearest, share);
        }
        EXPECT_LT(hidden.levelOf(100 * nearest) + 2, layer.level(x, y));
      }
    }
  }
  const size_t some = gathered(2).cellCount();
  EXPECT_LT(some, all);
  EXPECT_GT(some, 0u);
  EXPECT_EQ(gathered(images_.poses().size()).cellCount(), 0u) << "more views than there are";
}

TEST_F(HiddenSamplesTest, AreNotTakenForAnotherSurface) {
  HiddenSamples hidden = gathered();
  hidden.nearest *= 3;  // all samples are farther away than any surface is
  PartialImage filled = warped(1);
  const PartialImage before = filled;
  addHidden(filled, proxy_, camera(1), camera(0), hidden);
  EXPECT_EQ(filled.isKnown, before.isKnown);
  EXPECT_EQ(filled.image, before.image);
}

TEST_F(HiddenSamplesTest, ComeBackFromTheirBytes) {
  const HiddenSamples hidden = gathered();
  const std::vector<uint8_t> bytes = hiddenBytes(hidden, images_.projection(), png(), 90);
  const HiddenSamples back = hiddenFromBytes(bytes, images_.projection(), png(), "here");
  EXPECT_EQ(back.nearest, hidden.nearest);
  ASSERT_EQ(back.layers.size(), hidden.layers.size());
  for (size_t layer = 0; layer < hidden.layers.size(); ++layer) {
    EXPECT_EQ(back.layers[layer].level, hidden.layers[layer].level);
    for (int y = 0; y < images_.projection().height; ++y) {
      for (int x = 0; x < images_.projection().width; ++x) {
        if (hidden.layers[layer].level(x / HiddenSamples::kCell, y / HiddenSamples::kCell) != 0) {
          EXPECT_EQ(back.layers[layer].color(x, y), hidden.layers[layer].color(x, y)) << x << " " << y;
        }
      }
    }
  }
  for (const size_t size : {size_t{0}, size_t{7}, size_t{20}, bytes.size() - 1}) {
    EXPECT_THROW(hiddenFromBytes({bytes.data(), size}, images_.projection(), png(), "here"), InputError) << size;
  }
  std::vector<uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_THROW(hiddenFromBytes(longer, images_.projection(), png(), "here"), InputError);
  EXPECT_TRUE(hiddenBytes({}, images_.projection(), png(), 90).empty());
}

class HiddenSeaTest : public HiddenSamplesTest {
 protected:
  SeaSettings settings(const std::string& hidden, SeaWay way = SeaWay::kDirect) const {
    SeaSettings settings = settingsOf(images_, way);
    settings.hidden = hidden;
    settings.hiddenViews = 1;
    return settings;
  }
  std::filesystem::path build(const std::string& name, const SeaSettings& settings) const {
    buildSea(images_, roomProxy(), settings, folder_ / name, false, {},
             [](const Mesh&, const SeaPose&, double) { return wallPoints(0.02f); });
    return folder_ / name;
  }

  TemporaryFolder folder_;
};

/// What is left to say of all P-nodes.
double energyOf(const SeaFile& sea, const RoomImages& images) {
  const SeaDecoder decoder(sea.settings(), sea.proxy());
  double energy = 0;
  for (uint32_t i = 0; i < sea.count(); ++i) {
    const uint32_t reference = sea.stored(i).reference;
    if (reference != sea::kNoReference) {
      energy += residualEnergy(images.image(i), decoder.predicted(sea.reference(i), sea.pose(reference), sea.pose(i)));
    }
  }
  return energy;
}

TEST_F(HiddenSeaTest, LowerWhatIsLeftToSay) {
  const SeaFile without(build("without.sea", settings("none")));
  for (const SeaWay way : allSeaWays()) {
    const SeaFile with(build("with.sea", settings("walls", way)));
    with.verify(true);
    EXPECT_EQ(with.settings(), settings("walls", way));
    EXPECT_GT(summaryOf(with).hiddenBytes, 100u);
    for (uint32_t i = 0; i < with.count(); ++i) {
      EXPECT_LT(meanDifference(with.image(i), images_.image(i)), 0.5) << nameOf(way) << " " << i;
      const uint32_t reference = with.stored(i).reference;
      if (reference == sea::kNoReference) {
        EXPECT_EQ(with.image(i), without.image(i)) << "I-nodes are what they were";
      } else {
        EXPECT_EQ(with.imageFrom(with.reference(i), i), with.image(i)) << i;
        EXPECT_GE(with.bytesToRead(i), with.stored(i).bytes + with.stored(reference).hiddenBytes);
      }
    }
    if (way == without.settings().way) {
      EXPECT_LT(energyOf(with, images_), 0.9 * energyOf(without, images_));
    }
  }
}

TEST_F(HiddenSeaTest, SeasWithoutSayNothingOfThem) {
  const std::string plain = fileBytes(build("plain.sea", settings("none")));
  EXPECT_EQ(plain.find("hidden"), std::string::npos);
  buildSea(images_, roomProxy(), settings("none"), folder_ / "again.sea");
  EXPECT_EQ(fileBytes(folder_ / "again.sea"), plain);
  const SeaFile sea(folder_ / "plain.sea");
  EXPECT_EQ(summaryOf(sea).hiddenBytes, 0u);
}

TEST_F(HiddenSeaTest, ABuildThatWasStoppedAnywhereGoesOn) {
  const std::string whole = fileBytes(build("whole.sea", settings("walls")));
  std::string stopped = whole;
  const sea::Header unfinished = sea::sealed(sea::Header{});
  std::memcpy(stopped.data(), &unfinished, sizeof(unfinished));
  // Before each record: also between hidden samples and their image.
  size_t cuts = 0;
  size_t first = 0;
  for (int preamble = 0; preamble < 5; ++preamble) {
    first = stopped.find("SREC", first + 1);
  }
  for (size_t at = first; at != std::string::npos; at = stopped.find("SREC", at + 1)) {
    folder_.write("again.sea.partial", stopped.substr(0, at));
    build("again.sea", settings("walls"));
    EXPECT_TRUE(fileBytes(folder_ / "again.sea") == whole) << at;
    ++cuts;
  }
  EXPECT_GE(cuts, images_.poses().size() + 2) << "images, hidden samples, index";
}

}  // namespace
}  // namespace ocelli
