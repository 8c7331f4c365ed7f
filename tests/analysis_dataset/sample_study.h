// Small databases of studies, made by SQL from protocols/trials.schema.sql.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ocelli::test {

/// A folder that goes with its owner.
class SampleFolder {
 public:
  SampleFolder();
  ~SampleFolder();
  SampleFolder(const SampleFolder&) = delete;
  SampleFolder& operator=(const SampleFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

struct SampleTrial {
  std::string subject = "S01";
  int session = 1;
  std::optional<int> plan = 0;  ///< nothing: practice
  std::string task = "find";
  int blockIndex = 0;
  std::string block = "find stationary";
  int caseIndex = 0;
  std::string caseLabel = "location 1";
  std::string view = "ppc";
  std::string ending = "completed";  ///< empty: it runs
  std::optional<bool> moving = false;
  std::optional<double> exposure{};
  std::optional<int> objects = 1;
  std::optional<bool> duplicates{};
  std::string answer = "here";
  std::string expected = "here";
  bool correct = true;
  bool censored = false;
  double response = 10;
  std::string measures = "{}";
  int frames = 100;
  int dropped = 0;
  std::string verdict = "good";
  int attempt = 1;
};

/// `kSampleProtocol` has two blocks: "find stationary" with practice, and "count stationary"; a maze of 2 x 3 cells.
extern const char* const kSampleProtocol;

class SampleStudy {
 public:
  explicit SampleStudy(const std::string& path, const std::string& protocol = kSampleProtocol);

  void addSubject(const std::string& id, const std::string& kind = "person", const std::string& key = "");
  /// With one run that ended so; empty: it runs.
  void addSession(const std::string& subject, int session, const std::string& ending = "completed",
                  bool forced = false);
  void addConsent(const std::string& subject, bool agreed);
  void addAnswer(const std::string& subject, const std::string& form, const std::string& field,
                 const std::string& answer, int session = 1);
  int64_t addTrial(const SampleTrial& trial);
  /// At ticks 0, 4, 8, ...
  void addFrame(int64_t trial, int frame, double x, double z, double heading);

  SQLite::Database& database() { return database_; }

 private:
  SQLite::Database database_;
  int64_t trials_ = 0;
};

/// S01 and S02 with consent, demographics, survey and two sessions of two searches and one count each; S02's first
/// search ran out of time.
void fillSmallStudy(SampleStudy& study);

/// The text of what `work` throws as an error of ours; empty where it throws none.
template <class Work>
std::string analysisErrorOf(const Work& work);

}  // namespace ocelli::test

#include "oc_core/base/error.h"

template <class Work>
std::string ocelli::test::analysisErrorOf(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}
