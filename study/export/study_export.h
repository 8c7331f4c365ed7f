// The data of a study as tables for others: CSV files, or a data set by the rules of Psych-DS.
//
//   CSV       subjects.csv, runs.csv, trials.csv, answers.csv, events.csv, and columns.csv, which says what each column
//             means; frames.csv and inputs.csv where asked for.
//   Psych-DS  dataset_description.json with the meaning of each column, README.md, CHANGES.md, the protocol in
//             materials/, and the tables in data/, trials by task: data/study-NAME_task-find_data.csv.
//
// Subjects have their pseudonyms, nothing more. What experimenters typed (notes, reasons of pauses) may name people,
// and is left out unless asked for. The database keeps in its audit trail which files were written, so that a
// withdrawal finds them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"

namespace ocelli {

enum class ExportForm { kCsv, kPsychDs };

struct ExportOptions {
  ExportForm form = ExportForm::kCsv;
  bool frames = false;     ///< every frame of every trial
  bool inputs = false;     ///< every key and every move of the mouse
  bool gaze = false;       ///< where subjects looked
  bool notes = false;      ///< what experimenters typed
  bool overwrite = false;  ///< into a folder that holds files: those of an earlier export go, others stay
};

struct ExportReport {
  std::vector<std::string> files;  ///< in the folder
  int64_t rows = 0;
  int subjects = 0;
  int simulatedSubjects = 0;  ///< of them
  /// The database cannot be written, and so does not know of these files: a withdrawal will not find them.
  bool recorded = true;
};

/// Makes the folder where there is none. Throws InputError where it holds files and `overwrite` is not set, or has a
/// name that the database cannot keep; WorkError where it cannot be written, or a withdrawal or another export is under
/// way.
ExportReport exportStudy(const std::filesystem::path& database, const std::filesystem::path& folder,
                         const ExportOptions& options, const Progress& progress = {});

}  // namespace ocelli
