// Cameras whose rays turn, made by whoever: any sequence of operations is refused or leaves a camera that works.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oc_core/base/finite.h"
#include "oc_core/camera/graph_overlap.h"
#include "tests/camera/random_curved_cameras.h"

namespace ocelli {
namespace {

using test::Numbers;
using test::randomIndex;

/// A number that makes sense, or one that does not.
double hostileNumber(Numbers& numbers, double hostility) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 16> kHostile{0,     -0.0, 1e-310, -1e-310, 1e-160, -1e-17, 1e-9,      1e9,
                                            -1e17, 1e40, 1e160,  -1e308,  1e308,  NAN,    kInfinite, -kInfinite};
  return numbers.between(0, 1) < hostility ? kHostile[randomIndex(numbers, kHostile.size())] : numbers.between(-10, 10);
}
glm::dvec3 hostileVector(Numbers& numbers, double hostility) {
  const double x = hostileNumber(numbers, hostility);
  const double y = hostileNumber(numbers, hostility);
  return {x, y, hostileNumber(numbers, hostility)};
}
Plane hostilePlane(Numbers& numbers, double hostility) {
  if (numbers.between(0, 1) < hostility) {
    return {hostileVector(numbers, 0.5), hostileNumber(numbers, 0.5)};
  }
  return Plane::through(hostileVector(numbers, hostility / 4), hostileVector(numbers, hostility / 4));
}

/// Whatever is asked of it, it answers with numbers or with nothing.
template <class C>
void expectItWorks(const C& camera, Numbers& numbers) {
  for (int i = 0; i < 8; ++i) {
    const double hostility = i % 2 == 0 ? 0 : 0.4;
    const glm::dvec3 point = hostileVector(numbers, hostility);
    const auto image = camera.projectExactly(point);
    ASSERT_TRUE(!image || isFinite(glm::dvec3(image->u, image->v, image->t)))
        << point.x << ' ' << point.y << ' ' << point.z;
    const auto single = camera.project(glm::vec3(point));
    ASSERT_TRUE(!single || std::isfinite(single->u + single->v + single->t));
    const ExactImagePoint q{numbers.between(0, camera.width()), hostileNumber(numbers, hostility) * 3 + 30,
                            std::abs(hostileNumber(numbers, hostility)) * 3};
    const auto world = camera.unprojectExactly(q);
    ASSERT_TRUE(!world || isFinite(*world)) << q.u << ' ' << q.v << ' ' << q.t;
    for (const glm::vec3& corner : camera.rayPath({q.u, q.v})) {
      const bool inImage = q.v >= 0 && q.v <= camera.height();
      ASSERT_TRUE(!inImage || isFinite(corner)) << q.u << ' ' << q.v;
    }
  }
}

/// One operation on a random frustum. Returns whether it was accepted.
bool operate(GraphCamera& graph, Numbers& numbers, double hostility) {
  const auto any = [&] { return static_cast<int>(randomIndex(numbers, graph.frusta().size())); };
  const auto sensible = [&] {
    return test::randomTurn(numbers, test::middleRay(graph, static_cast<size_t>(any())), numbers.between(0.5, 11), 0.5);
  };
  const auto turn = [&]() -> GraphCamera::Bend {
    return numbers.between(0, 1) < hostility
               ? GraphCamera::Bend{hostilePlane(numbers, hostility), hostileVector(numbers, hostility)}
               : sensible();
  };
  try {
    switch (randomIndex(numbers, 5)) {
      case 0:
        graph.bend(any(), turn(), "bent");
        break;
      case 1: {
        GraphCamera::Part part(randomIndex(numbers, 6));
        for (glm::dvec2& corner : part) {
          corner = 4.0 * glm::dvec2(hostileVector(numbers, hostility)) + glm::dvec2(45, 30);
        }
        graph.bend(any(), turn(), "window", part);
        break;
      }
      case 2:
        graph.split(any(), turn(), turn(), "one", "other");
        break;
      case 3:
        graph.merge(any(), any(), turn(), "merged");
        break;
      default:
        graph.limit(any(), hostilePlane(numbers, hostility));
    }
  } catch (const InputError&) {
    return false;
  }
  return true;
}

TEST(HostileCamera, anyOperationsOnGraphCameras) {
  Numbers numbers;
  size_t accepted = 0;
  size_t frusta = 0;
  for (int k = 0; k < 1000 && !testing::Test::HasFailure(); ++k) {
    GraphCamera graph(test::smallCamera());
    const double hostility = k % 4 * 0.2;
    for (int operation = 0; operation < 20; ++operation) {
      const size_t before = graph.frusta().size();
      const bool done = operate(graph, numbers, hostility);
      accepted += done;
      ASSERT_TRUE(done || graph.frusta().size() == before) << "a refused operation changes nothing";
      expectItWorks(graph, numbers);
    }
    frusta = std::max(frusta, graph.frusta().size());
    EXPECT_NO_THROW(overlapsOf(graph, glm::dvec3(-10), glm::dvec3(10)));
  }
  EXPECT_GT(accepted, 3000u);
  EXPECT_GT(frusta, 6u);
}

TEST(HostileCamera, anyTurnsOfCurvedRayCameras) {
  Numbers numbers;
  size_t accepted = 0;
  for (int k = 0; k < 2000 && !testing::Test::HasFailure(); ++k) {
    CurvedRayCamera camera = test::randomCurved(numbers, static_cast<int>(randomIndex(numbers, 3)));
    const double hostility = 0.1 + k % 4 * 0.2;
    for (int turn = 0; turn < 5; ++turn) {
      const size_t before = camera.bends().size();
      try {
        const glm::dvec3 line = 2.0 * hostileVector(numbers, hostility / 4);
        const TransitionPlanes planes =
            numbers.between(0, 1) < hostility
                ? TransitionPlanes{hostilePlane(numbers, hostility), hostilePlane(numbers, hostility),
                                   hostilePlane(numbers, hostility)}
                : test::planesThrough(line, {-numbers.between(0, 0.3), 0, -1}, {0, 0, -1},
                                      {numbers.between(0, 0.3), 0, -1});
        camera.bend(planes, hostileVector(numbers, hostility / 4));
        ++accepted;
      } catch (const InputError&) {
        ASSERT_EQ(camera.bends().size(), before) << "a refused turn changes nothing";
      }
      expectItWorks(camera, numbers);
    }
  }
  EXPECT_GT(accepted, 100u);
}

}  // namespace
}  // namespace ocelli
