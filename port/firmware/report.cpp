// SPDX-License-Identifier: Apache-2.0
#include "firmware/report.hpp"

#include "firmware/line.hpp"

namespace krait::firmware {
namespace {

void say(const Board& board, const char* text) { board.port.log(board.port.context, text); }

// What is wrong with an argument of the request, and what to do. The ranges are Parameters::range's, whose code
// firmware does without.
const char* hint(Argument argument, const Request& request) {
  switch (argument) {
    case Argument::clearance:
      return ": --clearance is from 0 to 10 metres";
    case Argument::dt:
      return ": --dt is from 0.001 to 1 seconds";
    case Argument::start:
      if (request.has_start) return ": --start is out of range for this robot";
      return ": the scene has no start for this robot: compile with --start X,Y,HEADING, or ask with it";
    case Argument::goal:
      if (request.has_goal) return ": --goal lies outside of the scene, or its heading or tolerance is out of range";
      return ": the scene has no goal: compile with --goal X,Y,RADIUS, or ask with it";
    default:
      return "";
  }
}

// What is wrong with a start or a goal that can be used in other scenes, and what to do.
const char* advice(Status status) {
  switch (status) {
    case Status::start_outside:
      return ": the start lies outside of the scene: ask with another --start";
    case Status::start_in_collision:
      return ": the robot has no room at the start: ask with another --start, or with less --clearance";
    case Status::goal_in_obstacle:
      return ": no free part of the goal is left: ask with another --goal";
    default:
      return "";
  }
}

// That nothing was ever written where the board looks for a scene; null: something lies there.
const char* no_scene(const Board& board) {
  constexpr std::size_t kLook = 16;  // bytes
  const auto* bytes = static_cast<const unsigned char*>(board.scene);
  if (board.scene_room < kLook || (bytes[0] != 0xFF && bytes[0] != 0)) return nullptr;
  for (std::size_t i = 1; i < kLook; ++i) {
    if (bytes[i] != bytes[0]) return nullptr;
  }
  return bytes[0] == 0 ? ": no scene lies there, only zeros: load SCENE.krait to the board's SCENE"
                       : ": no scene lies there, only erased flash: load SCENE.krait to the board's SCENE";
}

void put_bad_scene(Line& line, const Board& board, const Failure& failure) {
  const char* const nothing = no_scene(board);
  if (nothing != nullptr) {
    line.put(nothing);
    return;
  }
  line.put(": section ").put(std::uint64_t{failure.section});
  line.put(", element ").put(std::uint64_t{failure.element});
  line.put(": not a whole scene file of this version (compile it again)");
}

// Why there is no plan.
void put_reason(Line& line, const Board& board, const Request& request, const Report& report) {
  const Failure& failure = report.failure;
  line.put(to_string(failure.status));
  switch (failure.status) {
    case Status::arena_too_small:
      line.put(": the planner's block must have ").put(failure.bytes_needed);
      line.put(" bytes; this machine has room for ").put(std::uint64_t{board.arena_room});
      break;
    case Status::bad_scene:
      put_bad_scene(line, board, failure);
      break;
    case Status::bad_argument:
    case Status::bad_robot:
      line.put(": ").put(to_string(static_cast<Argument>(failure.element)));
      line.put(hint(static_cast<Argument>(failure.element), request));
      if (failure.most > 0.0F)
        line.put(", less than ").put_decimal(failure.most).put(" for a robot so fast and so short");
      break;
    default:
      if (kGivesReasons && explains(failure.status)) {
        put_why(line, failure.status, report.why);
      } else {
        line.put(advice(failure.status));
      }
  }
}

void add_failure(JsonLine& line, const Failure& failure) {
  switch (failure.status) {
    case Status::arena_too_small:
      line.add("bytes_needed", failure.bytes_needed);
      break;
    case Status::bad_scene:
      line.add("section", std::uint64_t{failure.section}).add("element", std::uint64_t{failure.element});
      break;
    case Status::bad_argument:
    case Status::bad_robot:
      line.add("argument", to_string(static_cast<Argument>(failure.element)));
      break;
    default:
      break;
  }
}

void add_statistics(JsonLine& line, const Report& report) {
  const Statistics& s = report.statistics;
  line.add_seconds("time_s", report.nanoseconds)
      .add("iterations", s.iterations)
      .add("restarts", s.restarts)
      .add("vertices", s.vertices)
      .add("recycled", s.recycled)
      .add("collision_checks", s.collision_checks)
      .add("dijkstra_runs", s.dijkstra_runs)
      .add("regions_repaired", s.regions_repaired)
      .add("plans_refused", s.plans_refused)
      .add("bytes_used", s.bytes_used)
      .add("bytes_given", s.bytes_given)
      .add("plan_steps", std::uint64_t{s.plan_steps})
      .add_decimal("plan_length_m", s.plan_length)
      .add_decimal("plan_duration_s", s.plan_duration)
      .add_decimal("plan_end_speed_m_s", s.plan_end_speed)
      .add_hash("hash", s.hash);
}

void add_improvement(JsonLine& line, const Report& report) {
  const Improvement& improvement = report.improvement;
  line.add("improvements", report.statistics.improvements)
      .add_seconds("improve_time_s", improvement.nanoseconds)
      .add("improve_iterations", improvement.iterations)
      .add("first_plan_steps", std::uint64_t{improvement.first_steps})
      .add_decimal("first_plan_length_m", improvement.first_length)
      .add_decimal("first_plan_duration_s", improvement.first_duration);
}

// A number that the machine may not have.
void add_known(JsonLine& line, const char* name, bool known, std::uint64_t number) {
  if (known) {
    line.add(name, number);
  } else {
    line.add_null(name);
  }
}

void add_machine(JsonLine& line, const Board& board, const Request& request, const Report& report) {
  const bool counts = request.clock_counts_instructions;
  add_known(line, "instructions", counts, report.nanoseconds);
  add_known(line, "instructions_setup", counts, report.setup);
  add_known(line, "instructions_worst_expansion", counts, report.slowest);
  if (request.improve > 0.0) {
    add_known(line, "instructions_improve", counts, report.improvement.nanoseconds);
    add_known(line, "instructions_worst_improvement", counts, report.improvement.slowest);
  }
  add_known(line, "stack_bytes", board.stack_bytes != nullptr, board.stack_bytes != nullptr ? board.stack_bytes() : 0);
  add_known(line, "flash_bytes", board.flash_bytes > 0, board.flash_bytes);
  add_known(line, "ram_bytes", board.ram_bytes > 0, board.ram_bytes + report.statistics.bytes_given);
}

}  // namespace

int exit_code(Status status) {
  switch (status) {
    case Status::solved:
      return kDone;
    case Status::no_route:
    case Status::budget_used:
    case Status::tree_full:
    case Status::time_used:
      return kHonestNo;
    case Status::ok:
    case Status::ready:
    case Status::searching:
    case Status::internal:
      return kOwnBug;
    default:
      return kBadInput;
  }
}

int write(const Board& board, const Request& request, const Report& report) {
  const int code = exit_code(report.failure.status);
  if (code != kDone) {
    static Line reason;  // too large for a small stack; written once
    put_reason(reason.put("krait: "), board, request, report);
    say(board, reason.end());
  }
  static JsonLine line;  // too large for a small stack, too
  line.add("machine", board.name)
      .add("status", to_string(report.failure.status))
      .add("scene", report.scene)
      .add("robot", request.robot)
      .add("seed", request.seed);
  add_failure(line, report.failure);
  if (kGivesReasons) add_why(line, report.failure.status, report.why);
  add_statistics(line, report);
  if (request.improve > 0.0) add_improvement(line, report);
  add_machine(line, board, request, report);
  say(board, line.end());
  if (code == kOwnBug) board.port.fault(board.port.context, "the planner contradicted itself");
  return code;
}

int refuse(const Board& board, const char* complaint, const char* about, const char* more) {
  say(board, "krait: ");
  say(board, complaint);
  say(board, about);
  say(board, more);
  say(board, "\n");
  return kBadInput;
}

}  // namespace krait::firmware
