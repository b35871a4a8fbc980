// SPDX-License-Identifier: Apache-2.0
#include "host/run/robot_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/run/robots.hpp"
#include "host/verify/dynamics.hpp"
#include "host/workspace/printed.hpp"
#include "host/workspace/ring.hpp"
#include "motion/rk4.hpp"
#include "robot/shape.hpp"

namespace krait::host {
namespace {

double parameter(const RobotSpec& robot, const char* name) { return robot.parameters.at(name); }

// Whether it has front wheels whose lock these names describe.
bool has_steering(const RobotSpec& robot) {
  return robot.parameters.contains("max_steering") && robot.parameters.contains("wheelbase");
}

double distance_to_edge(const Point& p, const Point& a, const Point& b) {
  const Point along{b.x - a.x, b.y - a.y};
  const double square = along.x * along.x + along.y * along.y;
  const double share = std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square, 0.0, 1.0);
  return std::hypot(a.x + share * along.x - p.x, a.y + share * along.y - p.y);
}

// Of a convex ring, counter-clockwise.
bool inside(const Point& p, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

void measure_sweep(SteadyTurn& turn, const RobotSpec& robot, std::size_t count) {
  const Point center{0, turn.radius};
  const std::vector<Ring> bodies = bodies_in(turn, robot);
  turn.inner = std::numeric_limits<double>::infinity();
  turn.outer = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Ring& ring = bodies[k];
    if (inside(center, ring)) turn.inner = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      turn.outer = std::max(turn.outer, std::hypot(ring[i].x - center.x, ring[i].y - center.y));
      turn.inner = std::min(turn.inner, distance_to_edge(center, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
}

// The sine of the first hitch angle in a steady turn at this steering angle: hitch length times turn rate over the
// speed s that pulls the trailers, v of a snake, that of the rear axle of others. It may be above 1.
double first_sine(const RobotSpec& robot, double steering) {
  const double ratio = parameter(robot, "hitch_length") / parameter(robot, "wheelbase");
  return ratio * (robot.model == "snake" ? std::sin(steering) : std::tan(steering));
}

double steering_of(const RobotSpec& robot, double sine) {
  const double ratio = parameter(robot, "wheelbase") / parameter(robot, "hitch_length");
  return robot.model == "snake" ? std::asin(ratio * sine) : std::atan(ratio * sine);
}

// The largest first_sine of a steady turn. With q the first sine, the sine of hitch angle i is q over the root of
// 1 - (i - 1) q^2, since each body is pulled by what the cosine of the hitch angle leaves; the last one is the largest,
// and none of a steady turn is above a right angle.
double largest_first_sine(const RobotSpec& robot) {
  const double sine = std::sin(std::min(parameter(robot, "max_hitch_angle"), 0.5 * std::numbers::pi));
  return sine / std::sqrt(1 + (robot.links - 1) * sine * sine);
}

std::vector<double> steady_hitch_angles(double sine, int links) {
  std::vector<double> angles;
  double left = 1;
  for (int i = 0; i < links; ++i) {
    angles.push_back(std::asin(std::min(1.0, sine / left)));
    left *= std::cos(angles.back());
  }
  return angles;
}

// Of one body on an axle, which turns on the spot unless it must move.
void planar_turn_facts(const RobotSpec& robot, RobotFacts& facts) {
  SteadyTurn& turn = facts.tightest;
  turn.radius = facts.lock_radius;
  measure_sweep(turn, robot, 1);
  turn.swept_width = turn.radius > 0 ? turn.outer - turn.inner : 2 * turn.outer;
  facts.lock_outer = turn.outer;
}

void turn_facts(const RobotSpec& robot, RobotFacts& facts) {
  facts.lock_radius = lock_radius(robot);
  if (!has_steering(robot)) return planar_turn_facts(robot, facts);
  double steering = parameter(robot, "max_steering");
  SteadyTurn& turn = facts.tightest;
  if (robot.links > 0) {
    const double most = largest_first_sine(robot);
    facts.folds_at_lock = first_sine(robot, steering) > most;
    if (facts.folds_at_lock) steering = steering_of(robot, most / decimal(Chain::kTurnReserve));
    turn.hitch_angles = steady_hitch_angles(first_sine(robot, steering), robot.links);
  }
  turn.radius = parameter(robot, "wheelbase") / std::tan(steering);
  SteadyTurn lock{facts.lock_radius, turn.hitch_angles};
  measure_sweep(lock, robot, 1);
  facts.lock_outer = lock.outer;
  measure_sweep(turn, robot, robot.bodies.size());
  turn.swept_width = turn.outer - turn.inner;
}

void speed_facts(const RobotSpec& robot, const CoreRobot& core, RobotFacts& facts) {
  facts.least_speed = least_speed(robot);
  const double braking = decimal(core.extremes().braking);
  facts.top_speed = decimal(core.visit([](const auto& model) { return model.top_speed(); }));
  facts.stops_at_once = braking == 0;
  if (facts.stops_at_once) return;
  facts.stopping_time = facts.top_speed / braking;
  facts.stopping_distance = 0.5 * facts.top_speed * facts.stopping_time;
}

// Metres, of the body that is off most after a second: the core's steps of dt, as a plan is driven, against the
// verifier's of a hundredth, in double precision.
double error_of_steps(const RobotSpec& robot, const CoreRobot& any, double dt, int parts) {
  const Dynamics dynamics(robot);
  const Robot core = any.view();
  float states[2][kMaxState] = {};
  float held[kMaxControl] = {};
  any.visit([&](const auto& model) { model.turn_fastest(states[0], held); });
  State exact(states[0], states[0] + core.state_size());
  const Control control(held, held + core.control_size());
  const int steps = std::max(1, static_cast<int>(std::lround(1 / dt)));
  for (int i = 0; i < steps; ++i) {
    krait::Pose poses[kMaxBodies];
    core.place(states[i % 2], poses);
    detail::propagate_in_parts(core, states[i % 2], poses, held, static_cast<float>(dt), parts, states[1 - i % 2]);
    exact = dynamics.integrate(exact, control, dt, 100).back();
  }
  const float* const end = states[steps % 2];
  const std::vector<Frame> off = dynamics.frames(State(end, end + exact.size()));
  const std::vector<Frame> right = dynamics.frames(exact);
  double error = 0;
  for (std::size_t k = 0; k < off.size(); ++k) {
    error = std::max(error, std::hypot(off[k].origin.x - right[k].origin.x, off[k].origin.y - right[k].origin.y));
  }
  return error;
}

// Metres that the steered axle lies outside of body 0, ahead or behind; 0: inside, or none.
double front_axle_out(const RobotSpec& robot) {
  if (!has_steering(robot)) return 0;
  const auto by_x = [](const Point& a, const Point& b) { return a.x < b.x; };
  const auto [back, front] = std::minmax_element(robot.bodies[0].begin(), robot.bodies[0].end(), by_x);
  const double axle = parameter(robot, "wheelbase");
  return std::max({0.0, axle - front->x, back->x - axle});
}

// "body_length 450 m", "body 1 reaches 450 m from its axle"
std::string size_of_body(const RobotSpec& robot, int k, double reach) {
  const auto body = static_cast<std::size_t>(k);
  if (!same_ring(robot.bodies[body], default_bodies(robot)[body])) {
    return printed("body %d reaches %.4g m from its axle", k, reach);
  }
  const char* const larger =
      parameter(robot, "body_length") < parameter(robot, "body_width") ? "body_width" : "body_length";
  return printed("%s %.7g m", larger, parameter(robot, larger));
}

// Of a robot with a body that the core cannot use.
std::string why_no_body(const RobotSpec& robot, const Robot& core) {
  int k = 0;
  while (detail::usable_body(core.body(k))) ++k;
  const Polygon body = core.body(k);
  const float reach = detail::farthest(body.vertices, body.count);
  if (reach > detail::kMaxExtent) {
    return size_of_body(robot, k, static_cast<double>(reach)) +
           ": bodies must lie within 100 m of their axles; were centimetres meant?";
  }
  return printed("body %d: a side is shorter than 0.1 mm, or a corner next to straight", k);
}

}  // namespace

std::string axle_warning(const RobotSpec& robot) {
  const double out = front_axle_out(robot);
  if (!(out > 0)) return "";
  return printed("the steered axle lies %.4g m outside of body 0", out) +
         (robot.model == "car"
              ? ": is body_length, or a body's polygon, what it should be?"
              : ": a " + robot.model + "'s box is centred on its rear axle; bodies in a ROBOT.json place it");
}

double least_speed(const RobotSpec& robot) {
  const auto least = robot.parameters.find("min_speed");
  return least == robot.parameters.end() ? 0 : std::max(0.0, least->second);
}

double lock_radius(const RobotSpec& robot) {
  if (has_steering(robot)) return parameter(robot, "wheelbase") / std::tan(parameter(robot, "max_steering"));
  return decimal(CoreRobot(robot).visit([](const auto& model) { return model.turning_radius(); }));
}

std::vector<Ring> bodies_in(const SteadyTurn& turn, const RobotSpec& robot) {
  std::vector<Ring> bodies;
  Point origin;
  double heading = 0;
  for (std::size_t k = 0; k < robot.bodies.size(); ++k) {
    if (k > 0) {
      heading -= turn.hitch_angles[k - 1];
      origin = placed(Point{-parameter(robot, "hitch_length"), 0}, origin, heading);
    }
    bodies.push_back(placed(robot.bodies[k], origin, heading));
  }
  return bodies;
}

void require_usable(const std::string& name, const RobotSpec& robot) {
  const CoreRobot core(robot);
  const Argument bad = detail::first_bad_of_robot(core.view());
  if (bad == Argument::none) return;
  throw InputError(name + ": " +
                   (bad == Argument::robot_polygon ? why_no_body(robot, core.view())
                                                   : std::string(krait::to_string(bad)) + " cannot be used"));
}

RobotFacts facts_of(const std::string& name, const RobotSpec& robot, const Parameters& parameters) {
  require_usable(name, robot);
  RobotFacts facts;
  const CoreRobot core(robot);
  const Robot view = core.view();
  const RobotExtent extent = extent_of(core, parameters);
  facts.tree_parts = extent.tree_parts;
  facts.plan_parts = extent.plan_parts;
  facts.fastest_rate = static_cast<double>(view.fastest_rate(parameters.dt));
  facts.longest_time_step = static_cast<double>(
      detail::can_integrate(view, parameters.dt) ? parameters.dt : detail::longest_time_step(view, parameters.dt));
  if (!(facts.longest_time_step < decimal(parameters.dt))) {
    facts.step_error = error_of_steps(robot, core, decimal(parameters.dt), facts.plan_parts);
  }
  speed_facts(robot, core, facts);
  turn_facts(robot, facts);
  return facts;
}

}  // namespace krait::host
