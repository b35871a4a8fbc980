// SPDX-License-Identifier: Apache-2.0
// How far a placed body is from the obstacles and the bounds of the workspace.
#pragma once

#include "collision/distance.hpp"
#include "krait/scene.hpp"
#include "krait/status.hpp"

namespace krait::detail {

// A convex body in the workspace, the hull of up to 16 points: a body that stands, or what it sweeps between two
// places. Vertices are relative to `at`, which keeps float distances exact far from the origin.
struct PlacedBody {
  Vec2 at;
  Vec2 vertices[2 * format::kMaxPieceVertices];  // in any order
  int count = 0;

  Polygon polygon() const { return {vertices, count}; }
};

class Obstacles {
 public:
  // Metres: how far beyond what must be free pieces are looked for; measured: bench/ABLATIONS.md, "Constants".
  static constexpr float kLookBeyond = 1e-3F;

  Obstacles() = default;

  // `clearance` metres, >= 0, are kept between every body and every obstacle or bound, on top of what rounding needs.
  // Without `shortcuts` every piece's box is looked at, and each that is near by GJK. The scene must outlive this.
  Obstacles(const Scene& scene, float clearance, bool shortcuts = true);
  Obstacles(const Scene&&, float, bool = true) = delete;

  const ClearanceGrid& clearance() const { return scene_->clearance(); }

  // Metres from the body to the nearest obstacle or bound, less the margin: exact where it is below `reach` > 0, else
  // `reach`; zero or less where the body is too close or not finite. Worst case: every piece in the buckets that
  // the body's box, grown by `reach` and the margin, meets, one GJK each.
  float room(const PlacedBody& body, float reach) const;

  // The obstacle or bound that the body lacks most distance to, the first among equals; none where it keeps the margin
  // to all. `body` and the numbers of bodies are the caller's. O(pieces near the body).
  Contact contact(const PlacedBody& body) const;

  // Metres from a point to the nearest obstacle or bound, or `reach` where that is less; 0 in an obstacle or outside.
  float distance(Vec2 point, float reach) const;

  float margin() const { return margin_; }

 private:
  static constexpr float kRounding = 1e-4F;          // metres: GJK in float near the body, and the snap of the query
  static constexpr float kPositionRounding = 3e-6F;  // of the largest coordinate: 25 trailers placed one by one
  static constexpr float kRelativeRounding = 1e-6F;  // of a piece's largest coordinate seen from the body

  float room_to_bounds(const Box& box) const;
  Contact contact_with_bounds(const PlacedBody& body) const;
  // Metres from the body to one piece, as room returns them.
  float room_to_piece(const PlacedBody& body, Index piece, float reach) const;
  template <class Visit>
  void pieces_around(const Box& box, float around, Visit visit) const;
  template <class Visit>
  void pieces_of_buckets(const Box& box, float around, Visit visit) const;

  const Scene* scene_ = nullptr;
  float margin_ = 0.0F;
  bool shortcuts_ = true;
};

}  // namespace krait::detail
