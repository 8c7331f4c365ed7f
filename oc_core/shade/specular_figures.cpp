#include "oc_core/shade/specular_figures.h"

namespace ocelli {
namespace {

using Row = ShadeFigures;
using Value = std::optional<double>;

Value withDepth(const Row& row, double value) {
  return row.hasDepth ? Value(value) : std::nullopt;
}
Value inPyramids(const Row& row, double value) {
  return row.cost.steps() > 0 ? Value(value) : std::nullopt;
}
Value counted(size_t number) {
  return number > 0 ? Value(static_cast<double>(number)) : std::nullopt;
}

}  // namespace

const std::vector<SpecularFigure>& specularFigures() {
  static const std::vector<SpecularFigure> figures{
      {{"rays", nullptr, "one a pixel that sends one on", 0, 1},
       [](const Row& r) -> Value { return static_cast<double>(r.rays); }},
      {{"cast_rays", nullptr, "those whose traced first hit is on an object that depth images stand for", 0, 1},
       [](const Row& r) -> Value { return static_cast<double>(r.castRays); }},
      {{"psnr_db", "PSNR dB", "of the pixels that send rays on, against the traced picture", 2, 1},
       [](const Row& r) -> Value { return r.psnrDecibels; }},
      {{"lost", "lost %",
        "first hits that are missing or further than 1.5 footprints off, of the rays whose traced first "
        "hit is on an object that depth images stand for",
        2, 100},
       [](const Row& r) { return withDepth(r, r.lostRatio()); }},
      {{"missing", "missing %", "those of them that meet no sample", 2, 100},
       [](const Row& r) { return withDepth(r, r.missingRatio()); }},
      {{"false_hits", "false %",
        "rays that meet a sample more than 1.5 footprints before the traced first hit, of all rays", 2, 100},
       [](const Row& r) { return withDepth(r, r.falseRatio()); }},
      {{"steps_per_ray", "steps",
        "a ray: nodes of the pyramid that are opened and cells that are tested, or coarse and fine steps of a walk", 1,
        1},
       [](const Row& r) { return inPyramids(r, r.stepsPerRay()); }},
      {{"max_steps", "most", "the most steps of a ray", 0, 1}, [](const Row& r) { return inPyramids(r, r.maxSteps); }},
      {{"boxes_per_ray", "boxes", "bounds that are compared, a ray", 1, 1},
       [](const Row& r) { return inPyramids(r, r.boxesPerRay()); }},
      {{"second_rays", nullptr, "whose traced second-order ray meets an object that depth images stand for", 0, 1},
       [](const Row& r) { return counted(r.secondRays); }},
      {{"second_lost", "2nd lost %",
        "of those, whose second-order ray meets none of it within 1.5 footprints of there, in space", 2, 100},
       [](const Row& r) { return r.secondRays > 0 ? withDepth(r, r.secondLostRatio()) : std::nullopt; }},
      {{"exit_degrees", "exit deg",
        "between the rays that leave glass by its back faces and those that are traced through it, a mean", 2, 1},
       [](const Row& r) { return r.exitDegrees; }},
      {{"footprint", nullptr, "mean at the traced first hits on objects that depth images stand for, world units", 0,
        1},
       [](const Row& r) { return r.footprint > 0 ? Value(r.footprint) : std::nullopt; }},
      {{"samples", "samples", "of the images", 0, 1}, [](const Row& r) { return counted(r.samples); }},
      {{"triangles", "triangles", "that rays can hit", 0, 1}, [](const Row& r) { return counted(r.triangles); }},
      {{"build_ms", "build ms", "of the images; of the acceleration structure where the geometry is traced", 1, 1},
       [](const Row& r) -> Value { return r.buildMilliseconds; }},
      {{"structure_ms", "pyramid ms", "of the cells and the pyramid", 1, 1},
       [](const Row& r) { return inPyramids(r, r.structureMilliseconds); }},
      {{"shade_ms", "rays ms", "of all rays, on all threads", 1, 1},
       [](const Row& r) -> Value { return r.shadeMilliseconds; }},
      {{"gl_differing", "GL off %",
        "with --gl: rays that meet something else than on the CPU, or at another distance, or see another colour, of "
        "all rays",
        3, 100},
       [](const Row& r) { return r.deviceDiffering ? Value(r.deviceDifferingRatio()) : std::nullopt; }},
  };
  return figures;
}

}  // namespace ocelli
