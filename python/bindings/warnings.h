// What C++ has to tell of a source, as Python's warnings.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace ocelli {

/// A UserWarning for each sentence. Throws what a filter makes an error of.
inline void warnOf(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 2) != 0) {
      throw pybind11::error_already_set();
    }
  }
}

}  // namespace ocelli
