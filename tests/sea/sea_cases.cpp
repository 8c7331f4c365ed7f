#include "tests/sea/sea_cases.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "oc_core/sea/sea_build.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/made_sea.h"
#include "tests/sea/sea_repair.h"

namespace ocelli::test {
namespace {

using Bytes = std::vector<uint8_t>;

/// Images of 8x8 pixels: the fuzzer takes no long ones.
Bytes smallSea(SeaWay way, int count) {
  const TemporaryFolder folder;
  const RoomImages images(gridPoses(count, 1, 0.2), {.width = 8, .height = 8});
  SeaSettings settings = settingsOf(images, way);
  settings.spacing = 2;
  buildSea(images, roomProxy(), settings, folder / "small.sea");
  const std::string text = fileBytes(folder / "small.sea");
  return {text.begin(), text.end()};
}

sea::Header headerOf(const Bytes& file) {
  return seaRecord<sea::Header>(file, 0);
}

template <class Entry>
Bytes withEntry(const Bytes& file, uint64_t at, const std::function<void(Entry& entry)>& change) {
  Bytes changed = file;
  auto entry = seaRecord<Entry>(changed, at);
  change(entry);
  putSeaRecord(changed, at, entry);
  repairSeaChecksums(changed);
  return changed;
}

Bytes withPose(const Bytes& file, const std::function<void(sea::PoseEntry& entry)>& change) {
  return withEntry<sea::PoseEntry>(file, headerOf(file).posesOffset, change);
}
/// Of the last image, a P-node.
Bytes withIndex(const Bytes& file, const std::function<void(sea::IndexEntry& entry)>& change) {
  const sea::Header header = headerOf(file);
  return withEntry<sea::IndexEntry>(file, header.indexOffset + (header.images - 1) * sizeof(sea::IndexEntry), change);
}
Bytes withHeader(const Bytes& file, const std::function<void(sea::Header& entry)>& change) {
  return withEntry<sea::Header>(file, 0, change);
}
Bytes withText(const Bytes& file, const std::string& from, const std::string& to) {
  Bytes changed = file;
  const auto at = std::search(changed.begin(), changed.end(), from.begin(), from.end());
  std::copy(to.begin(), to.end(), at);
  repairSeaChecksums(changed);
  return changed;
}

}  // namespace

std::vector<SeaCase> seaCases() {
  const Bytes direct = smallSea(SeaWay::kDirect, 4);
  const Bytes root = smallSea(SeaWay::kRoot, 4);
  const sea::Header header = headerOf(direct);
  const uint64_t prefix =
      seaRecord<sea::IndexEntry>(direct, header.indexOffset + (header.images - 1) * sizeof(sea::IndexEntry)).offset;
  Bytes cut = direct;
  cut.resize(cut.size() - 8);
  repairSeaChecksums(cut);
  return {
      {"good_direct", direct},
      {"good_root", root},
      {"good_one", smallSea(SeaWay::kDirect, 1)},
      {"bad_images_many", withHeader(direct, [](sea::Header& h) { h.images = 1000000; }), "index lies outside"},
      {"bad_images_none", withHeader(direct, [](sea::Header& h) { h.images = 0; }), "damaged"},
      {"bad_index_offset", withHeader(direct, [](sea::Header& h) { h.indexOffset = ~uint64_t{0}; }), "outside"},
      {"bad_poses_offset", withHeader(direct, [](sea::Header& h) { h.posesOffset += 8; }), "poses"},
      {"bad_cut", cut, "damaged"},
      {"bad_position", withPose(direct, [](sea::PoseEntry& p) { p.position[1] = std::nan(""); }), "pose of image 0"},
      {"bad_rotation",
       withPose(direct,
                [](sea::PoseEntry& p) {
                  p.worldFromCamera = {2, 0, 0, 0};
                }),
       "pose of image 0"},
      {"bad_itself", withIndex(direct, [](sea::IndexEntry& e) { e.reference = 3; }), "index of image 3"},
      {"bad_reference", withIndex(direct, [](sea::IndexEntry& e) { e.reference = 77; }), "index of image 3"},
      {"bad_additions", withIndex(direct, [](sea::IndexEntry& e) { e.additions = 0; }), "index of image 3"},
      {"bad_offset", withIndex(direct, [](sea::IndexEntry& e) { e.offset = ~uint64_t{0} - 3; }), "index of image 3"},
      {"bad_bytes", withIndex(direct, [](sea::IndexEntry& e) { e.payloadBytes = 8; }), "index of image 3"},
      {"bad_elsewhere", withIndex(direct, [](sea::IndexEntry& e) { e.offset = 64; }), "image 3"},
      {"bad_prefix_reference",
       withEntry<sea::ImagePrefix>(direct, prefix, [](sea::ImagePrefix& p) { p.reference ^= 2; }), "image 3"},
      {"bad_prefix_rotation",
       withEntry<sea::ImagePrefix>(direct, prefix,
                                   [](sea::ImagePrefix& p) { p.rotation[0] = std::numeric_limits<float>::infinity(); }),
       "image 3"},
      {"bad_codec", withText(direct, "\"png\"", "\"pgn\""), "pgn"},
      {"bad_picture", withText(direct, "IHDR", "JHDR"), "image"},
      {"bad_size", withText(direct, "\"width\": 8", "\"width\": 9"), "image"},
  };
}

}  // namespace ocelli::test
