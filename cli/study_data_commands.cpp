// `ocelli study subjects`, `withdraw`, `merge` and `export`: the data of studies.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/study_command.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/export/study_export.h"
#include "study/store/identity_key.h"
#include "study/store/merge.h"
#include "study/store/study_database.h"
#include "study/store/withdraw.h"

namespace ocelli {
namespace {

void addDatabaseOption(CLI::App& command, std::string& path, const std::string& help) {
  command.add_option("--db", path, help)->required()->type_name("FILE");
}

// ---- subjects

struct SubjectsChoice {
  std::string database;
  bool asJson = false;
  std::string keyFile;
  std::string subject;
  std::string name;
};

std::string describe(const StoredSession& session) {
  const std::string ending = session.ending ? nameOf(*session.ending) : "not ended";
  return fmt::format("session {}: {} of {} trials, {}", session.session, session.completedTrials, session.plannedTrials,
                     ending);
}

/// Of people whose session ended before it was complete. They may come back, so no new subject gets their slot.
std::vector<std::string> slotsLeftEarly(const StudyDatabase& database) {
  std::vector<std::string> slots;
  for (const StoredSubject& subject : database.subjects()) {
    const std::vector<StoredSession> sessions = database.sessions(subject.id);
    if (subject.kind == SubjectKind::kPerson && !sessions.empty() && sessions.back().ending &&
        *sessions.back().ending != SessionEnding::kCompleted) {
      slots.push_back(fmt::format("{} ({}, {})", subject.slot, subject.id, nameOf(*sessions.back().ending)));
    }
  }
  return slots;
}

std::string subjectsAsText(const StudyDatabase& database) {
  const StoredStudy study = database.study();
  std::string text = fmt::format("{}: protocol {}, SHA-256 {}\n", database.path().string(), study.protocolName,
                                 study.protocolSha256.substr(0, 12));
  for (const StoredSubject& subject : database.subjects()) {
    text += fmt::format("  {:<12} {:<20} slot {:>3}", subject.id, nameOf(subject.kind), subject.slot);
    const std::vector<StoredSession> sessions = database.sessions(subject.id);
    for (size_t i = 0; i < sessions.size(); ++i) {
      text += fmt::format("{}{}", i == 0 ? "  " : "; ", describe(sessions[i]));
    }
    text += "\n";
  }
  if (const std::vector<std::string> slots = slotsLeftEarly(database); !slots.empty()) {
    text += fmt::format(
        "  slots of people whose session ended early: {}\n  they stay theirs until `ocelli study "
        "withdraw`, which deletes the data as well\n",
        fmt::join(slots, ", "));
  }
  return text;
}

std::string subjectsAsJson(const StudyDatabase& database) {
  const StoredStudy study = database.study();
  nlohmann::ordered_json json = {{"protocol", study.protocolName},
                                 {"protocol_sha256", study.protocolSha256},
                                 {"subjects", nlohmann::ordered_json::array()}};
  for (const StoredSubject& subject : database.subjects()) {
    nlohmann::ordered_json sessions = nlohmann::ordered_json::array();
    for (const StoredSession& session : database.sessions(subject.id)) {
      nlohmann::ordered_json ending;
      if (session.ending) {
        ending = nameOf(*session.ending);
      }
      sessions.push_back({{"session_number", session.session},
                          {"completed_trials", session.completedTrials},
                          {"planned_trials", session.plannedTrials},
                          {"runs", session.runs},
                          {"ending", ending}});
    }
    json["subjects"].push_back({{"subject_id", subject.id},
                                {"kind", nameOf(subject.kind)},
                                {"slot", subject.slot},
                                {"created_utc", subject.createdUtc},
                                {"sessions", sessions}});
  }
  return textOfJson(json, 2) + "\n";
}

/// Before the first session of a subject or after it.
void noteIdentity(const SubjectsChoice& choice, const CommandContext& context) {
  if (choice.subject.empty() || choice.name.empty()) {
    throw InputError("a line of the identity key needs a subject and a name", "--key", "--subject ID --name NAME");
  }
  if (!isSubjectId(choice.subject)) {
    throw InputError("this is no id of a subject", choice.subject, "use letters, digits, - and _");
  }
  const bool hasTakenPart = std::filesystem::exists(choice.database) &&
                            StudyDatabase::openForReading(choice.database).subject(choice.subject).has_value();
  addIdentity(choice.keyFile, choice.subject, choice.name);
  context.note(fmt::format("added {}{} to {}; keep that file apart from the data", choice.subject,
                           hasTakenPart ? "" : ", who has not taken part yet,", choice.keyFile));
}

void runSubjects(const SubjectsChoice& choice, const CommandContext& context) {
  if (!choice.keyFile.empty()) {
    noteIdentity(choice, context);
    return;
  }
  const StudyDatabase database = StudyDatabase::openForReading(choice.database);
  if (!choice.subject.empty() || !choice.name.empty()) {
    throw InputError("names go into an identity key alone", "--subject, --name", "--key FILE");
  }
  context.print(choice.asJson ? subjectsAsJson(database) : subjectsAsText(database));
}

void addSubjects(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("subjects", "List the subjects of a study, or note who one of them is");
  const auto choice = std::make_shared<SubjectsChoice>();
  addDatabaseOption(command, choice->database, "The database");
  command.add_flag("--json", choice->asJson, "Print the list as JSON");
  command.add_option("--key", choice->keyFile, "Add a line to the identity key, a file apart from the data (CSV)")
      ->type_name("FILE");
  command.add_option("--subject", choice->subject, "With --key: the subject")->type_name("ID");
  command.add_option("--name", choice->name, "With --key: who that is")->type_name("NAME");
  context.finish(command,
                 "  ocelli study subjects --db study.db\n"
                 "  ocelli study subjects --db study.db --key ~/private/key.csv --subject S01 --name \"Ada L.\"",
                 [choice, context] { runSubjects(*choice, context); });
}

// ---- withdraw

struct WithdrawChoice {
  std::string database;
  std::string subject;
  std::string keyFile;
  bool deleteExports = false;
};

void runWithdraw(const WithdrawChoice& choice, const CommandContext& context) {
  WithdrawOptions options;
  options.deleteExports = choice.deleteExports;
  if (!choice.keyFile.empty()) {
    options.keyFile = choice.keyFile;
  }
  const WithdrawReport report = withdrawSubject(choice.database, choice.subject, options);
  for (const std::filesystem::path& file : report.deletedFiles) {
    context.print(fmt::format("deleted {}\n", file.string()));
  }
  if (options.keyFile && !report.identityRemoved) {
    context.note(fmt::format("{} had no line of that subject", choice.keyFile));
  }
  if (report.notesThatNameIt > 0) {
    context.note(fmt::format("{} notes about other subjects hold this id; they stay", report.notesThatNameIt));
  }
  if (report.onlyLeftovers) {
    context.print(
        fmt::format("wiped what an earlier withdrawal had left; the database has no subject {}, so none of its "
                    "rows were deleted now\n",
                    choice.subject));
  } else {
    context.print(fmt::format("deleted the subject: {} sessions with {} trials\n", report.sessions, report.trials));
  }
  context.note(fmt::format(
      "not reached: copies of the database, databases merged from it, and exports and reports that were moved; `grep "
      "-rlw {} FOLDER` finds tables and pages that name them",
      choice.subject));
}

void addWithdraw(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("withdraw", "Delete a subject so that no byte of theirs remains");
  const auto choice = std::make_shared<WithdrawChoice>();
  addDatabaseOption(command, choice->database, "The database");
  command.add_option("--subject", choice->subject, "Who withdraws")->required()->type_name("ID");
  command.add_flag("--delete-exports", choice->deleteExports, "Delete exports and reports that hold the subject");
  command.add_option("--key", choice->keyFile, "Take the subject out of this identity key too")->type_name("FILE");
  context.finish(command, "  ocelli study withdraw --db study.db --subject S07 --delete-exports",
                 [choice, context] { runWithdraw(*choice, context); });
}

// ---- merge

struct MergeChoice {
  std::string database;
  std::vector<std::string> sources;
};

/// "slots 0-11: 2 each; slot 12: 1 each", or empty where there is nobody.
std::string balanceAsText(const std::vector<int>& use) {
  std::string text;
  for (size_t first = 0; first < use.size();) {
    size_t last = first;
    while (last + 1 < use.size() && use[last + 1] == use[first]) {
      ++last;
    }
    const std::string slots = first == last ? fmt::format("slot {}", first) : fmt::format("slots {}-{}", first, last);
    text += fmt::format("{}{}: {} each", text.empty() ? "" : "; ", slots, use[first]);
    first = last + 1;
  }
  return text;
}

void runMerge(const MergeChoice& choice, const CommandContext& context) {
  const MergeReport report = mergeDatabases(choice.database, {choice.sources.begin(), choice.sources.end()});
  context.print(fmt::format("{}: {} new subjects, {} new runs, {} new trials; {} subjects were there before\n",
                            choice.database, report.subjects, report.runs, report.trials, report.knownSubjects));
  if (report.runsThatWentOn > 0) {
    context.print(
        fmt::format("  {} runs that were there had gone on; the rest of them is added\n", report.runsThatWentOn));
  }
  if (!report.withdrawnSubjects.empty()) {
    context.note(
        fmt::format("left out, as they withdrew from {} or one of the sources: {}; withdraw them from the others "
                    "too",
                    choice.database, fmt::join(report.withdrawnSubjects, ", ")));
  }
  if (!report.withdrewElsewhere.empty()) {
    context.note(
        fmt::format("caution: {} still has subjects who withdrew from one of the sources: {}; `ocelli study "
                    "withdraw` deletes them here too",
                    choice.database, fmt::join(report.withdrewElsewhere, ", ")));
  }
  for (const bool simulated : {false, true}) {
    if (const std::string balance = balanceAsText(slotUse(choice.database, simulated)); !balance.empty()) {
      context.print(fmt::format("  {}, {}\n", simulated ? "simulated subjects" : "people", balance));
    }
  }
}

void addMerge(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("merge", "Join the databases of several stations");
  const auto choice = std::make_shared<MergeChoice>();
  addDatabaseOption(command, choice->database, "Where to; made where there is none");
  command.add_option("SOURCE", choice->sources, "Databases of the same protocol; they are only read")->required();
  context.finish(command, "  ocelli study merge --db all.db station-1.db station-2.db",
                 [choice, context] { runMerge(*choice, context); });
}

// ---- export

struct StudyExportChoice {
  std::string database;
  std::string folder;
  std::string form = "csv";
  ExportOptions options;
};

void runStudyExport(const StudyExportChoice& choice, const CommandContext& context) {
  ExportOptions options = choice.options;
  options.form = choice.form == "csv" ? ExportForm::kCsv : ExportForm::kPsychDs;
  const ExportReport report = exportStudy(choice.database, choice.folder, options, context.progress());
  context.note(fmt::format("wrote {} files with {} rows of {} subjects to {}", report.files.size(), report.rows,
                           report.subjects, choice.folder));
  if (!report.recorded) {
    context.note("the database is read-only and does not know of this export: a withdrawal will not find these files");
  }
  if (report.simulatedSubjects > 0) {
    context.note(
        fmt::format("{} of the subjects are simulated; the column \"simulated\" says which", report.simulatedSubjects));
  }
}

void addStudyExport(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand("export", "Write the data as CSV, or as a Psych-DS data set");
  const auto choice = std::make_shared<StudyExportChoice>();
  ExportOptions& options = choice->options;
  addDatabaseOption(command, choice->database, "The database");
  command.add_option("-o,--output", choice->folder, "A folder, new or empty")->required()->type_name("FOLDER");
  command.add_option("--form", choice->form, "What to write")
      ->check(CLI::IsMember({"csv", "psych-ds"}))
      ->type_name("csv|psych-ds")
      ->capture_default_str();
  command.add_flag("--frames", options.frames, "Also every frame of every trial: where one stood, and when");
  command.add_flag("--inputs", options.inputs, "Also every key, click and move of the mouse");
  command.add_flag("--gaze", options.gaze, "Also where subjects looked, as eye trackers said");
  command.add_flag("--notes", options.notes, "Also what experimenters typed, which may name people");
  command.add_flag("--force", options.overwrite, "Replace an earlier export in that folder");
  context.finish(command,
                 "  ocelli study export --db study.db -o tables\n"
                 "  ocelli study export --db study.db --form psych-ds --frames -o dataset",
                 [choice, context] { runStudyExport(*choice, context); });
}

}  // namespace

void addStudyDataCommands(CLI::App& study, const CommandContext& context) {
  addSubjects(study, context);
  addWithdraw(study, context);
  addMerge(study, context);
  addStudyExport(study, context);
}

}  // namespace ocelli
