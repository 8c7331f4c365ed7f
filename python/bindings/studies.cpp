// Studies: the tables of their databases.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/bindings/bindings.h"
#include "python/bindings/progress.h"
#include "study/export/study_tables.h"

namespace py = pybind11;

namespace ocelli {
namespace {

/// (name, {column: values}, {column: (unit, description)}) of each table.
py::list tables(const std::filesystem::path& database, bool frames, bool inputs, bool gaze, bool notes,
                const py::object& progress) {
  ExportOptions options;
  options.frames = frames;
  options.inputs = inputs;
  options.gaze = gaze;
  options.notes = notes;
  const PythonProgress told(progress);
  const std::vector<StudyTable> read = [&] {
    const py::gil_scoped_release released;
    return studyTables(database, options, told.function());
  }();
  py::list all;
  for (const StudyTable& table : read) {
    py::dict values;
    py::dict meanings;
    for (size_t column = 0; column < table.columns.size(); ++column) {
      const ColumnMeaning& meaning = table.columns[column];
      values[py::str(meaning.name)] = table.values[column];
      meanings[py::str(meaning.name)] = py::make_tuple(meaning.unit, meaning.description);
    }
    all.append(py::make_tuple(table.name, values, meanings));
  }
  return all;
}

}  // namespace

void bindStudies(py::module_& module) {
  module.def("study_tables", &tables, py::arg("database"), py::arg("frames"), py::arg("inputs"), py::arg("gaze"),
             py::arg("notes"), py::arg("progress"));
}

}  // namespace ocelli
