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

/// Pinholes that look at the pillar: an I-node with hidden samples, and images that hang on it.
Bytes hiddenSea() {
  const TemporaryFolder folder;
  std::vector<SeaPose> poses = aroundThePillar();
  poses.resize(3);
  for (SeaPose& pose : poses) {
    pose.worldFromCamera = glm::angleAxis(glm::radians(-90.0), glm::dvec3(0, 1, 0));
  }
  const RoomImages images(
      poses, {.kind = SeaProjectionKind::kPinhole, .width = 16, .height = 16, .focal = {10, 10}, .center = {8, 8}});
  SeaSettings settings = settingsOf(images);
  settings.hidden = "walls";
  settings.hiddenViews = 1;
  buildSea(images, roomProxy(), settings, folder / "hidden.sea", false, {},
           [](const Mesh&, const SeaPose&, double) { return wallPoints(0.05f); });
  const std::string text = fileBytes(folder / "hidden.sea");
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

/// Where the entry of the I-node lies in the index.
uint64_t hiddenEntryAt(const Bytes& file) {
  uint64_t at = headerOf(file).indexOffset;
  while (seaRecord<sea::IndexEntry>(file, at).hiddenBytes == 0) {
    at += sizeof(sea::IndexEntry);
  }
  return at;
}
uint64_t hiddenPayloadAt(const Bytes& file) {
  const auto entry = seaRecord<sea::IndexEntry>(file, hiddenEntryAt(file));
  return sea::hiddenOffset(entry.offset, entry.hiddenBytes);
}
/// `Record` has no check of its own.
template <class Record>
Bytes withHidden(const Bytes& file, uint64_t at, const std::function<void(Record& record)>& change) {
  Bytes changed = file;
  auto record = seaRecord<Record>(changed, at);
  change(record);
  putSeaRecord(changed, at, record);
  repairSeaChecksums(changed);
  return changed;
}

/// Hidden samples that mislead.
std::vector<SeaCase> hiddenCases() {
  const Bytes good = hiddenSea();
  const uint64_t entry = hiddenEntryAt(good);
  const uint64_t payload = hiddenPayloadAt(good);
  const uint64_t record = payload - sizeof(sea::RecordHeader);
  using Prefix = sea::HiddenPrefix;
  const auto withNearest = [&](float nearest) {
    return withHidden<Prefix>(good, payload, [=](Prefix& p) { p.nearest = nearest; });
  };
  const auto withBytes = [&](uint32_t bytes) {
    return withEntry<sea::IndexEntry>(good, entry, [=](sea::IndexEntry& e) { e.hiddenBytes = bytes; });
  };
  return {
      {"good_hidden", good},
      {"bad_hidden_layers", withHidden<Prefix>(good, payload, [](Prefix& p) { p.layers = 5; }), "layers"},
      {"bad_hidden_no_layers", withHidden<Prefix>(good, payload, [](Prefix& p) { p.layers = 0; }), "layers"},
      {"bad_hidden_nearest", withNearest(std::numeric_limits<float>::quiet_NaN()), "how near"},
      {"bad_hidden_mask", withHidden<uint16_t>(good, payload + sizeof(Prefix), [](uint16_t& masks) { masks = 0; }),
       "there are none"},
      {"bad_hidden_color", withHidden<Prefix>(good, payload, [](Prefix& p) { p.colorBytes = ~0u; }), "too early"},
      {"bad_hidden_level", withHidden<Prefix>(good, payload, [](Prefix& p) { --p.levelBytes; }), "image"},
      {"bad_hidden_none", withBytes(0), "index of image"},
      {"bad_hidden_long", withBytes(~0u), "index of image"},
      {"bad_hidden_short", withBytes(8), "index of image"},
      {"bad_hidden_of_a_residual", withIndex(good, [](sea::IndexEntry& e) { e.hiddenBytes = 64; }), "index of image"},
      {"bad_hidden_number", withEntry<sea::RecordHeader>(good, record, [](sea::RecordHeader& h) { h.number += 1; }),
       "another image"},
  };
}

std::vector<SeaCase> plainCases() {
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

}  // namespace

std::vector<SeaCase> seaCases() {
  std::vector<SeaCase> cases = plainCases();
  const std::vector<SeaCase> hidden = hiddenCases();
  cases.insert(cases.end(), hidden.begin(), hidden.end());
  return cases;
}

}  // namespace ocelli::test
