// The portal-based constructor (sections 4.3.1.1 and 7.2): through every portal in view the rays of the reference bend
// to look straight in, along the portal's normal, so that one sees what lies behind doors and down side corridors.
//
// A leaf's viewpoint is the eye, turned about the vertical through the middle of its portal until it faces it. How far
// it has turned is a function of where the eye is, and of nothing else: not at all next to the portal, where the eye
// faces it anyway, and where it is edge on and has no image. So images change smoothly with the view, and one walks
// through a portal without noticing: there is no state, and no frame depends on the one before. As the direction of the
// view has no part in it, no ray moves in the scene when the head turns, and a portal at the border of the image comes
// in as it is. From behind a wall likewise: what a wall hides, it hides of bent rays too, as they bend behind it.
//
// How far they turn from where is a curve (portalCurves()): "beyond" shows every portal in view that is farther away
// than where it collapses, "band" those in a band of distances and angles alone, "calm" turns rays evenly and while an
// opening is still small in the image, so that no step moves what is shown by more than the pinhole's steps do.
//
// Where portals are one before the other the nearer one has the rays. It holds them from a given presence on; below
// that the farther one takes over, so that it comes into being while the nearer one lets go.
//
// DEVIATION: the eye keeps its height over the portal's middle, in the direction of its side `halfUp`, so that what is
// level runs on across the frame; the text turns it onto the middle axis.
#pragma once

#include <string>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/scene/scene_guides.h"

namespace ocelli {

class JsonFields;

/// Distances are from the eye to the nearest point of the portal, in lengths of its shorter side; angles are those
/// between the direction to its middle, without the height, and its normal. The numbers here are those of the first
/// of portalCurves().
struct PortalOptions {
  std::vector<Portal> portals;  ///< where empty, those of the scene, or else the openings of its maze
  double straightWithin = 0.5;  ///< nearer than that rays go straight through
  double bentBeyond = 3;        ///< from there on nearness does not matter
  double farthest = 1e6;  ///< rays go straight through portals that are farther away; from 3/4 of it they bend less
  double straightDegrees = 25;   ///< rays go straight where the eye faces the portal
  double bentDegrees = 65;       ///< from there on facing it does not matter
  double edgeDegrees = 89.9;     ///< rays go straight again where the portal is nearly edge on
  double edgeFadeDegrees = 0.4;  ///< so much before that they are bent
  double evenness = 0;           ///< of nearness and facing: 0 eases in and out, 1 is as slow as it can be anywhere
  double handOver = 0.3;         ///< the presence from which on a portal has the rays, and those behind it do not
};

/// How much a portal bends rays from where, by a name.
struct PortalCurve {
  const char* name;
  const char* description;
  PortalOptions options;  ///< its list of portals is empty
};

/// The first is the usual one.
const std::vector<PortalCurve>& portalCurves();

/// Throws InputError where there is none of that name.
const PortalOptions& portalCurve(const std::string& name);

/// How much of the camera a portal is, from 0 to 1. Below `handOver` it only holds back those behind it; from there on
/// its rays turn. 0 where the eye is behind it.
double portalPresence(const Portal& portal, const glm::dvec3& eye, const PortalOptions& options = {});

/// By which share of the way from straight to its normal the rays of a portal turn that has none before it.
double portalShare(const Portal& portal, const glm::dvec3& eye, const PortalOptions& options = {});

/// Where the rays through a portal come from once they have turned by a share of the way.
glm::dvec3 portalViewpoint(const Portal& portal, const glm::dvec3& eye, double share);

/// Throws InputError where a portal of the options, not of the scene, has the eye behind it or is edge on; and where
/// the scene has neither portals nor a maze, or the eye is in a wall of that.
GraphCamera buildPortalCamera(const PortalOptions& options, const SceneGuides& guides, const PinholeCamera& reference);

/// Throws InputError naming the field.
PortalOptions readPortalOptions(JsonFields& fields);

/// The same on a given curve: the fields "curve", "edge_fade_degrees" and "hand_over" are not taken.
PortalOptions readPortalOptions(JsonFields& fields, const PortalOptions& curve);

}  // namespace ocelli
