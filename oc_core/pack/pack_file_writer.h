// Writes what was made of the parts of a scene as one file (pack_format.h).
#pragma once

#include <string>
#include <vector>

#include "oc_core/base/output_file.h"
#include "oc_core/pack/pack_format.h"
#include "oc_core/pack/pack_scene.h"
#include "oc_core/pack/part_file.h"
#include "oc_core/pack/scene_parts.h"

namespace ocelli {

class PackFileWriter {
 public:
  explicit PackFileWriter(const std::filesystem::path& path);

  /// Parts in the order of their plan: those that a part goes on from stand before it. Groups that something replaces
  /// stand before those that nothing does.
  void add(const PackedPart& part);

  /// The rest of the file; its size. Completes `report`.
  uint64_t finish(const ScenePlan& plan, const std::string& description, PackReport& report);

 private:
  opack::GroupRecord write(const PackedGroup& group);
  void write(std::span<const uint8_t> bytes);
  void align();
  void addTree();

  OutputFile file_;
  uint64_t at_ = 0;
  std::vector<uint32_t> firstOfPart_;        ///< the number of its first group in the file
  std::vector<opack::GroupRecord> records_;  ///< of groups that something replaces
  std::vector<opack::GroupRecord> standing_;
};

}  // namespace ocelli
