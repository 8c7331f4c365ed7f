// Writes one of each chart into a folder, as PNG, SVG and PDF: whoever changes a chart looks at it.
//
// Usage: plot_gallery FOLDER
#include <filesystem>
#include <fstream>

#include "tests/analysis_plot/sample_figures.h"

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "gallery";
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  for (const auto& [prefix, figures] :
       {std::pair<std::string, std::vector<ocelli::SampleFigure>>{"", ocelli::sampleFigures()},
        {"empty_", ocelli::emptyFigures()},
        {"tiny_", ocelli::tinyFigures()}}) {
    for (const ocelli::SampleFigure& sample : figures) {
      write(prefix + sample.name + ".png", ocelli::pngBytes(sample.figure));
      write(prefix + sample.name + ".svg", ocelli::svgText(sample.figure));
      write(prefix + sample.name + ".pdf", ocelli::pdfBytes(sample.figure));
    }
  }
}
