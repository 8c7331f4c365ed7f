#include "display_sim/dither_score/dither_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <system_error>
#include <utility>

#include "display_sim/dither/diffusion.h"
#include "display_sim/dither/voxel_dither.h"
#include "display_sim/dither_score/dither_images.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

/// Grey rises with the height.
Mesh shadedBall() {
  constexpr uint32_t kAround = 192;
  constexpr uint32_t kBallRings = 96;
  constexpr float kRadius = 0.7f;
  Mesh mesh;
  for (uint32_t ring = 0; ring <= kBallRings; ++ring) {
    const float down = std::numbers::pi_v<float> * static_cast<float>(ring) / kBallRings;
    for (uint32_t i = 0; i < kAround; ++i) {
      const float around = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
      mesh.positions.push_back(
          kRadius * glm::vec3(std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)));
      mesh.colors.emplace_back(0.5f + 0.45f * std::cos(down));
      if (ring < kBallRings) {
        const uint32_t next = ring * kAround + (i + 1) % kAround;
        mesh.triangles.emplace_back(ring * kAround + i, next, next + kAround);
        mesh.triangles.emplace_back(ring * kAround + i, next + kAround, ring * kAround + i + kAround);
      }
    }
  }
  return mesh;
}

std::string fileNameOf(const std::string& field) {
  std::string name = field;
  std::ranges::replace(name, ' ', '-');
  return name;
}

nlohmann::ordered_json jsonOf(const EvennessScore& score) {
  return {{"largest_over_least", score.largestOverLeast},
          {"relative_deviation", score.relativeDeviation},
          {"mean_light_for_area", score.mean}};
}

}  // namespace

double surfaceBlockError(const DisplayProfile& profile, ColorReduction colors) {
  const Mesh ball = shadedBall();
  const VoxelColors wanted = colorsExactly(ball, profile);
  const Volume volume = sliceExactly(ball, profile, {.colors = colors});
  const int across = (profile.width + kBlockColumns - 1) / kBlockColumns;
  const int down = (profile.height + kBlockRows - 1) / kBlockRows;
  std::map<int, std::pair<double, int>> blocks;  // error and voxels
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (const ColoredVoxel& voxel : wanted[static_cast<size_t>(slice)]) {
      const int column = static_cast<int>(voxel.position) % profile.width;
      const int row = static_cast<int>(voxel.position) / profile.width;
      auto& [error, voxels] =
          blocks[(slice / kBlockSlices * down + row / kBlockRows) * across + column / kBlockColumns];
      error += static_cast<double>(volume.levels(slice, column, row).g) / volume.fullLevel() - voxel.color.g;
      ++voxels;
    }
  }
  constexpr int kMinVoxels = 32;
  double sum = 0;
  int count = 0;
  for (const auto& [place, block] : blocks) {
    if (block.second >= kMinVoxels) {
      sum += std::abs(block.first) / block.second;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

DitherReport compareDithers(const DitherReportOptions& options, const Progress& progress) {
  DitherReport comparison{options, {}};
  const double steps = static_cast<double>(options.dithers.size() * (1 + options.evenLightRadii.size()));
  double done = 0;
  for (const NamedDither& dither : options.dithers) {
    DitherRow row{dither, {}, 0, {}};
    report(progress, "dithering", done++ / steps);
    for (const DitherField& field : ditherFields()) {
      row.fields.push_back(
          {field.name, scoreDither(field, shownLight(field, dither.colors, options.profile.colorBitsPerChannel))});
    }
    row.surfaceError = surfaceBlockError(options.profile, dither.colors);
    for (const double radius : options.evenLightRadii) {
      report(progress, "dithering", done++ / steps);
      std::vector<LightSample> samples =
          measureEvenness(options.profile, {.colors = dither.colors, .evenLightRadius = radius});
      const EvennessScore within = scoreEvenness(samples, radius > 0 ? radius : 1);
      const EvennessScore all = scoreEvenness(samples);
      row.evenness.push_back({radius, within, all, std::move(samples)});
    }
    comparison.rows.push_back(std::move(row));
  }
  report(progress, "dithering", 1);
  return comparison;
}

std::string textOf(const DitherReport& report) {
  std::string text = fmt::format(
      "{} bit{} a channel. Errors in 1/255 of full light; blocks of {}x{}x{} "
      "voxels\n\n{:<12}{:<14}{:>8}{:>8}{:>9}{:>10}"
      "\n",
      report.options.profile.colorBitsPerChannel, report.options.profile.colorBitsPerChannel == 1 ? "" : "s",
      kBlockColumns, kBlockRows, kBlockSlices, "dither", "field", "mean", "worst", "banding", "blotches");
  for (const DitherRow& row : report.rows) {
    for (const FieldScore& field : row.fields) {
      const DitherScore& score = field.score;
      text += fmt::format("{:<12}{:<14}{:>8.2f}{:>8.2f}{:>9.2f}{:>10.2f}\n", row.dither.name, field.field,
                          255 * score.meanBlockError, 255 * score.worstBlockError, 255 * score.banding, score.blotches);
    }
    text += fmt::format("{:<12}{:<14}{:>8.2f}\n", row.dither.name, "a surface", 255 * row.surfaceError);
  }
  text +=
      fmt::format("\nWhite surfaces: their light for their area, against the radius\n\n{:<12}{:>12}{:>15}{:>11}{:>7}\n",
                  "dither", "even within", "largest/least", "deviation", "mean");
  for (const DitherRow& row : report.rows) {
    for (const EvennessRow& evenness : row.evenness) {
      text +=
          fmt::format("{:<12}{:>12g}{:>15.2f}{:>10.1f}%{:>7.2f}\n", row.dither.name, evenness.evenLightRadius,
                      evenness.within.largestOverLeast, 100 * evenness.within.relativeDeviation, evenness.within.mean);
    }
  }
  return text;
}

std::string jsonOf(const DitherReport& report) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const DitherRow& row : report.rows) {
    nlohmann::ordered_json fields = nlohmann::ordered_json::array();
    for (const FieldScore& field : row.fields) {
      fields.push_back({{"field", field.field},
                        {"mean_block_error", field.score.meanBlockError},
                        {"worst_block_error", field.score.worstBlockError},
                        {"bias", field.score.bias},
                        {"banding", field.score.banding},
                        {"blotches", field.score.blotches}});
    }
    nlohmann::ordered_json evenness = nlohmann::ordered_json::array();
    for (const EvennessRow& each : row.evenness) {
      nlohmann::ordered_json samples = nlohmann::ordered_json::array();
      for (const LightSample& sample : each.samples) {
        samples.push_back({{"surface", nameOf(sample.surface)},
                           {"radius", sample.radius},
                           {"light_for_area", sample.lightPerArea},
                           {"expected", sample.expected}});
      }
      evenness.push_back({{"even_light_radius", each.evenLightRadius},
                          {"within_radius", jsonOf(each.within)},
                          {"all", jsonOf(each.all)},
                          {"samples", std::move(samples)}});
    }
    rows.push_back({{"dither", row.dither.name},
                    {"fields", std::move(fields)},
                    {"surface_block_error", row.surfaceError},
                    {"evenness", std::move(evenness)}});
  }
  const nlohmann::ordered_json json = {{"profile", report.options.profile.name},
                                       {"bits_per_channel", report.options.profile.colorBitsPerChannel},
                                       {"dithers", std::move(rows)}};
  return textOfJson(json, 2) + "\n";
}

void writeImages(const DitherReport& report, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw WorkError("cannot make this folder (" + failed.message() + ")", folder.string(),
                    "choose another one with -o");
  }
  for (const DitherField& field : ditherFields()) {
    writePng(folder / (fileNameOf(field.name) + ".png"),
             ditherImage(field, report.options.dithers, report.options.profile.colorBitsPerChannel));
  }
  if (!report.rows.empty() && !report.rows.front().evenness.empty()) {
    std::vector<std::vector<LightSample>> measured;
    for (const EvennessRow& row : report.rows.front().evenness) {
      measured.push_back(row.samples);
    }
    writePng(folder / "evenness.png", evennessImage(measured));
  }
}

}  // namespace ocelli
