// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "../host/plans/random_workspace.hpp"
#include "host/scenes/scenes.hpp"

namespace krait::campaign {
namespace {

constexpr int kStarts = 40;           // tried to find a free one
constexpr double kStartRoom = 0.003;  // m

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  std::mt19937_64& engine() { return random_; }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance(double share) { return uniform(0, 1) < share; }
  double angle() { return uniform(-std::numbers::pi, std::numbers::pi); }

 private:
  std::mt19937_64 random_;
};

// What a robot is made for.
struct Measures {
  double width;   // m, of a body
  double length;  // m
  double step;    // m, at top speed
  double dt;      // s
  double agile;   // at least this share of top speed and lock may be gained in a step
  double speed() const { return step / dt; }
};

float as_float(double x, double least, double most) { return static_cast<float>(std::clamp(x, least, most)); }
float dimension(double x) { return as_float(x, 0.001, 1000); }
float limit(double x) { return as_float(x, 0.001, 1e4); }

// Half of them so large that they only just pass.
Measures draw_measures(Draw& draw, double passage, double side) {
  Measures m;
  m.dt = draw.log_uniform(0.001, 1);
  const bool tight = draw.chance(0.6);
  m.agile = tight ? 0.1 : 0.005;
  if (tight) {
    m.width = passage * draw.uniform(0.2, 0.8);
    m.length = m.width * draw.log_uniform(0.7, 2.5);
    m.step = std::max(m.length * draw.log_uniform(0.1, 3), side / 2000);
    return m;
  }
  m.width = draw.chance(0.05) ? draw.log_uniform(0.001, 1000) : passage * draw.log_uniform(0.02, 0.7);
  m.length = m.width * draw.log_uniform(0.5, 4);
  m.step = draw.chance(0.05) ? draw.log_uniform(1e-6, 100) : side / draw.log_uniform(40, 2000);
  return m;
}

// Convex: corners of an ellipse that was moved, by angle.
std::vector<Vec2> draw_body(Draw& draw, const Measures& m, double ahead) {
  const int corners = draw.whole(3, 8);
  std::vector<double> angles;
  while (static_cast<int>(angles.size()) < corners) {
    const double angle = draw.uniform(0, 2 * std::numbers::pi);
    const auto near = [angle](double other) {
      const double apart = std::abs(angle - other);
      return std::min(apart, 2 * std::numbers::pi - apart) < 0.15;
    };
    if (std::none_of(angles.begin(), angles.end(), near)) angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  const double x = ahead * m.length, y = draw.chance(0.5) ? 0 : draw.uniform(-0.5, 0.5) * m.width;
  std::vector<Vec2> body;
  for (const double angle : angles) {
    body.push_back({static_cast<float>(x + m.length / 2 * std::cos(angle)),
                    static_cast<float>(y + m.width / 2 * std::sin(angle))});
  }
  return body;
}

void draw_bodies(Draw& draw, const Measures& m, Robot& robot) {
  if (!draw.chance(0.3)) return;
  for (int k = 0; k < robot.bodies(); ++k) robot.own_bodies.push_back(draw_body(draw, m, draw.uniform(-0.4, 0.4)));
}

int draw_links(Draw& draw, double hitch, double side) {
  const int links = draw.chance(0.4) ? draw.whole(1, 3) : draw.whole(0, draw.chance(0.5) ? 8 : kMaxTrailers);
  return std::min(links, static_cast<int>(0.5 * side / hitch));
}

float draw_hitch_limit(Draw& draw) {
  const double share = draw.uniform(0, 1);
  if (share < 0.6) return 1.5707963F;
  return static_cast<float>(share < 0.9 ? draw.log_uniform(0.1, 1.57) : draw.uniform(1.5707964, 3.1415));
}

void draw_chain(Draw& draw, const Measures& m, double side, Robot& robot) {
  ChainParameters& p = robot.chain;
  p.body_length = dimension(m.length);
  p.body_width = dimension(m.width);
  p.wheelbase = dimension(m.length * draw.log_uniform(0.3, draw.chance(0.5) ? 0.8 : 2));
  const double hitch = m.length * draw.log_uniform(0.15, 3);
  p.hitch_length = dimension(hitch);
  p.trailers = draw_links(draw, hitch, side);
  if (robot.model == Model::car) p.trailers = 0;
  p.max_speed = limit(m.speed());
  if (draw.chance(0.4)) p.min_speed = as_float(-m.speed() * draw.log_uniform(0.05, 1), -1e4, 0);
  p.max_steering = as_float(draw.chance(0.5) ? draw.uniform(0.5, 1.2) : draw.log_uniform(0.05, 1.57), 0.001, 1.57);
  p.max_acceleration = limit(m.speed() / m.dt * draw.log_uniform(m.agile, 5));
  p.max_steering_rate = limit(static_cast<double>(p.max_steering) / m.dt * draw.log_uniform(m.agile, 5));
  p.max_hitch_angle = draw_hitch_limit(draw);
  const int apart = static_cast<int>(std::min(1000.0, std::ceil(m.length * 1.05 / hitch)));
  p.self_collision_gap = draw.chance(0.1) ? draw.whole(1, 4) : std::max(1, apart) + draw.whole(0, 1);
}

void draw_kinematic_truck(Draw& draw, const Measures& m, double side, Robot& robot) {
  Robot like = robot;
  draw_chain(draw, m, side, like);
  const ChainParameters& c = like.chain;
  robot.kinematic = {c.trailers,           c.body_length,    c.body_width,
                     c.body_offset,        c.wheelbase,      c.hitch_length,
                     c.max_speed,          c.min_speed,      std::min(c.max_steering, 1.5F),
                     c.self_collision_gap, c.max_hitch_angle};
}

void draw_unicycle(Draw& draw, const Measures& m, Robot& robot) {
  UnicycleParameters& p = robot.unicycle;
  p.body_length = dimension(m.length);
  p.body_width = dimension(m.width);
  p.max_speed = limit(m.speed());
  const double kind = draw.uniform(0, 1);
  const double least = m.speed() * draw.log_uniform(0.05, 1);
  p.min_speed = kind < 0.4    ? 0.0F
                : kind < 0.85 ? as_float(-least, -1e4, 0)
                              : as_float(least, 0, static_cast<double>(p.max_speed));
  p.max_turn_rate = limit(draw.log_uniform(0.02, 3) / m.dt);
}

void draw_unicycle2(Draw& draw, const Measures& m, Robot& robot) {
  Unicycle2Parameters& p = robot.unicycle2;
  p.body_length = dimension(m.length);
  p.body_width = dimension(m.width);
  p.max_speed = limit(m.speed());
  p.min_speed = draw.chance(0.5) ? 0 : as_float(-m.speed() * draw.log_uniform(0.05, 1), -1e4, 0);
  p.max_turn_rate = limit(draw.log_uniform(0.02, 3) / m.dt);
  p.max_acceleration = limit(m.speed() / m.dt * draw.log_uniform(m.agile, 5));
  p.max_turn_acceleration = limit(static_cast<double>(p.max_turn_rate) / m.dt * draw.log_uniform(m.agile, 5));
}

void draw_differential_drive(Draw& draw, const Measures& m, Robot& robot) {
  DifferentialDriveParameters& p = robot.drive;
  p.body_length = dimension(m.length);
  p.body_width = dimension(m.width);
  p.wheel_radius = dimension(m.width * draw.log_uniform(0.05, 0.5));
  p.track_width = dimension(m.width * draw.log_uniform(0.3, 1.5));
  p.max_wheel_speed = limit(m.speed() / static_cast<double>(p.wheel_radius));
  p.max_wheel_acceleration = limit(static_cast<double>(p.max_wheel_speed) / m.dt * draw.log_uniform(m.agile, 5));
}

constexpr Model kDrawn[] = {Model::snake,    Model::snake,      Model::truck,     Model::truck,          Model::car,
                            Model::unicycle, Model::diff_drive, Model::unicycle2, Model::kinematic_truck};
#define KRAIT_DRAWN(name, Class, file, trailers) \
  static_assert(std::find(std::begin(kDrawn), std::end(kDrawn), Model::name) != std::end(kDrawn));
KRAIT_MODELS(KRAIT_DRAWN)
#undef KRAIT_DRAWN

Robot draw_robot(Draw& draw, const Measures& m, double side) {
  Robot robot;
  robot.model = kDrawn[draw.whole(0, std::size(kDrawn) - 1)];
  if (robot.model == Model::unicycle) {
    draw_unicycle(draw, m, robot);
  } else if (robot.model == Model::unicycle2) {
    draw_unicycle2(draw, m, robot);
  } else if (robot.model == Model::kinematic_truck) {
    draw_kinematic_truck(draw, m, side, robot);
  } else if (robot.model == Model::diff_drive) {
    draw_differential_drive(draw, m, robot);
  } else {
    draw_chain(draw, m, side, robot);
  }
  draw_bodies(draw, m, robot);
  return robot;
}

Parameters draw_parameters(Draw& draw, const Measures& m, double passage) {
  Parameters p;
  p.dt = as_float(m.dt, 0.001F, 1);
  if (draw.chance(0.3)) p.tuning.max_steps = static_cast<std::uint32_t>(draw.log_uniform(5, 300));
  if (draw.chance(0.1)) p.clearance = 0;
  if (draw.chance(0.1)) p.clearance = static_cast<float>(draw.log_uniform(1e-4, 0.05 * passage));
  if (draw.chance(0.2)) p.tuning.max_substeps = 1U << draw.whole(0, 6);
  if (draw.chance(0.05)) p.goal_margin = 0;
  return p;
}

// Headings of trailers begin with component `first`.
void bend_trailers(Draw& draw, float max_hitch_angle, std::size_t first, std::vector<float>& state) {
  const double bent = draw.log_uniform(0.01, 0.9) * static_cast<double>(max_hitch_angle);
  for (std::size_t i = first; i < state.size(); ++i) {
    state[i] = (i == first ? state[2] : state[i - 1]) + static_cast<float>(draw.uniform(-bent, bent));
  }
}

// Standing or moving, straight or bent.
void draw_motion(Draw& draw, const Robot& robot, std::vector<float>& state) {
  if (robot.model == Model::diff_drive) {
    for (std::size_t i = 3; i < 5; ++i) {
      state[i] = static_cast<float>(draw.uniform(-1, 1) * static_cast<double>(robot.drive.max_wheel_speed));
    }
  }
  if (robot.model == Model::unicycle2) {
    const Unicycle2Parameters& p = robot.unicycle2;
    state[3] = static_cast<float>(draw.uniform(static_cast<double>(p.min_speed), static_cast<double>(p.max_speed)));
    state[4] = static_cast<float>(draw.uniform(-1, 1) * static_cast<double>(p.max_turn_rate));
  }
  if (robot.model == Model::kinematic_truck) return bend_trailers(draw, robot.kinematic.max_hitch_angle, 3, state);
  if (!robot.is_chain()) return;
  const ChainParameters& p = robot.chain;
  state[3] = static_cast<float>(draw.uniform(static_cast<double>(p.min_speed), static_cast<double>(p.max_speed)));
  state[4] = static_cast<float>(draw.uniform(-1, 1) * static_cast<double>(p.max_steering));
  bend_trailers(draw, p.max_hitch_angle, 5, state);
}

std::vector<float> start_at(const Robot& robot, host::Point at, double heading) {
  std::vector<float> state(static_cast<std::size_t>(Equations(robot).state_size()), 0);
  state[0] = static_cast<float>(at.x);
  state[1] = static_cast<float>(at.y);
  state[2] = static_cast<float>(heading);
  const auto trailers = static_cast<std::size_t>(robot.trailers());
  for (std::size_t i = state.size() - trailers; i < state.size(); ++i) state[i] = state[2];
  return state;
}

bool free_at(const Robot& robot, const Field& field, const std::vector<float>& start) {
  const Equations equations(robot);
  const std::vector<Convex> bodies = bodies_of(robot);
  State state{};
  for (std::size_t i = 0; i < start.size(); ++i) state[i] = static_cast<double>(start[i]);
  Frames frames;
  equations.place(state, frames);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Placed body = placed(bodies[k], frames[k]);
    if (field.room(body, kStartRoom) < kStartRoom || field.inside(body)) return false;
  }
  return true;
}

// In the scene's coordinates.
host::Point draw_point(Draw& draw, const Scene& scene) {
  const auto [min, max] = scene.bounds();
  const double x = draw.uniform(static_cast<double>(min.x), static_cast<double>(max.x));
  return {x, draw.uniform(static_cast<double>(min.y), static_cast<double>(max.y))};
}

std::vector<float> draw_start(Draw& draw, const Robot& robot, const Scene& scene, const Field& field) {
  std::vector<float> start;
  const bool moving = draw.chance(0.2);
  const double turns = draw.chance(0.05) ? 2 * std::numbers::pi * draw.whole(-200, 200) : 0;
  if (scene.start_count() > 0 && draw.chance(0.6)) {
    const ScenePose pose = scene.start(0);
    start = start_at(robot, {static_cast<double>(pose.position.x), static_cast<double>(pose.position.y)},
                     static_cast<double>(pose.heading));
    if (free_at(robot, field, start)) return start;
  }
  for (int i = 0; i < kStarts; ++i) {
    start = start_at(robot, draw_point(draw, scene), draw.angle() + turns);
    if (moving) draw_motion(draw, robot, start);
    if (free_at(robot, field, start)) break;
  }
  return start;
}

void draw_disc(Draw& draw, const Scene& scene, const Field& field, double radius, DrawnQuery& drawn) {
  Convex small;
  for (const double corner : {0.0, 1.0, 2.0}) small.add(1e-3 * std::cos(2 * corner), 1e-3 * std::sin(2 * corner));
  host::Point center{};
  for (int i = 0; i < kStarts; ++i) {
    center = draw_point(draw, scene);
    const Placed at = placed(small, {center.x, center.y, 1, 0});
    if (field.room(at, 0.1) > 0 && !field.inside(at)) break;
  }
  const Vec2 at{static_cast<float>(center.x), static_cast<float>(center.y)};
  const auto size = static_cast<float>(radius);
  drawn.query.goal = Goal::disc(at, size);
  drawn.goal = Disc{static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(size)};
}

void name_goal(const host::Workspace& workspace, const Scene& scene, DrawnQuery& drawn) {
  drawn.query.goal = Goal::named(0);
  host::Ring ring = workspace.goals[0].polygon;
  for (host::Point& p : ring) p = {p.x - scene.header().origin_x, p.y - scene.header().origin_y};
  drawn.goal = ring;
}

void enlarge(host::Workspace& w, double factor) {
  const auto enlarged = [factor](host::Point& p) { p = {p.x * factor, p.y * factor}; };
  enlarged(w.min);
  enlarged(w.max);
  for (host::Obstacle& obstacle : w.obstacles) std::for_each(obstacle.outer.begin(), obstacle.outer.end(), enlarged);
  for (host::Goal& goal : w.goals) std::for_each(goal.polygon.begin(), goal.polygon.end(), enlarged);
  for (host::Start& start : w.starts) enlarged(start.position);
}

}  // namespace

// A shipped scene grows in rooms at first, with its passages as they are, and the rest of the scale in everything.
DrawnScene draw_scene(std::uint64_t seed) {
  Draw draw(seed);
  DrawnScene drawn;
  if (draw.chance(0.5)) {
    drawn.workspace = host::test::random_workspace(draw.engine());
    drawn.passage = (drawn.workspace.max.x - drawn.workspace.min.x) * draw.log_uniform(0.01, 0.1);
    return drawn;
  }
  const auto& names = host::scene_names();
  const double scale = draw.log_uniform(0.25, 16);
  const double rooms = std::clamp(draw.chance(0.5) ? 1 : scale, 0.5, 8.0);
  const auto last = static_cast<int>(names.size()) - 1;
  drawn.workspace = host::make_scene(names[static_cast<std::size_t>(draw.whole(0, last))].name, rooms).workspace;
  enlarge(drawn.workspace, scale / rooms);
  drawn.passage = 1.4 * scale / rooms;
  return drawn;
}

DrawnQuery draw_query(const DrawnScene& drawn, const Scene& scene, const Field& field, std::uint64_t seed, int number) {
  Draw draw(seed * 1009 + static_cast<std::uint64_t>(number));
  const double side = drawn.workspace.max.x - drawn.workspace.min.x;
  const Measures m = draw_measures(draw, drawn.passage, side);
  DrawnQuery result;
  Query& query = result.query;
  query.robot = draw_robot(draw, m, side);
  query.parameters = draw_parameters(draw, m, drawn.passage);
  query.start = draw_start(draw, query.robot, scene, field);
  if (!drawn.workspace.goals.empty() && draw.chance(0.6)) {
    name_goal(drawn.workspace, scene, result);
  } else {
    draw_disc(draw, scene, field, std::max(m.step * draw.log_uniform(0.3, 3), side * draw.log_uniform(0.005, 0.05)),
              result);
  }
  query.seed = draw.engine()();
  return result;
}

std::string describe(const Query& query) {
  const Robot& r = query.robot;
  const auto number = [](float x) { return static_cast<double>(x); };
  char line[600];
  int used =
      std::snprintf(line, sizeof line, "%s:%d dt %.6g", name(r.model), r.trailers(), number(query.parameters.dt));
  const auto add = [&](const char* form, auto... values) {
    used += std::snprintf(line + used, sizeof line - static_cast<std::size_t>(used), form, values...);
  };
  if (r.model == Model::unicycle) {
    const UnicycleParameters& p = r.unicycle;
    add(" body %.4g x %.4g v %.4g..%.4g turn %.4g", number(p.body_length), number(p.body_width), number(p.min_speed),
        number(p.max_speed), number(p.max_turn_rate));
  } else if (r.model == Model::unicycle2) {
    const Unicycle2Parameters& p = r.unicycle2;
    add(" body %.4g x %.4g v %.4g..%.4g turn %.4g accel %.4g turn accel %.4g", number(p.body_length),
        number(p.body_width), number(p.min_speed), number(p.max_speed), number(p.max_turn_rate),
        number(p.max_acceleration), number(p.max_turn_acceleration));
  } else if (r.model == Model::kinematic_truck) {
    const KinematicTruckParameters& p = r.kinematic;
    add(" body %.4g x %.4g base %.4g hitch %.4g v %.4g..%.4g steer %.4g gap %d hitch angle %.4g", number(p.body_length),
        number(p.body_width), number(p.wheelbase), number(p.hitch_length), number(p.min_speed), number(p.max_speed),
        number(p.max_steering), p.self_collision_gap, number(p.max_hitch_angle));
  } else if (r.model == Model::diff_drive) {
    const DifferentialDriveParameters& p = r.drive;
    add(" body %.4g x %.4g radius %.4g track %.4g wheels %.4g accel %.4g", number(p.body_length), number(p.body_width),
        number(p.wheel_radius), number(p.track_width), number(p.max_wheel_speed), number(p.max_wheel_acceleration));
  } else {
    const ChainParameters& p = r.chain;
    add(" body %.4g x %.4g base %.4g hitch %.4g v %.4g..%.4g steer %.4g a %.4g rate %.4g gap %d hitch angle %.4g",
        number(p.body_length), number(p.body_width), number(p.wheelbase), number(p.hitch_length), number(p.min_speed),
        number(p.max_speed), number(p.max_steering), number(p.max_acceleration), number(p.max_steering_rate),
        p.self_collision_gap, number(p.max_hitch_angle));
  }
  add("%s clearance %.3g substeps %u margin %.2g, from %.6g %.6g %.6g", r.own_bodies.empty() ? "" : " own bodies",
      number(query.parameters.clearance), query.parameters.tuning.max_substeps, number(query.parameters.goal_margin),
      number(query.start[0]), number(query.start[1]), number(query.start[2]));
  return line;
}

}  // namespace krait::campaign
