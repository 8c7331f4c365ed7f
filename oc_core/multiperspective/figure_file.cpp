#include "oc_core/multiperspective/figure_file.h"

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/drawing/drawing_error.h"

namespace ocelli {

void requireFigureFile(const std::filesystem::path& path) {
  if (path.extension() != ".svg" && path.extension() != ".png" && !isStream(path)) {
    throw InputError("a plan is an SVG or a PNG", path.string(), "end its name in .svg or .png");
  }
}

void writeFigure(const std::filesystem::path& path, const Figure& figure) {
  requireFigureFile(path);
  std::string bytes;
  try {
    bytes = path.extension() == ".png" ? pngBytes(figure, kPointsPerInch) : svgText(figure);
  } catch (const DrawingError& error) {
    throw WorkError(error.what(), path.string(), "make it smaller, or free some memory");
  }
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace ocelli
