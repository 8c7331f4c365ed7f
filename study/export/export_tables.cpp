#include "study/export/export_tables.h"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "oc_core/base/check.h"
#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "study/outline/question_kinds.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

/// SQL text in quotes.
std::string inQuotes(const std::string& text, char quote) {
  std::string result(1, quote);
  for (const char c : text) {
    result.append(c == quote ? 2 : 1, c);
  }
  return result + quote;
}

bool isKnownColumn(const std::string& name) {
  const auto& known = columnMeanings();
  return std::any_of(known.begin(), known.end(), [&](const ColumnMeaning& m) { return m.name == name; });
}

std::string inSmallLetters(std::string text) {
  for (char& c : text) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

/// The name of a measure as a column: letters, digits and _, and no other column's, nor one of `taken`. SQLite takes
/// names that differ only in capitals for the same.
std::string columnOfMeasure(const std::string& measure, const std::vector<std::string>& taken) {
  std::string name;
  for (const char c : measure) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += plain ? c : '_';
  }
  if (isKnownColumn(name) || name.empty() || (name.front() >= '0' && name.front() <= '9')) {
    name.insert(0, "measure_");
  }
  const auto isTaken = [&](const std::string& candidate) {
    return isKnownColumn(candidate) || std::any_of(taken.begin(), taken.end(), [&](const std::string& other) {
             return inSmallLetters(other) == inSmallLetters(candidate);
           });
  };
  std::string column = name;
  for (int i = 2; isTaken(column); ++i) {
    column = fmt::format("{}_{}", name, i);
  }
  return column;
}

constexpr const char* kHex = "CASE WHEN {0} IS NULL THEN NULL ELSE printf('0x%016x', {0}) END";

}  // namespace

ExportTable subjectsTable() {
  return {"subjects",
          "SELECT row_number() OVER (ORDER BY created_utc, subject_id) AS row_id, subject_id, simulated, "
          "kind AS subject_kind, slot, created_utc, "
          "(SELECT count(*) FROM session WHERE session.subject_id = subject.subject_id) AS sessions "
          "FROM subject ORDER BY created_utc, subject_id"};
}

ExportTable runsTable() {
  return {"runs",
          fmt::format("SELECT row_number() OVER (ORDER BY run_id) AS row_id, run_id, run.subject_id, run.simulated, "
                      "run.session_number, run_number, run.started_utc, ended_utc, ending, {} AS schedule_seed, "
                      "program_version, station, forced, environment_json, timing_check_json, simulation_json "
                      "FROM run JOIN session USING (subject_id, session_number) ORDER BY run_id",
                      fmt::format(kHex, "seed"))};
}

ExportTable trialsTable(SQLite::Database& database, const std::string& task) {
  const std::string where = task.empty() ? "" : fmt::format(" WHERE task = {}", inQuotes(task, '\''));
  ExportTable table{"trials", ""};
  std::string measures;
  SQLite::Statement row(database, "SELECT DISTINCT key FROM trial, json_each(measures_json)" + where + " ORDER BY key");
  while (row.executeStep()) {
    const std::string key = textOf(row, 0);
    table.measures.push_back(columnOfMeasure(key, table.measures));
    measures += fmt::format(", (SELECT value FROM json_each(measures_json) WHERE key = {}) AS {}", inQuotes(key, '\''),
                            inQuotes(table.measures.back(), '"'));
  }
  table.query = fmt::format(
      "SELECT row_number() OVER (ORDER BY trial_id) AS row_id, trial_id, subject_id, trial.simulated, "
      "kind AS subject_kind, slot, session_number, run_id, trial_number, "
      "trial_id IN (SELECT trial_id FROM final_trial) AS counts, practice, plan_index, attempt, block_index, block, "
      "task, "
      "case_index, case_label, view, moving, exposure_s, objects, duplicate_colors, ending, answer, expected, correct, "
      "censored, response_s, exposure_rule, exposure_shown_s, exposure_frames{0}, frames, dropped_frames, "
      "median_interval_ns, longest_interval_ns, "
      "timing_verdict, forced, screen_width_px, screen_height_px, refresh_hz, {1} AS trial_seed, started_ns, ended_ns, "
      "trial.started_utc, trial.ended_utc "
      "FROM trial JOIN subject USING (subject_id) "
      "JOIN (SELECT run_id, forced FROM run) USING (run_id){2} ORDER BY trial_id",
      measures, fmt::format(kHex, "trial_seed"), where);
  return table;
}

ExportTable answersTable(const std::vector<ProtocolForm>& forms) {
  // What each answer is comes of the protocol: databases hold texts.
  std::string types;
  for (const ProtocolForm& form : forms) {
    for (const QuestionItem& item : itemsOf(form.fields)) {
      const FormField& field = form.fields[static_cast<size_t>(item.field)];
      types += fmt::format("{}({}, {}, '{}')", types.empty() ? "VALUES " : ", ", inQuotes(form.name, '\''),
                           inQuotes(item.name, '\''), nameOf(questionKind(field.kind).value));
    }
  }
  return {"answers",
          fmt::format("WITH question(form, field, type) AS ({}) "
                      "SELECT row_number() OVER (ORDER BY answer_id) AS row_id, subject_id, simulated, session_number, "
                      "run_id, answer.form, answer.field, coalesce(type, '') AS answer_type, answer, "
                      "answer <> '' AS answered, "
                      "answer_id IN (SELECT answer_id FROM final_answer) AS counts, answered_utc "
                      "FROM answer LEFT JOIN question USING (form, field) ORDER BY answer_id",
                      types.empty() ? "SELECT '', '', '' WHERE 0" : types)};
}

ExportTable eventsTable(bool notes) {
  return {"events",
          fmt::format("SELECT row_number() OVER (ORDER BY event_id) AS row_id, subject_id, simulated, session_number, "
                      "run_id, at_ns, at_utc, what, {} AS detail FROM event ORDER BY event_id",
                      notes ? "detail" : "CASE WHEN what IN ('note', 'pause', 'abort') THEN '' ELSE detail END")};
}

// Subjects stand in these too: by them a withdrawal finds the files.
ExportTable framesTable() {
  return {"frames", fmt::format("SELECT row_number() OVER (ORDER BY trial_id, frame) AS row_id, trial_id, subject_id, "
                                "frame.simulated, frame, tick, shown_ns, x_m, z_m, heading_rad, {} AS pixel_hash "
                                "FROM frame JOIN (SELECT trial_id, subject_id FROM trial) USING (trial_id) "
                                "ORDER BY trial_id, frame",
                                fmt::format(kHex, "pixel_hash"))};
}

ExportTable inputsTable() {
  return {"inputs",
          "SELECT row_number() OVER (ORDER BY trial_id, input_index) AS row_id, trial_id, subject_id, simulated, "
          "input_index, tick, came_ns, kind, what, pressed, modifiers, x, y, more_json "
          "FROM input JOIN (SELECT trial_id, subject_id FROM trial) USING (trial_id) ORDER BY trial_id, input_index"};
}

ExportTable gazeTable() {
  return {"gaze",
          "SELECT row_number() OVER (ORDER BY trial_id, gaze_index) AS row_id, trial_id, subject_id, simulated, "
          "gaze_index, came_ns, device_time, valid, x_px, y_px, pupil "
          "FROM gaze JOIN (SELECT trial_id, subject_id FROM trial) USING (trial_id) ORDER BY trial_id, gaze_index"};
}

StudyFacts studyFactsOf(SQLite::Database& database, const std::filesystem::path& path) {
  SQLite::Statement row(database, "SELECT protocol_name, protocol_sha256, protocol_text FROM study");
  if (!row.executeStep()) {
    throw InputError("this database holds no study yet", path.string(), "start a session, which stores the protocol");
  }
  return {textOf(row, 0), textOf(row, 1), textOf(row, 2)};
}

std::vector<ExportTable> tablesBesideTrials(const std::string& protocol, const ExportOptions& options) {
  std::vector<ExportTable> tables{subjectsTable(), runsTable(),
                                  answersTable(formsOfProtocolText(protocol, "the stored protocol")),
                                  eventsTable(options.notes)};
  if (options.frames) {
    tables.push_back(framesTable());
  }
  if (options.inputs) {
    tables.push_back(inputsTable());
  }
  if (options.gaze) {
    tables.push_back(gazeTable());
  }
  return tables;
}

std::vector<std::string> tasksOf(SQLite::Database& database) {
  std::vector<std::string> tasks;
  SQLite::Statement row(database, "SELECT DISTINCT task FROM trial ORDER BY task");
  while (row.executeStep()) {
    tasks.push_back(textOf(row, 0));
  }
  return tasks;
}

std::vector<ColumnMeaning> meaningsOf(SQLite::Database& database, const ExportTable& table) {
  const SQLite::Statement statement(database, table.query);
  std::vector<ColumnMeaning> meanings;
  for (int column = 0; column < statement.getColumnCount(); ++column) {
    const std::string name = statement.getColumnName(column);
    if (std::find(table.measures.begin(), table.measures.end(), name) != table.measures.end()) {
      meanings.push_back(measureMeaning(name));
      continue;
    }
    const auto& known = columnMeanings();
    const auto meaning = std::find_if(known.begin(), known.end(), [&](const auto& m) { return m.name == name; });
    OC_CHECK(meaning != known.end(), "every column has a meaning");
    meanings.push_back(*meaning);
  }
  return meanings;
}

int64_t writeCsv(SQLite::Database& database, const ExportTable& table, const std::filesystem::path& file) {
  constexpr size_t kPiece = size_t{1} << 16;
  OutputFile output(file);
  fmt::memory_buffer lines;
  const auto to = std::back_inserter(lines);
  SQLite::Statement row(database, table.query);
  const int columns = row.getColumnCount();
  for (int column = 0; column < columns; ++column) {
    fmt::format_to(to, "{}{}", column == 0 ? "" : ",", csvText(row.getColumnName(column)));
  }
  fmt::format_to(to, "\r\n");
  int64_t count = 0;
  for (; row.executeStep(); ++count) {
    for (int column = 0; column < columns; ++column) {
      const SQLite::Column value = row.getColumn(column);
      fmt::format_to(to, "{}", column == 0 ? "" : ",");
      if (value.isInteger()) {
        fmt::format_to(to, "{}", value.getInt64());
      } else if (value.isFloat()) {
        fmt::format_to(to, "{}", value.getDouble());
      } else if (!value.isNull()) {
        fmt::format_to(to, "{}", csvText(value.getString()));
      }
    }
    fmt::format_to(to, "\r\n");
    if (lines.size() > kPiece) {
      output.write(std::string_view(lines.data(), lines.size()));
      lines.clear();
    }
  }
  output.write(std::string_view(lines.data(), lines.size()));
  output.commit();
  return count;
}

}  // namespace ocelli
