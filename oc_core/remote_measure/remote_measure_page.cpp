#include "oc_core/remote_measure/remote_measure_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/file_bytes.h"
#include "oc_core/evaluation/evaluation_style.h"
#include "oc_core/page/html.h"
#include "oc_core/remote_measure/remote_chart.h"

namespace ocelli {
namespace {

constexpr const char* kRemotePageStyle = R"css(.moments { display: grid; gap: 1.5rem; margin-top: 1rem; }
.moment { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(26rem, 100%), 1fr)); gap: .75rem; }
.moment img { display: block; width: 100%; height: auto; aspect-ratio: auto; border: 1px solid var(--line); border-radius: 4px; }
.moment figure { margin: 0; }
)css";

struct RemoteColumn {
  const char* group;
  const char* name;
  std::string (*text)(const ModeFigures& row);
};

std::string secondsText(const StallFigures& stalls) {
  return stalls.count == 0 ? "none" : fmt::format("{:.2f}", stalls.longestSeconds);
}
std::string errorText(const PictureErrors& errors, double value) {
  return errors.flips.empty() ? "\u2013" : fmt::format("{:.4f}", value);
}

constexpr RemoteColumn kColumns[] = {
    {"Sent", "MB", [](const ModeFigures& r) { return fmt::format("{:.3f}", static_cast<double>(r.bytes) / 1e6); }},
    {"Sent", "images", [](const ModeFigures& r) { return groupedDigits(r.images); }},
    {"Shown", "first, s",
     [](const ModeFigures& r) {
       return r.firstPictureSeconds ? fmt::format("{:.2f}", *r.firstPictureSeconds) : std::string("\u2013");
     }},
    {"Shown", "views / s", [](const ModeFigures& r) { return fmt::format("{:.1f}", r.viewsPerSecond); }},
    {"Shown", "lag, ms", [](const ModeFigures& r) { return fmt::format("{:.0f}", 1e3 * r.meanLagSeconds); }},
    {"Shown", "decoding, ms",
     [](const ModeFigures& r) {
       return r.clientDecodeSeconds > 0 ? fmt::format("{:.0f}", 1e3 * r.clientDecodeSeconds) : std::string("\u2013");
     }},
    {"Shown", "covered, %", [](const ModeFigures& r) { return fmt::format("{:.1f}", 100 * r.covered); }},
    {"FLIP", "mean", [](const ModeFigures& r) { return errorText(r.shown, r.shown.meanFlip()); }},
    {"FLIP", "95 %", [](const ModeFigures& r) { return errorText(r.shown, r.shown.flip95()); }},
    {"FLIP", "no latency",
     [](const ModeFigures& r) { return errorText(r.withoutLatency, r.withoutLatency.meanFlip()); }},
    {"PSNR", "dB",
     [](const ModeFigures& r) {
       if (r.shown.flips.empty()) {
         return std::string("\u2013");
       }
       const double value = r.shown.psnrDecibels();
       return std::isfinite(value) ? fmt::format("{:.1f}", value) : std::string("\u221e");
     }},
    {"Stalls", "longest, s", [](const ModeFigures& r) { return secondsText(r.stalls); }},
    {"Stalls", "number", [](const ModeFigures& r) { return groupedDigits(r.stalls.count); }},
    {"Stalls", "total, s", [](const ModeFigures& r) { return fmt::format("{:.1f}", r.stalls.totalSeconds); }},
    {"Stalls", "covered, s", [](const ModeFigures& r) { return secondsText(r.coveredStalls); }},
};

std::string linkTable(const LinkSpeed& link, const RemoteMeasurement& measurement) {
  const std::string caption = "Over " + link.name() + " of round trip";
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\"><table><caption>{0}</caption>\n<thead>"
      "<tr><th rowspan=\"2\" scope=\"col\">Mode</th>",
      htmlFromText(caption));
  for (auto column = std::begin(kColumns); column != std::end(kColumns);) {
    const auto end = std::find_if(column, std::end(kColumns), [&](const RemoteColumn& each) {
      return std::string_view(each.group) != column->group;
    });
    html += fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", end - column, column->group);
    column = end;
  }
  html += "</tr>\n<tr>";
  for (const RemoteColumn& column : kColumns) {
    html += fmt::format("<th scope=\"col\">{}</th>", column.name);
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const ModeFigures& row : measurement.rows) {
    if (row.link == link) {
      html += "<tr><th scope=\"row\">" + htmlFromText(row.name()) + "</th>";
      for (const RemoteColumn& column : kColumns) {
        html += "<td>" + column.text(row) + "</td>";
      }
      html += "</tr>\n";
    }
  }
  return html + "</tbody></table></div>\n";
}

/// The rows over the first link, which charts show: of each mode one, frames that are sent on and of middling quality.
std::vector<const ModeFigures*> chartRows(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement) {
  std::vector<const ModeFigures*> rows;
  for (const std::string& mode : options.modes) {
    std::vector<const ModeFigures*> ofMode;
    for (const ModeFigures& row : measurement.rows) {
      if (row.mode == mode && row.link == options.links.front()) {
        ofMode.push_back(&row);
      }
    }
    if (!ofMode.empty()) {
      rows.push_back(ofMode[ofMode.size() / 2]);
    }
  }
  return rows;
}

std::string chartSection(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement) {
  const std::vector<const ModeFigures*> rows = chartRows(options, measurement);
  std::vector<ChartSeries> lags;
  std::vector<ChartSeries> flips;
  for (size_t i = 0; i < rows.size(); ++i) {
    ChartSeries lag{rows[i]->name(), {}, i};
    for (size_t k = 0; k < rows[i]->lags.size(); ++k) {
      lag.points.emplace_back(options.path.secondsOf(k), 1e3 * rows[i]->lags[k]);
    }
    lags.push_back(std::move(lag));
    ChartSeries flip{rows[i]->name(), {}, i};
    for (size_t k = 0; k < rows[i]->judged.size(); ++k) {
      flip.points.emplace_back(options.path.secondsOf(rows[i]->judged[k]), rows[i]->shown.flips[k]);
    }
    flips.push_back(std::move(flip));
  }
  std::vector<ChartSeries> bytes;
  for (const StreamCurve& curve : measurement.curves) {
    ChartSeries series{curve.mode + ", without latency", {}, bytes.size(), true, true};
    for (const RatePoint& point : curve.points) {
      series.points.emplace_back(point.bytes / 1e6, point.flip);
    }
    bytes.push_back(std::move(series));
  }
  for (const std::string& mode : options.modes) {
    if (findImageMode(mode) == nullptr) {
      continue;
    }
    ChartSeries series{mode + ", each link", {}, bytes.size(), false, true};
    for (const ModeFigures& row : measurement.rows) {
      if (row.mode == mode && !row.shown.flips.empty()) {
        series.points.emplace_back(static_cast<double>(row.bytes) / 1e6, row.shown.meanFlip());
      }
    }
    bytes.push_back(std::move(series));
  }
  const std::string link = options.links.front().name();
  return "<div class=\"plots\">\n<figure>" +
         remoteChart("How far behind, over " + link, {"seconds"}, {"milliseconds"}, lags) + "</figure>\n<figure>" +
         remoteChart("Error of what is shown, over " + link, {"seconds"}, {"FLIP"}, flips) + "</figure>\n<figure>" +
         remoteChart("Error against bytes", {"megabytes over the path", true}, {"mean FLIP", true}, bytes) +
         "</figure>\n</div>\n";
}

std::string pictureName(size_t frame, const std::string& mode) {
  return fmt::format("frame-{}-{}.png", frame, mode);
}

std::string pictureTag(const RemoteMeasureOptions& options, size_t frame, const std::string& mode,
                       const std::string& caption) {
  return fmt::format(
      "<figure><a href=\"{0}\"><img src=\"{0}\" width=\"{1}\" height=\"{2}\" loading=\"lazy\" alt=\"{3}\"></a>"
      "<figcaption>{3}</figcaption></figure>\n",
      pictureName(frame, mode), options.screen.x, options.screen.y, htmlFromText(caption));
}

std::string pictureSection(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement) {
  std::string html = "<div class=\"moments\">\n";
  for (const size_t frame : measurement.moments) {
    html += fmt::format("<section><h3>At {:.1f} s</h3>\n<div class=\"moment\">\n", options.path.secondsOf(frame));
    html += pictureTag(options, frame, "truth", "What should be seen");
    for (const ModeFigures* row : chartRows(options, measurement)) {
      const auto judged = std::find(row->judged.begin(), row->judged.end(), frame);
      if (row->kept.contains(frame) && judged != row->judged.end()) {
        const double flip = row->shown.flips[static_cast<size_t>(judged - row->judged.begin())];
        html += pictureTag(options, frame, row->mode, fmt::format("{}: FLIP {:.3f}", row->name(), flip));
      }
    }
    html += "</div></section>\n";
  }
  return html + "</div>\n";
}

std::string equalSection(const RemoteMeasurement& measurement) {
  std::string rows;
  for (const ModeFigures& row : measurement.rows) {
    if (row.mode != "gpc" || row.shown.flips.empty()) {
      continue;
    }
    for (const StreamCurve& curve : measurement.curves) {
      const std::optional<double> bytes = bytesOfEqualStream(measurement, curve.mode, row);
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{:.4f}</td><td>{:.3f}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
          htmlFromText(row.link.name()), row.pictureFlip(), static_cast<double>(row.bytes) / 1e6,
          htmlFromText(curve.mode), bytes ? fmt::format("{:.3f}", *bytes / 1e6) : "beyond its curve",
          bytes ? fmt::format("{:.3f}", static_cast<double>(row.bytes) / *bytes) : "\u2013");
    }
  }
  if (rows.empty()) {
    return "";
  }
  return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Bytes at equal "
         "error\"><table><caption>Bytes "
         "over the path at equal error since the first picture of gpc: the stream\u2019s without "
         "latency</caption>\n<thead><tr><th "
         "scope=\"col\">Link</th>"
         "<th scope=\"col\">FLIP</th><th scope=\"col\">gpc, MB</th><th scope=\"col\">stream</th><th scope=\"col\">its "
         "MB</th><th scope=\"col\">ratio</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string meaningSection(const RemoteMeasureOptions& options) {
  const auto entry = [](const std::string& term, const std::string& text) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", htmlFromText(term), htmlFromText(text));
  };
  std::string html = "<dl>\n";
  for (const RemoteModeName& mode : remoteModes()) {
    if (std::find(options.modes.begin(), options.modes.end(), mode.name) != options.modes.end()) {
      html += entry(mode.name, mode.meaning + ".");
    }
  }
  html +=
      entry("FLIP, PSNR",
            fmt::format("What is on the screen at a moment against the view wanted at that moment: latency counts. One "
                        "of {} frames is judged. Before the first picture the screen is black, which is judged, too.",
                        options.every));
  html += entry("No latency", "Each shown frame against the view that it is of.");
  html += entry("Lag", "How old what is shown is, on average. Uncovered, the time since the view was covered last.");
  html += entry("Decoding", "What the client takes to decode an image, on a thread of its own.");
  html +=
      entry("Stalls",
            "Times of more than 100 ms in which what is shown does not change, or, of images, is not covered, though "
            "another view is wanted. The wait for the first picture is one. The last column counts views that the "
            "client\u2019s image covers only.");
  html += entry("Covered", "Frames whose view the client\u2019s image reaches, with its detail and near its eye.");
  return html + "</dl>\n";
}

}  // namespace

std::string remoteMeasurePage(const std::string& version, const RemoteMeasureOptions& options,
                              const RemoteMeasurement& measurement) {
  std::string html = pageBegin("Remote visualisation of " + options.scene, {kEvaluationStyle, kRemotePageStyle});
  html += fmt::format("<header>\n<h1>A scene explored over a network</h1>\n<p><code>{}</code></p>\n",
                      htmlFromText(options.scene));
  html += fmt::format(
      "<p class=\"soft\">{} frames of {} x {} at {:g} a second along the path \u201c{}\u201d; made by ocelli {}.</p>\n",
      groupedDigits(options.path.views.size()), options.screen.x, options.screen.y, options.path.framesPerSecond,
      htmlFromText(options.path.name), htmlFromText(version));
  for (const std::string& why : measurement.leftOut) {
    html += "<p class=\"warning\">Left out: " + htmlFromText(why) + "</p>\n";
  }
  html += "</header>\n<main>\n<section aria-labelledby=\"figures\">\n<h2 id=\"figures\">Figures</h2>\n";
  for (const LinkSpeed& link : options.links) {
    html += linkTable(link, measurement);
  }
  html += equalSection(measurement);
  html += "</section>\n<section aria-labelledby=\"charts\">\n<h2 id=\"charts\">Along the path</h2>\n" +
          chartSection(options, measurement) + "</section>\n";
  html += "<section aria-labelledby=\"pictures\">\n<h2 id=\"pictures\">What was on the screen</h2>\n<p>Over " +
          htmlFromText(options.links.front().name()) + ". Select a picture for its full size.</p>\n" +
          pictureSection(options, measurement) + "</section>\n";
  html += "<section aria-labelledby=\"meaning\">\n<h2 id=\"meaning\">What the figures mean</h2>\n" +
          meaningSection(options) + "</section>\n";
  return html + "</main>\n" + pageEnd();
}

void writeRemoteMeasurePage(const std::filesystem::path& folder, const std::string& version,
                            const RemoteMeasureOptions& options, const RemoteMeasurement& measurement) {
  for (const auto& [frame, picture] : measurement.truth) {
    writePng(folder / pictureName(frame, "truth"), picture);
  }
  for (const ModeFigures* row : chartRows(options, measurement)) {
    for (const auto& [frame, picture] : row->kept) {
      writePng(folder / pictureName(frame, row->mode), picture);
    }
  }
  writeFile(folder / "index.html", remoteMeasurePage(version, options, measurement));
}

}  // namespace ocelli
