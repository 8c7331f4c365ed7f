// Where subjects stood and looked, from the databases of a data set, trial by trial.
#pragma once

#include <memory>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/measures/walk.h"

namespace ocelli {

class PoseReader {
 public:
  /// Of the databases among the sources; tables hold no poses.
  explicit PoseReader(const std::vector<DataSource>& sources);
  ~PoseReader();
  PoseReader(const PoseReader&) = delete;
  PoseReader& operator=(const PoseReader&) = delete;

  /// Of a trial, in the order of its frames; empty where none are stored. Valid until the next call. Opens a database
  /// for the first of its trials that has any; throws InputError as readDatabase().
  const std::vector<Pose>& posesOf(const Trial& trial);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
