// The tables of a study's database, as protocols/trials.schema.sql has them.
#pragma once

#include <cstdint>

namespace ocelli {

/// `application_id` of these files: "Ocel".
inline constexpr int32_t kTrialsApplicationId = 0x4f63656c;
/// `user_version` of files that this program writes (migrations.h).
inline constexpr int kTrialsSchemaVersion = 1;

/// SQL that makes an empty database of that version.
const char* trialsSchema();

}  // namespace ocelli
