// Writes a report with every kind of element into a folder: whoever changes a writer looks at it.
//
// Usage: report_gallery FOLDER
#include "analysis/report/report_files.h"
#include "tests/analysis_report/sample_document.h"

int main(int argc, char** argv) {
  ocelli::writeReportFolder(argc > 1 ? argv[1] : "report_gallery", ocelli::reportFiles(ocelli::sampleDocument()));
}
