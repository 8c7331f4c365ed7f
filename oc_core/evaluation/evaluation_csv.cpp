#include "oc_core/evaluation/evaluation_csv.h"

#include <fmt/format.h>

#include <array>

namespace ocelli {
namespace {

/// Fields of one line, quoted where they need it.
class CsvLine {
 public:
  void add(const std::string& text) {
    separate();
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
      line_ += text;
      return;
    }
    line_ += '"';
    for (const char c : text) {
      line_.append(c == '"' ? 2 : 1, c);
    }
    line_ += '"';
  }
  template <class Number>
  void addNumber(Number number) {
    separate();
    line_ += fmt::format("{}", number);
  }
  void addMissing() { separate(); }

  std::string end() const { return line_ + "\n"; }

 private:
  void separate() {
    if (started_) {
      line_ += ',';
    }
    started_ = true;
  }

  std::string line_;
  bool started_ = false;
};

constexpr std::array<const char*, 3> kPlaces{"edges", "interior", "reference"};

std::array<const FrameErrors*, 3> placesOf(const RepresentationFigures& row) {
  return {&row.edges, &row.interior, &row.reference};
}

struct Measure {
  const char* name;
  double (*value)(const FrameErrors&);
  bool ofImages;
};

constexpr std::array<Measure, 7> kMeasures{{
    {"missing_strict", [](const FrameErrors& errors) { return errors.strictRatio(); }, false},
    {"missing_thick", [](const FrameErrors& errors) { return errors.thickRatio(); }, false},
    {"wrong_front", [](const FrameErrors& errors) { return errors.wrongFrontRatio(); }, false},
    {"false_skins", [](const FrameErrors& errors) { return errors.falseSkinRatio(); }, false},
    {"psnr_db", [](const FrameErrors& errors) { return errors.meanPsnrDecibels(); }, true},
    {"ssim", [](const FrameErrors& errors) { return errors.meanSsim(); }, true},
    {"flip", [](const FrameErrors& errors) { return errors.meanFlip(); }, true},
}};

void addMeasure(CsvLine& line, const Measure& measure, const FrameErrors& errors) {
  if (measure.ofImages && errors.images == 0) {
    line.addMissing();
  } else {
    line.addNumber(measure.value(errors));
  }
}

}  // namespace

std::string evaluationCsv(const EvaluationOptions& options, const std::vector<RepresentationFigures>& figures) {
  CsvLine header;
  for (const char* name :
       {"name", "triangles", "samples", "pixels", "bytes_raw", "bytes_zstd", "build_ms", "mesh_ms", "slice_ms"}) {
    header.add(name);
  }
  for (const Measure& measure : kMeasures) {
    for (const char* place : kPlaces) {
      header.add(std::string(measure.name) + "_" + place);
    }
  }
  header.add("strict_ratio_to_di");
  header.add("thick_ratio_to_di");
  std::string text = header.end();
  for (const RepresentationFigures& row : figures) {
    CsvLine line;
    line.add(row.name);
    for (const size_t count : {row.triangles, row.samples, row.pixels, row.bytes.raw, row.bytes.compressed}) {
      line.addNumber(count);
    }
    line.addNumber(row.buildMilliseconds);
    line.addNumber(row.meshMilliseconds);
    if (options.slice) {
      line.addNumber(row.sliceMilliseconds);
    } else {
      line.addMissing();
    }
    for (const Measure& measure : kMeasures) {
      for (const FrameErrors* errors : placesOf(row)) {
        addMeasure(line, measure, *errors);
      }
    }
    line.addNumber(row.strictRatioToDi);
    line.addNumber(row.thickRatioToDi);
    text += line.end();
  }
  return text;
}

std::string sequencesCsv(const EvaluationOptions& options, const std::vector<RepresentationFigures>& figures) {
  CsvLine header;
  for (const char* name : {"name", "edge", "right", "up", "backward"}) {
    header.add(name);
  }
  for (const Measure& measure : kMeasures) {
    header.add(measure.name);
  }
  std::string text = header.end();
  const std::vector<EdgeSequence> sequences = options.cell.edgeSequences(options.edgeViews);
  for (const RepresentationFigures& row : figures) {
    for (size_t edge = 0; edge < sequences.size() && !row.edgeViews.empty(); ++edge) {
      for (size_t step = 0; step < sequences[edge].views.size(); ++step) {
        CsvLine line;
        line.add(row.name);
        line.addNumber(edge);
        for (int axis = 0; axis < 3; ++axis) {
          line.addNumber(sequences[edge].places[step][axis]);
        }
        const FrameErrors& errors = row.edgeViews.at(sequences[edge].views[step]);
        for (const Measure& measure : kMeasures) {
          addMeasure(line, measure, errors);
        }
        text += line.end();
      }
    }
  }
  return text;
}

std::string offsetsCsv(const EvaluationOptions& options, const std::vector<RepresentationFigures>& figures) {
  CsvLine header;
  header.add("name");
  header.add("half_sides");
  for (const Measure& measure : kMeasures) {
    if (!measure.ofImages) {
      header.add(measure.name);
    }
  }
  std::string text = header.end();
  for (const RepresentationFigures& row : figures) {
    for (size_t i = 0; i < row.offsets.size(); ++i) {
      CsvLine line;
      line.add(row.name);
      line.addNumber(options.offsets[i]);
      for (const Measure& measure : kMeasures) {
        if (!measure.ofImages) {
          line.addNumber(measure.value(row.offsets[i]));
        }
      }
      text += line.end();
    }
  }
  return text;
}

}  // namespace ocelli
