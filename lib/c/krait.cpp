// SPDX-License-Identifier: Apache-2.0
// The functions of krait.h, of any model.
#include "krait/krait.h"

#include <cstddef>
#include <optional>

#include "c/model.hpp"

namespace krait::c {
namespace {

// What a krait_planner is: the front of a block. The robot lies behind it, then the pools.
struct Front {
  Planner planner;
  std::optional<PlanCursor> cursor;  // at the state that was read last
};

}  // namespace
}  // namespace krait::c

namespace {

using krait::c::Front;

using krait::Status;
using krait::c::convert;
using krait::c::is_made;

static_assert(sizeof(krait_scene) >= sizeof(krait::Scene) && alignof(krait_scene) >= alignof(krait::Scene));
static_assert(KRAIT_MAX_TRAILERS == krait::kMaxTrailers && KRAIT_MAX_STATE == krait::kMaxState);
static_assert(KRAIT_MAX_CONTROL == krait::kMaxControl && KRAIT_MAX_BODIES == krait::kMaxBodies);
static_assert(KRAIT_NONE == krait::kNone);

// The C enumeration numbers as the C++ one does; first, last and one between them stand for all.
static_assert(KRAIT_OK == static_cast<int>(Status::ok));
static_assert(KRAIT_SOLVED == static_cast<int>(Status::solved));
static_assert(KRAIT_BAD_SCENE == static_cast<int>(Status::bad_scene));
static_assert(KRAIT_INTERNAL == static_cast<int>(Status::internal));

static_assert(KRAIT_WITH_GROUND == static_cast<int>(krait::ContactKind::ground));

static_assert(sizeof(krait_parameters) == sizeof(krait::Parameters));

krait::Parameters parameters_of(const krait_parameters& from) {
  krait::Parameters to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof from);
  return to;
}

krait_status status_of(Status status) { return static_cast<krait_status>(status); }

krait_failure failure_of(const krait::Failure& failure) { return convert<krait_failure>(failure); }

krait_failure refusal(krait_status status, krait::Argument argument) {
  return {status, 0, static_cast<std::uint32_t>(argument), 0, 0.0F};
}

const krait::Scene& view(const krait_scene* scene) {
  return *std::launder(reinterpret_cast<const krait::Scene*>(scene));
}

krait_goal disc(std::uint32_t index, float x, float y, float radius) {
  return {index, x, y, radius, 0.0F, 0.0F, 0.0F, false};
}

// Fields that contradict each other become a goal that is refused.
krait::Goal goal_of(const krait_goal& from) {
  const bool turned = from.heading_tolerance != 0.0F || from.hitch_tolerance != 0.0F || from.either_way;
  krait::Facing facing{from.heading, from.heading_tolerance, from.either_way};
  if (from.hitch_tolerance != 0.0F) facing.hitches = from.hitch_tolerance;
  if (from.index != KRAIT_NONE) return krait::Goal::named(turned ? krait::kNone : from.index);
  const krait::Vec2 center{from.x, from.y};
  return turned ? krait::Goal::pose(center, from.radius, facing) : krait::Goal::disc(center, from.radius);
}

Front& front_of(krait_planner* planner) { return *std::launder(reinterpret_cast<Front*>(planner)); }
const Front& front_of(const krait_planner* planner) { return *std::launder(reinterpret_cast<const Front*>(planner)); }

constexpr std::uint64_t aligned(std::uint64_t bytes) {
  constexpr std::uint64_t kStep = krait::Setup::kAlignment;
  return (bytes + kStep - 1) / kStep * kStep;
}

static_assert(alignof(Front) <= krait::Setup::kAlignment);

// A robot on the stack, for one call.
class MadeRobot {
 public:
  explicit MadeRobot(const krait_robot& from) : robot_(from.model->make(place_, from)) {}
  MadeRobot(const MadeRobot&) = delete;
  MadeRobot& operator=(const MadeRobot&) = delete;

  const krait::Robot& robot() const { return robot_; }
  bool usable() const { return robot_.sound() && robot_.sizes_valid(); }

 private:
  alignas(krait::Setup::kAlignment) std::byte place_[krait::c::kMostRobotBytes];
  krait::Robot robot_;
};

// Bytes before the pools.
std::uint64_t front_bytes(const krait_robot& robot) {
  return aligned(sizeof(Front)) + aligned(robot.model->robot_bytes);
}

}  // namespace

const char* krait_status_name(krait_status status) { return krait::to_string(static_cast<Status>(status)); }

const char* krait_argument_name(uint32_t element) {
  return krait::to_string(static_cast<krait::Argument>(element <= 0xFF ? element : 0xFF));  // an index may be larger
}

void krait_sin_cos(float angle, float* sine, float* cosine) {
  const krait::SinCos at = krait::math::sin_cos(angle);
  *sine = at.sin;
  *cosine = at.cos;
}

float krait_atan2(float y, float x) { return krait::math::atan2(y, x); }

krait_failure krait_open(krait_scene* scene, const void* file, size_t file_bytes) {
  return failure_of(krait::Scene::open(file, file_bytes, *::new (scene) krait::Scene));
}

krait_scene_facts krait_facts(const krait_scene* scene) {
  const krait::Scene& s = view(scene);
  const krait::Box bounds = s.bounds();
  return {s.name(),     s.header().origin_x, s.header().origin_y, bounds.min.x,   bounds.min.y,
          bounds.max.x, bounds.max.y,        s.goal_count(),      s.start_count()};
}

krait_pose krait_start_pose(const krait_scene* scene, uint32_t start) {
  const krait::ScenePose pose = view(scene).start(start);
  return {pose.position.x, pose.position.y, pose.heading, pose.angles, pose.angle_count};
}

const char* krait_goal_name(const krait_scene* scene, uint32_t goal) { return view(scene).goal_name(goal); }

uint32_t krait_find_goal(const krait_scene* scene, const char* name) { return view(scene).find_goal(name); }

uint32_t krait_state_size(const krait_robot* robot) {
  if (!is_made(robot)) return 0;
  const MadeRobot made(*robot);
  return made.usable() ? static_cast<std::uint32_t>(made.robot().state_size()) : 0;
}

uint32_t krait_control_size(const krait_robot* robot) {
  if (!is_made(robot)) return 0;
  const MadeRobot made(*robot);
  return made.usable() ? static_cast<std::uint32_t>(made.robot().control_size()) : 0;
}

bool krait_rest(const krait_robot* robot, krait_pose pose, float* state) {
  if (!is_made(robot)) return false;
  const MadeRobot made(*robot);
  if (!made.robot().sound()) return false;
  return made.robot().rest({pose.x, pose.y}, pose.heading, pose.angles, pose.angle_count, state);
}

krait_parameters krait_default_parameters() {
  const krait::Parameters from;
  krait_parameters to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

uint64_t krait_bytes_required(const krait_scene* scene, const krait_robot* robot, const krait_limits* limits) {
  if (!is_made(robot)) return 0;
  const MadeRobot made(*robot);
  const krait::Limits from = convert<krait::Limits>(*limits);
  return front_bytes(*robot) + krait::Planner::bytes_required(view(scene), made.robot(), from);
}

krait_limits krait_limits_for(uint64_t bytes, const krait_scene* scene, const krait_robot* robot) {
  return krait_limits_to_improve(bytes, scene, robot, 0);
}

krait_limits krait_limits_to_improve(uint64_t bytes, const krait_scene* scene, const krait_robot* robot,
                                     uint32_t way_legs) {
  if (!is_made(robot)) return {};
  const std::uint64_t front = front_bytes(*robot);
  const std::uint64_t pools = bytes < front ? 0 : bytes - front;
  const MadeRobot made(*robot);
  return convert<krait_limits>(krait::Planner::limits_for(pools, view(scene), made.robot(), way_legs));
}

krait_failure krait_init(krait_planner** planner, const krait_setup* setup, const krait_parameters* parameters,
                         const krait_limits* limits) {
  *planner = nullptr;
  if (!is_made(setup->robot)) return refusal(KRAIT_BAD_ROBOT, krait::Argument::robot_sizes);
  if (setup->scene == nullptr || view(setup->scene).bytes() == 0) {
    return refusal(KRAIT_BAD_ARGUMENT, krait::Argument::scene);
  }
  const krait_robot& robot = *setup->robot;
  const krait_limits used = limits != nullptr ? *limits : convert<krait_limits>(krait::Limits());
  const krait::Argument bad = convert<krait::Limits>(used).first_bad();
  if (bad != krait::Argument::none) return refusal(KRAIT_BAD_ARGUMENT, bad);
  const std::uint64_t front = front_bytes(robot);
  if (setup->bytes < front) {
    krait_limits least = used;
    if (least.vertices == 0) least.vertices = 2;
    return {KRAIT_ARENA_TOO_SMALL, 0, 0, krait_bytes_required(setup->scene, &robot, &least), 0.0F};
  }
  if (setup->block == nullptr || reinterpret_cast<std::uintptr_t>(setup->block) % krait::Setup::kAlignment != 0) {
    return refusal(KRAIT_BAD_ARGUMENT, krait::Argument::block);
  }
  auto* const place = static_cast<std::byte*>(setup->block);
  auto* const made = ::new (setup->block) Front;
  const krait::Robot model_robot = robot.model->make(place + aligned(sizeof(Front)), robot);
  const krait_parameters turned = parameters != nullptr ? *parameters : krait_default_parameters();
  krait::Failure failure = made->planner.init({place + front, setup->bytes - front, &view(setup->scene), model_robot},
                                              parameters_of(turned), convert<krait::Limits>(used));
  if (failure.status == Status::arena_too_small) failure.bytes_needed += front;
  if (failure.ok()) *planner = reinterpret_cast<krait_planner*>(made);
  return failure_of(failure);
}

krait_goal krait_named_goal(uint32_t index) { return disc(index, 0.0F, 0.0F, 0.0F); }

krait_goal krait_disc_goal(float x, float y, float radius) { return disc(KRAIT_NONE, x, y, radius); }

krait_goal krait_pose_goal(float x, float y, float radius, float heading, float heading_tolerance) {
  const float tolerance = heading_tolerance == 0.0F ? -1.0F : heading_tolerance;  // in the struct, 0 means free
  return {KRAIT_NONE, x, y, radius, heading, tolerance, 0.0F, false};
}

krait_status krait_start(krait_planner* planner, const krait_query* query) {
  front_of(planner).cursor.reset();
  return status_of(front_of(planner).planner.start({query->start, goal_of(query->goal), query->seed}));
}

krait_status krait_advance(krait_planner* planner, uint64_t iterations) {
  return status_of(front_of(planner).planner.advance(iterations));
}

krait_status krait_improve(krait_planner* planner, uint64_t iterations) {
  front_of(planner).cursor.reset();
  return status_of(front_of(planner).planner.improve(iterations));
}

void krait_stop_for_time(krait_planner* planner) { front_of(planner).planner.stop_for_time(); }

krait_failure krait_last_failure(const krait_planner* planner) {
  return failure_of(front_of(planner).planner.failure());
}

krait_contact krait_start_contact(krait_planner* planner) {
  return convert<krait_contact>(front_of(planner).planner.contact());
}

krait_bottleneck krait_bottleneck_of(krait_planner* planner) {
  return convert<krait_bottleneck>(front_of(planner).planner.bottleneck());
}

krait_effort krait_effort_of(const krait_planner* planner) {
  return convert<krait_effort>(front_of(planner).planner.effort());
}

krait_statistics krait_statistics_of(const krait_planner* planner) {
  return convert<krait_statistics>(front_of(planner).planner.statistics());
}

bool krait_next(krait_planner* planner, float* state, float* control) {
  std::optional<krait::PlanCursor>& cursor = front_of(planner).cursor;
  const krait::Plan plan = front_of(planner).planner.plan();
  if (plan.empty() || (cursor && cursor->done())) return false;
  if (cursor) {
    cursor->advance();
  } else {
    cursor.emplace(plan.cursor());
  }
  for (int i = 0; i < plan.state_size(); ++i) state[i] = cursor->state()[i];
  for (int i = 0; i < plan.control_size(); ++i) control[i] = cursor->done() ? 0.0F : cursor->control()[i];
  return true;
}

void krait_rewind(krait_planner* planner) { front_of(planner).cursor.reset(); }
