#include "oc_core/evaluation/evaluation_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ocelli {
namespace {

std::string percent(double ratio) {
  return fmt::format("{:.3f} %", 100 * ratio);
}

std::string megabytes(size_t bytes) {
  return fmt::format("{:.2f}", static_cast<double>(bytes) / 1e6);
}

std::string imageTable(const std::vector<RepresentationFigures>& figures) {
  std::string text = fmt::format("\n{:<16} {:^19}   {:^26}   {:^26}   {:^17}   {:>9}\n", "", "wrong front",
                                 "false skins", "images, edges", "megabytes", "");
  text += fmt::format("{:<16} {:>9} {:>9}   {:>8} {:>8} {:>8}   {:>9} {:>8} {:>7}   {:>8} {:>8}   {:>9}\n", "camera",
                      "edges", "at ref.", "edges", "interior", "at ref.", "PSNR dB", "SSIM", "FLIP", "raw", "zstd",
                      "build ms");
  for (const RepresentationFigures& row : figures) {
    text += fmt::format(
        "{:<16} {:>9} {:>9}   {:>8} {:>8} {:>8}   {:>9.2f} {:>8.4f} {:>7.4f}   {:>8} {:>8}   {:>9.1f}\n", row.name,
        percent(row.edges.wrongFrontRatio()), percent(row.reference.wrongFrontRatio()),
        percent(row.edges.falseSkinRatio()), percent(row.interior.falseSkinRatio()),
        percent(row.reference.falseSkinRatio()), row.edges.meanPsnrDecibels(), row.edges.meanSsim(),
        row.edges.meanFlip(), megabytes(row.bytes.raw), megabytes(row.bytes.compressed), row.buildMilliseconds);
  }
  return text;
}

}  // namespace

std::string evaluationTable(const std::vector<RepresentationFigures>& figures) {
  std::string text = fmt::format("{:<16} {:>10} {:>9} {:>9} {:>8} {:>9}   {:^26}   {:^17}   {:^15}\n", "", "", "", "",
                                 "", "", "missing, strict", "missing, thick", "ratio to di");
  text += fmt::format("{:<16} {:>10} {:>9} {:>9} {:>8} {:>9}   {:>8} {:>8} {:>8}   {:>8} {:>8}   {:>7} {:>7}\n",
                      "camera", "triangles", "samples", "build ms", "mesh ms", "slice ms", "edges", "interior",
                      "at ref.", "edges", "interior", "strict", "thick");
  for (const RepresentationFigures& row : figures) {
    text += fmt::format(
        "{:<16} {:>10} {:>9} {:>9.1f} {:>8.1f} {:>9.1f}   {:>8} {:>8} {:>8}   {:>8} {:>8}   {:>7.3f} {:>7.3f}\n",
        row.name, row.triangles, row.samples, row.buildMilliseconds, row.meshMilliseconds, row.sliceMilliseconds,
        percent(row.edges.strictRatio()), percent(row.interior.strictRatio()), percent(row.reference.strictRatio()),
        percent(row.edges.thickRatio()), percent(row.interior.thickRatio()), row.strictRatioToDi, row.thickRatioToDi);
  }
  const bool images = std::any_of(figures.begin(), figures.end(), [](const auto& row) { return row.edges.images > 0; });
  return images ? text + imageTable(figures) : text;
}

}  // namespace ocelli
