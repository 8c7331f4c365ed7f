#include "analysis/measures/pose_reader.h"

#include <SQLiteCpp/Statement.h>

#include "study/trial/trials_file.h"

namespace ocelli {
namespace {

struct OpenDatabase {
  explicit OpenDatabase(const std::string& file)
      : path(file),
        database(openTrials(file)),
        frames(database, "SELECT tick, x_m, z_m, heading_rad FROM frame WHERE trial_id = ? ORDER BY frame") {}

  std::string path;
  SQLite::Database database;
  SQLite::Statement frames;
};

}  // namespace

struct PoseReader::State {
  std::vector<DataSource> sources;
  std::vector<std::unique_ptr<OpenDatabase>> databases;  ///< one a source, from the first trial with a log
  std::vector<Pose> poses;
};

PoseReader::PoseReader(const std::vector<DataSource>& sources) : state_(std::make_unique<State>()) {
  for (const DataSource& source : sources) {
    state_->sources.push_back({source.path, source.form});
  }
  state_->databases.resize(sources.size());
}

PoseReader::~PoseReader() = default;

const std::vector<Pose>& PoseReader::posesOf(const Trial& trial) {
  state_->poses.clear();
  const DataSource& source = state_->sources[static_cast<size_t>(trial.source)];
  if (source.form != DataSource::Form::kDatabase || trial.frames == 0) {
    return state_->poses;
  }
  auto& open = state_->databases[static_cast<size_t>(trial.source)];
  if (open == nullptr) {
    open = whileReading(source.path, [&] { return std::make_unique<OpenDatabase>(source.path); });
  }
  whileReading(open->path, [&] {
    open->frames.reset();
    open->frames.bind(1, trial.trialId);
    while (open->frames.executeStep()) {
      state_->poses.push_back({open->frames.getColumn(0).getInt64(), open->frames.getColumn(1).getDouble(),
                               open->frames.getColumn(2).getDouble(), open->frames.getColumn(3).getDouble()});
    }
    open->frames.reset();
  });
  return state_->poses;
}

}  // namespace ocelli
