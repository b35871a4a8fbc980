// SPDX-License-Identifier: Apache-2.0
// What the C interface needs of a model of robot, and how it comes from the C++ class.
#pragma once

#include <cstring>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

#include "krait/krait.h"
#include "krait/krait.hpp"

// The functions of a model; one constant each, so that a program contains the models that it names.
struct krait_model {
  std::size_t front_bytes;  // of a block
  std::uint32_t (*state_size)(const krait_robot& robot);
  bool (*rest)(const krait_robot& robot, const krait_pose& pose, float* state);
  std::uint64_t (*bytes_required)(const krait::Scene& scene, const krait_robot& robot, const krait::Limits& limits);
  krait::Limits (*limits_for)(std::uint64_t bytes, const krait::Scene& scene, const krait_robot& robot,
                              std::uint32_t way_legs);
  krait::Failure (*init)(void* block, std::uint64_t bytes, const krait::Scene& scene, const krait_robot& robot,
                         const krait::Parameters& parameters, const krait::Limits& limits);
  krait::Status (*start)(krait_planner* planner, const krait::Query& query);
  krait::Status (*advance)(krait_planner* planner, std::uint64_t iterations);
  krait::Status (*improve)(krait_planner* planner, std::uint64_t iterations);
  void (*stop_for_time)(krait_planner* planner);
  krait::Failure (*failure)(const krait_planner* planner);
  krait::Contact (*contact)(krait_planner* planner);
  krait::Bottleneck (*bottleneck)(krait_planner* planner);
  krait::Effort (*effort)(const krait_planner* planner);
  krait::Statistics (*statistics)(const krait_planner* planner);
  bool (*next)(krait_planner* planner, float* state, float* control);
  void (*rewind)(krait_planner* planner);
};

// The front of a block.
struct krait_planner {
  const krait_model* model;
};

namespace krait::c {

// A structure of C as the one of C++ with the same fields in the same order, or the other way round.
template <class To, class From>
To convert(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  static_assert(std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  To to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
  return to;
}

// A robot's parameters, by their type.
template <class Parameters>
Parameters parameters_of(const krait_robot& robot) {
  if constexpr (std::is_same_v<Parameters, ChainParameters>) return convert<Parameters>(robot.parameters.chain);
  if constexpr (std::is_same_v<Parameters, UnicycleParameters>) return convert<Parameters>(robot.parameters.unicycle);
  if constexpr (std::is_same_v<Parameters, DifferentialDriveParameters>) {
    return convert<Parameters>(robot.parameters.diff_drive);
  }
}

template <class R>
R make_robot(const krait_robot& from) {
  R robot(parameters_of<std::decay_t<decltype(std::declval<R>().parameters())>>(from));
  for (int k = 0; from.bodies != nullptr && k < robot.body_count() && k < R::kMaxBodies; ++k) {
    Vec2 corners[kMaxVertices] = {};
    const krait_polygon& body = from.bodies[k];
    for (int i = 0; i < body.count && i < kMaxVertices; ++i) {
      corners[i] = {body.corners[i].x, body.corners[i].y};
    }
    robot.set_body(k, {corners, body.count});
  }
  return robot;
}

// The functions of krait_model for the robot R.
template <class R>
struct Model {
  // The front of a block; the pools lie behind it.
  struct alignas(Arena::kAlignment) Session : krait_planner {
    explicit Session(const krait_robot& from) : krait_planner{from.model}, robot(make_robot<R>(from)) {}
    R robot;
    Planner<R> planner;
    std::optional<PlanCursor<R>> cursor;  // at the state that was read last
  };

  static Session& session(krait_planner* front) { return *static_cast<Session*>(front); }
  static Planner<R>& planner(krait_planner* front) { return static_cast<Session*>(front)->planner; }
  static const Planner<R>& planner(const krait_planner* front) { return static_cast<const Session*>(front)->planner; }

  static std::uint32_t state_size(const krait_robot& from) {
    const R robot = make_robot<R>(from);
    return robot.sound() ? static_cast<std::uint32_t>(robot.state_size()) : 0;
  }

  static bool rest(const krait_robot& from, const krait_pose& pose, float* state) {
    const R robot = make_robot<R>(from);
    if (!robot.sound()) return false;
    const Vec2 position{pose.x, pose.y};
    if constexpr (std::is_base_of_v<Chain, R>) {
      const auto trailers = static_cast<std::uint32_t>(robot.body_count() - 1);
      const bool straight = pose.angle_count == 0 || trailers == 0;
      if (!straight && pose.angle_count != trailers) return false;
      robot.rest(position, pose.heading, straight ? nullptr : pose.angles, state);
    } else {
      robot.rest(position, pose.heading, state);
    }
    return true;
  }

  static std::uint64_t bytes_required(const Scene& scene, const krait_robot& from, const Limits& limits) {
    return sizeof(Session) + Planner<R>::bytes_required(scene, make_robot<R>(from), limits);
  }

  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const krait_robot& from, std::uint32_t way_legs) {
    const std::uint64_t pools = bytes < sizeof(Session) ? 0 : bytes - sizeof(Session);
    return Planner<R>::limits_for(pools, scene, make_robot<R>(from), way_legs);
  }

  // `block` has room for the front at least.
  static Failure init(void* block, std::uint64_t bytes, const Scene& scene, const krait_robot& from,
                      const Parameters& parameters, const Limits& limits) {
    auto* const session = ::new (block) Session(from);
    Failure failure =
        session->planner.init(session + 1, bytes - sizeof(Session), scene, session->robot, parameters, limits);
    if (failure.status == Status::arena_too_small) failure.bytes_needed += sizeof(Session);
    return failure;
  }

  static Status start(krait_planner* front, const Query& query) {
    rewind(front);
    return planner(front).start(query);
  }
  static Status advance(krait_planner* front, std::uint64_t iterations) { return planner(front).advance(iterations); }
  static Status improve(krait_planner* front, std::uint64_t iterations) {
    rewind(front);
    return planner(front).improve(iterations);
  }
  static void stop_for_time(krait_planner* front) { planner(front).stop_for_time(); }
  static Failure failure(const krait_planner* front) { return planner(front).failure(); }
  static Contact contact(krait_planner* front) { return planner(front).contact(); }
  static Bottleneck bottleneck(krait_planner* front) { return planner(front).bottleneck(); }
  static Effort effort(const krait_planner* front) { return planner(front).effort(); }
  static Statistics statistics(const krait_planner* front) { return planner(front).statistics(); }

  static bool next(krait_planner* front, float* state, float* control) {
    std::optional<PlanCursor<R>>& cursor = session(front).cursor;
    const Plan<R> plan = planner(front).plan();
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
  static void rewind(krait_planner* front) { session(front).cursor.reset(); }
};

template <class R>
inline constexpr krait_model kModel = {sizeof(typename Model<R>::Session),
                                       Model<R>::state_size,
                                       Model<R>::rest,
                                       Model<R>::bytes_required,
                                       Model<R>::limits_for,
                                       Model<R>::init,
                                       Model<R>::start,
                                       Model<R>::advance,
                                       Model<R>::improve,
                                       Model<R>::stop_for_time,
                                       Model<R>::failure,
                                       Model<R>::contact,
                                       Model<R>::bottleneck,
                                       Model<R>::effort,
                                       Model<R>::statistics,
                                       Model<R>::next,
                                       Model<R>::rewind};

}  // namespace krait::c
