// A volume in the memory of the GPU, where the slicer lights it and the observer looks at it.
//
// Laid out as a Volume is (volume.h), but a word of 32 bits stands for the byte of each of the three planes: word k of
// a slice holds the eight voxels of byte k, four bits each from the least significant, bit 0 red, 1 green, 2 blue, 3
// zero. So a voxel is lit by one atomic operation, and rows and slices need no padding beside that of rows to eight
// voxels.
#pragma once

#include "display_sim/frames/volume.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

class GlVolume {
 public:
  /// All voxels dark. Throws GlError where the GPU has no room for the profile, InputError for a profile of more than
  /// one bit a channel.
  GlVolume(GlContext& context, DisplayProfile profile);
  GlVolume(GlContext& context, const Volume& volume);

  const DisplayProfile& profile() const { return profile_; }
  const VolumeLayout& layout() const { return layout_; }
  GlContext& context() const { return *context_; }
  /// The words, uint32.
  const GlObject& words() const { return words_; }
  size_t wordCount() const { return layout_.slices * layout_.planeBytes; }

  void clear();
  Volume read() const;

 private:
  GlContext* context_;
  DisplayProfile profile_;
  VolumeLayout layout_;
  GlObject words_;
};

}  // namespace ocelli
