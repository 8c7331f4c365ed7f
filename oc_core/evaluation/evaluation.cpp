#include "oc_core/evaluation/evaluation.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/evaluation/error_image.h"
#include "oc_core/evaluation/truth_frames.h"
#include "oc_core/ranks/packed_bytes.h"
#include "oc_core/ranks/shared_tasks.h"

namespace ocelli {
namespace {

double milliseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double ratio(double value, double reference) {
  return reference > 0 ? value / reference : 0;
}

/// Frames [first, last) of the truth belong together.
struct Place {
  size_t first = 0;
  size_t last = 0;
};

/// The viewpoints of all places, one after the other.
class Viewpoints {
 public:
  explicit Viewpoints(const EvaluationOptions& options) {
    edges = add(options.cell.edgeViews(options.view, options.edgeViews));
    interior = add(options.cell.interiorViews(options.view, options.interiorViews, options.seed));
    reference = add({options.view});
    const std::vector<glm::vec3> directions = options.cell.directions(options.offsetDirections, options.seed);
    for (const float offset : options.offsets) {
      std::vector<View> there;
      for (const glm::vec3& direction : directions) {
        there.push_back(movedEye(options.view, direction * (offset * options.cell.halfSide())));
      }
      offsets.push_back(offset == 0 ? reference : add(there));
    }
  }

  std::vector<View> views;
  Place edges, interior, reference;
  std::vector<Place> offsets;

 private:
  Place add(const std::vector<View>& more) {
    const Place place{views.size(), views.size() + more.size()};
    views.insert(views.end(), more.begin(), more.end());
    return place;
  }
};

std::vector<PinholeCamera> camerasOf(const std::vector<View>& views, int width, int height) {
  std::vector<PinholeCamera> cameras;
  for (const View& view : views) {
    cameras.emplace_back(view, width, height);
  }
  return cameras;
}

void takeBest(double& best, double time, bool first) {
  best = first ? time : std::min(best, time);
}

}  // namespace

std::vector<float> defaultOffsets() {
  return {0, 0.02f, 0.05f, 0.1f, 0.15f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1};
}

struct Evaluator::Impl {
  Impl(const EvaluatedScene& evaluated, const EvaluationOptions& given)
      : scene(evaluated),
        options(given),
        viewpoints(given),
        truth([this](const PinholeCamera& camera) { return scene.frame(camera); },
              camerasOf(viewpoints.views, given.width, given.height)) {
    for (const View& view : viewpoints.views) {
      scene.requireViewpoint(view.eye);
    }
  }
  /// Takes what it is told to keep.
  Impl(std::unique_ptr<const EvaluatedScene> evaluated, const EvaluationOptions& given) : Impl(*evaluated, given) {
    kept = std::move(evaluated);
  }

  FrameComparison comparisonWith(const PinholeCamera& camera, const ViewFrame& shown, const ViewFrame& frame) const {
    return compareViewFrames(camera, shown, frame, [this](const glm::vec3& point, float reach) {
      return scene.hasSurfaceNear(point, reach);
    });
  }

  const PinholeCamera& reference() const { return truth.camera(viewpoints.reference.first); }
  Ranks& ranks() const { return options.ranks != nullptr ? *options.ranks : *alone; }

  /// `measure(k)` for each k below `count`: the same in all ranks.
  template <class Result, class Measure>
  std::vector<Result> atEach(size_t count, const Measure& measure) {
    const std::vector<size_t> tasks = tasksOfRank(ranks(), count);
    std::vector<Bytes> mine(tasks.size());
    parallelFor(tasks.size(), 1, [&](size_t begin, size_t end) {
      for (size_t task = begin; task < end; ++task) {
        BytePacker packer;
        packer.add(Result(measure(tasks[task])));
        mine[task] = packer.take();
      }
    });
    std::vector<Result> results;
    for (const Bytes& result : gatherTasksToAll(ranks(), count, mine)) {
      results.push_back(ByteUnpacker(result).value<Result>());
    }
    return results;
  }

  /// Errors are measured once at each viewpoint, although the reference belongs to two places.
  /// Those that were not measured before are handed out to the ranks, and all get what each has measured.
  class Measured {
   public:
    Measured(Impl& impl, const Mesh& mesh, const std::string& name, const Progress& progress)
        : impl_(impl), mesh_(mesh), name_(name), progress_(progress), errors_(impl.truth.count()) {}

    FrameErrors at(const Place& place, bool images) {
      FrameErrors sum;
      for (const FrameErrors& each : atEachOf(place, images)) {
        sum += each;
      }
      return sum;
    }

    std::vector<FrameErrors> atEachOf(const Place& place, bool images) {
      std::vector<size_t> open;
      for (size_t i = place.first; i < place.last; ++i) {
        if (!errors_[i]) {
          open.push_back(i);
        }
      }
      const std::vector<FrameErrors> errors =
          impl_.atEach<FrameErrors>(open.size(), [&](size_t k) { return measure(open[k], images); });
      for (size_t k = 0; k < open.size(); ++k) {
        errors_[open[k]] = errors[k];
      }
      std::vector<FrameErrors> all;
      for (size_t i = place.first; i < place.last; ++i) {
        all.push_back(*errors_[i]);
      }
      return all;
    }

   private:
    FrameErrors measure(size_t i, bool images) {
      const auto ranks = static_cast<size_t>(impl_.ranks().size());
      report(progress_, name_, static_cast<double>(ranks * done_++) / static_cast<double>(errors_.size()));
      const std::shared_ptr<const ViewFrame> truth = impl_.truth.frame(i);
      const ViewFrame frame = renderFrame(impl_.truth.camera(i), mesh_);
      FrameErrors errors = countErrors(impl_.comparisonWith(impl_.truth.camera(i), *truth, frame), frame);
      if (images) {
        addImageErrors(errors, *truth, frame);
      }
      return errors;
    }

    Impl& impl_;
    const Mesh& mesh_;
    const std::string& name_;
    const Progress& progress_;
    std::vector<std::optional<FrameErrors>> errors_;
    std::atomic<size_t> done_ = 0;
  };

  /// The ratios need the depth image, whether or not it is among what is measured.
  const MissingSamples& missingFromDepthImage() {
    if (!depthImage) {
      const Mesh mesh = scene.depthImageMesh(reference());
      const size_t first = viewpoints.edges.first;
      MissingSamples missing;
      for (const MissingSamples& each : atEach<MissingSamples>(viewpoints.edges.last - first, [&](size_t k) {
             const PinholeCamera& camera = truth.camera(first + k);
             return countMissing(compareFrames(camera, truth.frame(first + k)->points, positionImage(camera, mesh)));
           })) {
        missing += each;
      }
      depthImage = missing;
    }
    return *depthImage;
  }

  std::unique_ptr<const EvaluatedScene> kept;
  const EvaluatedScene& scene;
  EvaluationOptions options;
  std::unique_ptr<Ranks> alone = serialRanks();
  Viewpoints viewpoints;
  TruthFrames truth;
  std::optional<MissingSamples> depthImage;
};

Evaluator::Evaluator(const Mesh& scene, const EvaluationOptions& options)
    : impl_(std::make_unique<Impl>(std::make_unique<const MeshScene>(scene), options)) {}

Evaluator::Evaluator(const EvaluatedScene& scene, const EvaluationOptions& options)
    : impl_(std::make_unique<Impl>(scene, options)) {}

Evaluator::~Evaluator() = default;

RepresentationFigures Evaluator::measure(const CameraChoice& choice, const Progress& progress,
                                         const MeshVisitor& visit) {
  return measure(
      choice.name,
      [&](RepresentationTimes& times) { return impl_->scene.represent(choice, impl_->reference(), progress, &times); },
      progress, visit);
}

RepresentationFigures Evaluator::measure(const std::string& name, const MakeRepresentation& make,
                                         const Progress& progress, const MeshVisitor& visit) {
  const EvaluationOptions& options = impl_->options;
  RepresentationFigures figures;
  figures.name = name;
  Representation made;
  const int runs = impl_->ranks().isFirst() ? options.runs : 1;
  for (int run = 0; run < std::max(runs, 1); ++run) {
    report(progress, name, 0);
    RepresentationTimes times;
    made = make(times);
    const bool first = run == 0;
    takeBest(figures.buildMilliseconds, times.buildMilliseconds, first);
    takeBest(figures.meshMilliseconds, times.meshMilliseconds, first);
    if (options.slice) {
      takeBest(figures.sliceMilliseconds, milliseconds([&] { options.slice(made.mesh); }), first);
    }
  }
  figures.triangles = made.mesh.triangles.size();
  figures.samples = made.sampleCount();
  figures.pixels = made.pixelCount();
  if (made.images.empty()) {
    figures.bytes = storedSize(made.mesh);
  }
  for (const ReferenceImage& image : made.images) {
    figures.bytes += storedSize(image);
  }
  Impl::Measured measured(*impl_, made.mesh, name, progress);
  figures.edges = measured.at(impl_->viewpoints.edges, options.compareImages);
  figures.edgeViews = measured.atEachOf(impl_->viewpoints.edges, options.compareImages);
  figures.interior = measured.at(impl_->viewpoints.interior, options.compareImages);
  figures.reference = measured.at(impl_->viewpoints.reference, options.compareImages);
  for (const Place& place : impl_->viewpoints.offsets) {
    figures.offsets.push_back(measured.at(place, false));
  }
  figures.strictRatioToDi = ratio(figures.edges.strictRatio(), impl_->missingFromDepthImage().strictRatio());
  figures.thickRatioToDi = ratio(figures.edges.thickRatio(), impl_->missingFromDepthImage().thickRatio());
  if (visit) {
    visit(made.mesh);
  }
  report(progress, name, 1);
  return figures;
}

View Evaluator::exampleView() const {
  const ViewCell& cell = impl_->options.cell;
  const glm::vec3 left = cell.shape == ViewCell::Shape::kSegment ? cell.directions(2, 0).back() : glm::vec3(-1, 0, 0);
  return movedEye(impl_->options.view, left * cell.halfSide());
}

Image<Rgb8> Evaluator::exampleImage() const {
  return impl_->scene.frame({exampleView(), impl_->options.width, impl_->options.height}).image;
}

Evaluator::Example Evaluator::example(const Mesh& mesh) const {
  const PinholeCamera camera(exampleView(), impl_->options.width, impl_->options.height);
  const ViewFrame truth = impl_->scene.frame(camera);
  const ViewFrame frame = renderFrame(camera, mesh);
  return {frame.image, errorImage(truth, impl_->comparisonWith(camera, truth, frame))};
}

std::vector<RepresentationFigures> evaluate(const Mesh& mesh, const std::vector<CameraChoice>& choices,
                                            const EvaluationOptions& options, const Progress& progress) {
  Evaluator evaluator(mesh, options);
  std::vector<RepresentationFigures> rows;
  for (const CameraChoice& choice : choices) {
    rows.push_back(evaluator.measure(choice, progress));
  }
  return rows;
}

}  // namespace ocelli
