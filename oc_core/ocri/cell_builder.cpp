#include "oc_core/ocri/cell_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/construction.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/set_difference.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

/// Samples stored for each one of a satellite: tiles repeat the first row and column of the next ones.
constexpr float kTileOverhead = 16.0f * 16 / (15 * 15);

/// The i-th number of the van der Corput sequence in a base: points spread evenly over [0, 1).
float radicalInverse(int i, int base) {
  float value = 0;
  float digit = 1.0f / static_cast<float>(base);
  for (; i > 0; i /= base) {
    value += static_cast<float>(i % base) * digit;
    digit /= static_cast<float>(base);
  }
  return value;
}

/// The farthest viewpoints of the cell first, corners that face each other one after the other, then points spread over
/// the cell.
std::vector<View> satelliteViews(const View& reference, const CellOptions& options) {
  constexpr std::array<glm::vec3, 8> kCorners{
      {{-1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}}};
  const ViewCell& cell = options.cell;
  std::vector<View> views;
  if (cell.shape == ViewCell::Shape::kCube) {
    for (const glm::vec3& corner : kCorners) {
      views.push_back(movedEye(reference, corner * cell.halfSide()));
    }
  } else {
    views = cell.edgeViews(reference);
  }
  for (int i = 1; static_cast<int>(views.size()) < options.maxSatellites; ++i) {
    const glm::vec3 spread = glm::vec3(radicalInverse(i, 2), radicalInverse(i, 3), radicalInverse(i, 5)) * 2.0f - 1.0f;
    if (cell.shape == ViewCell::Shape::kSegment) {
      views.push_back(movedEye(reference, glm::normalize(cell.segmentDirection) * (spread.x * cell.halfSide())));
    } else if (cell.shape == ViewCell::Shape::kCube || glm::length(spread) <= 1) {
      views.push_back(movedEye(reference, spread * cell.halfSide()));
    }
  }
  views.resize(static_cast<size_t>(options.maxSatellites), reference);
  return views;
}

/// World positions of the samples, w = 0 where there is none.
Image<glm::vec4> positionsOf(const ReferenceImage& image) {
  const PinholeCamera camera = image.reference();
  Image<glm::vec4> positions(image.width(), image.height(), glm::vec4(0));
  parallelFor(static_cast<size_t>(image.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < image.width(); ++x) {
        if (const auto point = camera.unproject(image.undistorted(x, y))) {
          positions(x, y) = glm::vec4(*point, 1);
        }
      }
    }
  });
  return positions;
}

bool isMissing(SampleState state) {
  return state == SampleState::kMissing || state == SampleState::kMissingThick;
}

/// Marks the missing pixels that lie in groups of at least `least`, neighbours along rows, columns and diagonals.
Image<uint8_t> missingGroups(const Image<SampleState>& states, int least) {
  Image<uint8_t> marks(states.width(), states.height(), 0);
  Image<uint8_t> visited(states.width(), states.height(), 0);
  std::vector<glm::ivec2> group;
  for (int y = 0; y < states.height(); ++y) {
    for (int x = 0; x < states.width(); ++x) {
      if (!isMissing(states(x, y)) || visited(x, y) != 0) {
        continue;
      }
      group.assign(1, {x, y});
      visited(x, y) = 1;
      for (size_t next = 0; next < group.size(); ++next) {
        const glm::ivec2 p = group[next];
        for (int v = p.y - 1; v <= p.y + 1; ++v) {
          for (int u = p.x - 1; u <= p.x + 1; ++u) {
            if (states.contains(u, v) && isMissing(states(u, v)) && visited(u, v) == 0) {
              visited(u, v) = 1;
              group.push_back({u, v});
            }
          }
        }
      }
      if (group.size() >= static_cast<size_t>(least)) {
        for (const glm::ivec2& p : group) {
          marks(p.x, p.y) = 1;
        }
      }
    }
  }
  return marks;
}

/// What one viewpoint sees, and what of it is stored.
struct Part {
  PinholeCamera camera;
  FragmentImage seen;
  ReferenceImage image;  ///< the depth image, without colours
  Image<glm::vec4> truth;
  size_t firstVertex = 0;  ///< of its mesh in the mesh of all
  std::vector<uint32_t> pixelOfVertex{};
};

/// Appends the mesh of the part.
void appendPart(Mesh& mesh, Part& part) {
  part.firstVertex = mesh.positions.size();
  append(mesh, imageMesh(part.image, {}, &part.pixelOfVertex));
}

Mesh meshOf(std::vector<Part>& parts) {
  Mesh mesh;
  for (Part& part : parts) {
    appendPart(mesh, part);
  }
  return mesh;
}

/// Takes out the satellite samples whose triangles lie in front of what a viewpoint sees. Returns how many.
size_t removeHarmful(std::vector<Part>& parts, const Mesh& mesh) {
  std::vector<Image<uint8_t>> harm;
  harm.reserve(parts.size());
  for (const Part& part : parts) {
    harm.emplace_back(part.image.width(), part.image.height(), 0);
  }
  for (const Part& viewer : parts) {
    const FragmentImage frame = rasterize(viewer.camera, mesh);
    const Image<SampleState> states = compareFrames(viewer.camera, viewer.truth, positionImage(frame, mesh));
    for (int y = 0; y < frame.height(); ++y) {
      for (int x = 0; x < frame.width(); ++x) {
        if (!isMissing(states(x, y)) || !frame(x, y).covered() ||
            frame(x, y).t >= viewer.camera.cameraFromWorld(glm::vec3(viewer.truth(x, y))).z) {
          continue;
        }
        const glm::uvec3& triangle = mesh.triangles[frame(x, y).triangle];
        size_t owner = parts.size() - 1;
        while (parts[owner].firstVertex > triangle.x) {
          --owner;
        }
        for (int corner = 0; corner < 3 && owner > 0; ++corner) {
          uint8_t& count = harm[owner][parts[owner].pixelOfVertex[triangle[corner] - parts[owner].firstVertex]];
          count = static_cast<uint8_t>(std::min(count + 1, 255));
        }
      }
    }
  }
  size_t removed = 0;
  for (size_t i = 1; i < parts.size(); ++i) {
    for (size_t pixel = 0; pixel < harm[i].size(); ++pixel) {
      if (harm[i][pixel] > 0 && parts[i].image.holds(pixel)) {
        parts[i].image.clear(pixel);
        ++removed;
      }
    }
  }
  return removed;
}

/// The reference part, then the satellites that add to it.
struct Found {
  std::vector<Part> parts;
  Mesh mesh;                       ///< of all parts
  size_t samples = 0;              ///< that they take
  std::vector<View> candidates{};  ///< viewpoints that would add something if their samples were a pixel apart
};

size_t maxSamples(const Found& found, const CellOptions& options) {
  return static_cast<size_t>(options.maxSamples * static_cast<float>(found.parts[0].image.sampleCount()));
}

Part partSeenFrom(const PinholeCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  Part part{camera, seenFrom(camera, mesh, renderer), {}, {}};
  const FragmentImage& seen = part.seen;
  part.image = {.camera = "di",
                .view = camera.view(),
                .color = {},
                .t = Image<float>(seen.width(), seen.height()),
                .held = Image<uint8_t>(seen.width(), seen.height()),
                .displacement = Image<glm::vec2>(seen.width(), seen.height())};
  parallelFor(seen.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (seen[i].covered()) {
        part.image.t[i] = camera.cameraFromWorld(positionOf(seen[i], mesh)).z;
        part.image.held[i] = 1;
      }
    }
  });
  part.truth = positionsOf(part.image);
  return part;
}

/// The reference part alone.
Found referencePart(const PinholeCamera& reference, const Mesh& mesh, const SceneRenderer* renderer) {
  Found found;
  found.parts.push_back(partSeenFrom(reference, mesh, renderer));
  found.samples = found.parts[0].image.sampleCount();
  appendPart(found.mesh, found.parts[0]);
  return found;
}

/// Adds satellites at those of `views` that matter, their samples `spacing` apart. Once they take too many samples:
/// what there is so far where it `mayStop`, nothing otherwise.
std::optional<Found> findParts(Found found, const Mesh& mesh, const std::vector<View>& views,
                               const CellOptions& options, float spacing, bool mayStop, const Progress& progress,
                               const SceneRenderer* renderer) {
  const PinholeCamera reference = found.parts[0].camera;
  const auto least = static_cast<size_t>(options.minShare * static_cast<float>(found.samples));
  const auto scaled = [&](int pixels) {
    return std::max(static_cast<int>(std::lround(static_cast<float>(pixels) / spacing)), 1);
  };
  for (size_t i = 0; i < views.size(); ++i) {
    report(progress, "satellites", static_cast<double>(i) / static_cast<double>(views.size()));
    const PinholeCamera camera(views[i], scaled(reference.width()), scaled(reference.height()));
    Part part = partSeenFrom(camera, mesh, renderer);
    Image<uint8_t> marks =
        missingGroups(compareFrames(camera, part.truth, positionImage(camera, found.mesh)), options.minGroup);
    const auto missing = static_cast<size_t>(std::count(marks.begin(), marks.end(), 1));
    if (2 * static_cast<float>(missing) * spacing * spacing > static_cast<float>(least)) {
      found.candidates.push_back(views[i]);
    }
    if (missing <= least) {
      continue;
    }
    for (int step = 0; step < options.seamPixels; ++step) {
      growAlongSurface(marks, part.image);
    }
    keepMarked(part.image, marks);
    const auto added = static_cast<size_t>(kTileOverhead * static_cast<float>(part.image.sampleCount()));
    if (found.samples + added > maxSamples(found, options)) {
      return mayStop ? std::optional(std::move(found)) : std::nullopt;
    }
    found.samples += added;
    appendPart(found.mesh, part);
    found.parts.push_back(std::move(part));
  }
  return found;
}

/// The closest spacing of samples for which those of satellites should suffice, given what they take at the coarsest:
/// groups have an area and a border.
float expectedSpacing(const Found& coarsest, const CellOptions& options) {
  constexpr float kGrowth = 1.5f;
  const auto own = static_cast<float>(coarsest.parts[0].image.sampleCount());
  const float taken = static_cast<float>(coarsest.samples) - own;
  const float given = (options.maxSamples - 1) * own;
  return given > 0 ? options.coarsestSpacing * std::pow(taken / given, 1 / kGrowth) : options.coarsestSpacing;
}

void takeOutHarmful(Found& found, const CellOptions& options, const Progress& progress) {
  for (int round = 0; round < options.feedbackRounds; ++round) {
    report(progress, "do no harm", static_cast<double>(round) / options.feedbackRounds);
    if (removeHarmful(found.parts, found.mesh) == 0) {
      break;
    }
    found.mesh = meshOf(found.parts);
  }
  report(progress, "do no harm", 1);
}

/// The parts of the camera, the reference first.
std::vector<Part> construct(const PinholeCamera& reference, const Mesh& mesh, const CellOptions& options,
                            const Progress& progress, const SceneRenderer* renderer) {
  constexpr float kCoarser = 1.12f;
  const Found alone = referencePart(reference, mesh, renderer);
  Found found = *findParts(alone, mesh, satelliteViews(reference.view(), options), options, options.coarsestSpacing,
                           true, progress, renderer);
  // Closer together, samples are looked for only from the viewpoints that may have some then.
  const std::vector<View> views = found.candidates;
  float spacing = std::max(expectedSpacing(found, options), 1.0f);
  std::optional<Found> finer;
  while (!finer && spacing < options.coarsestSpacing) {
    finer = findParts(alone, mesh, views, options, spacing, false, progress, renderer);
    spacing *= kCoarser;
  }
  if (finer) {
    found = std::move(*finer);
  }
  takeOutHarmful(found, options, progress);
  return std::move(found.parts);
}

CellCamera cameraOf(const std::vector<Part>& parts) {
  std::vector<CellCamera::Viewpoint> viewpoints;
  for (const Part& part : parts) {
    viewpoints.push_back({part.camera, part.image.t});
  }
  for (float& reach : viewpoints[0].reach) {
    reach = reach > 0 ? reach : parts[0].camera.view().zFar;
  }
  return CellCamera(std::move(viewpoints));
}

/// The image of what each viewpoint sees; `seenBy` is called for one after the other.
template <class SeenBy>
ReferenceImage imageOf(const CellCamera& camera, const Mesh& mesh, const SeenBy& seenBy) {
  FragmentImage fragments(camera.width(), camera.height());
  const auto copy = [&](size_t viewpoint, const FragmentImage& seen, const glm::ivec2& from, const glm::ivec2& extent,
                        const glm::ivec2& to) {
    const Image<float>& reach = camera.viewpoints()[viewpoint].reach;
    for (int y = 0; y < extent.y; ++y) {
      for (int x = 0; x < extent.x; ++x) {
        if (reach.contains(from.x + x, from.y + y) && reach(from.x + x, from.y + y) > 0) {
          fragments(to.x + x, to.y + y) = seen(from.x + x, from.y + y);
        }
      }
    }
  };
  const PinholeCamera& reference = camera.reference();
  copy(0, seenBy(0), {0, 0}, {reference.width(), reference.height()}, {0, 0});
  for (size_t tile = 0; tile < camera.tiles().size();) {
    const size_t viewpoint = camera.tiles()[tile].viewpoint;
    const FragmentImage& seen = seenBy(viewpoint);
    for (; tile < camera.tiles().size() && camera.tiles()[tile].viewpoint == viewpoint; ++tile) {
      copy(viewpoint, seen, camera.tiles()[tile].corner, glm::ivec2(CellCamera::kTileSide), camera.cornerOf(tile));
    }
  }
  return cellImage(camera, fragments, mesh);
}

}  // namespace

CellCamera buildCellCamera(const PinholeCamera& reference, const Mesh& mesh, const CellOptions& options,
                           const Progress& progress, const SceneRenderer* renderer) {
  return cameraOf(construct(reference, mesh, options, progress, renderer));
}

ReferenceImage cellImage(const CellCamera& camera, const FragmentImage& fragments, const Mesh& mesh) {
  const PinholeCamera& reference = camera.reference();
  ReferenceImage image = referenceImage(fragments, mesh, reference, "cell");
  image.pinholeSize = {reference.width(), reference.height()};
  image.tileSide = CellCamera::kTileSide;
  if (camera.viewpoints().size() > 1) {
    image.tileSpacing = reference.focalPixels() / camera.viewpoints()[1].camera.focalPixels();
  }
  return image;
}

ReferenceImage buildCellImage(const CellCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  return imageOf(camera, mesh,
                 [&](size_t viewpoint) { return seenFrom(camera.viewpoints()[viewpoint].camera, mesh, renderer); });
}

ReferenceImage buildCellImage(const PinholeCamera& reference, const Mesh& mesh, const CellOptions& options,
                              const Progress& progress, const SceneRenderer* renderer) {
  const std::vector<Part> parts = construct(reference, mesh, options, progress, renderer);
  return imageOf(cameraOf(parts), mesh,
                 [&](size_t viewpoint) -> const FragmentImage& { return parts[viewpoint].seen; });
}

}  // namespace ocelli
