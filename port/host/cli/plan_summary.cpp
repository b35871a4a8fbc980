// SPDX-License-Identifier: Apache-2.0
#include "host/cli/plan_summary.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/run/robot_facts.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// "1 body", "3 bodies"
std::string bodies(std::size_t count) { return count == 1 ? "1 body" : printed("%zu bodies", count); }

// "goal 'dock': within 0.1 m of 18,2, heading 1.57 rad, within 0.1 rad"; "goal: within 1 m of 18,2, any heading"
std::string goal_text(const SearchRequest& request) {
  const GoalDisc& goal = *request.goal;
  std::string text = request.goal_name.empty() ? "goal" : "goal '" + request.goal_name + "'";
  text += printed(": within %.6g m of %.10g,%.10g, ", goal.radius, goal.center.x, goal.center.y);
  if (!request.facing) return text + "any heading";
  const GoalFacing& facing = *request.facing;
  text += printed("heading %.6g rad", facing.heading);
  if (facing.either_way) text += " or the opposite one";
  text += printed(", within %.6g rad", facing.tolerance);
  if (facing.hitches) text += printed(", hitches straight within %.6g rad", *facing.hitches);
  return text;
}

}  // namespace

std::string times(std::uint64_t count) { return counted(count, "time"); }

void print_summary(const SearchResult& result, const SearchRequest& request, const Ground& ground, bool asks_heading,
                   const std::optional<Clearance>& clearance) {
  const PlanFile& plan = result.plan;
  const auto& s = *plan.statistics;
  std::printf("%s: %s (%s) in %s, seed %llu: %.4f s, %llu iterations, %llu vertices\n", plan.status.c_str(),
              plan.robot.model.c_str(), bodies(plan.robot.bodies.size()).c_str(), plan.scene.c_str(),
              static_cast<unsigned long long>(plan.seed), s.at("time_s").get<double>(),
              s.at("iterations").get<unsigned long long>(), s.at("vertices").get<unsigned long long>());
  if (request.goal) {
    const bool of_map = request.facing && !asks_heading;
    std::printf("  %s%s\n", goal_text(request).c_str(), of_map ? " (--any-heading asks for the place alone)" : "");
  }
  if (result.stopped) {
    std::printf("stopped by you after %llu iterations%s\n", s.at("iterations").get<unsigned long long>(),
                plan.states.empty() ? "" : ": this is the best plan so far");
  }
  if (ground.grown > 0) {
    std::printf(
        "  the map's cells as they are (--tolerance 0): with obstacles grown by up to %.4g m there was no plan\n",
        ground.grown);
  }
  const bool no_route = plan.status == to_string(Status::no_route);  // the reason names the clearance
  if (clearance && !no_route) std::printf("  %s\n", text(*clearance, ground.map).c_str());
  for (const std::string& reason : result.why) std::printf("  %s\n", reason.c_str());
  if (plan.states.empty()) return;
  std::printf("plan: %zu steps, %.1f s, %.1f m, hash %s, verified\n", plan.controls.size(),
              s.at("plan_duration_s").get<double>(), s.at("plan_length_m").get<double>(),
              s.at("hash").get<std::string>().c_str());
}

void print_improvement(const SearchResult& result, const SearchRequest& request) {
  const auto& s = *result.plan.statistics;
  const auto improvements = s.at("improvements").get<std::uint64_t>();
  if (improvements > 0) {
    std::printf("improved %s in %.4f s: %.1f s became %.1f s, %.1f m became %.1f m\n", times(improvements).c_str(),
                s.at("improve_time_s").get<double>(), result.first.duration, s.at("plan_duration_s").get<double>(),
                result.first.length, s.at("plan_length_m").get<double>());
  } else if (result.near_shortest) {
    std::printf("the first plan was not improved\n");
  } else if (result.stopped) {
    std::printf("no better plan was found before you stopped it\n");
  } else if (result.late) {
    std::printf("no better plan was found within the time limit\n");
  } else {
    std::printf("no better plan was found in %.7g times the first plan's collision checks\n",
                s.at("improve").get<double>());
  }
  if (result.near_shortest) {
    std::printf("  longer than the shortest way by less than %.7g %%, as asked (--stop-within)\n",
                100 * request.stop_within);
  }
}

void print_quality(const SearchResult& result, const SearchRequest& request, const SceneBytes& bytes,
                   const Verdict& verdict) {
  const bool far = verdict.clearance >= kLargestClearance;
  std::printf("as driven: least clearance %s%.4g m, ", far ? "at least " : "", verdict.clearance);
  if (least_speed(request.robot) > 0) {
    std::printf("never at rest");
  } else {
    std::printf("speed at the end %.3g m/s", verdict.end_speed);
  }
  if (!std::isnan(verdict.heading_error)) std::printf(", %.3g rad off the heading", verdict.heading_error);
  const double shortest = shortest_way_of(result.plan, request, open_scene(result.plan.scene, bytes));
  const double length = result.plan.statistics->at("plan_length_m").get<double>();
  if (shortest > 0.1)
    std::printf(", %.2f times the shortest way that is wide enough (%.1f m)", length / shortest, shortest);
  std::printf("\n");
}

}  // namespace krait::host
