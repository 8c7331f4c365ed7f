// The tables of a study's database, as protocols/trials.schema.sql has them.
#pragma once

namespace ocelli {

/// SQL that makes an empty database of version kTrialsSchemaVersion (study/trial/trials_file.h).
const char* trialsSchema();

/// SQL that makes a database of version 2 of one of version 1 (study/store/migration_1.sql).
const char* migrationOfVersion1();

/// SQL that makes a database of version 3 of one of version 2 (study/store/migration_2.sql).
const char* migrationOfVersion2();

/// SQL that makes a database of version 4 of one of version 3 (study/store/migration_3.sql).
const char* migrationOfVersion3();

}  // namespace ocelli
