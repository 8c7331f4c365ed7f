#include "oc_core/evaluation/evaluation_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>

#include "oc_core/evaluation/error_image.h"
#include "oc_core/evaluation/evaluation_plot.h"
#include "oc_core/evaluation/evaluation_style.h"
#include "oc_core/evaluation/evaluation_work.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

using FigureRows = std::vector<RepresentationFigures>;

// The scene itself: it has no errors to be proud of.
constexpr const char* kSceneItself = "geometry";

struct Column {
  std::string group;
  std::string name;
  std::function<double(const RepresentationFigures&)> value;
  std::function<std::string(double)> text;
  bool moreIsBetter = false;
};

std::string percentText(double ratio) {
  return fmt::format("{:.3f}", 100 * ratio);
}
std::string wholePercentText(double ratio) {
  return fmt::format("{:.1f}", 100 * ratio);
}
std::string decibelText(double value) {
  return std::isinf(value) ? "\u221e" : fmt::format("{:.2f}", value);
}
std::string fourDigits(double value) {
  return fmt::format("{:.4f}", value);
}
std::string countText(double value) {
  return groupedDigits(static_cast<size_t>(value));
}
std::string megabyteText(double bytes) {
  return fmt::format("{:.2f}", bytes / 1e6);
}
std::string timeText(double milliseconds) {
  return milliseconds < 10 ? fmt::format("{:.1f}", milliseconds) : fmt::format("{:.0f}", milliseconds);
}

std::vector<Column> errorColumns() {
  using Row = RepresentationFigures;
  return {
      {"Missing, strict, %", "edges", [](const Row& r) { return r.edges.strictRatio(); }, percentText},
      {"Missing, strict, %", "inside", [](const Row& r) { return r.interior.strictRatio(); }, percentText},
      {"Missing, strict, %", "at ref.", [](const Row& r) { return r.reference.strictRatio(); }, percentText},
      {"Missing, thick, %", "edges", [](const Row& r) { return r.edges.thickRatio(); }, percentText},
      {"Missing, thick, %", "inside", [](const Row& r) { return r.interior.thickRatio(); }, percentText},
      {"Of DI\u2019s, %", "strict", [](const Row& r) { return r.strictRatioToDi; }, wholePercentText},
      {"Of DI\u2019s, %", "thick", [](const Row& r) { return r.thickRatioToDi; }, wholePercentText},
      {"Wrong front, %", "edges", [](const Row& r) { return r.edges.wrongFrontRatio(); }, percentText},
      {"Wrong front, %", "at ref.", [](const Row& r) { return r.reference.wrongFrontRatio(); }, percentText},
      {"False skins, %", "edges", [](const Row& r) { return r.edges.falseSkinRatio(); }, percentText},
      {"False skins, %", "at ref.", [](const Row& r) { return r.reference.falseSkinRatio(); }, percentText},
      {"Images, edges", "PSNR, dB", [](const Row& r) { return r.edges.meanPsnrDecibels(); }, decibelText, true},
      {"Images, edges", "SSIM", [](const Row& r) { return r.edges.meanSsim(); }, fourDigits, true},
      {"Images, edges", "FLIP", [](const Row& r) { return r.edges.meanFlip(); }, fourDigits},
  };
}

std::vector<Column> costColumns() {
  using Row = RepresentationFigures;
  const auto number = [](size_t value) { return static_cast<double>(value); };
  return {
      {"Counts", "samples", [=](const Row& r) { return number(r.samples); }, countText},
      {"Counts", "pixels", [=](const Row& r) { return number(r.pixels); }, countText},
      {"Counts", "triangles", [=](const Row& r) { return number(r.triangles); }, countText},
      {"Megabytes", "raw", [=](const Row& r) { return number(r.bytes.raw); }, megabyteText},
      {"Megabytes", "zstd", [=](const Row& r) { return number(r.bytes.compressed); }, megabyteText},
      {"Milliseconds", "build", [](const Row& r) { return r.buildMilliseconds; }, timeText},
      {"Milliseconds", "mesh", [](const Row& r) { return r.meshMilliseconds; }, timeText},
      {"Milliseconds", "slice", [](const Row& r) { return r.sliceMilliseconds; }, timeText},
  };
}

/// The text that is marked: the best value as it is printed, so that equal texts are equally good. None where most
/// are.
std::string bestText(const Column& column, const FigureRows& rows) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const RepresentationFigures& row : rows) {
    if (row.name != kSceneItself) {
      least = std::min(least, column.value(row));
      most = std::max(most, column.value(row));
    }
  }
  if (least > most) {
    return "";  // the scene itself is all there is
  }
  const std::string best = column.text(column.moreIsBetter ? most : least);
  const auto holders = std::count_if(rows.begin(), rows.end(), [&](const RepresentationFigures& row) {
    return row.name != kSceneItself && column.text(column.value(row)) == best;
  });
  return 2 * static_cast<size_t>(holders) > rows.size() ? "" : best;
}

std::string tableOf(const std::string& caption, const std::vector<Column>& columns, const FigureRows& rows) {
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\"><table><caption>{0}</caption>\n<thead>"
      "<tr><th rowspan=\"2\" scope=\"col\">Representation</th>",
      caption);
  for (size_t i = 0; i < columns.size();) {
    size_t end = i;
    while (end < columns.size() && columns[end].group == columns[i].group) {
      ++end;
    }
    html += fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", end - i, columns[i].group);
    i = end;
  }
  html += "</tr>\n<tr>";
  for (const Column& column : columns) {
    html += fmt::format("<th scope=\"col\">{}</th>", column.name);
  }
  html += "</tr></thead>\n<tbody>\n";
  std::vector<std::string> best;
  for (const Column& column : columns) {
    best.push_back(bestText(column, rows));
  }
  for (const RepresentationFigures& row : rows) {
    html += "<tr><th scope=\"row\">" + htmlFromText(row.name) + "</th>";
    for (size_t i = 0; i < columns.size(); ++i) {
      const std::string text = columns[i].text(columns[i].value(row));
      const bool marked = row.name != kSceneItself && text == best[i];
      html += marked ? fmt::format("<td class=\"best\">{}<span class=\"hidden\"> (best)</span></td>", text)
                     : fmt::format("<td>{}</td>", text);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::vector<PlotSeries> seriesOf(
    const FigureRows& rows,
    const std::function<std::vector<std::pair<double, double>>(const RepresentationFigures&)>& points) {
  std::vector<PlotSeries> series;
  for (size_t i = 0; i < rows.size(); ++i) {
    series.push_back({rows[i].name, points(rows[i]), i});
  }
  return series;
}

std::string frontierPlots(const FigureRows& rows) {
  const auto plot = [&](const std::string& title, double (*error)(const RepresentationFigures&)) {
    return "<figure>" +
           frontierPlot(
               title, "samples", "missing, over the edges of the cell",
               seriesOf(rows,
                        [error](const RepresentationFigures& row) {
                          return std::vector<std::pair<double, double>>{{static_cast<double>(row.samples), error(row)}};
                        })) +
           "</figure>\n";
  };
  return "<div class=\"plots\">\n" +
         plot("Missing samples, strict", [](const RepresentationFigures& row) { return row.edges.strictRatio(); }) +
         plot("Missing samples, thick", [](const RepresentationFigures& row) { return row.edges.thickRatio(); }) +
         "</div>\n";
}

std::string offsetPlots(const EvaluationOptions& options, const FigureRows& rows) {
  const auto plot = [&](const std::string& title, double (*error)(const FrameErrors&)) {
    return "<figure>" +
           curvePlot(title, "distance from the reference viewpoint, in half sides of the cell",
                     "ratio of samples, mean over directions",
                     seriesOf(rows,
                              [&](const RepresentationFigures& row) {
                                std::vector<std::pair<double, double>> points;
                                for (size_t i = 0; i < row.offsets.size(); ++i) {
                                  points.emplace_back(static_cast<double>(options.offsets[i]), error(row.offsets[i]));
                                }
                                return points;
                              })) +
           "</figure>\n";
  };
  return "<div class=\"plots\">\n" +
         plot("Missing samples, strict", [](const FrameErrors& errors) { return errors.strictRatio(); }) +
         plot("Missing samples, thick", [](const FrameErrors& errors) { return errors.thickRatio(); }) +
         plot("False skins", [](const FrameErrors& errors) { return errors.falseSkinRatio(); }) +
         plot("Wrong fronts", [](const FrameErrors& errors) { return errors.wrongFrontRatio(); }) + "</div>\n";
}

std::string swatch(const Rgb8& color, const std::string& text) {
  return fmt::format("<li><span class=\"swatch\" style=\"background: #{:02x}{:02x}{:02x}\"></span>{}</li>\n", color.x,
                     color.y, color.z, text);
}

std::string imageTag(const std::string& file, const EvaluationOptions& options, const std::string& alternative) {
  return fmt::format(R"(<a href="{0}"><img src="{0}" width="{1}" height="{2}" loading="lazy" alt="{3}"></a>)",
                     htmlFromText(file), options.width, options.height, htmlFromText(alternative));
}

std::string descriptionOf(const std::string& name) {
  for (const CameraName& known : cameraNames()) {
    if (known.name == name) {
      return std::string(known.description) + ". ";
    }
  }
  return "";
}

std::string imageSection(const EvaluatePage& page, const EvaluationOptions& options, const FigureRows& rows) {
  std::string html = fmt::format(
      "<div class=\"key\"><figure>{}<figcaption><b>The scene</b> as it is, from there.</figcaption></figure>\n"
      "<ul class=\"legend\">\n",
      imageTag(page.truthImage, options, "The scene from the example viewpoint"));
  html += swatch(kWrongFrontColor, "wrong front: a false surface hides the scene") +
          swatch(kFalseSkinColor, "false skin: a surface where the scene has none") +
          swatch(kMissingThickColor, "missing, thick: in holes of three pixels or more") +
          swatch(kMissingColor, "missing, strict only: in narrower ones") + "</ul></div>\n<div class=\"shown\">\n";
  for (size_t i = 0; i < rows.size(); ++i) {
    const RepresentationFigures& row = rows[i];
    html += fmt::format(
        "<article><h3>{}</h3>\n<figure><div class=\"pair\">{}{}</div><figcaption>{}{} % missing strictly and {} % in "
        "thick holes, over the edges of the cell.</figcaption></figure></article>\n",
        htmlFromText(row.name), imageTag(page.images[i].frame, options, row.name + ": what it shows"),
        imageTag(page.images[i].errors, options, row.name + ": its errors in false colours"),
        htmlFromText(descriptionOf(row.name)), percentText(row.edges.strictRatio()),
        percentText(row.edges.thickRatio()));
  }
  return html + "</div>\n";
}

std::string edgesText(const EvaluationOptions& options) {
  switch (options.cell.shape) {
    case ViewCell::Shape::kCube:
      return options.edgeViews == 1
                 ? "the 12 edge midpoints and 8 corners of the cube"
                 : fmt::format("{} viewpoints on each of the 12 edges of the cube, and its 8 corners",
                               options.edgeViews);
    case ViewCell::Shape::kSphere:
      return "20 points of the sphere, the corners of a regular dodecahedron";
    case ViewCell::Shape::kSegment:
      return "the two ends of the segment";
  }
  OC_CHECK(false, "every shape has edges");
}

std::string definitions(const EvaluationOptions& options) {
  const auto entry = [](const std::string& term, const std::string& text) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, text);
  };
  return "<dl>\n" +
         entry("Edges, inside, at ref.",
               fmt::format("Viewpoints: {}; {} seeded points inside; the reference viewpoint itself.",
                           edgesText(options), options.interiorViews)) +
         entry("Missing, strict",
               "Samples of the scene\u2019s own rendering with no sample of the representation\u2019s rendering in the "
               "3 x 3 pixels around them that lies within 1.5 pixel footprints of them in space. Ratio of the "
               "scene\u2019s samples.") +
         entry("Missing, thick",
               "Strictly missing samples whose eight neighbours are missing too: holes of three pixels or more.") +
         entry("Of DI\u2019s, %", "Missing over the edges, relative to the depth image of the same view and size.") +
         entry("False skins",
               "Samples of the representation\u2019s rendering that lie farther than 1.5 pixel footprints from every "
               "point of the scene\u2019s surface, seen or hidden. Ratio of the representation\u2019s samples.") +
         entry("Wrong front",
               "Strictly missing samples before which the representation shows something nearer by more than 1.5 "
               "footprints. Ratio of the scene\u2019s samples.") +
         entry("PSNR, SSIM, FLIP",
               "How the representation\u2019s image differs from the scene\u2019s, on black, over the edges. PSNR of "
               "the mean squared error; SSIM with 11 x 11 Gaussian windows on luma, 1 is best; LDR-FLIP at 67 pixels "
               "per degree, 0 is best.") +
         entry("Samples, pixels",
               "Samples that the reference images hold, and pixels they have for them. A representation without "
               "images counts its vertices.") +
         entry("Megabytes",
               "Colours, depths and displacements of the images, or the arrays of the mesh, as 32-bit numbers; and "
               "compressed with zstd at level 3.") +
         entry("Milliseconds",
               fmt::format("Building from the scene, meshing, slicing the mesh. The best of {}, on this machine.",
                           options.runs)) +
         "</dl>\n";
}

}  // namespace

EvaluateImages imageNames(const std::string& name, const std::string& identity) {
  std::string stem;
  for (const char c : name) {
    stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '_' ? c : '-';
  }
  if (stem != identity) {
    stem += fmt::format("-{}", textHash(identity));
  }
  return {"frame-" + stem + ".png", "errors-" + stem + ".png"};
}

std::string evaluatePage(const EvaluatePage& page, const EvaluationOptions& options, const FigureRows& figures) {
  const std::string scene = htmlFromText(page.scene);
  const double sideInches = options.cell.sideRadii * kReferenceDisplayRadiusMetres / kInchMetres;
  std::string html = pageBegin("Evaluation of " + page.scene, {kEvaluationStyle});
  html +=
      fmt::format("<header>\n<h1>What stands for a scene, and what it misses</h1>\n<p><code>{}</code></p>\n", scene);
  html += fmt::format(
      "<p class=\"soft\">{}; reference images of {} x {} pixels; a view cell that is a {} of {:g} in ({:g} "
      "display radii) around ({:g}, {:g}, {:g}); seed {}; made by ocelli {}.</p>\n",
      page.sceneParts.empty() ? groupedDigits(page.sceneTriangles) + " triangles" : htmlFromText(page.sceneParts),
      options.width, options.height, cellShapeName(options.cell.shape), std::round(sideInches * 1000) / 1000,
      options.cell.sideRadii, options.view.eye.x, options.view.eye.y, options.view.eye.z, options.seed,
      htmlFromText(page.version));
  if (!page.complete) {
    html +=
        "<p class=\"warning\">This evaluation was interrupted: rows are missing. The same command goes on with "
        "it.</p>\n";
  }
  html += "</header>\n<main>\n<section aria-labelledby=\"errors\">\n<h2 id=\"errors\">Errors</h2>\n";
  html += tableOf(
      "Errors over the view cell. The best of each column is marked with a star; the scene itself does "
      "not compete.",
      errorColumns(), figures);
  html += "</section>\n<section aria-labelledby=\"cost\">\n<h2 id=\"cost\">Cost</h2>\n";
  html += tableOf("Size and time, on this machine.", costColumns(), figures);
  html +=
      "</section>\n<section aria-labelledby=\"frontier\">\n<h2 id=\"frontier\">Error against samples</h2>\n<p>Down and "
      "left is better. The dotted line joins those that no other one beats in both.</p>\n";
  html += frontierPlots(figures) + "</section>\n";
  if (!options.offsets.empty()) {
    html += fmt::format(
        "<section aria-labelledby=\"offset\">\n<h2 id=\"offset\">Error against offset</h2>\n<p>Means over {} "
        "directions "
        "from the reference viewpoint; half a side is {:g} in.</p>\n",
        options.cell.directions(options.offsetDirections, options.seed).size(), std::round(sideInches * 500) / 1000);
    html += offsetPlots(options, figures) + "</section>\n";
  }
  html += fmt::format(
      "<section aria-labelledby=\"images\">\n<h2 id=\"images\">Where the errors are</h2>\n<p>Seen from half a side "
      "{}. Left: what the representation shows. Right: its errors in false colours over the scene. Select an image "
      "for its full size.</p>\n",
      options.cell.shape == ViewCell::Shape::kSegment ? "against the direction of the segment" : "to the left");
  html += imageSection(page, options, figures) + "</section>\n";
  html += "<section aria-labelledby=\"meaning\">\n<h2 id=\"meaning\">What the figures mean</h2>\n" +
          definitions(options) + "</section>\n";
  return html + "</main>\n" + pageEnd();
}

}  // namespace ocelli
