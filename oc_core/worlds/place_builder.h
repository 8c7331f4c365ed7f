// Builds places to walk through out of closed solids whose surfaces are grids of vertices, with textures
// (surface_textures.h) and light (indoor_light.h) in their colours. Neighbouring faces of a solid share the places of
// their vertices, so that no crack opens between them; solids may be stuck into one another, but must not share planes.
//
// Solids are described first; build() colours them all, on all cores. Metres, y up.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/indoor_light.h"
#include "oc_core/worlds/surface_textures.h"

namespace ocelli {

enum class BoxFace : size_t { kLeft, kRight, kBottom, kTop, kBack, kFront };  ///< -x, x, -y, y, -z, z

/// How the faces of a box look.
struct BoxLook {
  std::array<SurfaceTexture, 6> textures;  ///< by BoxFace; metres from the lower left corner of the face
  std::array<bool, 6> isPlain{};  ///< of one colour and few triangles: of faces that are hardly seen, or not at all
  float fineness = 1;             ///< the spacing of vertices, as a multiple of the place's
  glm::vec3 stretch{1};           ///< the same along each axis, besides
  bool casts = true;              ///< whether it casts shadows and keeps light away
  float glow = 0;                 ///< over 0: the light that it gives itself, instead of that which falls on it

  BoxLook(const SurfaceTexture& all) { textures.fill(all); }  // NOLINT(google-explicit-constructor)
  BoxLook& with(BoxFace face, const SurfaceTexture& texture) {
    textures[static_cast<size_t>(face)] = texture;
    return *this;
  }
  BoxLook& plain(BoxFace face) {
    isPlain[static_cast<size_t>(face)] = true;
    return *this;
  }
  BoxLook& finer(float factor) {
    fineness = factor;
    return *this;
  }
  BoxLook& stretched(const glm::vec3& factors) {
    stretch = factors;
    return *this;
  }
  BoxLook& noShadow() {
    casts = false;
    return *this;
  }
  BoxLook& glowing(float light) {
    glow = light;
    return *this;
  }
};

/// An upright wall: its front in the plane z = 0 of its own frame, from (0, 0) to `size`.
struct PlaceWall {
  glm::vec2 size{1};
  float thickness = 0.2f;
  std::vector<std::array<glm::vec2, 2>> openings;  ///< lower left and upper right corners; none at the rim
  SurfaceTexture front;
  SurfaceTexture back;
  SurfaceTexture rim;
  float fineness = 1;
  bool isBackPlain = false;  ///< only without openings
};

class PlaceBuilder {
 public:
  /// Vertices stand about `texel` metres apart.
  explicit PlaceBuilder(float texel) : texel_(texel) {}

  IndoorLight& light() { return light_; }
  float texel() const { return texel_; }

  /// What is added from here on has another identity (Instance::object); 0 again is the structure.
  void beginObject();
  void beginStructure() { object_ = 0; }

  /// A box of a size around the origin of its frame, which stands upright at any turn, or lies anyhow.
  void addBox(const glm::vec3& size, const glm::mat4& worldFromBox, const BoxLook& look);
  void addWall(const PlaceWall& wall, const glm::mat4& worldFromWall);
  /// What a profile of (radius, height) sweeps around the y axis, from the bottom to the top, with radius 0 at both
  /// ends; `shape` may move its points.
  void addTurned(const std::vector<glm::vec2>& profile, const glm::mat4& worldFromSolid, const SurfaceTexture& texture,
                 float fineness = 1, const std::function<glm::vec3(const glm::vec3&)>& shape = {});
  /// A ball of half axes.
  void addBall(const glm::vec3& half, const glm::mat4& worldFromBall, const SurfaceTexture& texture,
               float fineness = 1);
  /// A cable or rod along points.
  void addTube(const std::vector<glm::vec3>& points, float radius, const SurfaceTexture& texture, float fineness = 1);

  /// All that was added, one mesh for each identity, its light in its colours.
  Scene build();

 private:
  /// A grid of vertices, cells + 1 along each side, counter-clockwise seen from outside.
  struct Grid {
    size_t columns = 1;
    size_t rows = 1;
    std::function<glm::vec3(size_t, size_t)> position;
    std::function<glm::vec2(size_t, size_t)> metres;
    SurfaceTexture texture;
    float glow = 0;
    bool hasPoles = false;  ///< its first and last rows are points
    bool isFlat = true;     ///< its light hardly changes over a decimetre
    uint32_t object = 0;
  };
  /// A face of one colour.
  struct Fan {
    std::vector<glm::vec3> rim;
    glm::vec3 color{1};
    bool isLit = true;
    uint32_t object = 0;
  };

  void addRound(size_t around, size_t rows, const std::function<glm::vec3(size_t, size_t)>& position, float girth,
                float length, const SurfaceTexture& texture);
  void addFace(const std::array<std::vector<float>, 3>& lines, size_t face, const glm::mat4& worldFromBox,
               const BoxLook& look);
  void color(const Grid& grid, glm::vec3* positions, glm::vec3* colors) const;

  float texel_;
  uint32_t object_ = 0;
  uint32_t objects_ = 0;
  IndoorLight light_;
  std::vector<Grid> grids_;
  std::vector<Fan> fans_;
};

}  // namespace ocelli
