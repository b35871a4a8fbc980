// SPDX-License-Identifier: Apache-2.0
// krait plan and krait verify by their files and exit codes: the plan's JSON field by field, the ends of a search,
// and that the same arguments give the same bytes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "host/cli/program.hpp"
#include "host/every_robot.hpp"
#include "host/robot_file/robot_file.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

class CliPlan : public CliTest {
 protected:
  // krait plan room.krait … -o plan.json, expected to end with `code`; returns the JSON.
  ordered_json plan(std::vector<std::string> options, int code = 0) const {
    std::vector<std::string> arguments = {"plan", "room.krait", "-o", "plan.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.output << outcome.errors;
    return json("plan.json");
  }

  static void expect_no_plan(const ordered_json& plan, const std::string& status) {
    EXPECT_EQ(plan.at("status"), status);
    EXPECT_EQ(plan.at("states"), ordered_json::array());
    EXPECT_EQ(plan.at("controls"), ordered_json::array());
    EXPECT_EQ(plan.at("statistics").at("hash"), "0000000000000000");
    EXPECT_EQ(plan.at("statistics").at("plan_steps"), 0);
  }
};

std::vector<std::string> keys(const ordered_json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

// FNV-1a 64 over s0, u0, s1, u1, …, sL, each number as the 4 bytes, low first, of the float that it reads back to.
class Fnv {
 public:
  void add(const ordered_json& row) {
    for (const auto& number : row) {
      const auto value = static_cast<float>(number.get<double>());
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int shift = 0; shift < 32; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xFFU)) * 0x100000001B3U;
    }
  }

  std::string text() const {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
    return text;
  }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

std::string hash_of(const ordered_json& plan) {
  Fnv fnv;
  for (std::size_t i = 0; i < plan.at("states").size(); ++i) {
    fnv.add(plan.at("states")[i]);
    if (i < plan.at("controls").size()) fnv.add(plan.at("controls")[i]);
  }
  return fnv.text();
}

std::string without_time(ordered_json plan) {
  for (const char* time : {"time_s", "improve_time_s"}) plan.at("statistics").erase(time);
  return plan.dump();
}

constexpr const char* kTinyGoal = "17,5,0.001";  // m: no search hits a millimetre
constexpr const char* kStraightOn = "5,5,0.5";   // there is no better plan than the first

TEST_F(CliPlan, HasTheFieldsOfTheFormat) {
  const ordered_json plan = this->plan({"--robot", "snake:2", "--seed", "7"});
  EXPECT_THAT(keys(plan), ElementsAre("format", "version", "status", "scene", "seed", "planner", "robot", "dt", "goal",
                                      "state_names", "control_names", "states", "controls", "origin", "statistics"));
  EXPECT_EQ(plan.at("format"), "krait-plan");
  EXPECT_EQ(plan.at("version"), 1);
  EXPECT_EQ(plan.at("status"), "solved");
  EXPECT_EQ(plan.at("scene"), "room");
  EXPECT_EQ(plan.at("seed"), 7);
  EXPECT_EQ(plan.at("planner"), "adaptive");
  EXPECT_FLOAT_EQ(plan.at("dt").get<float>(), 0.1F);
  EXPECT_EQ(plan.at("goal").at("name"), "east");
  EXPECT_EQ(plan.at("goal").at("polygon").size(), 4U);
  EXPECT_THAT(plan.at("state_names"), ElementsAre("x", "y", "theta0", "v", "psi", "theta1", "theta2"));
  EXPECT_THAT(plan.at("control_names"), ElementsAre("acceleration", "steering_rate"));
  EXPECT_THAT(plan.at("origin"), ElementsAre(0.0, 0.0));
}

TEST_F(CliPlan, StatesTheWholeRobot) {
  const ordered_json robot = plan({"--robot", "truck:2"}).at("robot");
  EXPECT_THAT(keys(robot), ElementsAre("model", "links", "parameters", "bodies"));
  EXPECT_EQ(robot.at("model"), "truck");
  EXPECT_EQ(robot.at("links"), 2);
  EXPECT_THAT(keys(robot.at("parameters")),
              testing::UnorderedElementsAre("body_length", "body_width", "wheelbase", "hitch_length", "max_speed",
                                            "min_speed", "max_steering", "max_acceleration", "max_steering_rate",
                                            "self_collision_gap", "max_hitch_angle"));
  ASSERT_EQ(robot.at("bodies").size(), 3U);
  EXPECT_EQ(robot.at("bodies")[2].at("polygon").size(), 4U);
}

TEST_F(CliPlan, HasOneStateMoreThanControlsAllInTheirLimits) {
  const ordered_json plan = this->plan({"--robot", "snake:2"});
  ASSERT_EQ(plan.at("states").size(), plan.at("controls").size() + 1);
  for (const auto& state : plan.at("states")) {
    ASSERT_EQ(state.size(), 7U);
    EXPECT_LE(std::abs(state[3].get<double>()), 2.5);
    EXPECT_LE(std::abs(state[4].get<double>()), 1.0);
  }
  for (const auto& control : plan.at("controls")) {
    ASSERT_EQ(control.size(), 2U);
    EXPECT_LE(std::abs(control[0].get<double>()), 5.0);
    EXPECT_LE(std::abs(control[1].get<double>()), 4.0);
  }
  const auto& last = plan.at("states").back();
  EXPECT_NEAR(last[0].get<double>(), 17, 1);
  EXPECT_NEAR(last[1].get<double>(), 5, 1);
}

TEST_F(CliPlan, HasTheStatisticsOfTheFormat) {
  const ordered_json plan = this->plan({"--robot", "car", "--memory", "1M", "--improve", "0"});
  const ordered_json& s = plan.at("statistics");
  EXPECT_THAT(keys(s), ElementsAre("time_s", "iterations", "restarts", "vertices", "recycled", "collision_checks",
                                   "dijkstra_runs", "regions_repaired", "plans_refused", "bytes_used", "bytes_given",
                                   "plan_steps", "plan_length_m", "plan_duration_s", "plan_end_speed_m_s", "hash"));
  for (const char* whole : {"iterations", "restarts", "vertices", "recycled", "collision_checks", "dijkstra_runs",
                            "regions_repaired", "plans_refused", "bytes_used", "bytes_given", "plan_steps"}) {
    EXPECT_TRUE(s.at(whole).is_number_unsigned()) << whole;
  }
  EXPECT_GT(s.at("time_s").get<double>(), 0);
  EXPECT_EQ(s.at("bytes_given"), 1U << 20U);
  EXPECT_LE(s.at("bytes_used").get<std::uint64_t>(), 1U << 20U);
  EXPECT_EQ(s.at("plan_steps").get<std::size_t>(), plan.at("controls").size());
  EXPECT_NEAR(s.at("plan_duration_s").get<double>(), 0.1 * static_cast<double>(plan.at("controls").size()), 1e-3);
  double length = 0;
  for (std::size_t i = 1; i < plan.at("states").size(); ++i) {
    const auto& a = plan.at("states")[i - 1];
    const auto& b = plan.at("states")[i];
    length += std::hypot(b[0].get<double>() - a[0].get<double>(), b[1].get<double>() - a[1].get<double>());
  }
  EXPECT_NEAR(s.at("plan_length_m").get<double>(), length, 1e-3 * length);
}

TEST_F(CliPlan, HashIsThatOfTheNumbersInTheFile) {
  for (const std::string& robot : every_robot(2)) {
    const ordered_json plan = this->plan({"--robot", robot});
    const std::string hash = plan.at("statistics").at("hash");
    EXPECT_THAT(hash, testing::MatchesRegex("[0-9a-f]{16}"));
    EXPECT_EQ(hash, hash_of(plan)) << robot;
  }
}

TEST_F(CliPlan, IsTheSameTwice) {
  const std::string first = without_time(plan({"--robot", "snake:5"}));
  EXPECT_EQ(without_time(plan({"--robot", "snake:5"})), first);
  EXPECT_EQ(without_time(plan({"--robot", "snake:5", "--seed", "1", "--memory", "64M", "--time-limit", "100"})), first);
}

TEST_F(CliPlan, ImprovesByTheUsualMultiplesUnlessAskedOtherwise) {
  for (const std::string& robot : every_robot(2)) {
    const ordered_json first = plan({"--robot", robot, "--seed", "3", "--improve", "0"});
    const ordered_json better = plan({"--robot", robot, "--seed", "3"});
    const ordered_json& s = better.at("statistics");
    EXPECT_FALSE(first.at("statistics").contains("improvements"));
    EXPECT_EQ(s.at("first_plan_length_m"), first.at("statistics").at("plan_length_m")) << robot;
    EXPECT_EQ(s.at("first_plan_duration_s"), first.at("statistics").at("plan_duration_s")) << robot;
    EXPECT_EQ(s.at("improvements").get<int>() > 0, better.at("controls").size() < first.at("controls").size()) << robot;
    EXPECT_EQ(s.at("hash"), hash_of(better)) << robot;
    const Outcome verdict = krait({"verify", "room.json", "plan.json", "--robot", robot});
    EXPECT_EQ(verdict.code, 0) << verdict.output << verdict.errors;
    const double multiples = s.at("improve");
    const double checks = s.at("collision_checks");
    EXPECT_GE(multiples * checks, 3e5) << robot;
    EXPECT_LT((multiples - 1) * checks, 3e5) << robot;
    EXPECT_EQ(without_time(plan({"--robot", robot, "--seed", "3", "--improve", printed("%.7g", multiples)})),
              without_time(better));
  }
}

TEST_F(CliPlan, ImprovesNoFurtherThanAsked) {
  const Arguments options = {"--robot", "car", "--seed", "3"};
  const auto with = [&](const Arguments& more) {
    Arguments all = options;
    all.insert(all.end(), more.begin(), more.end());
    return plan(all);
  };
  const ordered_json first = with({"--improve", "0"});
  const ordered_json better = with({"--improve", "30"});
  ASSERT_LT(better.at("statistics").at("plan_duration_s"), first.at("statistics").at("plan_duration_s"));
  const ordered_json far = with({"--improve", "30", "--stop-within", "1e-6"});
  EXPECT_EQ(far.at("statistics").at("hash"), better.at("statistics").at("hash"));
  const ordered_json near = with({"--improve", "30", "--stop-within", "100"});
  EXPECT_EQ(near.at("statistics").at("hash"), first.at("statistics").at("hash"));
  EXPECT_THAT(krait({"plan", "room.krait", "--robot", "car", "--stop-within", "100"}).output,
              HasSubstr("\nthe first plan was not improved\n  longer than the shortest way by less than 10000 %, as"));
}

TEST_F(CliPlan, AsksForNoShortPlanWhereTheFirstIsKept) {
  const auto refused = [&](const Arguments& options, const std::string& keeper) {
    Arguments all = {"plan", "room.krait", "--robot", "car", "--stop-within", "0.1"};
    all.insert(all.end(), options.begin(), options.end());
    expect_refused(all, "krait: --stop-within: " + keeper +
                            " keeps the first plan: leave one of them out, or give --improve a number above 0\n");
  };
  refused({"--improve", "0"}, "--improve 0");
  refused({"--paper"}, "--paper");
  refused({"--planner", "prior"}, "--planner prior");
  refused({"--planner", "rrt"}, "--planner rrt");
  const Arguments small = {"plan", "room.krait", "--robot", "car", "--stop-within", "0.1", "--memory", "512K"};
  EXPECT_EQ(krait(small).errors,
            "krait: warning: --stop-within: a --memory under 1M keeps the first plan, unless --improve is given\n");
  Arguments improved = small;
  improved.insert(improved.end(), {"--improve", "1"});
  expect_done(improved);
}

TEST_F(CliPlan, NothingIsImprovedWhereThereIsNoPlan) {
  const Outcome run = krait({"plan", "room.krait", "--robot", "car", "--iterations", "1", "--stop-within", "0.1"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, testing::StartsWith("budget_used: "));
}

// A long chain's plan is improved by searches, whose counts are not the first one's.
TEST_F(CliPlan, CountsTheSearchForTheFirstPlanAlone) {
  const ordered_json first = plan({"--robot", "snake:4", "--seed", "4", "--improve", "0"}).at("statistics");
  const ordered_json better = plan({"--robot", "snake:4", "--seed", "4"}).at("statistics");
  EXPECT_GT(better.at("improvements"), 0);
  EXPECT_LT(better.at("plan_steps"), first.at("plan_steps"));
  for (const char* count : {"iterations", "restarts", "vertices", "recycled", "collision_checks", "dijkstra_runs",
                            "regions_repaired", "plans_refused"}) {
    EXPECT_EQ(better.at(count), first.at(count)) << count;
  }
}

TEST_F(CliPlan, SaysWhatImprovementMadeOfThePlan) {
  const auto said = [this](Arguments options) {
    options.insert(options.begin(), {"plan", "room.krait", "-o", "plan.json"});
    const Outcome outcome = krait(options);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome.output;
  };
  int all = 0;
  for (const std::string& robot : every_robot(2)) {
    const std::string text = said({"--robot", robot, "--seed", "3"});
    const int count = json("plan.json").at("statistics").at("improvements");
    const std::string times = count == 1 ? "1 time" : std::to_string(count) + " times";
    EXPECT_THAT(text, HasSubstr(count > 0 ? "\nimproved " + times + " in " : "\nno better plan was found in "));
    all += count;
  }
  EXPECT_GT(all, 0);
  EXPECT_THAT(said({"--robot", "car", "--improve", "0"}), Not(HasSubstr("improved")));
  EXPECT_THAT(said({"--robot", "car", "--goal", kStraightOn, "--improve", "10"}),
              HasSubstr("\nno better plan was found in 10 times the first plan's collision checks\n"));
  const std::string usual = said({"--robot", "car", "--goal", kStraightOn});
  EXPECT_THAT(usual, HasSubstr(printed("\nno better plan was found in %.7g times the first plan's collision checks\n",
                                       json("plan.json").at("statistics").at("improve").get<double>())));
  EXPECT_THAT(said({"--robot", "car", "--goal", kStraightOn, "--improve", "1e6", "--time-limit", "0.5"}),
              HasSubstr("\nno better plan was found within the time limit\n"));
}

// Of a rival, of the paper's algorithm, and where there is little memory.
TEST_F(CliPlan, DoesNotImproveUnaskedWhereTheFirstPlanIsWanted) {
  const std::vector<Arguments> all = {
      {"--planner", "prior"}, {"--planner", "rrt"}, {"--paper"}, {"--memory", "1048575"}};
  for (Arguments options : all) {
    options.insert(options.end(), {"--robot", "car", "--seed", "3"});
    const ordered_json unasked = plan(options);
    options.insert(options.end(), {"--improve", "0"});
    EXPECT_EQ(without_time(plan(options)), without_time(unasked)) << options.front();
    options.back() = "10";
    EXPECT_TRUE(plan(options).at("statistics").contains("improvements")) << options.front();
  }
}

TEST_F(CliPlan, ImprovesPlansToPoses) {
  int better = 0;
  for (const std::string& robot : every_robot(2)) {
    for (const char* heading : {"0", "1.57", "3.14"}) {
      const std::vector<std::string> pose = {"--goal", "15,8,0.2", "--heading", heading};
      std::vector<std::string> options = {"--robot", robot, "--seed", "10001", "--improve", "20"};
      options.insert(options.end(), pose.begin(), pose.end());
      if (plan(options).at("statistics").at("improvements").get<int>() > 0) ++better;
      std::vector<std::string> judged = {"verify", "room.json", "plan.json", "--robot", robot};
      judged.insert(judged.end(), pose.begin(), pose.end());
      const Outcome verdict = krait(judged);
      EXPECT_EQ(verdict.code, 0) << verdict.output << verdict.errors;
    }
  }
  EXPECT_GE(better, 10);  // of 15
}

TEST_F(CliPlan, RefusesToImproveByWhatIsNoNumber) {
  for (const char* times : {"-1", "1e7", "much", "nan"}) {
    EXPECT_EQ(krait({"plan", "room.krait", "--robot", "car", "--improve", times}).code, 2) << times;
  }
}

TEST_F(CliPlan, DependsOnTheSeed) {
  const ordered_json one = plan({"--robot", "car", "--seed", "1"});
  const ordered_json two = plan({"--robot", "car", "--seed", "18446744073709551615"});
  EXPECT_EQ(two.at("seed").get<std::uint64_t>(), UINT64_MAX);
  EXPECT_NE(one.at("statistics").at("hash"), two.at("statistics").at("hash"));
}

TEST_F(CliPlan, EqualsItsRobotGivenAsAFile) {
  const ordered_json by_name = plan({"--robot", "truck:1"});
  write("robot.json", by_name.at("robot").dump());
  EXPECT_EQ(without_time(plan({"--robot", "robot.json"})), without_time(by_name));
}

TEST_F(CliPlan, TakesGoalsByNameAndAsADiscWithoutCompilingAgain) {
  plan({"--robot", "car", "--goal", "south"});
  expect_done({"verify", "room.json", "plan.json", "--robot", "car", "--goal", "south"});
  EXPECT_EQ(krait({"verify", "room.json", "plan.json", "--robot", "car"}).code, 1);
  const ordered_json disc = plan({"--robot", "car", "--goal", "15,8,0.5"});
  const auto& last = disc.at("states").back();
  EXPECT_LE(std::hypot(last[0].get<double>() - 15, last[1].get<double>() - 8), 0.5);
  for (const auto& p : disc.at("goal").at("polygon")) {
    EXPECT_LE(std::hypot(p[0].get<double>() - 15, p[1].get<double>() - 8), 0.5 + 1e-6);
  }
  expect_done({"verify", "room.json", "plan.json", "--robot", "car", "--goal", "15,8,0.5"});
}

TEST_F(CliPlan, TakesStartsByNameAndAsAPose) {
  const ordered_json pose = plan({"--robot", "unicycle", "--start", "4,2,1.5"});
  EXPECT_THAT(pose.at("states")[0], ElementsAre(4, 2, 1.5));
  const ordered_json named = plan({"--robot", "truck:2", "--start", "north"});
  const std::vector<double> first = named.at("states")[0];
  const std::vector<double> asked = {3, 8, -0.5, 0, 0, -0.4, -0.2};
  EXPECT_THAT(first, testing::Pointwise(testing::DoubleNear(1e-6), asked));
  expect_done({"verify", "room.json", "plan.json", "--robot", "truck:2", "--start", "north"});
}

TEST_F(CliPlan, BeginsInTheGoalWithAnEmptyPlan) {
  EXPECT_THAT(krait({"plan", "room.krait", "--robot", "car", "--goal", "3,5,1"}).output, Not(HasSubstr("better plan")));
  const ordered_json plan = this->plan({"--robot", "car", "--goal", "3,5,1"});
  EXPECT_EQ(plan.at("status"), "solved");
  EXPECT_EQ(plan.at("states").size(), 1U);
  EXPECT_EQ(plan.at("controls").size(), 0U);
  EXPECT_EQ(plan.at("statistics").at("hash"), hash_of(plan));
  expect_done({"verify", "room.json", "plan.json", "--robot", "car", "--goal", "3,5,1"});
}

TEST_F(CliPlan, ARobotWiderThanEveryDoorHasNoRouteAtOnce) {
  write("wide.json", R"({"model": "unicycle", "parameters": {"body_length": 3, "body_width": 3}})");
  const ordered_json plan = this->plan({"--robot", "wide.json"}, 1);
  expect_no_plan(plan, "no_route");
  EXPECT_EQ(plan.at("statistics").at("iterations"), 0);
}

// Its rear axle alone would fit through the door: there are 0.7 m of body behind it.
TEST_F(CliPlan, ACarWiderThanTheDoorHasNoRouteAtOnce) {
  write("door.json", R"({"name": "door", "bounds": {"min": [0, 0], "max": [30, 20]},
    "obstacles": [{"box": {"center": [15, 4.5], "size": [1, 9]}}, {"box": {"center": [15, 15.5], "size": [1, 9]}}],
    "goals": [{"name": "far", "box": {"center": [25, 10], "size": [2, 2]}}],
    "starts": [{"name": "near", "position": [5, 10], "heading": 0}]})");
  expect_done({"compile", "door.json", "-o", "door.krait"});
  const auto car = [&](const char* width) {
    write("wide.json",
          std::string(R"({"model": "car", "parameters": {"body_length": 4, "wheelbase": 2.6, "body_width": )") + width +
              "}}");
    krait({"plan", "door.krait", "--robot", "wide.json", "-o", "plan.json"});
    return ordered_json::parse(read_text(path("plan.json")));
  };
  EXPECT_EQ(car("1.2").at("status"), "solved");
  const ordered_json plan = car("2.2");
  expect_no_plan(plan, "no_route");
  EXPECT_EQ(plan.at("statistics").at("iterations"), 0);
}

TEST_F(CliPlan, EndsWithTheBudget) {
  const ordered_json plan = this->plan({"--robot", "snake:15", "--iterations", "1"}, 1);
  expect_no_plan(plan, "budget_used");
  EXPECT_EQ(plan.at("statistics").at("iterations"), 1);
}

TEST_F(CliPlan, EndsWithTheTime) {
  const ordered_json plan = this->plan({"--robot", "snake:15", "--goal", kTinyGoal, "--time-limit", "0.001"}, 1);
  expect_no_plan(plan, "time_used");
  EXPECT_LT(plan.at("statistics").at("time_s").get<double>(), 1);
}

TEST_F(CliPlan, EndsWithTheMemory) {
  const ordered_json plan =
      this->plan({"--robot", "car", "--goal", kTinyGoal, "--memory", "64K", "--planner", "rrt"}, 1);
  expect_no_plan(plan, "tree_full");
  EXPECT_LE(plan.at("statistics").at("bytes_used").get<std::uint64_t>(), 64U << 10U);
}

TEST_F(CliPlan, GoesOnInFullMemory) {
  const ordered_json plan =
      this->plan({"--robot", "car", "--goal", kTinyGoal, "--memory", "24K", "--iterations", "2000"}, 1);
  expect_no_plan(plan, "budget_used");
  EXPECT_GT(plan.at("statistics").at("recycled"), 0);
  EXPECT_LE(plan.at("statistics").at("bytes_used").get<std::uint64_t>(), 24U << 10U);
}

TEST_F(CliPlan, TheMemoryThatItAsksForIsEnoughAndNoByteLess) {
  const std::string complaint = krait({"plan", "room.krait", "--robot", "car", "--memory", "0"}).errors;
  const std::size_t at = complaint.find("at least ");
  ASSERT_NE(at, std::string::npos) << complaint;
  const std::uint64_t needed = std::stoull(complaint.substr(at + 9));
  expect_no_plan(plan({"--robot", "car", "--memory", std::to_string(needed), "--iterations", "2"}, 1), "budget_used");
  std::filesystem::remove(path("plan.json"));
  expect_refused({"plan", "room.krait", "--robot", "car", "-o", "plan.json", "--memory", std::to_string(needed - 1)},
                 "at least " + std::to_string(needed));
}

// Improvement takes a share of the block, so that a larger one must have more room for it.
TEST_F(CliPlan, TheMemoryThatItAsksForIsEnoughToImproveToo) {
  expect_done({"scene", "openings", "-o", "openings.json"});
  expect_done({"compile", "openings.json", "-o", "openings.krait"});
  const auto in = [this](const std::string& memory) {
    return krait(
        {"plan", "openings.krait", "--robot", "car", "--iterations", "1", "--improve", "1", "--memory", memory});
  };
  const std::string complaint = in("0").errors;
  const std::size_t at = complaint.find("at least ");
  ASSERT_NE(at, std::string::npos) << complaint;
  EXPECT_EQ(in(std::to_string(std::stoull(complaint.substr(at + 9)))).code, 1) << complaint;
}

TEST_F(CliPlan, PaperRunsAndSaysWhetherItsPlanHolds) {
  const Outcome outcome = krait({"plan", "room.krait", "--robot", "snake:5", "--paper", "-o", "plan.json"});
  const std::string status = json("plan.json").at("status");
  EXPECT_EQ(outcome.code, status == "solved" ? 0 : 1) << outcome.errors;
  if (status != "solved") expect_no_plan(json("plan.json"), "verification_failed");
}

TEST_F(CliPlan, WritesATableOfTheSameNumbers) {
  const ordered_json plan = this->plan({"--robot", "car", "--csv", "plan.csv"});
  std::ifstream table(path("plan.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "t,x,y,theta0,v,psi,acceleration,steering_rate");
  for (std::size_t i = 0; i < plan.at("states").size(); ++i) {
    ASSERT_TRUE(std::getline(table, line));
    std::istringstream row(line);
    std::string cell;
    std::getline(row, cell, ',');
    EXPECT_NEAR(std::stod(cell), 0.1 * static_cast<double>(i), 1e-4);
    for (const auto& number : plan.at("states")[i]) {
      std::getline(row, cell, ',');
      EXPECT_EQ(std::stof(cell), static_cast<float>(number.get<double>()));
    }
    if (i == plan.at("controls").size()) continue;
    for (const auto& number : plan.at("controls")[i]) {
      std::getline(row, cell, ',');
      EXPECT_EQ(std::stof(cell), static_cast<float>(number.get<double>()));
    }
  }
  EXPECT_FALSE(std::getline(table, line));
}

// 10 m by 10 m.
constexpr const char* kFar = R"({"bounds": {"min": [690000, 5333000], "max": [690010, 5333010]},
  "starts": [{"name": "s", "position": [690002, 5333003], "heading": 0}],
  "goals": [{"name": "g", "circle": {"center": [690008, 5333007], "radius": 1}}]})";

TEST_F(CliPlan, HoldsInACompiledSceneFarFrom0) {
  write("far.json", kFar);
  expect_done({"compile", "far.json", "-o", "far.krait"});
  expect_done({"plan", "far.krait", "--robot", "car", "-o", "plan.json"});
  expect_done({"verify", "far.json", "plan.json", "--robot", "car"});
}

// A start's angles are those of trailers: a robot that has none begins there all the same.
TEST_F(CliPlan, ARobotWithoutTrailersHasNoUseForAStartsAngles) {
  write("bent.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]},
      "starts": [{"name": "s", "position": [3, 5], "heading": 0, "angles": [0.2, 0.4]}],
      "goals": [{"name": "g", "circle": {"center": [15, 5], "radius": 1}}]})");
  expect_done({"compile", "bent.json", "-o", "bent.krait"});
  for (const char* scene : {"bent.krait", "bent.json"}) {
    expect_done({"plan", scene, "--robot", "car", "-o", "plan.json"});
    expect_done({"verify", "bent.json", "plan.json", "--robot", "car"});
  }
}

TEST_F(CliPlan, WritesATableInTheMapsCoordinatesFarFrom0) {
  write("far.json", kFar);
  expect_done({"plan", "far.json", "--robot", "car", "-o", "plan.json", "--csv", "plan.csv"});
  const ordered_json plan = json("plan.json");
  std::ifstream table(path("plan.csv"));
  std::string line;
  std::getline(table, line);
  std::getline(table, line);
  EXPECT_THAT(line, testing::StartsWith("0,690002,5333003,0,"));
  for (std::size_t i = 1; std::getline(table, line); ++i) {
    std::istringstream row(line.substr(line.find(',') + 1));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::string cell;
      std::getline(row, cell, ',');
      const double local = plan.at("states")[i][axis].get<double>();
      EXPECT_NEAR(std::stod(cell), plan.at("origin")[axis].get<double>() + local, 1e-6);
    }
  }
}

TEST_F(CliPlan, DrawsAndLeavesNothingElse) {
  plan({"--robot", "car", "--svg", "p.svg", "--png", "p.png", "--html", "p.html"});
  EXPECT_THAT(read_text(path("p.svg")), HasSubstr("<svg"));
  EXPECT_THAT(read_text(path("p.png")), testing::StartsWith("\x89PNG"));
  EXPECT_THAT(read_text(path("p.html")), HasSubstr("</html>"));
  EXPECT_EQ(files().size(), 6U);
}

TEST_F(CliPlan, WritesToStandardOutputWhenAskedTo) {
  const Outcome outcome = krait({"scene", "gates", "-o", "/dev/stdout"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(ordered_json::parse(outcome.output).contains("bounds"));
}

TEST_F(CliPlan, VerifyTrustsNothingInThePlan) {
  ordered_json plan = this->plan({"--robot", "car"});
  expect_done({"verify", "room.json", "plan.json", "--robot", "car"});
  expect_done({"verify", "room.krait", "plan.json", "--robot", "car"});
  EXPECT_EQ(krait({"verify", "room.json", "plan.json", "--robot", "unicycle"}).code, 1);
  EXPECT_EQ(krait({"verify", "room.json", "plan.json", "--robot", "car", "--start", "north"}).code, 1);
  plan["states"][3][1] = plan["states"][3][1].get<double>() + 0.05;
  write("plan.json", plan.dump());
  const Outcome outcome = krait({"verify", "room.json", "plan.json", "--robot", "car"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("the plan does not hold"));
}

TEST_F(CliPlan, EndsAtRestUnlessAskedOtherwise) {
  const auto end_speed = [this](const std::vector<std::string>& options) {
    const ordered_json plan = this->plan(options);
    EXPECT_EQ(plan.at("statistics").at("plan_end_speed_m_s").get<float>(), plan.at("states").back()[3].get<float>());
    return plan.at("states").back()[3].get<double>();
  };
  EXPECT_LT(end_speed({"--robot", "car"}), 0.005);
  expect_done({"verify", "room.json", "plan.json", "--robot", "car"});
  EXPECT_GT(end_speed({"--robot", "car", "--end-speed", "inf"}), 2);
  expect_done({"verify", "room.json", "plan.json", "--robot", "car", "--end-speed", "inf"});
  const Outcome fast = krait({"verify", "room.json", "plan.json", "--robot", "car", "--end-speed", "1"});
  EXPECT_EQ(fast.code, 1);
  EXPECT_THAT(fast.output, HasSubstr("m/s, asked at most 1 m/s"));
  EXPECT_EQ(krait({"verify", "room.json", "plan.json", "--robot", "car"}).code, 1) << "at rest is the default";
  EXPECT_LT(end_speed({"--robot", "car", "--end-speed", "1"}), 1.005);
  EXPECT_GT(end_speed({"--robot", "car", "--paper"}), 0.1);
  EXPECT_GT(end_speed({"--robot", "car", "--planner", "prior", "--end-speed", "inf"}), 0.1);
}

TEST_F(CliPlan, AsksNoPlannerToBrakeThatDoesNot) {
  for (const std::string planner : {"prior", "rrt"}) {
    expect_refused({"plan", "room.krait", "--robot", "car", "--planner", planner, "--end-speed", "0"},
                   "krait: --end-speed: --planner " + planner +
                       " does not brake, its plans end at any speed: leave it out, or give inf\n");
  }
}

TEST_F(CliPlan, TakesNoNumberThatThePlannerDoesNotRead) {
  const auto with = [](const std::string& planner, const std::string& option) {
    return Arguments{"plan", "room.krait", "--robot", "car", "--planner", planner, option, "1", "--iterations", "1"};
  };
  const std::vector<std::pair<std::string, std::vector<std::string>>> unread = {
      {"rrt", {"--alpha", "--beta", "--gamma", "--kappa"}}, {"prior", {"--gamma", "--kappa"}}};
  for (const auto& [planner, options] : unread) {
    for (const std::string& option : options) {
      Arguments arguments = with(planner, option);
      if (option == "--beta") arguments[7] = "0.5";
      expect_refused(arguments, "krait: " + option + ": --planner " + planner + " does not read it: leave it out\n");
    }
  }
  EXPECT_EQ(krait(with("prior", "--alpha")).code, 1);
  EXPECT_EQ(krait(with("adaptive", "--gamma")).code, 1);
}

TEST_F(CliPlan, OfARobotThatNeverStopsEndsAtNoSpeedBelowItsLeast) {
  write("glider.json", R"({"model": "unicycle", "parameters": {"min_speed": 0.2}})");
  (void)plan({"--robot", "glider.json"});
  const Outcome held = krait({"verify", "room.json", "plan.json", "--robot", "glider.json"});
  EXPECT_EQ(held.code, 0);
  EXPECT_THAT(held.output, HasSubstr(" m, never at rest; stored states differ by "));
  const std::string why =
      "krait: --end-speed: the robot is never slower than 0.2 m/s: give that or more, or leave it out\n";
  expect_refused({"plan", "room.krait", "--robot", "glider.json", "--end-speed", "0.1"}, why);
  expect_refused({"verify", "room.json", "plan.json", "--robot", "glider.json", "--end-speed", "0"}, why);
  expect_done({"verify", "room.json", "plan.json", "--robot", "glider.json", "--end-speed", "0.2"});
}

TEST_F(CliPlan, EndsWithTheHeadingAskedFor) {
  const std::vector<std::string> pose = {"--robot", "car", "--goal", "8,5,0.2", "--heading", "2.5"};
  const ordered_json found = plan(pose);
  const double heading = found.at("states").back()[2].get<double>();
  EXPECT_LE(std::abs(std::remainder(heading - 2.5, 2 * 3.14159265358979)), 0.1);
  EXPECT_EQ(found.at("goal").at("name"), "pose");
  EXPECT_EQ(found.at("goal").at("heading"), 2.5);
  EXPECT_EQ(found.at("goal").at("heading_tolerance"), 0.1);
  EXPECT_EQ(found.at("goal").at("either_way"), false);
  EXPECT_FALSE(found.at("goal").contains("hitch_tolerance"));
  const std::vector<std::string> verify = {"verify", "room.json", "plan.json", "--robot", "car", "--goal", "8,5,0.2"};
  const auto with = [](std::vector<std::string> all, const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  EXPECT_THAT(krait(verify).output, HasSubstr("to the heading 2.5 to 0.1 rad, the plan's own"));
  EXPECT_EQ(krait(with(verify, {"--heading", "2.5"})).code, 0);
  const Outcome other = krait(with(verify, {"--heading", "-2.5"}));
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.output, HasSubstr("goal: the plan was not made for the heading and the tolerances asked for"));
  ordered_json forged = found;
  forged["goal"]["heading"] = -2.5;
  write("plan.json", forged.dump());
  const Outcome missed = krait(with(verify, {"--heading", "-2.5"}));
  EXPECT_EQ(missed.code, 1);
  EXPECT_THAT(missed.output, testing::StartsWith("goal: the heading of the driven end is 1."));
  EXPECT_EQ(krait(verify).code, 1) << "the plan's own heading is held to as well";
}

TEST_F(CliPlan, AHeadingThatCannotBeUsedIsRefused) {
  const auto error = [this](std::vector<std::string> options) {
    options.insert(options.begin(), {"plan", "room.krait", "--robot", "car"});
    const Outcome outcome = krait(options);
    EXPECT_EQ(outcome.code, 2);
    return outcome.errors;
  };
  EXPECT_THAT(error({"--heading", "90", "--goal", "8,5,0.2"}), HasSubstr("were degrees meant? 90 degrees are 1.5708"));
  EXPECT_THAT(error({"--heading", "north", "--goal", "8,5,0.2"}), HasSubstr("give radians from -2 pi to 2 pi"));
  EXPECT_THAT(error({"--heading", "1"}), HasSubstr("--heading: give the goal as --goal X,Y,RADIUS with it"));
  EXPECT_THAT(error({"--either-way", "--goal", "8,5,0.2"}), HasSubstr("--either-way: give --heading RADIANS with it"));
  EXPECT_THAT(error({"--hitch-tolerance", "0.1"}), HasSubstr("--hitch-tolerance: give --heading RADIANS with it"));
  EXPECT_THAT(error({"--heading", "1", "--goal", "8,5,0.2", "--heading-tolerance", "4"}), HasSubstr("radians from"));
  EXPECT_THAT(error({"--heading", "1", "--goal", "8,5,0.2", "--heading-tolerance", "0"}), HasSubstr("radians from"));
}

TEST_F(CliPlan, VerifyBeginsWhereThePlanDoesUnlessAskedOtherwise) {
  plan({"--robot", "truck:2", "--start", "north"});
  const Outcome own = krait({"verify", "room.json", "plan.json", "--robot", "truck:2"});
  EXPECT_EQ(own.code, 0);
  EXPECT_THAT(own.output, HasSubstr("from 3,8,-0.5, the plan's own start"));
  plan({"--robot", "truck:2", "--start", "3.3,8.1,-0.4"});
  const Outcome odd = krait({"verify", "room.json", "plan.json", "--robot", "truck:2"});
  EXPECT_THAT(odd.output, HasSubstr("from 3.3,8.1,-0.4, the plan's own start"));  // not 3.299999952
  plan({"--robot", "truck:2", "--start", "north"});
  const Outcome asked = krait({"verify", "room.json", "plan.json", "--robot", "truck:2", "--start", "west"});
  EXPECT_EQ(asked.code, 1);
  EXPECT_THAT(asked.output, testing::StartsWith("start: state 0 lies 3 m from the start asked for\n"));
}

TEST_F(CliPlan, VerifyPrintsTheFirstComplaintAndAllWhereAsked) {
  plan({"--robot", "car"});
  const std::vector<std::string> verify = {"verify", "room.json", "plan.json", "--robot", "unicycle"};
  const std::string first = krait(verify).output;
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 3);
  EXPECT_THAT(first, testing::StartsWith("robot: model is \"car\", asked \"unicycle\"\n"));
  EXPECT_THAT(first, HasSubstr("more, which the first may explain: --all prints them"));
  std::vector<std::string> all = verify;
  all.emplace_back("--all");
  EXPECT_GT(krait(all).output.size(), 2 * first.size());
}

TEST_F(CliPlan, SaysHowGoodThePlanIs) {
  const Outcome outcome = krait({"plan", "room.krait", "--robot", "car", "-o", "plan.json"});
  EXPECT_THAT(outcome.output, HasSubstr("\nas driven: least clearance 0."));
  EXPECT_THAT(outcome.output, HasSubstr(" m, speed at the end "));
  const ordered_json plan = json("plan.json");
  const std::size_t at = outcome.output.find(" m/s, ");
  ASSERT_NE(at, std::string::npos);
  double ratio = 0, shortest = 0;
  ASSERT_EQ(std::sscanf(outcome.output.c_str() + at, " m/s, %lf times the shortest way that is wide enough (%lf m)",
                        &ratio, &shortest),
            2);
  const auto& first = plan.at("states").front();
  const auto& last = plan.at("states").back();
  const double straight =
      std::hypot(last[0].get<double>() - first[0].get<double>(), last[1].get<double>() - first[1].get<double>());
  EXPECT_NEAR(shortest, straight, 0.06);  // the door is in the middle
  EXPECT_NEAR(ratio, plan.at("statistics").at("plan_length_m").get<double>() / straight, 0.02);
}

TEST_F(CliPlan, VerifyOfAnHonestNoSaysSo) {
  plan({"--robot", "car", "--goal", kTinyGoal, "--memory", "64K", "--planner", "rrt"}, 1);
  const Outcome outcome = krait({"verify", "room.json", "plan.json", "--robot", "car", "--goal", kTinyGoal});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("tree_full"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace krait::host
