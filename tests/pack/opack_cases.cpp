#include "tests/pack/opack_cases.h"

#include <functional>
#include <limits>
#include <string_view>

#include "oc_core/pack/pack_file_writer.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/opack_repair.h"

namespace ocelli::test {
namespace {

using Bytes = std::vector<uint8_t>;

/// A fan of triangles that all differ, at `x`.
LevelCluster fan(float x, uint8_t triangles, const GroupName& finer = {}) {
  LevelCluster level;
  level.finer = finer;
  for (uint8_t i = 0; i < triangles + 2; ++i) {
    const auto k = static_cast<float>(i);
    level.cluster.positions.emplace_back(x + 0.01f * k, 0.02f * k * k, 0.1f * k);
    level.cluster.colors.push_back({static_cast<uint16_t>(1000 * i), 30000, 65535});
  }
  for (uint8_t i = 0; i < triangles; ++i) {
    level.cluster.triangles.push_back({0, static_cast<uint8_t>(i + 1), static_cast<uint8_t>(i + 2)});
  }
  level.finerSphere = level.cluster.bounds();
  return level;
}

PackedGroup groupOf(std::vector<LevelCluster> clusters, float error) {
  ClusterGroup group;
  for (const LevelCluster& level : clusters) {
    group.sphere = around(group.sphere, level.cluster.bounds());
  }
  group.clusters = std::move(clusters);
  group.error = error;
  return packedGroup(group);
}

Bytes writtenPack(const PackedPart& part, uint64_t triangles, const std::string& description) {
  const TemporaryFolder folder;
  ScenePlan plan;
  plan.triangles = triangles;
  plan.box = {glm::vec3(-1), glm::vec3(1)};
  PackReport report;
  PackFileWriter file(folder / "small.opack");
  file.add(part);
  file.finish(plan, description, report);
  const std::string bytes = fileBytes(folder / "small.opack");
  return {bytes.begin(), bytes.end()};
}

constexpr const char* kDescription = R"({"scene": "builtin:box", "fit": true, "shading": "lambert"})";

Bytes onePack() {
  PackedPart part;
  part.groups.push_back(groupOf({fan(0, 2)}, std::numeric_limits<float>::infinity()));
  return writtenPack(part, 2, kDescription);
}

void overwrite(Bytes& file, uint64_t at, std::string_view with) {
  std::copy(with.begin(), with.end(), file.begin() + static_cast<std::ptrdiff_t>(at));
}

/// The small pack after changes, with checksums that fit.
Bytes changedTrailer(const std::function<void(opack::Trailer&)>& change) {
  Bytes file = smallPack();
  opack::Trailer trailer = opackTrailer(file);
  change(trailer);
  trailer.check = opack::checkOf(trailer);
  putOpackRecord(file, file.size() - sizeof(trailer), trailer);
  return file;
}

Bytes changedGroup(uint32_t group, const std::function<void(opack::GroupRecord&)>& change) {
  Bytes file = smallPack();
  const uint64_t at = opackTrailer(file).tableOffset + group * sizeof(opack::GroupRecord);
  auto record = opackRecord<opack::GroupRecord>(file, at);
  change(record);
  putOpackRecord(file, at, record);
  repairOpackChecksums(file);
  return file;
}

/// The first cluster of the group, and its bytes in the file from its arrays on.
Bytes changedCluster(uint32_t group, const std::function<void(opack::ClusterRecord&, uint8_t* arrays)>& change) {
  Bytes file = smallPack();
  const auto groupRecord =
      opackRecord<opack::GroupRecord>(file, opackTrailer(file).tableOffset + group * sizeof(opack::GroupRecord));
  auto record = opackRecord<opack::ClusterRecord>(file, groupRecord.offset);
  change(record, file.data() + groupRecord.offset + record.offset);
  putOpackRecord(file, groupRecord.offset, record);
  repairOpackChecksums(file);
  return file;
}

Bytes described(const std::string& text) {
  PackedPart part;
  part.groups.push_back(groupOf({fan(0, 2)}, std::numeric_limits<float>::infinity()));
  return writtenPack(part, 2, text);
}

void addBadEnds(std::vector<OpackCase>& cases) {
  const Bytes whole = smallPack();
  const auto cut = [&](size_t size) { return Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)); };
  cases.push_back({"bad_empty", {}, "too short"});
  cases.push_back({"bad_truncated", cut(whole.size() - 1), "cut off"});
  cases.push_back({"bad_half", cut(whole.size() / 2), "cut off"});
  Bytes longer = whole;
  longer.push_back(0);
  cases.push_back({"bad_trailing_byte", longer, "cut off"});
  Bytes other = whole;
  overwrite(other, 1, "opack");
  cases.push_back({"bad_magic", other, "no packed scene"});
  other = whole;
  other[8] = 2;
  cases.push_back({"bad_version", other, "version 2"});
  other = whole;
  other[other.size() - 20] ^= 1U;
  cases.push_back({"bad_end_checksum", other, "its end is damaged"});
  const auto trailer = [&](const char* name, const char* complaint,
                           const std::function<void(opack::Trailer&)>& change) {
    cases.push_back({name, changedTrailer(change), complaint});
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  trailer("bad_file_bytes", "cut off", [](auto& t) { ++t.fileBytes; });
  trailer("bad_table_offset", "do not fit", [](auto& t) { t.tableOffset = ~uint64_t{0}; });
  trailer("bad_group_count", "do not fit", [](auto& t) { t.groups = 0xffffffffU; });
  trailer("bad_no_group", "do not fit", [](auto& t) { t.groups = 0; });
  trailer("bad_fewer_groups", "what its end says", [](auto& t) { --t.groups; });
  trailer("bad_description_offset", "do not fit", [](auto& t) { t.descriptionOffset = ~uint64_t{0}; });
  trailer("bad_description_bytes", "do not fit", [](auto& t) { t.descriptionBytes = 70000; });
  trailer("bad_description_checksum", "description is damaged", [](auto& t) { ++t.descriptionCheck; });
  trailer("bad_box", "finite", [](auto& t) { t.upper[1] = kNan; });
  trailer("bad_few_triangles", "what its end says", [](auto& t) { t.triangles = 1; });
  trailer("bad_stored_triangles", "what its end says", [](auto& t) { ++t.storedTriangles; });
  trailer("bad_cluster_count", "what its end says", [](auto& t) { t.clusters = uint64_t{1} << 60U; });
  cases.push_back({"bad_description_json", described("{"), ""});
  cases.push_back({"bad_description_type", described(R"({"fit": 3})"), "fit"});
}

void addBadGroups(std::vector<OpackCase>& cases) {
  const auto group = [&](const char* name, uint32_t index, const std::function<void(opack::GroupRecord&)>& change,
                         const char* complaint = "the record of group") {
    cases.push_back({name, changedGroup(index, change), complaint});
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  group("bad_group_offset", 1, [](auto& g) { g.offset = ~uint64_t{0}; });
  group("bad_group_bytes", 1, [](auto& g) { g.blobBytes = 0xffffffffU; });
  group("bad_group_clusters", 1, [](auto& g) { g.clusters = 0xffffffffU; });
  group("bad_group_sphere", 1, [](auto& g) { g.center[2] = kNan; });
  group("bad_group_radius", 1, [](auto& g) { g.radius = -1; });
  group("bad_group_error", 1, [](auto& g) { g.error = kNan; });
  group("bad_inner_itself", 3, [](auto& g) { g.firstInner = 3; });
  group("bad_inner_above", 1, [](auto& g) {
    g.firstInner = 3;
    g.innerGroups = 1;
  });
  group("bad_inner_count", 3, [](auto& g) { g.innerGroups = 0xffffffffU; });
  group(
      "bad_group_triangles", 1, [](auto& g) { ++g.triangles; }, "the clusters of group");
  // All groups show the clusters of one: a file of some kilobytes could hold millions of triangles.
  Bytes shared = smallPack();
  const opack::Trailer trailer = opackTrailer(shared);
  const auto first = opackRecord<opack::GroupRecord>(shared, trailer.tableOffset);
  for (uint32_t i = 1; i < trailer.groups; ++i) {
    putOpackRecord(shared, trailer.tableOffset + i * sizeof(first), first);
  }
  repairOpackChecksums(shared);
  cases.push_back({"bad_shared_bytes", shared, "shares its bytes"});
  Bytes record = smallPack();
  record[trailer.tableOffset + 5] ^= 1U;
  cases.push_back({"bad_group_checksum", record, "the record of group 0"});
  Bytes blob = smallPack();
  blob[first.offset + 40] ^= 1U;
  cases.push_back({"bad_blob_checksum", blob, "the clusters of group 0"});
}

void addBadClusters(std::vector<OpackCase>& cases) {
  const auto cluster = [&](const char* name, uint32_t group,
                           const std::function<void(opack::ClusterRecord&, uint8_t*)>& change) {
    cases.push_back({name, changedCluster(group, change), "the clusters of group"});
  };
  cluster("bad_finer_itself", 1, [](auto& c, auto*) { c.finer = 1; });
  cluster("bad_finer_above", 1, [](auto& c, auto*) { c.finer = 3; });
  cluster("bad_cluster_offset", 1, [](auto& c, auto*) { c.offset = 0xfffffff0U; });
  cluster("bad_cluster_vertices", 1, [](auto& c, auto*) { c.vertices = 65535; });
  cluster("bad_cluster_empty", 1, [](auto& c, auto*) { c.vertices = 0; });
  cluster("bad_cluster_no_triangles", 1, [](auto& c, auto*) { c.triangles = 0; });
  cluster("bad_cluster_radius", 1, [](auto& c, auto*) { c.radius = -2; });
  cluster("bad_vertex", 1, [](auto&, auto* arrays) {
    const float infinite = std::numeric_limits<float>::infinity();
    std::memcpy(arrays + 4, &infinite, sizeof(infinite));
  });
  cluster("bad_corner", 1, [](auto& c, auto* arrays) { arrays[c.vertices * 18 + 1] = 95; });
  cluster("bad_overlapping_clusters", 0, [](auto& c, auto*) {
    // The arrays of the other cluster of this group.
    c.offset += static_cast<uint32_t>(opack::clusterBytes(c.vertices, c.triangles));
    c.vertices += 1;
  });
}

}  // namespace

std::vector<uint8_t> smallPack() {
  PackedPart part;
  part.groups.push_back(groupOf({fan(0, 4), fan(0.2f, 5)}, 0.05f));
  part.groups.push_back(groupOf({fan(0, 2, {0, 0}), fan(0.3f, 1, {0, 0})}, std::numeric_limits<float>::infinity()));
  part.groups.push_back(groupOf({fan(0.6f, 3)}, std::numeric_limits<float>::infinity()));
  return writtenPack(part, 12, kDescription);
}

std::vector<OpackCase> opackCases() {
  std::vector<OpackCase> cases{{"good_levels", smallPack(), ""},
                               {"good_one_group", onePack(), ""},
                               {"good_no_description", described("{}"), ""}};
  addBadEnds(cases);
  addBadGroups(cases);
  addBadClusters(cases);
  return cases;
}

}  // namespace ocelli::test
