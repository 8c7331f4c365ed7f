// What `ocelli-read-scene` hands back: a scene before its textures are baked, or why there is none. Both ends are of
// one build and on one machine, so numbers are as they are in memory; but the writer may have been led astray by the
// file that it read, so the reader trusts nothing.
//
//   bytes "OCSCENE1", u32 kind (0 scene, 1 failure)
//   failure: text, a whole error message
//   scene:   u32 warnings, each a text
//            u32 textures, each u32 width, u32 height, u8 wrap u, u8 wrap v, then width * height pixels of 3 bytes
//            (sRGB) u32 parts, each u32 vertices, u32 triangles, u8 flags (1 colours, 2 base layer, 4 emissive layer,
//            8 mask, 16 unlit, 32 lines, 64 points), 3 f32 emission,
//              3 f32 a vertex, 3 f32 a vertex where there are colours, 3 u32 a triangle, then the layers: u32 texture,
//              2 f32 a vertex; of a mask its layer and f32 cutoff; u32 lines, 2 u32 each; u32 points, a u32 each
//            u32 instances, each u32 part, 16 f32 (columns of worldFromPart)
//            u32 rigs, 0 or 1; where it is 1 (rig.h):
//              u32 warnings, each a text
//              u32 nodes, each u32 parent or 2^32 - 1, 16 f32 (columns of parentFromNode)
//              of each instance u32 node
//              of each part
//                u32 bones, each u32 node, 16 f32 (columns of boneFromMesh); where there are some
//                  u32 a vertex and one more (where its weights begin), u32 weights, each u32 bone, f32 weight
//                u32 morphs, each f32 weight at rest, 3 f32 a vertex
//              u32 animations, each a text and u32 channels, each u32 node, u8 target, u8 course (0 straight, 1 steps,
//              2
//                cubic), u32 values of a key, u32 keys, f32 time of each, the values of each, then of a cubic spline
//                the tangents of each
//   bytes "END."
//   text:    u32 bytes, then the bytes
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/byte_sink.h"
#include "oc_core/scene/rig.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {

struct SceneRecord {
  std::vector<Texture> textures;
  std::vector<TexturedMesh> parts;
  std::vector<Instance> instances;    ///< `mesh` is an index into parts; no tint, no identity
  std::vector<std::string> warnings;  ///< what the user should know of, a sentence each
  std::optional<Rig> rig;             ///< of a file with animations: what moves parts and instances
};

/// Writes what sceneFromRecord() reads; more than 2^32 of anything is a bug of the caller.
void writeSceneRecord(const SceneRecord& record, const ByteSink& sink);
/// `message` as Error::what() gives it.
void writeFailureRecord(const std::string& message, const ByteSink& sink);

/// Throws InputError with the message of a failure, and WorkError naming `writer` where the bytes are no record: an
/// index, a count or a size out of range, a number that is not finite where one must be, or bytes missing or left over.
/// Memory is bounded by the number of bytes. Positions may be anything: validate() says which one is wrong.
SceneRecord sceneFromRecord(std::span<const std::byte> bytes, const std::string& writer);

}  // namespace ocelli
