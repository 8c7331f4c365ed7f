// A finished figure, and its files: SVG, PDF and PNG, painted by Cairo.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oc_core/drawing/drawing.h"

namespace ocelli {

struct Figure {
  std::string title;        ///< what it shows, in a line; not painted: captions stand outside
  std::string description;  ///< what it shows to those who do not see it, with its numbers
  double width = 0;         ///< points
  double height = 0;
  Drawing drawing;
};

/// A stand-alone SVG with title and description. Letters are outlines, so it looks the same everywhere. The same figure
/// gives the same bytes on the same machine. DrawingError where Cairo fails.
std::string svgText(const Figure& figure);

/// The same to stand inside a page of HTML: without namespaces and file head, its ids start with `idPrefix`, which no
/// other figure of the page may have.
std::string inlineSvgText(const Figure& figure, const std::string& idPrefix);

/// One page of the figure's size, with its fonts.
std::string pdfBytes(const Figure& figure);

/// On white, with so many pixels an inch.
std::string pngBytes(const Figure& figure, double pixelsPerInch = 150);

/// On white, a pixel a point.
Pixels pixelsOf(const Figure& figure);

}  // namespace ocelli
