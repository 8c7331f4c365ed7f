// Progress of long work as a Python callable, and Ctrl-C while it runs.
#pragma once

#include <pybind11/pybind11.h>

#include <thread>

#include "oc_core/base/progress.h"

namespace ocelli {

/// Calls `callback(stage, fraction)`, unless it is None, and looks whether Ctrl-C was pressed: what either raises ends
/// the work. Made on the thread that calls the work, which may then release the interpreter; what other threads report
/// is left out.
class __attribute__((visibility("hidden"))) PythonProgress {
 public:
  explicit PythonProgress(pybind11::object callback);

  Progress function() const;

 private:
  pybind11::object callback_;
  std::thread::id thread_;
};

}  // namespace ocelli
