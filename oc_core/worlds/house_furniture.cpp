#include "oc_core/worlds/house_furniture.h"

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/worlds/facade.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

/// Puts a painted box between two heights of a piece.
class PieceBuilder {
 public:
  explicit PieceBuilder(FurnitureKind kind) : half_(furnitureSize(kind) * 0.5f) {}

  float halfX() const { return half_.x; }
  float halfZ() const { return half_.y; }
  void box(const glm::vec3& lower, const glm::vec3& upper, const glm::vec3& color) {
    addPaintedBox(mesh_, upper - lower, placedAt((lower + upper) * 0.5f), color);
  }
  void legs(float height, float thickness, const glm::vec3& color) {
    for (const float x : {-half_.x, half_.x - thickness}) {
      for (const float z : {-half_.y, half_.y - thickness}) {
        box({x, 0, z}, {x + thickness, height, z + thickness}, color);
      }
    }
  }
  void solid(Mesh part, const glm::mat4& pieceFromPart, const glm::vec3& color) {
    paint(part, color);
    append(mesh_, part, pieceFromPart);
  }
  Mesh take() { return std::move(mesh_); }

 private:
  glm::vec2 half_;
  Mesh mesh_;
};

glm::vec3 furnitureWood() {
  return palette::fromSrgbBytes(156, 104, 64);
}

void buildBed(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.legs(0.25f, 0.08f, furnitureWood());
  piece.box({-x, 0.25f, -z}, {x, 0.35f, z}, furnitureWood());
  piece.box({-x + 0.04f, 0.35f, -z + 0.06f}, {x - 0.04f, 0.5f, z - 0.04f}, palette::ivory());
  piece.box({-x + 0.02f, 0.42f, -z + 0.65f}, {x - 0.02f, 0.54f, z - 0.02f}, color);
  piece.box({-x, 0.35f, -z}, {x, 1.0f, -z + 0.06f}, furnitureWood() * 0.8f);
  for (const float side : {-0.4f, 0.4f}) {
    piece.solid(makeSphere(16), glm::scale(placedAt({side, 0.54f, -z + 0.36f}), glm::vec3(0.32f, 0.1f, 0.2f)),
                palette::ivory() * 0.95f);
  }
}

void buildWardrobe(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.box({-x, 0, -z}, {x, 2.1f, z - 0.03f}, furnitureWood() * 0.9f);
  for (const float side : {-1.0f, 1.0f}) {
    const float inner = side < 0 ? -x + 0.03f : 0.015f;
    piece.box({inner, 0.08f, z - 0.03f}, {inner + x - 0.045f, 2.05f, z - 0.005f}, color);
    piece.box({side * 0.08f - 0.015f, 1, z - 0.005f}, {side * 0.08f + 0.015f, 1.2f, z}, palette::ivory());
  }
}

void buildDesk(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.legs(0.7f, 0.05f, furnitureWood() * 0.8f);
  piece.box({-x, 0.7f, -z}, {x, 0.75f, z}, furnitureWood());
  piece.box({-x + 0.05f, 0.1f, -z + 0.05f}, {-x + 0.45f, 0.7f, z - 0.05f}, color);
  piece.box({-0.25f, 0.75f, -z + 0.1f}, {0.25f, 0.77f, -z + 0.26f}, palette::slate());
  piece.box({-0.3f, 0.85f, -z + 0.14f}, {0.3f, 1.2f, -z + 0.18f}, palette::slate());
  piece.box({-0.03f, 0.77f, -z + 0.16f}, {0.03f, 0.9f, -z + 0.2f}, palette::slate() * 1.3f);
}

void buildChair(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.legs(0.43f, 0.04f, furnitureWood() * 0.85f);
  piece.box({-x, 0.43f, -z}, {x, 0.48f, z}, color);
  piece.box({-x, 0.48f, -z}, {-x + 0.04f, 0.95f, -z + 0.04f}, furnitureWood() * 0.85f);
  piece.box({x - 0.04f, 0.48f, -z}, {x, 0.95f, -z + 0.04f}, furnitureWood() * 0.85f);
  piece.box({-x, 0.68f, -z + 0.005f}, {x, 0.93f, -z + 0.03f}, color);
}

void buildSofa(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.legs(0.1f, 0.06f, furnitureWood());
  piece.box({-x, 0.08f, -z}, {x, 0.3f, z}, color * 0.8f);
  piece.box({-x, 0.3f, -z}, {x, 0.85f, -z + 0.2f}, color);
  for (const float side : {-1.0f, 1.0f}) {
    const float outer = side * x;
    piece.box({std::min(outer, outer - side * 0.18f), 0.3f, -z + 0.2f},
              {std::max(outer, outer - side * 0.18f), 0.6f, z}, color * 0.9f);
    const float from = side < 0 ? -x + 0.19f : 0.01f;
    piece.box({from, 0.3f, -z + 0.22f}, {from + x - 0.2f, 0.45f, z - 0.01f}, color);
    piece.box({from + 0.25f, 0.45f, -z + 0.22f}, {from + 0.6f, 0.78f, -z + 0.34f}, palette::ivory());
  }
}

void buildShelf(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  const std::array covers{palette::vermilion(), palette::blue(), palette::yellow(), palette::green(), color};
  piece.box({-x, 0, -z}, {x, 1.9f, -z + 0.02f}, furnitureWood() * 0.7f);
  for (const float side : {-x, x - 0.03f}) {
    piece.box({side, 0, -z + 0.02f}, {side + 0.03f, 1.9f, z}, furnitureWood());
  }
  size_t next = 0;
  for (int board = 0; board < 6; ++board) {
    const float y = 0.05f + 0.36f * static_cast<float>(board);
    piece.box({-x + 0.03f, y, -z + 0.02f}, {x - 0.03f, y + 0.03f, z}, furnitureWood());
    // Books of a few widths and heights, the same in every shelf.
    float from = -x + 0.05f;
    while (board < 5 && from < x - 0.15f) {
      const float width = 0.03f + 0.012f * static_cast<float>((next * 7) % 4);
      const float height = 0.2f + 0.03f * static_cast<float>((next * 5) % 4);
      piece.box({from, y + 0.03f, -z + 0.06f}, {from + width, y + 0.03f + height, z - 0.05f},
                covers[(next * 3) % covers.size()] * (next % 2 == 0 ? 1.0f : 0.8f));
      from += width + 0.008f;
      ++next;
    }
  }
}

void buildCounter(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.box({-x, 0.1f, -z}, {x, 0.88f, z - 0.04f}, palette::ivory() * 0.9f);
  piece.box({-x, 0.88f, -z}, {x, 0.92f, z}, palette::slate() * 1.2f);
  piece.box({-x + 0.03f, 0, -z + 0.05f}, {x - 0.03f, 0.1f, z - 0.1f}, palette::slate());
  for (int door = 0; door < 3; ++door) {
    const float from = -x + 0.02f + 0.6f * static_cast<float>(door);
    piece.box({from, 0.13f, z - 0.04f}, {from + 0.56f, 0.86f, z - 0.02f}, color);
    piece.box({from + 0.2f, 0.78f, z - 0.02f}, {from + 0.36f, 0.8f, z - 0.005f}, palette::ivory());
  }
  for (const float plate : {-0.6f, -0.25f}) {
    piece.solid(makeTurned({{0, 0}, {0.12f, 0}, {0.12f, 0.012f}, {0, 0.012f}}, 24), placedAt({plate, 0.919f, 0}),
                palette::vermilion());
  }
  piece.solid(makeTurned({{0, 0}, {0.2f, 0}, {0.2f, 0.015f}, {0, 0.015f}}, 24), placedAt({0.5f, 0.919f, 0}),
              palette::skyBlue());
  piece.box({0.48f, 0.92f, -z + 0.06f}, {0.52f, 1.2f, -z + 0.1f}, palette::mortar());
}

void buildTable(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  piece.legs(0.71f, 0.07f, furnitureWood() * 0.8f);
  piece.box({-x, 0.71f, -z}, {x, 0.75f, z}, furnitureWood());
  piece.solid(makeTurned({{0, 0}, {0.1f, 0}, {0.16f, 0.14f}, {0.06f, 0.28f}, {0.09f, 0.34f}, {0, 0.34f}}, 32),
              placedAt({0.2f, 0.75f, 0}), color);
  piece.solid(makeTurned({{0, 0}, {0.1f, 0}, {0.2f, 0.07f}, {0.18f, 0.07f}, {0.09f, 0.02f}, {0, 0.02f}}, 32),
              placedAt({-0.35f, 0.75f, 0.1f}), palette::yellow());
}

void buildBathtub(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  constexpr float kTubRim = 0.08f;
  const glm::vec3 white = palette::fromSrgbBytes(244, 246, 248);
  piece.box({-x, 0, -z}, {x, 0.2f, z}, white * 0.85f);
  piece.box({-x, 0.2f, -z}, {x, 0.58f, -z + kTubRim}, white);
  piece.box({-x, 0.2f, z - kTubRim}, {x, 0.58f, z}, color);
  piece.box({-x, 0.2f, -z + kTubRim}, {-x + kTubRim, 0.58f, z - kTubRim}, white);
  piece.box({x - kTubRim, 0.2f, -z + kTubRim}, {x, 0.58f, z - kTubRim}, white);
  piece.box({-x + kTubRim, 0.2f, -z + kTubRim}, {x - kTubRim, 0.4f, z - kTubRim}, palette::skyBlue());
}

void buildToilet(PieceBuilder& piece, const glm::vec3& color) {
  const float x = piece.halfX();
  const float z = piece.halfZ();
  const glm::vec3 white = palette::fromSrgbBytes(244, 246, 248);
  piece.box({-x, 0.35f, -z}, {x, 0.8f, -z + 0.18f}, white * 0.9f);
  piece.solid(
      makeTurned({{0, 0}, {0.12f, 0}, {0.1f, 0.2f}, {0.2f, 0.4f}, {0.12f, 0.4f}, {0.08f, 0.25f}, {0, 0.25f}}, 24),
      placedAt({0, 0, 0.08f}), white);
  piece.box({-0.08f, 0, -z + 0.02f}, {0.08f, 0.35f, 0}, white * 0.85f);
  piece.solid(makeTurned({{0, 0.4f}, {0.2f, 0.4f}, {0.2f, 0.43f}, {0, 0.43f}}, 24), placedAt({0, 0, 0.08f}), color);
}

void buildPlant(PieceBuilder& piece, const glm::vec3& color) {
  piece.solid(makeTurned({{0, 0}, {0.14f, 0}, {0.2f, 0.35f}, {0.17f, 0.35f}, {0.16f, 0.3f}, {0, 0.3f}}, 24),
              glm::mat4(1), color);
  piece.box({-0.02f, 0.28f, -0.02f}, {0.02f, 0.9f, 0.02f}, furnitureWood() * 0.6f);
  piece.solid(makeSphere(20), glm::scale(placedAt({0, 1.05f, 0}), glm::vec3(0.24f, 0.3f, 0.24f)), palette::green());
  piece.solid(makeSphere(16), glm::scale(placedAt({0.06f, 0.8f, 0.06f}), glm::vec3(0.17f)), palette::green() * 0.8f);
}

}  // namespace

Mesh makeFurniture(FurnitureKind kind, const glm::vec3& color) {
  PieceBuilder piece(kind);
  switch (kind) {
    case FurnitureKind::kBed:
      buildBed(piece, color);
      break;
    case FurnitureKind::kWardrobe:
      buildWardrobe(piece, color);
      break;
    case FurnitureKind::kDesk:
      buildDesk(piece, color);
      break;
    case FurnitureKind::kChair:
      buildChair(piece, color);
      break;
    case FurnitureKind::kSofa:
      buildSofa(piece, color);
      break;
    case FurnitureKind::kShelf:
      buildShelf(piece, color);
      break;
    case FurnitureKind::kCounter:
      buildCounter(piece, color);
      break;
    case FurnitureKind::kTable:
      buildTable(piece, color);
      break;
    case FurnitureKind::kBathtub:
      buildBathtub(piece, color);
      break;
    case FurnitureKind::kToilet:
      buildToilet(piece, color);
      break;
    case FurnitureKind::kPlant:
      buildPlant(piece, color);
      break;
  }
  return piece.take();
}

}  // namespace ocelli
