// The tables of a study's database, as protocols/trials.schema.sql has them.
#pragma once

#include <cstdint>

namespace ocelli {

/// `application_id` of these files: "Ocel".
inline constexpr int32_t kTrialsApplicationId = 0x4f63656c;
/// `user_version` of files that this program writes (migrations.h).
inline constexpr int kTrialsSchemaVersion = 2;

/// SQL that makes an empty database of that version.
const char* trialsSchema();

/// SQL that makes a database of version 2 of one of version 1 (study/store/migration_1.sql).
const char* migrationOfVersion1();

}  // namespace ocelli
