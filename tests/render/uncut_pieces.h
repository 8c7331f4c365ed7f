// Pieces of rays that are drawn without culling: every block of the mesh in every region, each as one that may reach
// out of the piece and end anywhere. The slow reference of what the lists of blocks pass over.
#pragma once

#include <algorithm>
#include <memory>

#include "oc_core/render/draw_pieces.h"

namespace ocelli::test {

class UncutPiece final : public PieceRasterizer {
 public:
  UncutPiece(std::unique_ptr<PieceRasterizer> piece, const MeshBlocks& blocks, const PixelBounds& image)
      : piece_(std::move(piece)), blocks_(blocks), image_(image) {}

  uint8_t order() const override { return piece_->order(); }
  const PixelBounds& rect() const override { return piece_->rect(); }
  std::span<const int16_t> kindOfLeaf() const override { return piece_->kindOfLeaf(); }
  void findBlocks(MeshBlocks::Runs runs, uint32_t piece, const RegionGrid& /*grid*/,
                  std::vector<BlockTask>& tasks) const override {
    for (size_t block = runs.first * MeshBlocks::kRun; block < std::min(runs.last * MeshBlocks::kRun, blocks_.size());
         ++block) {
      tasks.push_back({.piece = piece, .block = static_cast<uint32_t>(block), .rect = image_});
    }
  }
  std::unique_ptr<Scratch> makeScratch() const override { return piece_->makeScratch(); }
  void begin(const RegionBuffer& region, uint64_t kinds, Scratch& scratch) const override {
    piece_->begin(region, kinds, scratch);
  }
  void draw(RegionBuffer& region, const BlockTask& task, Scratch& scratch) const override {
    piece_->draw(region, task, scratch);
  }

 private:
  std::unique_ptr<PieceRasterizer> piece_;
  const MeshBlocks& blocks_;
  PixelBounds image_;
};

}  // namespace ocelli::test
