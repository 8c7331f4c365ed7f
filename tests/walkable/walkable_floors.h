// Small scenes to walk in, made of boxes.
#pragma once

#include <string>

#include "oc_core/scene/mesh.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli::test {

/// Adds a closed box that looks outwards.
void addBox(Mesh& mesh, const glm::vec3& lower, const glm::vec3& upper);

/// Walls without floor around a rectangle of the plan, `height` high and 0.2 thick, outside of it.
void addWalls(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float height, float floor = 0);

/// A floor slab of that thickness whose top is at `top`.
void addFloor(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float top = 0, float thickness = 0.2f);

/// Whether the plan of a cell's box holds a point, and its floor is within half a metre of it.
bool holds(const WalkCell& cell, const glm::vec3& point);

/// The first cell that holds it; -1 where none does.
int cellAt(const WalkMap& map, const glm::vec3& point);

/// The portals between two cells, in either direction.
size_t portalsBetween(const WalkMap& map, int a, int b);

/// The message of the InputError that looking for ways gives; empty where there is none.
std::string walkErrorOf(const Mesh& mesh, const WalkOptions& options = {});

}  // namespace ocelli::test
