// Graph cameras of random turns, for tests of what must hold for all of them.
#pragma once

#include <string>

#include "oc_core/base/error.h"
#include "tests/camera/inverse_errors.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli::test {

inline glm::dvec3 randomVector(Numbers& numbers, double most) {
  return {numbers.between(-most, most), numbers.between(-most, most), numbers.between(-most, most)};
}

inline size_t randomIndex(Numbers& numbers, size_t count) {
  return std::min(static_cast<size_t>(numbers.between(0, static_cast<double>(count))), count - 1);
}

/// The last straight piece of the ray through the middle of a frustum's part.
struct MiddleRay {
  glm::dvec3 from{0};
  glm::dvec3 direction{0};
};
inline MiddleRay middleRay(const GraphCamera& graph, size_t i) {
  const RayPath path = graph.rayPath(glm::vec2(GraphCamera::middleOf(graph.frusta()[i].part)));
  const glm::dvec3 from(path[path.size() - 2]);
  return {from, glm::normalize(glm::dvec3(path.back()) - from)};
}

/// A turn of most rays of a frustum: at `way` along its middle, to a viewpoint as far behind that, turned by up to
/// `most`.
inline GraphCamera::Bend randomTurn(Numbers& numbers, const MiddleRay& ray, double way, double most) {
  const glm::dvec3 at = ray.from + ray.direction * way;
  const glm::dvec3 normal = ray.direction + randomVector(numbers, most);
  // One number a statement: the same cameras with any compiler.
  const glm::dvec3 back = ray.direction + randomVector(numbers, most);
  return turnAt(at, normal, at - back * numbers.between(3, 12));
}

/// Bends, splits, merges or windows, `operations` of them, each of a frustum that has no child yet. Those that do not
/// fit are left out.
inline GraphCamera randomGraph(Numbers& numbers, int operations, double most = 0.3) {
  GraphCamera graph(smallCamera());
  for (int k = 0; k < operations; ++k) {
    size_t i = randomIndex(numbers, graph.frusta().size());
    while (!graph.frusta()[i].children.empty()) {
      i = static_cast<size_t>(graph.frusta()[i].children.back());
    }
    const MiddleRay ray = middleRay(graph, i);
    const GraphCamera::Bend turn = randomTurn(numbers, ray, numbers.between(i == 0 ? 7 : 1, i == 0 ? 11 : 4), most);
    const int index = static_cast<int>(i);
    const std::string name = std::to_string(k);
    try {
      switch (randomIndex(numbers, 4)) {
        case 0:
          graph.bend(index, turn, name);
          break;
        case 1: {
          const glm::dvec3 at = turn.plane.crossing(ray.from, ray.from + ray.direction);
          const glm::dvec3 aside = glm::normalize(glm::cross(ray.direction, randomVector(numbers, 1)));
          // Viewpoints apart along the split line leave the two in touch.
          const bool touch = randomIndex(numbers, 2) == 0;
          const glm::dvec3 line = glm::normalize(glm::cross(turn.plane.normal, aside));
          const glm::dvec3 spread = (touch ? line : aside) * numbers.between(-2, 2);
          graph.split(index, turnAt(at, turn.plane.normal + aside * 0.2, turn.viewpoint - spread),
                      turnAt(at, turn.plane.normal - aside * 0.2, turn.viewpoint + spread), name + " one",
                      name + " other");
          break;
        }
        case 2: {
          const std::vector<int>& siblings =
              graph.frusta()[static_cast<size_t>(std::max(0, graph.frusta()[i].parent))].children;
          if (siblings.size() == 2) {
            graph.merge(siblings[0], siblings[1], turn, name);
          }
          break;
        }
        default: {
          // The middle of the part.
          GraphCamera::Part window = graph.frusta()[i].part;
          const glm::dvec2 middle = GraphCamera::middleOf(window);
          for (glm::dvec2& corner : window) {
            corner = middle + (corner - middle) * 0.6;
          }
          graph.bend(index, turn, name, window);
          graph.limit(index, turn.plane);  // what passes beside the window
        }
      }
    } catch (const InputError&) {
      continue;  // as wanted
    }
  }
  return graph;
}

}  // namespace ocelli::test
