#include "oc_core/feeds_measure/errors_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/base/output_file.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

// Kinds differ by colour and, as not all tell colours apart, by how high their bars are.
struct FateLook {
  const char* color;  ///< a property of page_colors.h
  double height;      ///< of its bars, as a share of the row
};

FateLook lookOf(WalkerFate fate) {
  switch (fate) {
    case WalkerFate::kRight:
      return {"line", 0.15};
    case WalkerFate::kBetween:
      return {"sky", 0.3};
    case WalkerFate::kHidden:
      return {"soft", 0.5};
    case WalkerFate::kGhost:
      return {"ochre", 0.65};
    case WalkerFate::kDoubled:
      return {"vermilion", 0.8};
    case WalkerFate::kMisplaced:
      return {"purple", 0.9};
    case WalkerFate::kMissing:
      return {"text", 1};
  }
  return {"line", 1};
}

constexpr const char* kErrorsStyle = R"css(
.key { display: flex; flex-wrap: wrap; gap: .25rem 1.5rem; padding: 0; list-style: none; }
.key svg { width: 1rem; height: 1.1rem; vertical-align: -.2rem; margin-right: .4rem; }
.time { display: block; width: 100%; min-width: 40rem; background: var(--card); border: 1px solid var(--line); }
.time text { font: 13px var(--sans); fill: var(--text); }
.time .tick { fill: var(--soft); text-anchor: middle; }
.time .grid { stroke: var(--grid); stroke-width: 1; }
.time .seam { fill: none; stroke: var(--vermilion); stroke-width: 1.5; }
.time .inside { fill: none; stroke: var(--soft); stroke-width: 1.5; stroke-dasharray: 4 3; }
figure.pair { margin: 1rem 0 2rem; }
figure.pair img { aspect-ratio: auto; border-radius: 0; max-width: 100%; }
figure.pair .over { display: flex; font-size: .875rem; color: var(--soft); }
figure.pair .over span { flex: 1; }
td.none { color: var(--soft); }
)css";

constexpr double kTimeLeft = 90;
constexpr double kTimeWidth = 1000;
constexpr double kTimeRowHeight = 26;
constexpr double kTimeRowGap = 8;
constexpr double kTimeAxis = 24;
constexpr double kTimeSeamHeight = 90;

std::array<WalkerFate, kWalkerFates> allFates() {
  std::array<WalkerFate, kWalkerFates> fates{};
  for (size_t i = 0; i < kWalkerFates; ++i) {
    fates[i] = static_cast<WalkerFate>(i);
  }
  return fates;
}

std::string cellOf(size_t count, size_t frames) {
  if (count == 0) {
    return "<td class=\"none\">0</td>";
  }
  return fmt::format("<td>{}<br><span class=\"soft\">{:.1f} %</span></td>", count,
                     100 * static_cast<double>(count) / static_cast<double>(std::max<size_t>(frames, 1)));
}

std::string fatesTable(const FeedsEvaluation& evaluation) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Errors by kind and "
      "walker\"><table><caption>Frames by what became of each walker.</caption>\n<thead><tr><th "
      "scope=\"col\">Walker</th>";
  for (const WalkerFate fate : allFates()) {
    html += fmt::format("<th scope=\"col\">{}</th>", nameOf(fate));
  }
  html += "</tr></thead>\n<tbody>\n";
  const auto row = [&](const std::string& name, size_t frames, const auto& countOf) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", name);
    for (const WalkerFate fate : allFates()) {
      html += cellOf(countOf(fate), frames);
    }
    html += "</tr>\n";
  };
  for (size_t w = 0; w < evaluation.walkers.size(); ++w) {
    row(std::to_string(w + 1), evaluation.frames,
        [&](WalkerFate fate) { return evaluation.walkers[w][static_cast<size_t>(fate)]; });
  }
  row("all", evaluation.frames * evaluation.walkers.size(), [&](WalkerFate fate) { return evaluation.count(fate); });
  return html + "</tbody></table></div>\n";
}

std::string keyList() {
  std::string html = "<ul class=\"key\">\n";
  for (const WalkerFate fate : allFates()) {
    const FateLook look = lookOf(fate);
    html += fmt::format(
        "<li><svg viewBox=\"0 0 16 18\" aria-hidden=\"true\"><rect x=\"2\" y=\"{:.1f}\" width=\"12\" height=\"{:.1f}\" "
        "fill=\"var(--{})\"/></svg><b>{}</b> {}</li>\n",
        17 - 16 * look.height, 16 * look.height, look.color, nameOf(fate), meaningOf(fate));
  }
  return html + "</ul>\n";
}

/// The x of the beginning of a frame; of the last one's end for `frame` == frames.
double timeX(size_t frame, size_t frames) {
  return kTimeLeft + kTimeWidth * static_cast<double>(frame) / static_cast<double>(std::max<size_t>(frames, 1));
}

std::string timeAxis(const FeedsEvaluation& evaluation, double height) {
  std::string svg;
  const double first = evaluation.timeline.front().seconds;
  const double last = evaluation.timeline.back().seconds;
  double step = 1;
  while ((last - first) / step > 14) {
    step *= step == 2 || step == 20 || step == 200 ? 2.5 : 2;
  }
  for (double seconds = std::ceil(first / step) * step; seconds <= last; seconds += step) {
    const double x = kTimeLeft + kTimeWidth * (last > first ? (seconds - first) / (last - first) : 0);
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"{1:.1f}\"/><text class=\"tick\" "
        "x=\"{0:.1f}\" y=\"{2:.1f}\">{3:g} s</text>",
        x, height, height + 17, seconds);
  }
  return svg;
}

std::string timelineOf(const FeedsEvaluation& evaluation) {
  const size_t frames = evaluation.timeline.size();
  const double height = kTimeRowGap + static_cast<double>(evaluation.walkers.size()) * (kTimeRowHeight + kTimeRowGap);
  std::string svg = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Timeline by walker\"><svg class=\"time\" "
      "viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"What became of each walker over time\">{}",
      kTimeLeft + kTimeWidth + 20, height + kTimeAxis, timeAxis(evaluation, height));
  for (size_t w = 0; w < evaluation.walkers.size(); ++w) {
    const double top = kTimeRowGap + static_cast<double>(w) * (kTimeRowHeight + kTimeRowGap);
    svg += fmt::format("<text x=\"12\" y=\"{:.1f}\">walker {}</text>", top + kTimeRowHeight - 8, w + 1);
    for (size_t begin = 0; begin < frames;) {
      const WalkerFate fate = evaluation.timeline[begin].fates[w];
      size_t end = begin;
      while (end < frames && evaluation.timeline[end].fates[w] == fate) {
        ++end;
      }
      const FateLook look = lookOf(fate);
      svg += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"var(--{})\"><title>{} {:.2f} to "
          "{:.2f} s</title></rect>",
          timeX(begin, frames), top + kTimeRowHeight * (1 - look.height), timeX(end, frames) - timeX(begin, frames),
          kTimeRowHeight * look.height, look.color, nameOf(fate), evaluation.timeline[begin].seconds,
          evaluation.timeline[end - 1].seconds);
      begin = end;
    }
  }
  return svg + "</svg></div>\n";
}

std::string seamsOf(const FeedsEvaluation& evaluation) {
  const size_t frames = evaluation.timeline.size();
  double most = 1;
  for (const FrameJudgement& frame : evaluation.timeline) {
    most = std::max({most, frame.seams.levels, frame.seams.insideLevels});
  }
  const auto line = [&](const char* name, const auto& levelsOf) {
    std::string points;
    for (size_t k = 0; k < frames; ++k) {
      points += fmt::format("{:.1f},{:.1f} ", (timeX(k, frames) + timeX(k + 1, frames)) / 2,
                            kTimeSeamHeight - (kTimeSeamHeight - 8) * levelsOf(evaluation.timeline[k].seams) / most);
    }
    return fmt::format("<polyline class=\"{}\" points=\"{}\"/>", name, points);
  };
  return fmt::format(
      "<p>Along the borders between frusta the composed image jumps by {:.1f} levels of 255 more than the rendering "
      "does "
      "there; {} pixels beside them, within frusta, by {:.1f}. The excess is over {:g} levels at {:.1f} % of the "
      "border.</p>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Seams over time\"><svg "
      "class=\"time\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"Excess at borders over time\">{}<text "
      "x=\"12\" y=\"20\">{:.1f} levels</text><text x=\"12\" y=\"{:.0f}\">0</text>{}{}</svg></div>\n<p "
      "class=\"soft\">Line: at borders. Broken line: beside them.</p>\n",
      evaluation.seams.levels, kSeamInside, evaluation.seams.insideLevels, kSeamLevels,
      100 * evaluation.seams.visibleShare(), kTimeLeft + kTimeWidth + 20, kTimeSeamHeight + kTimeAxis,
      timeAxis(evaluation, kTimeSeamHeight), most, kTimeSeamHeight - 2,
      line("inside", [](const FeedSeams& seams) { return seams.insideLevels; }),
      line("seam", [](const FeedSeams& seams) { return seams.levels; }));
}

std::string besideOf(const StitcherFigures& stitcher) {
  return fmt::format(
      "<h2>OpenCV's stitcher</h2>\n<p>Of {} frames it makes a picture of {}, {} of them with all feeds. It takes the "
      "cameras for ones that turn about one point. In its pictures walkers are in the part of one feed {} times, of "
      "several {} times, of none {} times. It takes {:.0f} ms a frame.</p>\n",
      stitcher.frames, stitcher.pictures, stitcher.picturesOfAll, stitcher.seenOnce, stitcher.seenTwice,
      stitcher.notSeen, 1e3 * stitcher.meanSeconds());
}

std::string picturesOf(const FeedsEvaluation& evaluation) {
  std::string html;
  for (const WalkerFate fate : allFates()) {
    std::string figures;
    for (const ErrorPicture& picture : evaluation.pictures) {
      if (picture.fate == fate) {
        figures += fmt::format(
            "<figure class=\"pair\"><div class=\"over\"><span>Composed of feeds</span><span>Rendered</span></div><a "
            "href=\"{0}\"><img src=\"{0}\" width=\"{1}\" height=\"{2}\" loading=\"lazy\" alt=\"Composed beside "
            "rendered: walker {3} is {4}\"></a><figcaption>Walker <b>{3}</b> at {5:.2f} s.</figcaption></figure>\n",
            htmlFromText(picture.file), picture.width, picture.height, picture.walker + 1, nameOf(fate),
            picture.seconds);
      }
    }
    if (!figures.empty()) {
      html += fmt::format("<h3>{}</h3>\n<p>{}</p>\n{}", nameOf(fate), meaningOf(fate), figures);
    }
  }
  return html.empty() ? "<p>No walker was anything but right.</p>\n" : html;
}

}  // namespace

std::string errorsPage(const FeedsEvaluation& evaluation, const std::string& title) {
  std::string html = pageBegin(title, {kErrorsStyle}) +
                     fmt::format(
                         "<header>\n<h1>{}</h1>\n<p>{:.1f} % of {} walkers in {} frames are right, or fade "
                         "between two feeds; with these cameras {:.1f} % could be. {:.1f} dB against the graph "
                         "camera's own rendering of the scene.</p>\n",
                         htmlFromText(title), 100 * evaluation.rightShare(), evaluation.walkers.size(),
                         evaluation.frames, 100 * evaluation.possibleShare(), evaluation.psnrDecibels);
  html += fatesTable(evaluation) + "</header>\n<main>\n";
  if (!evaluation.timeline.empty()) {
    html += "<h2>When</h2>\n" + keyList() + timelineOf(evaluation) + "<h2>Seams</h2>\n" + seamsOf(evaluation);
  }
  if (evaluation.stitcher.frames > 0) {
    html += besideOf(evaluation.stitcher);
  }
  html +=
      "<h2>Pictures</h2>\n<p class=\"soft\">A yellow frame is around what an image shows of the walker; a broken "
      "one is where it shows nothing of it, but the other image does.</p>\n" +
      picturesOf(evaluation);
  return html + "</main>\n" + pageEnd();
}

void writeErrorsPage(const FeedsEvaluation& evaluation, const std::string& title, const std::filesystem::path& folder) {
  makeFolder(folder);
  OutputFile file(folder / "index.html");
  file.write(errorsPage(evaluation, title));
  file.commit();
}

}  // namespace ocelli
