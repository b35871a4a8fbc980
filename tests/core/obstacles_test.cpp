// SPDX-License-Identifier: Apache-2.0
// The room around a body against brute force over all pieces in double precision.
#include "collision/obstacles.hpp"

#include <gtest/gtest.h>

#include "convex.hpp"
#include "krait/geometry.hpp"
#include "robot/shape.hpp"

namespace krait::test::obstacles_test {
namespace {

constexpr Rect kBounds{0, 0, 12, 12};

Room crowded(unsigned seed, Point shift = {0, 0}) {
  std::mt19937 random(seed);
  Room room = random_room(seed, 12, 5);
  for (int i = 0; i < 8; ++i) {
    room.loose_pieces.push_back(random_convex(random, {uniform(random, 1, 11), uniform(random, 1, 11)}, 1));
  }
  const auto move = [&](Rect& r) { r = {r.x0 + shift.x, r.y0 + shift.y, r.x1 + shift.x, r.y1 + shift.y}; };
  move(room.bounds);
  for (Rect& box : room.boxes) move(box);
  for (Rect& goal : room.goals) move(goal);
  for (auto& piece : room.loose_pieces) {
    for (Vec2& v : piece) v = {snap(point(v).x + shift.x), snap(point(v).y + shift.y)};
  }
  return room;
}

detail::PlacedBody body_at(Vec2 at, const std::vector<Vec2>& vertices) {
  detail::PlacedBody body;
  body.at = at;
  body.count = static_cast<int>(vertices.size());
  for (int i = 0; i < body.count; ++i) body.vertices[i] = vertices[static_cast<std::size_t>(i)];
  return body;
}

Ring placed(const detail::PlacedBody& body) {
  Ring result;
  for (int i = 0; i < body.count; ++i) {
    result.push_back({point(body.at).x + point(body.vertices[i]).x, point(body.at).y + point(body.vertices[i]).y});
  }
  return result;
}

double true_room(const Scene& scene, const detail::PlacedBody& body) {
  const Box b = scene.bounds();
  double least = room_inside(placed(body), {point(b.min).x, point(b.min).y, point(b.max).x, point(b.max).y});
  for (Index p = 0; p < scene.piece_count(); ++p) least = std::min(least, distance(placed(body), ring(scene.piece(p))));
  return least;
}

void expect_room(const Scene& scene, Point corner, float clearance, double rounding, unsigned seed) {
  const detail::Obstacles obstacles(scene, clearance);
  const double margin = static_cast<double>(obstacles.margin());
  std::mt19937 random(seed);
  int near = 0, far = 0, hit = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 at{uniform_float(random, corner.x, corner.x + 12), uniform_float(random, corner.y, corner.y + 12)};
    const detail::PlacedBody body = body_at(at, random_convex(random, {0, 0}, 0.4));
    const float reach = uniform_float(random, 0.001, 1.5);
    const double expected = true_room(scene, body) - margin;
    const auto got = static_cast<double>(obstacles.room(body, reach));
    ASSERT_LE(got, std::max(expected, 0.0) + rounding);  // never more than there is
    ASSERT_LE(got, static_cast<double>(reach));
    if (expected > 0) {
      ASSERT_GE(got, std::min(expected, static_cast<double>(reach)) - 1e-4);  // and all of it, up to the reach
      (expected < static_cast<double>(reach) ? near : far) += 1;
    } else {
      ASSERT_LE(got, 0.0);
      ++hit;
    }
  }
  EXPECT_GT(near, 100);
  EXPECT_GT(far, 100);
  EXPECT_GT(hit, 100);
}

TEST(Obstacles, RoomIsExactBelowTheReachAndTheReachBeyond) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const OpenScene open(crowded(seed));
    expect_room(open.scene, {0, 0}, 0.0F, 5e-6, seed);
    expect_room(open.scene, {0, 0}, 0.05F, 5e-6, seed + 100);
  }
}

TEST(Obstacles, RoomIsAsGoodFarFromTheOrigin) {
  for (const Point shift : {Point{980, 0}, Point{-1990, 1980}}) {
    const OpenScene open(crowded(7, shift));
    expect_room(open.scene, shift, 0.0F, 1.5e-4, 7);  // the bounds are compared in absolute floats
  }
}

TEST(Obstacles, MarginIsTheClearanceRoundingAndTheFilesOwnError) {
  Room room;
  SceneData data = data_of(room);
  data.header.obstacle_error = 0.01F;
  const SceneBytes bytes = data.bytes();
  Scene scene;
  ASSERT_TRUE(Scene::open(bytes.data(), bytes.size(), scene).ok());
  EXPECT_GE(detail::Obstacles(scene, 0.0F).margin(), 0.0101F);
  EXPECT_NEAR(static_cast<double>(detail::Obstacles(scene, 0.25F).margin()), 0.26, 2e-3);
}

TEST(Obstacles, BoundsAreWalls) {
  const OpenScene open{Room{}};
  const detail::Obstacles obstacles(open.scene, 0.0F);
  const auto square = corners({-0.5, -0.5, 0.5, 0.5});
  EXPECT_NEAR(static_cast<double>(obstacles.room(body_at({0.75F, 5}, square), 1.0F)), 0.25, 2e-4);
  EXPECT_NEAR(static_cast<double>(obstacles.room(body_at({5, 9.25F}, square), 1.0F)), 0.25, 2e-4);
  EXPECT_LE(obstacles.room(body_at({0.5F, 5}, square), 1.0F), 0.0F);
  EXPECT_LE(obstacles.room(body_at({5, -3}, square), 1.0F), 0.0F);
  EXPECT_LE(obstacles.room(body_at({1e6F, 5}, square), 1.0F), 0.0F);
}

TEST(Obstacles, BodyThatIsNotFiniteHasNoRoom) {
  const OpenScene open{Room{}};
  const detail::Obstacles obstacles(open.scene, 0.0F);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec2 at : {Vec2{nan, 5}, Vec2{5, nan}, Vec2{kInfinity, 5}, Vec2{5, -kInfinity}}) {
    EXPECT_LE(obstacles.room(body_at(at, corners({-0.5, -0.5, 0.5, 0.5})), 1.0F), 0.0F);
    EXPECT_EQ(obstacles.clearance().at(at), 0.0F);
  }
}

TEST(Obstacles, RoomByTheGridIsNeverMoreThanThereIs) {
  const OpenScene open(crowded(3));
  const detail::Obstacles obstacles(open.scene, 0.0F);
  std::mt19937 random(3);
  int positive = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec2 at{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
    const detail::PlacedBody body = body_at(at, random_convex(random, {0, 0}, 0.4));
    const float radius = detail::farthest(body.vertices, body.count) * 1.000001F;
    const auto by_grid = static_cast<double>(obstacles.clearance().at(at) - radius - obstacles.margin());
    ASSERT_LE(by_grid, true_room(open.scene, body));
    positive += by_grid > 0 ? 1 : 0;
  }
  EXPECT_GT(positive, 100);
}

TEST(Obstacles, ContactIsWithWhatLacksMostOfTheMargin) {
  const OpenScene open(crowded(4));
  const detail::Obstacles obstacles(open.scene, 0.3F);
  const auto margin = static_cast<double>(obstacles.margin());
  std::mt19937 random(4);
  int near = 0, hit = 0, free = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 at{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
    const detail::PlacedBody body = body_at(at, random_convex(random, {0, 0}, 0.4));
    const double expected = std::max(true_room(open.scene, body), 0.0);
    const Contact contact = obstacles.contact(body);
    if (contact.kind == ContactKind::none) {
      ASSERT_GT(expected, margin - 1e-4);
      ++free;
      continue;
    }
    ASSERT_NEAR(static_cast<double>(contact.distance), expected, 1e-4);
    ASSERT_NEAR(static_cast<double>(contact.needed), margin, 1e-4);
    if (contact.kind == ContactKind::obstacle) {
      const Ring piece = ring(open.scene.piece(contact.other));
      ASSERT_NEAR(distance(placed(body), piece), expected, 1e-4);
      ASSERT_NEAR(distance_to_convex(point(contact.at), piece), expected / 2, 1e-3);
      ASSERT_NEAR(distance_to_convex(point(contact.at), placed(body)), expected / 2, 1e-3);
    }
    (contact.distance > 0.0F ? near : hit) += 1;
  }
  EXPECT_GT(near, 100);
  EXPECT_GT(hit, 100);
  EXPECT_GT(free, 100);
}

TEST(Obstacles, DistanceOfAPoint) {
  const OpenScene open(crowded(5));
  const detail::Obstacles obstacles(open.scene, 0.3F);  // which a distance leaves out
  std::mt19937 random(5);
  for (int i = 0; i < 3000; ++i) {
    const Vec2 at{uniform_float(random, -1, 13), uniform_float(random, -1, 13)};
    const float reach = uniform_float(random, 0.01, 2);
    double expected = room_inside({point(at)}, kBounds);
    for (Index p = 0; p < open.scene.piece_count(); ++p) {
      expected = std::min(expected, distance_to_convex(point(at), ring(open.scene.piece(p))));
    }
    expected = std::clamp(expected, 0.0, static_cast<double>(reach));
    ASSERT_NEAR(static_cast<double>(obstacles.distance(at, reach)), expected, 1e-4);
  }
}

TEST(Obstacles, BodyWithAVertexAtInfinityHasNoRoom) {
  const OpenScene open{Room{}};
  const detail::Obstacles obstacles(open.scene, 0.0F);
  const std::vector<Vec2> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  ASSERT_GT(obstacles.room(body_at({5, 5}, square), 1.0F), 0.0F);
  for (std::size_t i = 0; i < square.size(); ++i) {
    for (const Vec2 far : {Vec2{kInfinity, 0}, Vec2{-kInfinity, 0}, Vec2{0, kInfinity}, Vec2{0, -kInfinity}}) {
      std::vector<Vec2> body = square;
      body[i] = far;
      EXPECT_LE(obstacles.room(body_at({5, 5}, body), 1.0F), 0.0F) << i;
    }
  }
}

}  // namespace
}  // namespace krait::test::obstacles_test
