#include "oc_core/pack/pack_file_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/pack/cluster_groups.h"

namespace ocelli {
namespace {

Sphere sphereOf(const opack::GroupRecord& record) {
  return {{record.center[0], record.center[1], record.center[2]}, record.radius};
}

void setSphere(opack::GroupRecord& record, const Sphere& sphere) {
  record.center = {sphere.center.x, sphere.center.y, sphere.center.z};
  record.radius = sphere.radius;
}

}  // namespace

PackFileWriter::PackFileWriter(const std::filesystem::path& path) : file_(path) {
  write(opack::bytesOf(opack::Mark{}));
}

void PackFileWriter::write(std::span<const uint8_t> bytes) {
  file_.write(bytes);
  at_ += bytes.size();
}

void PackFileWriter::align() {
  constexpr std::array<uint8_t, opack::kAlignment> kZeros{};
  write(std::span(kZeros).first((opack::kAlignment - at_ % opack::kAlignment) % opack::kAlignment));
}

opack::GroupRecord PackFileWriter::write(const PackedGroup& group) {
  std::vector<uint8_t> blob = group.blob;
  for (size_t i = 0; i < group.finer.size(); ++i) {
    if (!group.finer[i].isNone()) {
      const uint32_t number = firstOfPart_[group.finer[i].part] + group.finer[i].index;
      std::memcpy(blob.data() + i * sizeof(opack::ClusterRecord) + offsetof(opack::ClusterRecord, finer), &number,
                  sizeof(number));
    }
  }
  align();
  opack::GroupRecord record{.error = group.error,
                            .clusters = static_cast<uint32_t>(group.finer.size()),
                            .offset = at_,
                            .blobBytes = static_cast<uint32_t>(blob.size()),
                            .triangles = group.triangles,
                            .sceneClusters = group.sceneClusters,
                            .blobCheck = opack::checksum(blob)};
  setSphere(record, group.sphere);
  write(blob);
  return record;
}

void PackFileWriter::add(const PackedPart& part) {
  firstOfPart_.push_back(static_cast<uint32_t>(records_.size()));
  for (const PackedGroup& group : part.groups) {
    const opack::GroupRecord record = write(group);
    (std::isinf(group.error) ? standing_ : records_).push_back(record);
  }
}

/// A tree over the groups that nothing replaces: neighbours stand under one group without clusters of its own.
void PackFileWriter::addTree() {
  std::vector<Sphere> spheres;
  for (const opack::GroupRecord& record : standing_) {
    spheres.push_back(sphereOf(record));
  }
  std::vector<opack::GroupRecord> level;
  for (const uint32_t i : spatialOrder(spheres)) {
    level.push_back(standing_[i]);
  }
  while (level.size() > 1) {
    std::vector<opack::GroupRecord> above;
    for (size_t first = 0; first < level.size(); first += opack::kTree) {
      const size_t count = std::min(opack::kTree, level.size() - first);
      opack::GroupRecord record{.error = std::numeric_limits<float>::infinity(),
                                .firstInner = static_cast<uint32_t>(records_.size() + first),
                                .innerGroups = static_cast<uint32_t>(count)};
      Sphere sphere;
      for (size_t i = first; i < first + count; ++i) {
        sphere = around(sphere, sphereOf(level[i]));
      }
      setSphere(record, sphere);
      above.push_back(record);
    }
    records_.insert(records_.end(), level.begin(), level.end());
    level = std::move(above);
  }
  records_.insert(records_.end(), level.begin(), level.end());
}

uint64_t PackFileWriter::finish(const ScenePlan& plan, const std::string& description, PackReport& report) {
  OC_CHECK(!standing_.empty(), "something of a scene stands for all of it");
  addTree();
  align();
  opack::Trailer trailer{.tableOffset = at_,
                         .triangles = plan.triangles,
                         .groups = static_cast<uint32_t>(records_.size()),
                         .descriptionBytes = static_cast<uint32_t>(description.size()),
                         .lower = {plan.box.lower.x, plan.box.lower.y, plan.box.lower.z},
                         .upper = {plan.box.upper.x, plan.box.upper.y, plan.box.upper.z}};
  for (opack::GroupRecord& record : records_) {
    record.check = opack::checkOf(record);
    trailer.storedTriangles += record.triangles;
    trailer.clusters += record.clusters;
    write(opack::bytesOf(record));
  }
  trailer.descriptionOffset = at_;
  const std::span<const uint8_t> text(reinterpret_cast<const uint8_t*>(description.data()), description.size());
  trailer.descriptionCheck = opack::checksum(text);
  write(text);
  trailer.fileBytes = at_ + sizeof(trailer);
  trailer.check = opack::checkOf(trailer);
  write(opack::bytesOf(trailer));
  file_.commit();
  report.storedTriangles = trailer.storedTriangles;
  report.clusters = trailer.clusters;
  report.groups = trailer.groups;
  return at_;
}

}  // namespace ocelli
