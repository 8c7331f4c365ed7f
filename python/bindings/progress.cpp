#include "python/bindings/progress.h"

#include <string>
#include <utility>

namespace py = pybind11;

namespace ocelli {

PythonProgress::PythonProgress(py::object callback)
    : callback_(std::move(callback)), thread_(std::this_thread::get_id()) {}

Progress PythonProgress::function() const {
  // It refers to this object, which lives for the call: copies must not count references without the interpreter.
  return [this](std::string_view stage, double fraction) {
    if (std::this_thread::get_id() != thread_) {
      return;
    }
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
    if (!callback_.is_none()) {
      callback_(std::string(stage), fraction);
    }
  };
}

}  // namespace ocelli
