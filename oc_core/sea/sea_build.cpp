#include "oc_core/sea/sea_build.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "oc_core/base/parallel.h"
#include "oc_core/sea/hidden_bytes.h"
#include "oc_core/sea/pose_refinement.h"
#include "oc_core/sea/proxy_bytes.h"
#include "oc_core/sea/reference_store.h"
#include "oc_core/sea/residual.h"
#include "oc_core/sea/sea_writer.h"

namespace ocelli {
namespace {

/// Images that are built together. It does not depend on the threads, so that the file does not.
constexpr size_t kMaxInGroup = 16;
/// P-nodes whose energies are looked at before any is coded.
constexpr size_t kSampledEnergies = 24;

struct Coded {
  sea::ImagePrefix prefix;
  std::vector<std::byte> bytes;
  std::vector<uint8_t> hidden;
};

std::string nameLines(const std::vector<std::string>& names) {
  std::string lines;
  for (const std::string& name : names) {
    lines += name + "\n";
  }
  return lines;
}

class Builder {
 public:
  Builder(const SeaSource& source, const SeaDecoder& decoder, const SeaTree& tree, const HiddenPoints& hiddenPoints)
      : source_(source),
        decoder_(decoder),
        tree_(tree),
        hiddenPoints_(hiddenPoints),
        refinement_(requirePoseRefinement(decoder.settings().refinement, "refinement")) {
    const SeaProjection& whole = source.projection();
    const double share = std::min(1.0, static_cast<double>(kRefinementSide) / std::max(whole.width, whole.height));
    small_ = whole.scaled(share);
  }

  void setEnergies(const EnergyRange& range) { energies_ = range; }

  Coded inner(uint32_t image) const {
    const SeaSettings& settings = decoder_.settings();
    Coded coded;
    coded.prefix.quality = static_cast<float>(settings.iQuality);
    coded.bytes = encoded(decoder_.iCodec(), source_.image(image), settings.iQuality);
    return coded;
  }

  /// hiddenBytes() of an I-node, for the images that hang on it.
  std::vector<uint8_t> hidden(uint32_t image) const {
    const SeaSettings& settings = decoder_.settings();
    const std::vector<SeaPose>& poses = source_.poses();
    const glm::dvec3& eye = poses[image].position;
    std::vector<std::pair<double, uint32_t>> hanging;
    for (uint32_t i = 0; i < tree_.nodes.size(); ++i) {
      if (tree_.nodes[i].reference == image) {
        hanging.emplace_back(glm::distance(poses[i].position, eye), i);
      }
    }
    if (hanging.empty()) {
      return {};
    }
    std::sort(hanging.begin(), hanging.end());
    HiddenViews views;
    for (const auto& [distance, number] : hanging) {
      views.poses.push_back(poses[number]);
    }
    views.image = [&](size_t view) { return source_.image(hanging[view].second); };
    views.fewest = static_cast<size_t>(settings.hiddenViews);
    std::vector<uint8_t> bytes;
    runAlone([&] {
      const std::vector<glm::vec3> points = hiddenPoints_(decoder_.proxy().mesh(), poses[image], hanging.back().first);
      const HiddenSamples samples =
          gatherHiddenSamples(decoder_.proxy(), {settings.projection, poses[image]}, points, views);
      bytes = hiddenBytes(samples, settings.projection, decoder_.iCodec(), settings.hiddenQuality);
    });
    return bytes;
  }

  /// What the reference does not tell of the image.
  struct Difference {
    Image<Rgb8> image;
    Image<Rgb8> predicted;
    PoseOffset offset;
  };
  Difference difference(uint32_t image, const WarpReference& reference) const {
    Difference found;
    found.image = source_.image(image);
    const SeaPose& pose = source_.poses()[image];
    const SeaPose& referencePose = source_.poses()[tree_.nodes[image].reference];
    if (refinement_.algorithm >= 0) {
      const WarpReference smallReference(reducedImage(reference.image(), small_.width, small_.height), small_);
      const Image<Rgb8> smallTarget = reducedImage(found.image, small_.width, small_.height);
      const double reach = glm::distance(pose.position, referencePose.position);
      found.offset = rounded(refinedPose({decoder_.proxy(), small_, smallReference, referencePose, smallTarget, pose},
                                         refinement_, reach));
    }
    found.predicted =
        decoder_.predicted(reference, referencePose, movedBy(pose, found.offset.translation, found.offset.rotation));
    return found;
  }

  Coded residual(uint32_t image, const Difference& difference) const {
    const SeaSettings& settings = decoder_.settings();
    const double energy = residualEnergy(difference.image, difference.predicted);
    const double quality = adaptedQuality(settings.pQuality, settings.adaptive, energy, energies_);
    Coded coded;
    const auto floats = [](const glm::dvec3& v) {
      return std::array{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    coded.prefix = {floats(difference.offset.translation), floats(difference.offset.rotation),
                    tree_.nodes[image].reference, static_cast<float>(quality)};
    coded.bytes = encoded(decoder_.pCodec(), residualOf(difference.image, difference.predicted), quality);
    return coded;
  }

 private:
  /// As it is stored: what is predicted must be what a reader predicts.
  static PoseOffset rounded(const PoseOffset& offset) {
    return {glm::dvec3(glm::vec3(offset.translation)), glm::dvec3(glm::vec3(offset.rotation))};
  }
  static std::vector<std::byte> encoded(const ColorCodec& codec, const Image<Rgb8>& image, double quality) {
    std::vector<std::byte> bytes;
    runAlone([&] { bytes = codec.encode(image, quality); });
    return bytes;
  }

  const SeaSource& source_;
  const SeaDecoder& decoder_;
  const SeaTree& tree_;
  const HiddenPoints& hiddenPoints_;
  const PoseRefinementMethod& refinement_;
  SeaProjection small_;
  EnergyRange energies_;
};

/// Of some P-nodes, evenly chosen, against what they hang on, coded as I-nodes are.
EnergyRange sampledEnergies(const Builder& builder, const SeaDecoder& decoder, const SeaSource& source,
                            const SeaTree& tree, const Progress& progress) {
  std::vector<uint32_t> residuals;
  for (const uint32_t image : tree.order) {
    if (tree.nodes[image].reference != SeaNode::kNone) {
      residuals.push_back(image);
    }
  }
  const size_t count = std::min(kSampledEnergies, residuals.size());
  std::vector<double> energies(count);
  parallelFor(count, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t image = residuals[i * residuals.size() / count];
      const Coded coded = builder.inner(tree.nodes[image].reference);
      const WarpReference reference(
          decoder.inner({reinterpret_cast<const uint8_t*>(coded.bytes.data()), coded.bytes.size()}),
          source.projection());
      const Builder::Difference difference = builder.difference(image, reference);
      energies[i] = residualEnergy(difference.image, difference.predicted);
    }
    report(progress, "energies", static_cast<double>(end) / static_cast<double>(count));
  });
  if (energies.empty()) {
    return {};
  }
  const auto number = static_cast<double>(count);
  const double mean = std::accumulate(energies.begin(), energies.end(), 0.0) / number;
  double squares = 0;
  for (const double energy : energies) {
    squares += (energy - mean) * (energy - mean);
  }
  return {mean, std::sqrt(squares / number)};
}

}  // namespace

double adaptedQuality(double quality, double adaptive, double energy, const EnergyRange& range) {
  const double lower = range.mean - range.deviation;
  const double width = 2 * range.deviation;
  const double share = width > 0 ? std::clamp((energy - lower) / width, 0.0, 1.0) : 1.0;
  return std::max(1.0, quality * (1 - adaptive * (1 - share)));
}

std::vector<std::vector<uint32_t>> buildGroups(const SeaTree& tree) {
  std::vector<std::vector<uint32_t>> groups;
  const auto full = [&] { return groups.empty() || groups.back().size() == kMaxInGroup; };
  for (const uint32_t image : tree.order) {
    if (tree.nodes[image].reference == SeaNode::kNone) {
      if (full()) {
        groups.emplace_back();
      }
      groups.back().push_back(image);
    }
  }
  // The group that each image is in: what hangs on it comes later.
  std::vector<size_t> groupOf(tree.nodes.size(), 0);
  for (size_t group = 0; group < groups.size(); ++group) {
    for (const uint32_t image : groups[group]) {
      groupOf[image] = group;
    }
  }
  size_t first = groups.size();
  for (const uint32_t image : tree.order) {
    const uint32_t reference = tree.nodes[image].reference;
    if (reference == SeaNode::kNone) {
      continue;
    }
    // The first group from there on that has room and stands behind its reference.
    size_t group = std::max(first, groupOf[reference] + 1);
    while (group < groups.size() && groups[group].size() == kMaxInGroup) {
      ++group;
    }
    if (group == groups.size()) {
      groups.emplace_back();
    }
    groups[group].push_back(image);
    groupOf[image] = group;
    while (first < groups.size() && groups[first].size() == kMaxInGroup) {
      ++first;
    }
  }
  return groups;
}

SeaBuildReport buildSea(const SeaSource& source, const Mesh& proxy, const SeaSettings& settings,
                        const std::filesystem::path& path, bool startOver, const Progress& progress,
                        const HiddenPoints& hiddenPoints) {
  const auto start = std::chrono::steady_clock::now();
  OC_CHECK(!settings.hasHidden() || hiddenPoints, "someone chooses the hidden samples");
  OC_CHECK(settings.projection == source.projection(), "the settings are those of the images");
  const std::vector<SeaPose>& poses = source.poses();
  const SeaPreamble preamble{jsonText(settings), nameLines(source.names()), poses, proxyBytes(proxy, "the proxy")};
  SeaWriter writer(path, preamble, startOver);
  const SeaProxy stored(proxyFromBytes(preamble.proxy, "the proxy"));
  const SeaDecoder decoder(settings, stored);
  std::vector<glm::dvec3> positions;
  positions.reserve(poses.size());
  for (const SeaPose& pose : poses) {
    positions.push_back(pose.position);
  }
  const SeaTree tree = makeSeaTree(positions, settings.way, settings.spacing);
  SeaBuildReport result;
  result.images = poses.size();
  result.resumed = writer.count();
  result.rawBytes = uint64_t{3} * poses.size() * static_cast<uint64_t>(settings.projection.width) *
                    static_cast<uint64_t>(settings.projection.height);
  Builder builder(source, decoder, tree, hiddenPoints);
  if (settings.adaptive > 0 && writer.count() < poses.size()) {
    builder.setEnergies(sampledEnergies(builder, decoder, source, tree, progress));
  }
  ReferenceStore references(writer, decoder, poses);
  for (std::vector<uint32_t>& group : buildGroups(tree)) {
    std::erase_if(group, [&](uint32_t image) { return writer.has(image); });
    std::vector<uint32_t> needed;
    for (const uint32_t image : group) {
      if (tree.nodes[image].reference != SeaNode::kNone) {
        needed.push_back(tree.nodes[image].reference);
      }
    }
    references.prepare(needed);
    std::vector<Coded> coded(group.size());
    parallelFor(group.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const uint32_t reference = tree.nodes[group[i]].reference;
        if (reference == SeaNode::kNone) {
          coded[i] = builder.inner(group[i]);
          if (settings.hasHidden()) {
            coded[i].hidden = builder.hidden(group[i]);
          }
        } else {
          coded[i] = builder.residual(group[i], builder.difference(group[i], references.at(reference)));
        }
      }
    });
    for (size_t i = 0; i < group.size(); ++i) {
      writer.add(group[i], coded[i].prefix,
                 {reinterpret_cast<const uint8_t*>(coded[i].bytes.data()), coded[i].bytes.size()}, coded[i].hidden);
    }
    report(progress, "images", static_cast<double>(writer.count()) / static_cast<double>(poses.size()));
  }
  for (const SeaNode& node : tree.nodes) {
    result.inner += node.reference == SeaNode::kNone ? 1 : 0;
  }
  writer.finish();
  result.fileBytes = writer.bytes();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace ocelli
