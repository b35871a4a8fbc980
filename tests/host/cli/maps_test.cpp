// SPDX-License-Identifier: Apache-2.0
// From a map that a user has to a verified plan: real maps, a map that is turned, a drawing far from the origin.
#include <cmath>

#include "host/cli/campaign.hpp"
#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

std::string samples() { return test::source_path("../shared/samples"); }

class Maps : public ScratchTest {
 protected:
  Query query_of(const std::string& input, const std::string& robot) const {
    Query query;
    query.input = input;
    query.compiled = path("scene.krait");
    query.robot = parse_robot(robot.starts_with('{') ? write("robot.json", robot) : robot);
    return query;
  }

  void expect_solved(const Query& query, std::uint64_t count) const {
    ASSERT_NO_FATAL_FAILURE(compile_input(query, directory()));
    const std::string title = std::filesystem::path(query.input).filename().string() + " " + query.robot.model;
    expect_all_solved(title, query, count);
  }
};

class SampleMaps : public Maps {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(samples())) GTEST_SKIP() << "no sample maps in " << samples();
  }

  Query sample(const std::string& map, const std::string& robot) const {
    return query_of(samples() + "/" + map, robot);
  }
};

constexpr const char* kDepotUnicycle =
    R"({"model": "unicycle", "parameters": {"body_length": 0.342, "body_width": 0.339, "max_speed": 0.46}})";
constexpr const char* kDepotCar = R"({"model": "car", "links": 0, "parameters": {"body_length": 0.342,
    "body_width": 0.339, "max_speed": 0.46, "wheelbase": 0.2, "max_steering": 0.7}})";
constexpr const char* kBurger =
    R"({"model": "unicycle", "parameters": {"body_length": 0.138, "body_width": 0.178, "max_speed": 0.22}})";
constexpr const char* kBurgerCar = R"({"model": "car", "links": 0, "parameters": {"body_length": 0.138,
    "body_width": 0.178, "max_speed": 0.22, "wheelbase": 0.1, "max_steering": 0.7}})";

TEST_F(SampleMaps, Depot) {
  for (const char* robot : {kDepotUnicycle, kDepotCar}) {
    Query query = sample("nav2/depot.yaml", robot);
    query.import.unknown = Unknown::occupied;
    query.start = StartPose{{2, 2}, 0};
    query.goal = GoalDisc{{28, 13}, 0.3};
    expect_solved(query, seeds(5, 20));
  }
}

TEST_F(SampleMaps, TurtleBot3) {
  for (const char* map : {"turtlebot3/map.yaml", "nav2/tb3_sandbox.yaml"}) {
    for (const char* robot : {kBurger, kBurgerCar}) {
      Query query = sample(map, robot);
      query.start = StartPose{{-2, -0.5}, 0};
      query.goal = GoalDisc{{2, 0.5}, 0.2};
      expect_solved(query, seeds(5, 20));
    }
  }
}

TEST_F(SampleMaps, Maze) {
  Query query = sample("mir/maze.yaml", "unicycle");
  query.start = StartPose{{4, 10.2}, 0};
  query.goal = GoalDisc{{16, 10.2}, 0.5};
  expect_solved(query, seeds(3, 20));
}

TEST_F(SampleMaps, KarlKurzer) {
  Query query = sample("karlkurzer/map.yaml", "car");
  query.start = StartPose{{6, 6}, 0};
  query.goal = GoalDisc{{70, 70}, 1.5};
  expect_solved(query, seeds(5, 20));
}

TEST_F(SampleMaps, Arena) {
  Query query = sample("movingai/arena.map", "truck:1");
  query.start = StartPose{{4.5, 24.5}, 0};
  query.goal = GoalDisc{{44.5, 24.5}, 1};
  expect_solved(query, seeds(5, 20));
}

TEST_F(SampleMaps, Den312d) {
  Query query = sample("movingai/den312d.map", "diff_drive");
  // The longest of den312d.map.scen: from column 60, row 12 to column 63, row 76, counted from the top.
  query.start = StartPose{{60.5, 81 - 12.5}, 0};
  query.goal = GoalDisc{{63.5, 81 - 76.5}, 0.4};
  expect_solved(query, seeds(3, 20));
}

TEST_F(SampleMaps, Dynobench) {
  const char* robot = R"({"model": "unicycle", "parameters": {"body_length": 0.5, "body_width": 0.25,
      "max_speed": 0.5, "min_speed": -0.5, "max_turn_rate": 0.5}})";
  expect_solved(sample("dynobench/bugtrap_0.yaml", robot), seeds(5, 20));
  expect_solved(sample("dynobench/parallelpark_0.yaml", robot), seeds(5, 20));
}

// A wall with one door, moved by (x, y).
std::string room_at(double x, double y) {
  const auto at = [&](double px, double py) {
    char text[64];
    std::snprintf(text, sizeof text, "[%.17g, %.17g]", x + px, y + py);
    return std::string(text);
  };
  return R"({"name": "far", "bounds": {"min": )" + at(0, 0) + R"(, "max": )" + at(40, 20) +
         R"(}, "obstacles": [{"box": {"center": )" + at(20, 4.5) + R"(, "size": [1, 9], "angle": 0}},
             {"box": {"center": )" +
         at(20, 15.7) + R"(, "size": [1, 8.6], "angle": 0}}],
             "goals": [{"name": "goal", "box": {"center": )" +
         at(35, 10) + R"(, "size": [3, 3], "angle": 0.3}}],
             "starts": [{"name": "start", "position": )" +
         at(12, 4) + R"(, "heading": 0.5}]})";
}

TEST_F(Maps, FarFromTheOrigin) {
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1e6, -1e6}, {-5'000'000.125, 9'000'000.0}}) {
    Query query = query_of(write("far.json", room_at(x, y)), "truck:2");
    expect_solved(query, seeds(3, 20));
    query.start = StartPose{{x + 8, y + 16}, -0.5};
    query.goal = GoalDisc{{x + 35, y + 4}, 0.5};
    expect_solved(query, seeds(3, 20));
  }
}

// 160 x 80 cells of 0.1 m, a wall from column 80 on with a door in rows 30 to 49, turned by `yaw` about its corner.
std::string turned_map(double yaw) {
  char text[200];
  std::snprintf(text, sizeof text,
                "image: turned.pgm\nresolution: 0.1\norigin: [3, -2, %g]\nnegate: 0\noccupied_thresh: 0.65\n"
                "free_thresh: 0.196\n",
                yaw);
  return text;
}

std::string wall_with_a_door() {
  std::string image = "P5\n160 80\n255\n";
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 160; ++column) {
      const bool wall = column >= 80 && column < 84 && (row < 30 || row >= 50);
      image += static_cast<char>(wall ? 0 : 254);
    }
  }
  return image;
}

TEST_F(Maps, Turned) {
  write("turned.pgm", wall_with_a_door());
  for (const double yaw : {0.0, 0.7, -2.5, 1.5707963267948966}) {
    const auto world = [yaw](double x, double y) {
      return Point{3 + x * std::cos(yaw) - y * std::sin(yaw), -2 + x * std::sin(yaw) + y * std::cos(yaw)};
    };
    for (const char* robot : {"car", "unicycle"}) {
      Query query = query_of(write("turned.yaml", turned_map(yaw)), robot);
      query.start = StartPose{world(3, 2), yaw};
      query.goal = GoalDisc{world(14, 6), 0.5};
      expect_solved(query, seeds(2, 20));
    }
  }
}

}  // namespace
}  // namespace krait::host
