#include "display_driver/demo/demo_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "display_driver/demo/demo_style.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

constexpr int kBarPixels = 220;   // of the longest bar
constexpr size_t kMaxBeside = 4;  // images of a row

std::string percent(double ratio) {
  return fmt::format("{:.2f} %", 100 * ratio);
}

std::string displayName(const std::string& representation) {
  if (representation == "di") {
    return "Depth image (DI)";
  }
  if (representation == "ddoc") {
    return "OCRI (DDOC)";
  }
  if (representation == "ddoc-constant") {
    return "OCRI, one radius for every edge";
  }
  if (representation == "eoc-hv") {
    return "Two crossing epipolar cameras (EOC)";
  }
  return representation == "cell" ? "Cell camera" : representation;
}

std::string imageTag(const DemoImage& image, const std::string& alternative) {
  return fmt::format(R"(<img src="{}" width="{}" height="{}" loading="lazy" alt="{}">)", htmlFromText(image.file),
                     image.width, image.height, htmlFromText(alternative));
}

// The same images in one place, switched with radio buttons: arrow keys flip through them.
std::string flipBlock(const DemoRow& row, const std::string& id, const std::string& sceneTitle) {
  std::string inputs;
  std::string stack;
  for (size_t i = 0; i < std::min(row.images.size(), kMaxBeside); ++i) {
    const DemoImage& image = row.images[i];
    inputs += fmt::format(R"(<input type="radio" name="{0}" id="{0}-{1}"{2}><label for="{0}-{1}">{3}</label>)", id, i,
                          i == 0 ? " checked" : "", htmlFromText(image.name));
    stack += imageTag(image, sceneTitle + ", " + row.title + ": " + image.name);
  }
  return fmt::format(
      "<details><summary>Compare in place</summary>\n<fieldset class=\"flip\"><legend>{}</legend>{}<div "
      "class=\"stack\">{}</div></fieldset></details>\n",
      htmlFromText(row.title), inputs, stack);
}

std::string rowBlock(const DemoRow& row, const std::string& id, const std::string& sceneTitle) {
  std::string html = "<h3>" + htmlFromText(row.title) + "</h3>\n";
  if (!row.text.empty()) {
    html += "<p>" + htmlFromText(row.text) + "</p>\n";
  }
  const size_t columns = std::min(row.images.size(), kMaxBeside);
  html += fmt::format("<div class=\"row\" style=\"--columns: {}\">\n", columns);
  for (const DemoImage& image : row.images) {
    html += fmt::format("<figure><a href=\"{}\">{}</a><figcaption><b>{}</b> {}</figcaption></figure>\n",
                        htmlFromText(image.file), imageTag(image, sceneTitle + ", " + row.title + ": " + image.name),
                        htmlFromText(image.name), htmlFromText(image.caption));
  }
  return html + "</div>\n" + flipBlock(row, id, sceneTitle);
}

// As many as eyes: the figures of each in one column after the other.
std::string solidityTable(const DemoScene& scene) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"How solid it looks\"><table><caption>Hidden "
      "light: the share of all light that comes from surfaces which should be hidden. PSNR and FLIP: how the observed "
      "image differs from the opaque one; of PSNR more is better, of FLIP less.</caption>\n<thead><tr><th "
      "scope=\"col\">Shown</th>";
  for (const std::string& eye : scene.solidityEyes) {
    for (const char* figure : {"Hidden light", "PSNR", "FLIP"}) {
      html += fmt::format("<th scope=\"col\">{},<br>{}</th>", figure, htmlFromText(eye));
    }
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const SolidityFigures& row : scene.solidity) {
    html += "<tr><th scope=\"row\">" + htmlFromText(row.name) + "</th>";
    for (const SolidityErrors& errors : row.groups) {
      html += fmt::format("<td>{}</td><td>{:.1f} dB</td><td>{:.3f}</td>", percent(errors.hiddenShare()),
                          errors.psnrDecibels(), errors.meanFlip());
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string figuresTable(const DemoScene& scene) {
  std::string html =
      "<h3>Errors and times</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Errors and "
      "times\"><table><caption>Missing: ratio of the samples of the full geometry that are not shown, from the corners "
      "and edge midpoints of the 8 in cube around the reference viewpoint; thick: in holes of three pixels or more. "
      "Times "
      "in milliseconds on this machine.</caption>\n<thead><tr><th scope=\"col\">Representation</th><th "
      "scope=\"col\">Triangles</th><th scope=\"col\">Missing<br>strict</th><th scope=\"col\">Missing<br>thick</th><th "
      "scope=\"col\">Strict,<br>of DI's</th><th scope=\"col\">Thick,<br>of DI's</th><th scope=\"col\">Missing "
      "at<br>the "
      "reference</th><th scope=\"col\">Build</th><th scope=\"col\">Mesh</th><th scope=\"col\">Slice</th></tr></thead>\n"
      "<tbody>\n";
  for (const RepresentationFigures& row : scene.figures) {
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{:.1f} %</td><td>{:.1f} "
        "%</td><td>{}</td><td>{:.0f}</td><td>{:.0f}</td><td>{:.0f}</td></tr>\n",
        htmlFromText(displayName(row.name)), groupedDigits(row.triangles), percent(row.edges.strictRatio()),
        percent(row.edges.thickRatio()), 100 * row.strictRatioToDi, 100 * row.thickRatioToDi,
        percent(row.reference.strictRatio()), row.buildMilliseconds, row.meshMilliseconds, row.sliceMilliseconds);
  }
  html += fmt::format(
      "<tr><th scope=\"row\">Full geometry</th><td>{}</td><td>{}</td><td>{}</td><td>0.0 %</td><td>0.0 "
      "%</td><td>{}</td><td></td><td></td><td>{:.0f}</td></tr>\n",
      groupedDigits(scene.geometryTriangles), percent(0), percent(0), percent(0), scene.geometrySliceMilliseconds);
  return html + "</tbody></table></div>\n";
}

// One line a scene: how much the depth image and the OCRI miss, as numbers and bars.
std::string summaryTable(const std::vector<DemoScene>& scenes) {
  double most = 0;
  for (const DemoScene& scene : scenes) {
    for (const RepresentationFigures& row : scene.figures) {
      most = std::max(most, row.edges.strictRatio());
    }
  }
  std::string html =
      "<table><caption>What a viewer misses who moves his head by up to 4 in along each axis: missing samples, "
      "strict.</caption>\n<thead><tr><th scope=\"col\">Scene</th><th scope=\"col\">Depth image</th><th "
      "scope=\"col\">OCRI (DDOC)</th></tr></thead>\n<tbody>\n";
  for (size_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i].figures.empty()) {
      continue;
    }
    html += fmt::format("<tr><th scope=\"row\"><a href=\"#scene-{}\">{}</a></th>", i, htmlFromText(scenes[i].title));
    for (const char* name : {"di", "ddoc"}) {
      for (const RepresentationFigures& row : scenes[i].figures) {
        if (row.name == name) {
          html += fmt::format("<td>{}<span class=\"bar {}\" style=\"width: {:.0f}px\"></span></td>",
                              percent(row.edges.strictRatio()), name,
                              most > 0 ? kBarPixels * row.edges.strictRatio() / most : 0.0);
        }
      }
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

}  // namespace

std::string demoPage(const std::vector<DemoScene>& scenes, const DemoOptions& options, const std::string& version) {
  std::string html =
      pageBegin("Ocelli: from scene to display", {kDemoStyle}) + "<header>\n<h1>Ocelli: from scene to display</h1>\n";
  html += fmt::format(
      "<p>A reference image is one layer of samples, taken with one camera. Its triangle mesh is bounded however large "
      "the "
      "scene is, and goes to a swept-screen volumetric display. A pinhole camera stores only what it sees, so a viewer "
      "who "
      "moves his head sees holes. An occlusion camera also stores what such a viewer is about to see: the image is an "
      "occlusion camera reference image (OCRI).</p>\n<p class=\"soft\">Reference images of {} x {} pixels; display "
      "profile <code>{}</code>, {} slices a half turn of {} x {} pixels; made by ocelli {}. Select an image for its "
      "full "
      "size.</p>\n",
      options.width, options.height, htmlFromText(options.profile.name), options.profile.slicesPerHalfTurn,
      options.profile.width, options.profile.height, htmlFromText(version));
  html += summaryTable(scenes);
  html += "</header>\n<main>\n";
  for (size_t i = 0; i < scenes.size(); ++i) {
    const DemoScene& scene = scenes[i];
    html += fmt::format(
        "<section aria-labelledby=\"scene-{0}\">\n<h2 id=\"scene-{0}\">{1}</h2>\n<p class=\"soft\"><code>{2}"
        "</code></p>\n",
        i, htmlFromText(scene.title), htmlFromText(scene.source));
    for (size_t r = 0; r < scene.rows.size(); ++r) {
      html += rowBlock(scene.rows[r], fmt::format("flip-{}-{}", i, r), scene.title);
    }
    html += (scene.figures.empty() ? "" : solidityTable(scene) + figuresTable(scene)) + "</section>\n";
  }
  return html + "</main>\n" + pageEnd();
}

}  // namespace ocelli
