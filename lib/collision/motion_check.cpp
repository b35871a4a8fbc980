// SPDX-License-Identifier: Apache-2.0
#include "collision/motion_check.hpp"

#include <algorithm>

#include "robot/shape.hpp"

namespace krait::detail {

MotionCheck::MotionCheck() = default;

void MotionCheck::allocate(Arena& arena, const Robot& robot) {
  const auto bodies = static_cast<std::uint32_t>(robot.body_count());
  circles_ = arena.allocate<Circle>(Pool::work, bodies);
  needed_ = arena.allocate<float>(Pool::work, bodies);
  farthest_ = arena.allocate<float>(Pool::work, bodies);
  travel_ = arena.allocate<Travel>(Pool::work, bodies);
  centers_ = arena.allocate<Vec2>(Pool::work, bodies);
  along_ = arena.allocate<float>(Pool::work, bodies);
  for (Placement& placement : placements_) {
    placement = {arena.allocate<Pose>(Pool::work, bodies), arena.allocate<float>(Pool::work, bodies)};
  }
  for (float*& state : middle_)
    state = arena.allocate<float>(Pool::work, static_cast<std::uint32_t>(robot.state_size()));
  checks_ = 0;
}

void MotionCheck::assign(const Robot& robot, const Scene& scene, float clearance, int max_substeps, bool shortcuts) {
  robot_ = robot;
  scene_ = &scene;
  max_substeps_ = max_substeps;
  shortcuts_ = shortcuts;
  gap_ = robot.self_collision_gap();
  bodies_ = robot.body_count();
  checks_ = 0;
  keep(clearance, kInfinity);
}

void MotionCheck::keep(float clearance, float longest_step) {
  obstacles_ = Obstacles(*scene_, clearance, shortcuts_);
  longest_step_ = longest_step;
  measure_bodies();
}

bool MotionCheck::free(const float* state) {
  place(state, after());
  if (!all_finite(state, after())) return false;
  for (int k = 0; k < bodies_; ++k) {
    if (!keeps_margin(after(), k)) return false;
  }
  before_ = 1 - before_;
  return never_touch() || still_apart();
}

Contact MotionCheck::contact(const float* state) {
  Placement& placement = after();
  robot_.place(state, placement.poses);
  Contact worst;
  const auto consider = [&worst](Contact contact, int body) {
    if (contact.kind == ContactKind::none) return;
    contact.body = static_cast<Index>(body);
    const bool worse = contact.needed - contact.distance > worst.needed - worst.distance;
    if (worst.kind == ContactKind::none || worse) worst = contact;
  };
  for (int k = 0; k < bodies_; ++k) consider(obstacles_.contact(placed(placement, k, placement.poses[k].position)), k);
  for (int i = 0; i + gap_ < bodies_; ++i) {
    for (int j = i + gap_; j < bodies_; ++j) consider(contact_of_pair(placement, i, j), i);
  }
  return worst;
}

bool MotionCheck::lead_free(const float* state, const float* next) {
  if (!robot_.leads() || bodies_ == 1 || !shortcuts_) return true;
  if (before().circle_room[0] > length(Vec2{next[0], next[1]} - Vec2{state[0], state[1]})) return true;
  robot_.place_lead(next, after().poses);
  find_room(after(), 1);
  if (keeps_margin(after(), 0)) return true;
  ++checks_;
  return false;
}

bool MotionCheck::keeps_limits(const float* state, const float* control, float dt, const float* next) {
  return usable(control) && bound({state, control, dt, next});
}

bool MotionCheck::step_free(const float* state, const float* control, float dt, const float* next) {
  if (!usable(control)) return false;
  const Step step{state, control, dt, next};
  place(next, after());
  Unproven unproven{true, true, ~0U};
  const Outcome whole = judge(step, unproven);
  if (whole == Outcome::hit) return false;
  if (whole == Outcome::unproven && !prove_by_halves(step, unproven)) return false;
  before_ = 1 - before_;
  return true;
}

void MotionCheck::measure_bodies() {
  farthest_of_all_ = 0.0F;
  centered_ = true;
  for (int k = 0; k < bodies_; ++k) {
    const Polygon body = robot_.body(k);
    const Box box = bounding_box(body);
    const Vec2 center = 0.5F * (box.min + box.max);
    float radius = 0.0F;
    for (int i = 0; i < body.count; ++i) {
      const float distance = length(body[i] - center);
      if (distance > radius) radius = distance;
    }
    circles_[k] = {center, length(center)};
    centered_ = centered_ && circles_[k].offset == 0.0F;
    needed_[k] = shortcuts_ ? radius * (1.0F + 1e-6F) + obstacles_.margin() : kInfinity;
    farthest_[k] = farthest(body.vertices, body.count);
    if (farthest_[k] > farthest_of_all_) farthest_of_all_ = farthest_[k];
  }
}

Vec2 MotionCheck::center(const Placement& placement, int k) const {
  const Pose& pose = placement.poses[k];
  return pose.position + turned(pose.heading, circles_[k].center);
}

void MotionCheck::place(const float* state, Placement& placement) {
  robot_.place(state, placement.poses);
  ++checks_;
  find_room(placement, bodies_);
  if (!robot_.answers_proven() && !all_finite(state, placement)) leave_no_room(placement);
}

bool MotionCheck::all_finite(const float* state, const Placement& placement) const {
  float sum = sum_of(state, robot_.state_size());
  for (int k = 0; k < bodies_; ++k) sum = sum + placement.poses[k].heading.sin + placement.poses[k].heading.cos;
  return finite(sum);
}

float MotionCheck::sum_of(const float* numbers, int count) {
  float sum = 0.0F;
  for (int i = 0; i < count; ++i) sum = sum + numbers[i];
  return sum;
}

void MotionCheck::leave_no_room(Placement& placement) {
  placement.poses[0].position.x = std::numeric_limits<float>::quiet_NaN();
  placement.circle_room[0] = -kInfinity;
}

[[gnu::flatten]] void MotionCheck::find_room(Placement& placement, int bodies) const {
  const ClearanceGrid grid = obstacles_.clearance();
  const float* const needed = needed_;
  const Pose* const poses = placement.poses;
  float* const rooms = placement.circle_room;
  const bool centered = centered_;
  for (int k = 0; k < bodies; ++k) {
    const float room = grid.at(centered ? poses[k].position : center(placement, k)) - needed[k];
    rooms[k] = room > 0.0F ? room : -kInfinity;
  }
}

PlacedBody MotionCheck::placed(const Placement& placement, int k, Vec2 at) const {
  PlacedBody body;
  body.at = at;
  add_vertices(placement, k, body);
  return body;
}

[[gnu::flatten]] void MotionCheck::add_vertices(const Placement& placement, int k, PlacedBody& body) const {
  const Polygon shape = robot_.body(k);
  const Pose pose = placement.poses[k];
  const Vec2 shift = pose.position - body.at;
  Vec2* const vertices = body.vertices + body.count;
  for (int i = 0; i < shape.count; ++i) vertices[i] = shift + turned(pose.heading, shape[i]);
  body.count += shape.count;
}

PlacedBody MotionCheck::swept(int k, Vec2 at) const {
  PlacedBody hull = placed(placements_[1 - before_], k, at);
  add_vertices(placements_[before_], k, hull);
  return hull;
}

bool MotionCheck::keeps_margin(const Placement& placement, int k) const {
  return placement.circle_room[k] > 0.0F ||
         obstacles_.room(placed(placement, k, placement.poses[k].position), Obstacles::kLookBeyond) > 0.0F;
}

bool MotionCheck::bound(const Step& step) {
  bounded_ = false;
  if (shortcuts_) {
    quick_ = robot_.quick_bound(step.state, step.control, step.dt, step.next);
    if (quick_.limits_kept && usable(quick_.most)) return true;
  }
  quick_.separation = 0.0F;
  return bound_bodies(step);
}

bool MotionCheck::bound_bodies(const Step& step) {
  bounded_ = true;
  bool kept = robot_.travel(step.state, step.control, step.dt, step.next, travel_);
  for (int k = 0; !robot_.answers_proven() && k < bodies_; ++k) {
    if (usable(travel_[k])) continue;
    travel_[k] = {kInfinity, kInfinity, kInfinity, kInfinity};
    kept = false;
  }
  return kept;
}

bool MotionCheck::usable(const float* control) const {
  return robot_.answers_proven() || finite(sum_of(control, robot_.control_size()));
}

bool MotionCheck::usable(const Travel& travel) const {
  if (robot_.answers_proven()) return true;
  return travel.path >= 0.0F && travel.turn >= 0.0F && travel.bend >= 0.0F && travel.twist >= 0.0F;
}

inline int MotionCheck::next_near(int k) const {
  if (bounded_ || !centered_) {
    while (k < bodies_ && circle_free(k)) ++k;
    return k;
  }
  const float path = quick_.most.path;
  while (k < bodies_ && circle_rooms(k) > path) ++k;
  return k;
}

float MotionCheck::stray(int k) const {
  const Travel& most = travel(k);
  const float bent = most.bend + farthest_[k] * most.twist;
  const float half = 0.5F * (most.path + farthest_[k] * most.turn);
  return std::min(half, bent);
}

bool MotionCheck::hull_free(const Step& step, int k) {
  const float allowed = stray(k);
  const float room =
      obstacles_.room(swept(k, placements_[1 - before_].poses[k].position), allowed + Obstacles::kLookBeyond);
  if (room > allowed) return true;
  if (bounded_ || room <= 0.0F) return false;
  bound_bodies(step);
  return room > stray(k);
}

MotionCheck::Outcome MotionCheck::judge(const Step& step, Unproven& unproven) {
  const Unproven before = unproven;
  const bool kept = bound(step);
  unproven = {before.limits && !kept, false, 0};
  for (int k = next_near(0); k < bodies_; k = next_near(k + 1)) {
    if ((before.bodies >> k & 1U) == 0 || hull_free(step, k)) continue;
    if (!keeps_margin(after(), k)) return Outcome::hit;
    unproven.bodies |= 1U << k;
  }
  unproven.self = before.self && !self_free(step);
  return unproven.limits || unproven.self || unproven.bodies != 0 ? Outcome::unproven : Outcome::free;
}

bool MotionCheck::prove_by_halves(const Step& step, const Unproven& whole) {
  for (int i = 0; i < robot_.state_size(); ++i) middle_[0][i] = step.state[i];
  int here = 0;
  int done = 0;  // in parts of 1 / max_substeps
  int part = max_substeps_ / 2;
  while (part > 0 && done < max_substeps_) {
    const bool last = done + part >= max_substeps_;
    const float* from = middle_[here];
    float* to = middle_[1 - here];
    const float duration = step.dt * static_cast<float>(part) / static_cast<float>(max_substeps_);
    if (last) {
      for (int i = 0; i < robot_.state_size(); ++i) to[i] = step.next[i];
    } else {
      propagate_in_parts(robot_, from, poses(), step.control, duration,
                         parts_of(duration, longest_step_, kMostPlanParts), to);
    }
    place(to, after());
    Unproven unproven = whole;
    const Outcome outcome = judge({from, step.control, duration, to}, unproven);
    if (outcome == Outcome::hit) return false;
    if (outcome == Outcome::unproven) {
      part /= 2;
      continue;
    }
    done += part;
    here = 1 - here;
    if (done < max_substeps_) before_ = 1 - before_;
    while (done % (2 * part) == 0 && done + 2 * part <= max_substeps_) part *= 2;
  }
  return done >= max_substeps_;
}

bool MotionCheck::self_free(const Step& step) {
  if (never_touch() || far_apart(quick_.separation) || pairs_free()) return true;
  if (bounded_) return false;
  bound_bodies(step);
  return pairs_free();
}

bool MotionCheck::still_apart() {
  for (int k = 0; k < bodies_; ++k) after().poses[k] = before().poses[k];
  bounded_ = false;
  quick_.most = {};
  return pairs_free();
}

[[gnu::flatten]] bool MotionCheck::pairs_free() {
  const int bodies = bodies_;
  Vec2* const centers = centers_;
  float* const along = along_;
  float path = 0.0F;
  float gone = 0.0F;
  for (int k = 0; k < bodies; ++k) {
    const Vec2 center = 0.5F * (placements_[0].poses[k].position + placements_[1].poses[k].position);
    if (k > 0) gone = gone + length(center - centers[k - 1]);
    centers[k] = center;
    along[k] = gone;
    if (travel(k).path > path) path = travel(k).path;
  }
  const float near = 2.0F * farthest_of_all_ + path + obstacles_.margin();
  for (int i = 0; i + gap_ < bodies; ++i) {
    int j = i + gap_;
    while (j < bodies) {
      const float apart = length(centers[j] - centers[i]) - near;
      if (apart > 0.0F) {
        const float reached = along[j] + apart;
        for (++j; shortcuts_ && j < bodies && along[j] < reached;) ++j;
      } else {
        if (!pair_free(i, j)) return false;
        ++j;
      }
    }
  }
  return true;
}

Contact MotionCheck::contact_of_pair(const Placement& placement, int i, int j) const {
  const Vec2 at = placement.poses[i].position;
  const Gap gap = polygon_gap(placed(placement, i, at).polygon(), placed(placement, j, at).polygon());
  if (!(gap.distance <= obstacles_.margin())) return {};
  return {ContactKind::body, 0, static_cast<Index>(j), gap.distance, obstacles_.margin(), at + gap.middle};
}

bool MotionCheck::pair_free(int i, int j) const {
  const Vec2 at = placements_[1 - before_].poses[i].position;
  const float apart = polygon_distance(swept(i, at).polygon(), swept(j, at).polygon());
  return apart - obstacles_.margin() > stray(i) + stray(j);
}

}  // namespace krait::detail
