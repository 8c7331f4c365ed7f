// The analysis of studies: the report's numbers, as the JSON and the tables of files that `ocelli analyse` writes.
#include <pybind11/stl.h>

#include "analysis/dataset/column_map.h"
#include "analysis/report/json_report.h"
#include "analysis/report/study_analysis.h"
#include "python/bindings/bindings.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

/// What of an analysis Python makes tables of.
struct AnalysedStudy {
  StudyAnalysis study;
  ReportDocument report;
  std::string json;
  std::vector<ReportFile> files;
};

AnalysedStudy analysedStudy(const StudyAnalysisRequest& request, const Progress& progress) {
  AnalysedStudy done{analyseStudy(request), {}, {}, {}};
  StudyReportOptions options;
  options.only = {request.only.begin(), request.only.end()};
  options.version = OCELLI_VERSION;
  options.created = reportTimeNow();
  options.progress = progress;
  done.report = studyReport(done.study.analysis, done.study.tables, options);
  done.json = jsonReport(done.report);
  done.files = tableFiles(done.study.analysis, done.report, options, true);
  return done;
}

py::dict analysed(const std::vector<std::string>& sources, const std::string& plan, const std::string& protocol,
                  const std::string& columns, const std::vector<std::string>& only, const std::string& simulated,
                  bool otherProtocols, std::optional<uint64_t> seed, const py::object& progress) {
  const StudyAnalysisRequest request{
      .sources = sources,
      .plan = plan,
      .protocol = protocol,
      .columns = columns,
      .only = only,
      .merge = {.simulated = simulatedRowsFromName(simulated, "simulated"), .allowOtherProtocols = otherProtocols},
      .seed = seed};
  const PythonProgress told(progress);
  const AnalysedStudy done = [&] {
    const py::gil_scoped_release released;
    return analysedStudy(request, told.function());
  }();
  const AnalysisData& analysis = done.study.analysis;
  py::dict files;
  for (const ReportFile& file : done.files) {
    files[py::str(file.name)] = file.bytes;
  }
  py::dict all;
  all["report"] = done.json;
  all["files"] = files;
  all["warnings"] = analysis.warnings;
  all["failures"] = done.report.failures;
  all["subjects"] = analysis.flow.analysed;
  all["trials"] = analysis.flow.analysedTrials;
  all["simulated"] = isSimulated(analysis);
  all["data_sha256"] = analysis.dataSha256;
  all["plan_sha256"] = analysis.plan.sha256;
  return all;
}

}  // namespace

void bindAnalysis(py::module_& module) {
  module.def("analyse", &analysed, py::arg("sources"), py::arg("plan"), py::arg("protocol"), py::arg("columns"),
             py::arg("only"), py::arg("simulated"), py::arg("other_protocols"), py::arg("seed"), py::arg("progress"));
  module.def("column_maps", &builtInColumnMapNames);
}

}  // namespace ocelli
