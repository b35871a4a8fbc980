// SPDX-License-Identifier: Apache-2.0
#include "last_metres/last_metres.hpp"

#include <algorithm>

#include "last_metres/arc.hpp"
#include "last_metres/docking.hpp"
#include "last_metres/parking.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Constants".
constexpr float kLeastRadius = 0.4F;                   // in lengths of body 0: of a robot that turns on the spot, and
                                                       // of as many metres a radian of a turn counts
constexpr float kRadii[] = {1.05F, 1.5F, 3.0F};        // of the lines' arcs, in turning radii
constexpr float kCaptureRadii = 4.0F;                  // how near the goal must be, in turning radii, and
constexpr float kCaptureLengths = 3.5F;                // as many lengths of body 0 more
constexpr float kLeads[] = {0.0F, 0.35F, 0.7F, 1.3F};  // straight ends of lines, in lengths of body 0: two short
                                                       // ones, for where there is no room for the others; or
constexpr float kHitchLeads[] = {1.2F, 2.8F, 1.15F, 2.4F};  // where hitches must be straight, the latter two in lengths
                                                            // of body 0 times the number of bodies
constexpr float kDetour = 2.0F;                             // the most of a line, in distances to the goal, and
constexpr float kDetourLengths = 8.0F;                      // as many lengths of body 0 more
constexpr float kSightRoom = 0.9F;    // of the disc that is looked for, of that in body 0 at its position
constexpr float kSightStep = 0.4F;    // of looks along a line, in lengths of body 0, or
constexpr int kMostLooks = 128;       // this many
constexpr float kLookSteps = 2.5F;    // how far ahead the robot steers, in time steps of its way, and kLook
constexpr float kOff = 1.0F;          // how far off the line it may be, in lengths of body 0
constexpr float kBraking = 0.12F;     // of the sharpest
constexpr float kNearEnough = 0.25F;  // of the goal's radius: there it stops
constexpr std::uint32_t kMostStops = 5;
constexpr float kTight = 4.0F;         // lengths of body 0 that a turn counts where there may be no room for it
constexpr float kFaced = 0.1F;         // radians off a straight piece's direction: there it begins
constexpr float kTurned = 0.5F;        // of the goal's tolerance
constexpr float kTurnLook = 2.0F;      // lengths of body 0: how far ahead a robot steers that turns on the spot,
constexpr float kTurnCreep = 1e-3F;    // and at which share of the top speed
constexpr float kMoveRadius = 1.15F;   // of the arcs of ways out, in turning radii
constexpr float kShortCost = 5.0F;     // steps that each step which a way out's last arc is too short costs
constexpr float kNearMoveEnd = 5e-4F;  // lengths of body 0 from the end of a move that is driven out: there it stops

// Metres: of the tightest arcs that lines to a pose are drawn with, over 1.
float least_radius(const Nimbleness& robot) {
  const float least = kLeastRadius * robot.length;
  return std::max(least, robot.turning_radius);
}

// Of a way; `otherwise` where it is no longer than `least`.
SinCos heading_of(Vec2 way, float least, SinCos otherwise) {
  const float far = length(way);
  return far > least ? SinCos{way.y / far, way.x / far} : otherwise;
}

}  // namespace

void LastMetres::assign(const Scene& scene, const Goal& goal, const Nimbleness& robot) {
  scene_ = &scene;
  goal_ = goal;
  robot_ = robot;
  braking_ = kBraking;
  turn_ = 0.0F;
  draw_with({});
  const bool spins = robot.turning_radius == 0.0F;
  short_leads_ = asks_for_straight() || !spins ? kShortLeadCount : 0;
  capture_ = kCaptureRadii * least_radius(robot) + kCaptureLengths * robot.length + leads_[kLeadCount - 1];
  sight_ = Sight::in(scene, kSightRoom * robot.half_width, kSightStep * robot.length);
  spin_ = Sight::in(scene, robot.reach, kSightStep * robot.length);
  near_ = kNearEnough * goal.radius();
  shot_count_ = 0;
  shot_ = 0;
  ways_of_ = WaysOf::none;
  hold_ = kHold;
  look_ = kLook * robot_.length;
}

void LastMetres::draw_with(const Lines& lines) {
  const float radius = least_radius(robot_);
  const bool spins = robot_.turning_radius == 0.0F;
  radii_[0] = 0.0F;
  for (int i = spins ? 1 : 0; i < kRadii; ++i) radii_[i] = lines.radii * detail::kRadii[spins ? i - 1 : i] * radius;
  const float* leads = asks_for_straight() ? kHitchLeads : kLeads;
  const float unit = asks_for_straight() ? robot_.train : robot_.length;
  for (int i = 0; i < kLeadCount; ++i) {
    leads_[i] = lines.leads * leads[i] * (i < kShortLeadCount ? robot_.length : unit);
  }
  detours_ = lines.detours;
}

void LastMetres::forget_shots(bool by_detour) {
  shot_count_ = 0;
  shot_ = 0;
  by_detour_ = by_detour;
}

void LastMetres::choose(const Pose* poses) {
  forget_shots(false);
  if (robot_.docking != nullptr) robot_.docking->measure(*this, poses);
  consider_leads(poses, short_leads_, kLeadCount);
  if (shot_count_ == 0) consider_leads(poses, 0, short_leads_);
}

// All words, radii and ways with the straight ends from `first` to before `last`.
void LastMetres::consider_leads(const Pose* poses, int first, int last) {
  const int ways = goal_.facing().either_way ? 2 : 1;
  const int directions = robot_.backward ? 2 : 1;
  Shot shot;
  shot.way = Manoeuvre::kNoWay;
  shot.stage = 0.0F;
  shot.end.heading = math::sin_cos(goal_.facing().heading);
  for (int way = 0; way < ways; ++way) {
    for (int gear = 0; gear < directions; ++gear) {
      shot.backward = gear == 1;
      shot.end.position = goal_.center();
      if (leader(shot) > 0) shot.end.position = goal_.center() - reach_back_ * direction(shot.end.heading);
      for (int lead = first; lead < last; ++lead) {
        shot.lead = leads_[lead];
        consider_words(poses, shot);
      }
    }
    shot.end.heading = opposite(shot.end.heading);
  }
}

void LastMetres::consider_words(const Pose* poses, Shot& shot) {
  for (shot.radius = 0; shot.radius < kRadii; ++shot.radius) {
    for (shot.word = 0; shot.word < kDubinsWords; ++shot.word) consider(poses, shot);
  }
}

void LastMetres::choose_ways(const Pose* poses) {
  forget_shots(true);
  if (ways_of_ != WaysOf::goal) {
    manoeuvre_.assign(*scene_, robot_, ways_, near_);
    ways_.find(*scene_, goal_, body_that_pulls_out(0.0F));
    ways_of_ = WaysOf::goal;
  }
  Shot shot;
  shot.lead = 0.0F;
  shot.stage = 0.0F;
  for (int way = 0; way < ways_.count(); ++way) {
    shot.way = static_cast<std::uint8_t>(way);
    shot.end = ways_.end(way);
    for (int direction = 0; direction < 2; ++direction) {
      shot.backward = direction == 1;
      consider_words(poses, shot);
    }
  }
}

int LastMetres::find_ways_from(const Pose& start, bool far_out) {
  ways_of_ = WaysOf::start;
  manoeuvre_.assign(*scene_, robot_, ways_, kNearMoveEnd * robot_.length);
  ways_.find(*scene_, start, body_that_pulls_out(far_out ? kShortCost : 0.0F));
  return ways_.count();
}

PullOuts::Body LastMetres::body_that_pulls_out(float short_cost) const {
  return {robot_.outline, robot_.length, kMoveRadius * least_radius(robot_), robot_.clearance, short_cost};
}

// Keeps the shot if it is among the shortest.
void LastMetres::consider(const Pose* poses, Shot& shot) {
  const Pose& from = poses[leader(shot)];
  const bool full = shot_count_ == kMostShots;
  const float far = kDetour * length(goal_.center() - from.position) + kDetourLengths * robot_.length;
  const float most = full ? std::min(far, shots_[kMostShots - 1].length) : far;
  CurvedLine line;
  if (!draw(from, shot, most, line)) return;
  shot.length = line.length() + kLeastRadius * robot_.length * line.turned();
  if (on_the_spot(shot) && spin_.slack(before_end(shot, shot.lead).position) < 0.0F) {
    shot.length += kTight * robot_.length;
  }
  if (!(shot.length < most)) return;
  if (robot_.docking != nullptr && !robot_.docking->allows(*this, poses, shot, line)) return;
  if (!looks_free(line)) return;
  std::uint32_t at = full ? kMostShots - 1 : shot_count_++;
  for (; at > 0 && shots_[at - 1].length > shot.length; --at) shots_[at] = shots_[at - 1];
  shots_[at] = shot;
}

Pose LastMetres::before_end(const Shot& shot, float lead) {
  const SinCos ahead = shot.backward ? opposite(shot.end.heading) : shot.end.heading;
  return {shot.end.position - lead * direction(ahead), ahead};
}

bool LastMetres::draw(const Pose& from, const Shot& shot, float most, CurvedLine& line) const {
  const int last_turn = swing(shot);
  const Pose to = before_end(shot, last_turn == 0 ? shot.lead : 0.0F);
  const Pose begin{from.position, shot.backward ? opposite(from.heading) : from.heading};
  const bool spins = on_the_spot(shot);
  line = CurvedLine(begin, spins ? 1.0F : radii_[shot.radius]);
  if (spins) {
    if (shot.word != 0) return false;
    line.face(heading_of(to.position - begin.position, near_, to.heading));
    line.add(0, length(to.position - begin.position));
    line.face(to.heading);
  } else {
    DubinsPieces pieces;
    if (!dubins(shot.word, begin, to, radii_[shot.radius], pieces) || pieces.length() + shot.lead > most) return false;
    line.add(pieces);
  }
  line.add(last_turn, shot.lead);
  return true;
}

// Places within the slack of one that was looked at are not looked at.
bool LastMetres::looks_free(const CurvedLine& line) const {
  const float whole = line.length();
  const float wanted = kSightStep * robot_.length;
  const float least = whole / static_cast<float>(kMostLooks);
  const float step = std::max(least, wanted);
  float arc = whole;
  float free_from = kInfinity;
  for (int look = 0; look < kMostLooks; ++look) {
    if (arc <= 0.0F) return true;
    if (arc < free_from) {
      const float room = sight_.slack(line.at(arc).position);
      if (room < 0.0F) return false;
      free_from = arc - room;
    }
    arc = arc - step;
  }
  return true;
}

bool LastMetres::next(const Pose* poses) {
  if (shot_ == shot_count_ && !by_detour_ && detours_) {
    if (robot_.parking != nullptr) robot_.parking->choose(*this, poses);
    if (robot_.docking != nullptr) robot_.docking->choose(*this, poses);
  }
  if (shot_ == shot_count_) return false;
  const Shot& shot = shots_[shot_++];
  manoeuvre_.begin(shot.way);
  arc_ = 0.0F;
  stops_ = 0;
  turning_ = false;
  straight_ = on_the_spot(shot);
  lead_ = straight_ ? shot.lead : 0.0F;
  return draw(poses[leader(shot)], shot, kInfinity, line_);
}

bool LastMetres::aim(const Moment& now, Target& target) {
  if (manoeuvre_.moving()) return robot_.parking->aim(manoeuvre_, now, target);
  const Shot& shot = shots_[shot_ - 1];
  if (shot.stage > 0.0F && arrived()) robot_.docking->turn_back(*this);
  const Pose& at = now.poses[leader(shot)];
  if (!straight_ && !keep_to_line(at)) return false;
  if (!straight_ && lead_ > 0.0F && arrived()) {
    straight_ = true;
    lead_ = 0.0F;
  }
  if (straight_ && !begin_straight(shot, at)) return turn(at, target);
  const bool stops = arrived();
  if (stops && manoeuvre_.any()) return robot_.parking->aim(manoeuvre_, now, target);
  if (stops && robot_.turning_radius == 0.0F) {
    facing_ = shot.end.heading;
    enough_ = kTurned * goal_.facing().tolerance;
    if (off(at) > enough_) return turn(at, target);
  }
  turning_ = false;
  if (stops && ++stops_ > kMostStops) return false;
  const float speed = now.robot.speed(now.state);
  const float share = pace(robot_, remaining(), speed, now.robot.stopping_way(now.state), braking_);
  target.speed = stops ? 0.0F : (shot.backward ? -share : share);
  target.turn = 1.0F;
  const float look = leader(shot) > 0 ? push_look_ : look_;
  target.point = point_ahead(line_, arc_, look + kLookSteps * robot_.dt * speed);
  return true;
}

float LastMetres::least_remaining(const Moment& now) const {
  const float way = remaining();
  const float braked = math::absolute(now.robot.stopping_way(now.state)) / braking_;
  const float radius = radii_[shots_[shot_ - 1].radius];
  const float turns = turn_ > radius ? (turn_ - radius) * least_turn(now) : 0.0F;
  return way + std::min(way, braked) + turns;
}

float LastMetres::least_turn(const Moment& now) const {
  const Shot& shot = shots_[shot_ - 1];
  if (!on_the_spot(shot)) return line_.curve_from(arc_);
  const float here = turning_ ? off(now.poses[leader(shot)]) : 0.0F;
  return arrived() ? here : here + angle_between(line_.at(0.0F).heading, before_end(shot, 0.0F).heading);
}

bool LastMetres::leg_over(std::uint32_t steps, const Moment& now) {
  if (manoeuvre_.moving()) return robot_.parking->leg_over(manoeuvre_, steps, now);
  return turning_ ? steps >= kLongest || off(now.at()) <= enough_ : steps >= hold_;
}

bool LastMetres::keep_to_line(const Pose& at) {
  for (int i = 0; i < 2; ++i) {
    const Pose on = line_.at(arc_);
    arc_ = arc_ + math::clamp(dot(at.position - on.position, direction(on.heading)), 0.0F, kOff * robot_.length);
  }
  return length(at.position - line_.at(arc_).position) <= kOff * robot_.length;
}

bool LastMetres::begin_straight(const Shot& shot, const Pose& at) {
  const Pose to = before_end(shot, lead_);
  const Vec2 way = to.position - at.position;
  const SinCos ahead = heading_of(way, near_, to.heading);
  facing_ = shot.backward ? opposite(ahead) : ahead;
  enough_ = kFaced;
  if (off(at) > enough_) return false;
  straight_ = false;
  turning_ = false;
  arc_ = 0.0F;
  line_ = CurvedLine({at.position, ahead}, 1.0F);
  line_.add(0, length(way));
  return true;
}

bool LastMetres::turn(const Pose& at, Target& target) {
  const float angle = off(at);
  if (turning_ && angle >= off_) return false;
  turning_ = true;
  off_ = angle;
  target.speed = kTurnCreep;
  target.turn = 1.0F;
  target.point = point_ahead(CurvedLine({at.position, facing_}, 1.0F), 0.0F, kTurnLook * robot_.length);
  return true;
}

Vec2 LastMetres::point_ahead(const CurvedLine& line, float arc, float look) const {
  Vec2 point = line.at(arc + look).position;
  for (int i = 0; i < kMostShortenings && !scene_->inside_bounds(point); ++i) {
    look = kShortening * look;
    point = line.at(arc + look).position;
  }
  return point;
}

}  // namespace krait::detail
