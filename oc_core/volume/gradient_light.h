// How a place of a volume is lit by the gradient of its field: the one rule, which renderers in double precision, in
// vectors, in shaders and displays follow.
//
// With the gradient's direction n in the world, the direction l to the light, and h that of l + v, where v is the
// direction back along the ray, the colour c of the place becomes
//
//   c (ambient + diffuse |n.l|) + specular |n.h|^shininess,
//
// on both sides alike, as which side of a layer is its outside depends on the values around it. Where the field is
// flat it has no direction: where its gradient, by the mean distance of voxels, is below kFlatShare of the volume's
// range, that of the formula turns linearly into c.
//
// Two copies cannot share this code: that of vectors (volume_render/march_steps-inl.h) and that of OpenGL
// (volume_gl/shaders/volume_light.glsl). Their tests compare them with it, place by place
// (tests/volume_render/place_lights.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

/// What is done to the colour of a place: it is multiplied by `factor`, and `added` is added to each of its channels.
template <class Number>
struct PlaceLight {
  Number factor = 1;
  Number added = 0;
};

/// The rule with the numbers of one volume, in double or single precision.
template <class Number>
struct GradientLight {
  using Vector = glm::vec<3, Number>;

  /// Takes a gradient of values by index coordinates to one of the scene's world, by the mean distance of voxels.
  glm::mat<3, 3, Number> worldFromIndexGradient{1};
  /// 1 / the length, as the matrix gives it, from which on a gradient has a direction; 0 of a volume whose values are
  /// all the same, which has no gradients.
  Number litByGradient = 0;
  Vector toLight{0};  ///< of length 1
  Number ambient = 0;
  Number diffuse = 0;
  Number specular = 0;
  Number shininess = 0;

  /// `direction` is that of the ray in the scene's world, of length 1.
  PlaceLight<Number> at(const Vector& indexGradient, const Vector& direction) const {
    const Slope slope = slopeOf(indexGradient);
    const Vector between = toLight - direction;
    const Number length = glm::length(between);
    const Number highlight = length > 0 ? std::abs(glm::dot(slope.normal, between)) / length : Number(0);
    return {factorOf(slope), slope.lit * specular * std::pow(highlight, shininess)};
  }
  /// The factor of at(), which does not depend on the ray.
  Number factorAt(const Vector& indexGradient) const { return factorOf(slopeOf(indexGradient)); }

 private:
  struct Slope {
    Vector normal{0};  ///< of length 1
    Number lit = 0;    ///< how far the place has a direction
  };

  Slope slopeOf(const Vector& indexGradient) const {
    const Vector gradient = worldFromIndexGradient * indexGradient;
    const Number length = glm::length(gradient);
    return length > 0 ? Slope{gradient / length, std::min(length * litByGradient, Number(1))} : Slope{};
  }

  Number factorOf(const Slope& slope) const {
    const Number cosine = std::abs(glm::dot(slope.normal, toLight));
    return glm::mix(Number(1), ambient + diffuse * cosine, slope.lit);
  }
};

/// The light is where that of meshes is (scene/shading.h); `range` is that of the volume's values.
GradientLight<double> gradientLight(const glm::dmat4& worldFromIndex, const VolumeShading& shading,
                                    const ValueRange& range);

/// In single precision, of gradients that times `factor` are those of `light`: of numbers in voxels instead of values.
GradientLight<float> singleLight(const GradientLight<double>& light, double factor);

}  // namespace ocelli
