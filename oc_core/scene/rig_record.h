// The rig in the record of a scene (scene_record.h). For scene_record.cpp.
#pragma once

#include "oc_core/base/record_bytes.h"
#include "oc_core/scene/scene_record.h"

namespace ocelli {

void writeRig(RecordWriter& writer, const Rig& rig);

/// `record` has its parts and copies already. Fails where an index is out of range, a node stands before its parent, a
/// number is not finite, weights are out of range or do not add up to 1, times do not ascend, or lists have another
/// length than they must.
Rig readRig(RecordParser& parser, const SceneRecord& record);

}  // namespace ocelli
