// SPDX-License-Identifier: Apache-2.0
#include "host/run/run.hpp"

#include <chrono>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "firmware/improvement.hpp"
#include "host/input/file.hpp"
#include "host/run/session.hpp"
#include "host/run/shortest_way.hpp"
#include "host/run/standing.hpp"
#include "host/run/why.hpp"
#include "host/workspace/printed.hpp"
#include "robot/shape.hpp"

namespace krait::host {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kSlice = 64;  // expansions between looks at the clock

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// What happens beside a search: news of it are passed on, and its user may stop it.
class Company {
 public:
  Company(Session& session, const SearchRequest& request, const SearchWatch& watch, Clock::time_point begin)
      : session_(session), request_(request), watch_(watch), begin_(begin) {}

  // Whether the search is to end here, for want of time or by its user's wish.
  bool ends() {
    stopped_ = stopped_ || (watch_.stop && watch_.stop());
    const double seconds = since(begin_);
    if (watch_.tell && seconds - told_ > kBetweenNews) {
      told_ = seconds;
      tell();
    }
    late_ = request_.time_limit && seconds > *request_.time_limit;
    return stopped_ || late_;
  }
  bool stopped() const { return stopped_; }
  bool late() const { return late_; }

 private:
  static constexpr double kBetweenNews = 0.2;  // seconds

  void tell() {
    const Statistics s = session_.statistics();
    watch_.tell({s.iterations,
                 s.vertices,
                 static_cast<double>(session_.cost_to_go()),
                 s.improvements,
                 {static_cast<double>(s.plan_length), static_cast<double>(s.plan_duration)}});
  }

  Session& session_;
  const SearchRequest& request_;
  const SearchWatch& watch_;
  Clock::time_point begin_;
  double told_ = 0;
  bool stopped_ = false;
  bool late_ = false;
};

void search_to_end(Session& session, Company& company) {
  while (session.advance(kSlice) == Status::searching) {
    if (company.ends()) session.stop_for_time();
  }
}

// Metres: the width of the largest disc around the middle of body 0 that lies in it.
float disc_width(const RobotSpec& robot) {
  std::vector<Vec2> corners;
  for (const Point& p : robot.bodies[0]) corners.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
  const Polygon body{corners.data(), static_cast<int>(corners.size())};
  return 2 * detail::inner_radius(body, detail::middle(body));
}

bool near_shortest(const Session& session, const SearchRequest& request, const krait::Scene& scene) {
  PlanFile plan;
  session.copy_plan(plan);
  const auto length = static_cast<double>(session.statistics().plan_length);
  return length <= (1 + request.stop_within) * shortest_way_of(plan, request, scene);
}

// By collision checks, so that the result does not depend on the machine; without a time limit. Returns whether the
// plan became as short as asked.
bool improve(Session& session, double multiples, const SearchRequest& request, const krait::Scene& scene,
             Company& company) {
  std::optional<std::uint64_t> judged;  // by its number, the plan whose length was
  bool near = false;
  firmware::improve(session, multiples, [&] {
    if (request.stop_within > 0 && judged != session.statistics().improvements) {
      judged = session.statistics().improvements;
      near = near_shortest(session, request, scene);
    }
    return !near && session.improve(1) == Status::solved && !company.ends();
  });
  return near;
}

nlohmann::ordered_json statistics_json(const Statistics& s, double seconds) {
  return {{"time_s", seconds},
          {"iterations", s.iterations},
          {"restarts", s.restarts},
          {"vertices", s.vertices},
          {"recycled", s.recycled},
          {"collision_checks", s.collision_checks},
          {"dijkstra_runs", s.dijkstra_runs},
          {"regions_repaired", s.regions_repaired},
          {"plans_refused", s.plans_refused},
          {"bytes_used", s.bytes_used},
          {"bytes_given", s.bytes_given},
          {"plan_steps", s.plan_steps},
          {"plan_length_m", static_cast<double>(s.plan_length)},
          {"plan_duration_s", static_cast<double>(s.plan_duration)},
          {"plan_end_speed_m_s", static_cast<double>(s.plan_end_speed)},
          {"hash", printed("%016llx", static_cast<unsigned long long>(s.hash))}};
}

}  // namespace

SceneBytes SceneBytes::read(const std::string& path) {
  const std::string content = read_file(path, UINT32_MAX);
  return copy(content.data(), content.size());
}

SceneBytes SceneBytes::copy(const void* bytes, std::size_t size) {
  SceneBytes copy;
  copy.size_ = size;
  copy.words_.resize((size + 7) / 8);
  std::memcpy(copy.words_.data(), bytes, size);
  return copy;
}

std::string section_name(std::uint8_t section) {
  static constexpr const char* kNames[format::kSectionCount] = {"vertices",
                                                                "triangle_vertices",
                                                                "triangle_neighbors",
                                                                "triangle_portals",
                                                                "triangle_goals",
                                                                "portal_widths",
                                                                "goal_offsets",
                                                                "goal_vertices",
                                                                "starts",
                                                                "start_angles",
                                                                "piece_offsets",
                                                                "piece_vertices",
                                                                "piece_boxes",
                                                                "bucket_triangle_offsets",
                                                                "bucket_triangles",
                                                                "bucket_piece_offsets",
                                                                "bucket_pieces",
                                                                "clearance",
                                                                "names"};
  return section < format::kSectionCount ? kNames[section] : "header";
}

bool is_scene_file(std::string_view content) {
  return content.size() >= sizeof format::kMagic &&
         std::memcmp(content.data(), format::kMagic, sizeof format::kMagic) == 0;
}

krait::Scene open_scene(const std::string& path, const SceneBytes& bytes) {
  if (bytes.size() >= sizeof format::kMagic && std::memcmp(bytes.data(), format::kMagic, sizeof format::kMagic) != 0) {
    throw InputError(path + ": bad_scene: is no compiled scene; krait compile makes one of a map or drawing");
  }
  krait::Scene scene;
  const Failure failure = krait::Scene::open(bytes.data(), bytes.size(), scene);
  if (!failure.ok()) {
    const char* unit = failure.section == krait::Scene::kHeaderSection ? ", byte " : ", element ";
    throw InputError(path + ": bad_scene: section " + section_name(failure.section) + unit +
                     std::to_string(failure.element) + ": not a whole scene file of this version (compile it again)");
  }
  return scene;
}

double shortest_way_of(const PlanFile& plan, const SearchRequest& request, const krait::Scene& scene) {
  const auto position = [](const std::vector<float>& state) { return Vec2{state[0], state[1]}; };
  const float width = disc_width(request.robot) + 2 * request.parameters.clearance;
  return shortest_way(scene, width, position(plan.states.front()), position(plan.states.back()));
}

SearchResult run_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                        const SearchWatch& watch) {
  Block block = block_of(request);
  return run_search(scene_path, bytes, request, block, watch);
}

SearchResult run_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                        Block& block, const SearchWatch& watch) {
  Clock::time_point begin = Clock::now();
  const krait::Scene scene = open_scene(scene_path, bytes);
  const std::unique_ptr<Session> session = start_session(scene, request, block);
  const Clock::time_point asked = Clock::now();
  const bool closed = session->status() == Status::no_route;  // which has its own reason
  const std::optional<std::string> no_room = closed ? std::nullopt : why_it_never_ends(scene, request);
  begin += Clock::now() - asked;  // a search's time is what the planner takes
  Company company(*session, request, watch, begin);
  if (!no_room) search_to_end(*session, company);
  const Statistics found = session->statistics();
  const double searched = since(begin);
  const PlanMeasure first{static_cast<double>(found.plan_length), static_cast<double>(found.plan_duration)};
  const double multiples = request.multiples_of(found.collision_checks);
  const bool near_shortest =
      session->status() == Status::solved && improve(*session, multiples, request, scene, company);
  SearchResult result{session->query().form, session->query().asked, since(begin)};
  result.first = first;
  result.stopped = company.stopped();
  result.late = company.late();
  result.near_shortest = near_shortest;
  result.plan.status = to_string(no_room ? Status::no_route : session->status());
  session->copy_plan(result.plan);
  const Statistics best = session->statistics();
  nlohmann::ordered_json statistics = statistics_json(firmware::with_plan_of(found, best), searched);
  SearchRequest limited = request;
  if (result.stopped) limited.time_limit.reset();  // it was not what ended the search
  result.why = no_room ? std::vector{*no_room} : why_no_plan(*session, scene, limited);
  if (request.improve > 0) {
    statistics["improve"] = multiples;
    statistics["improvements"] = best.improvements;
    statistics["improve_time_s"] = result.seconds - searched;
    statistics["first_plan_length_m"] = first.length;
    statistics["first_plan_duration_s"] = first.duration;
  }
  result.plan.statistics = std::make_shared<const nlohmann::ordered_json>(std::move(statistics));
  return result;
}

}  // namespace krait::host
