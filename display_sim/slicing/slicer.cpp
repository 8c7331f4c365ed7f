#include "display_sim/slicing/slicer.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "display_sim/frames/volume_pool.h"
#include "oc_core/base/check.h"

namespace ocelli {

struct Slicer::Impl {
  Impl(const DisplayProfile& display, const SliceOptions& options)
      : profile(display), pass(makeSlicePass(display, options)), volume(volumes.take(display)) {}

  void makeAll(const SliceMesh& mesh) {
    spans.assign(mesh.chunks().size(), {});
    std::vector<int> slices(static_cast<size_t>(profile.storedSlices()));
    std::iota(slices.begin(), slices.end(), 0);
    make(mesh, allChunks(mesh), slices);
  }

  void makeMoved(const SliceMesh& mesh) {
    std::vector<size_t> moved;
    for (size_t c = 0; c < versions.size(); ++c) {
      if (mesh.chunks()[c].version != versions[c]) {
        moved.push_back(c);
      }
    }
    std::vector<char> dirty(static_cast<size_t>(profile.storedSlices()));
    markSlices(moved, dirty);
    pass->findSpans(mesh, moved, spans);
    markSlices(moved, dirty);
    std::vector<int> slices;
    for (size_t i = 0; i < dirty.size(); ++i) {
      if (dirty[i] != 0) {
        slices.push_back(static_cast<int>(i));
      }
    }
    make(mesh, chunksTouching(dirty), slices);
  }

  void makeSome(const SliceMesh& mesh, std::span<const int> slices) {
    spans.assign(mesh.chunks().size(), {});
    pass->findSpans(mesh, allChunks(mesh), spans);
    std::vector<char> wanted(static_cast<size_t>(profile.storedSlices()));
    for (const int slice : slices) {
      wanted[static_cast<size_t>(slice)] = 1;
    }
    make(mesh, chunksTouching(wanted), {slices.begin(), slices.end()});
    versions.clear();  // the volume is not whole
  }

  DisplayProfile profile;
  std::unique_ptr<SlicePass> pass;
  VolumePool volumes;
  std::shared_ptr<Volume> volume;
  /// Of the chunks in the volume; none where the volume is new.
  std::vector<SectorSpan> spans;
  std::vector<uint32_t> versions;
  int made = 0;
  SliceStages stages;

 private:
  static std::vector<size_t> allChunks(const SliceMesh& mesh) {
    std::vector<size_t> chunks(mesh.chunks().size());
    std::iota(chunks.begin(), chunks.end(), size_t{0});
    return chunks;
  }

  std::vector<size_t> chunksTouching(const std::vector<char>& wanted) const {
    std::vector<size_t> chunks;
    for (size_t c = 0; c < spans.size(); ++c) {
      bool touches = false;
      forEachSlice(spans[c], [&](size_t slice) { touches |= wanted[slice] != 0; });
      if (touches) {
        chunks.push_back(c);
      }
    }
    return chunks;
  }

  void make(const SliceMesh& mesh, const std::vector<size_t>& chunks, const std::vector<int>& slices) {
    stages = pass->run(mesh, chunks, slices, spans, *volume);
    made = static_cast<int>(slices.size());
    versions.clear();
    for (const SliceChunk& chunk : mesh.chunks()) {
      versions.push_back(chunk.version);
    }
  }

  void markSlices(const std::vector<size_t>& chunks, std::vector<char>& dirty) const {
    for (const size_t chunk : chunks) {
      forEachSlice(spans[chunk], [&](size_t slice) { dirty[slice] = 1; });
    }
  }

  template <class Visit>
  void forEachSlice(const SectorSpan& span, Visit&& visit) const {
    for (int i = 0; i < span.count; ++i) {
      for (int slice = (span.first + i) % profile.slicesPerHalfTurn; slice < profile.storedSlices();
           slice += profile.slicesPerHalfTurn) {
        visit(static_cast<size_t>(slice));
      }
    }
  }
};

Slicer::Slicer(const DisplayProfile& profile, const SliceOptions& options)
    : impl_(std::make_unique<Impl>(profile, options)) {
  OC_CHECK(!needsExactSlicer(options), "the fast slicer was asked for what sliceExactly() alone can do");
}
Slicer::~Slicer() = default;
Slicer::Slicer(Slicer&&) noexcept = default;

const DisplayProfile& Slicer::profile() const {
  return impl_->profile;
}

const Volume& Slicer::slice(const SliceMesh& mesh) {
  impl_->makeAll(mesh);
  return *impl_->volume;
}

const Volume& Slicer::slice(const SliceMesh& mesh, std::span<const int> slices) {
  impl_->makeSome(mesh, slices);
  return *impl_->volume;
}

const Volume& Slicer::update(const SliceMesh& mesh) {
  OC_CHECK(impl_->versions.size() == mesh.chunks().size(), "another mesh than was sliced last, or none");
  impl_->makeMoved(mesh);
  return *impl_->volume;
}

int Slicer::slicesMade() const {
  return impl_->made;
}

const SliceStages& Slicer::stages() const {
  return impl_->stages;
}

Volume Slicer::takeVolume() {
  impl_->versions.clear();
  return std::exchange(*impl_->volume, Volume(impl_->profile));
}

std::shared_ptr<const Volume> Slicer::takeShared() {
  impl_->versions.clear();
  std::shared_ptr<const Volume> taken = std::move(impl_->volume);
  impl_->volume = impl_->volumes.take(impl_->profile);
  return taken;
}

Volume slice(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options) {
  Slicer slicer(profile, options);
  slicer.slice(SliceMesh(mesh));
  return slicer.takeVolume();
}

}  // namespace ocelli
