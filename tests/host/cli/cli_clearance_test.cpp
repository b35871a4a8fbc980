// SPDX-License-Identifier: Apache-2.0
// The clearance that krait plan keeps where none is asked for, and what it says where there is no room for it.
#include "host/cli/program.hpp"
#include "host/run/run.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

// 10 x 10 m in cells of half a metre, free but for a frame of one cell.
std::string framed_image() {
  constexpr int kSize = 20;
  std::string image = "P2 20 20 255\n";
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const bool frame = row == 0 || column == 0 || row == kSize - 1 || column == kSize - 1;
      image += frame ? "0 " : "255 ";
    }
    image += "\n";
  }
  return image;
}

// 20 m by 10 m, and a wall with a door in its middle.
std::string door(const std::string& width) {
  const double half = std::stod(width) / 2, wall = 5 - half;
  const auto box = [&](double y) {
    return R"({"box": {"center": [10, )" + std::to_string(y) + R"(], "size": [0.2, )" + std::to_string(wall) +
           R"(], "angle": 0}})";
  };
  return R"({"name": "door", "bounds": {"min": [0, 0], "max": [20, 10]}, "obstacles": [)" + box(wall / 2) + ", " +
         box(10 - wall / 2) + R"(], "starts": [{"name": "west", "position": [8, 5], "heading": 0}],
    "goals": [{"name": "east", "polygon": [[14, 3], [18, 3], [18, 7], [14, 7]]}]})";
}

class CliClearance : public CliTest {
 protected:
  // What krait plan prints for the car, or for another robot, 0.6 m wide as the car; the plan's least clearance as
  // driven must be at least `least`.
  std::string planned(Arguments arguments, double least, const std::string& robot = "car") const {
    arguments.insert(arguments.begin(), "plan");
    arguments.insert(arguments.end(), {"--robot", robot});
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    const std::string mark = "\nas driven: least clearance ";
    const std::size_t at = outcome.output.find(mark);
    EXPECT_NE(at, std::string::npos) << outcome.output;
    if (at == std::string::npos) return outcome.output;
    EXPECT_GE(std::stod(outcome.output.substr(at + mark.size())), least);
    return outcome.output;
  }
};

TEST_F(CliClearance, IsAShareOfTheRobotsWidth) {
  write("door.json", door("1.2"));
  EXPECT_THAT(planned({"door.json"}, 0.012),
              HasSubstr("\n  clearance 0.012 m: 2 % of the robot's width (--clearance asks for another)\n"));
}

TEST_F(CliClearance, IsHalfACellMoreOnAMap) {
  write("map.yaml",
        "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  write("map.pgm", framed_image());
  EXPECT_THAT(planned({"map.yaml", "--start", "2,2,0", "--goal", "8,8,0.5"}, 0.262),
              HasSubstr("\n  clearance 0.262 m: 2 % of the robot's width and half a cell of the map (--clearance "));
}

TEST_F(CliClearance, ThatIsAskedForIsKeptAndNotExplained) {
  write("door.json", door("1.2"));
  EXPECT_THAT(planned({"door.json", "--clearance", "0.1"}, 0.1), Not(HasSubstr("\n  clearance")));
}

TEST_F(CliClearance, IsHalvedWhereTheStartHasTooLittleRoom) {
  write("door.json", door("1.2"));
  const Arguments start = {"door.json", "--start", "3,0.312,0"};
  EXPECT_THAT(planned(start, 0.003), HasSubstr("\n  clearance 0.003 m: the start has too little room for twice the "
                                               "usual 0.012 m, 2 % of the robot's width\n"));
  const Outcome asked = krait({"plan", "door.json", "--robot", "car", "--start", "3,0.312,0", "--clearance", "0.012"});
  EXPECT_EQ(asked.code, 2);
  EXPECT_THAT(asked.errors, HasSubstr("the start does not keep the clearance"));
}

// The door has room for it, but hardly for a search that looks for a way through.
TEST_F(CliClearance, IsHalvedWhereEveryWayHasTooLittleRoom) {
  write("door.json", door("0.64"));
  EXPECT_THAT(planned({"door.json", "--improve", "0"}, 0.006),
              HasSubstr("\n  clearance 0.006 m: every way to the goal has too little room for twice the usual 0.012 m, "
                        "2 % of the robot's width\n"));
}

// A disc in a body that is broader than long finds a way through the door with any clearance, the body with a small
// one.
constexpr const char* kBroad = R"({"model": "unicycle", "parameters": {"body_length": 0.3, "body_width": 0.6}})";

TEST_F(CliClearance, IsAMillimetreWhereASearchWithTheUsualOneIsInVain) {
  write("door.json", door("0.623"));
  write("broad.json", kBroad);
  EXPECT_THAT(
      planned({"door.json", "--iterations", "20000"}, 0.001, "broad.json"),
      HasSubstr("\n  clearance 0.001 m: a search with 0.012 m used up its iterations (the usual is 0.012 m, 2 % "
                "of the robot's width)\n"));
}

// A slot has room for the body, which is broader than long, with a millimetre on both sides.
TEST_F(CliClearance, IsAMillimetreWhereTheGoalHasNoRoomWithTheUsualOne) {
  write("slot.json", R"({"bounds": {"min": [0, 0], "max": [12, 10]}, "obstacles": [
      {"box": {"center": [3, 8], "size": [6, 4], "angle": 0}},
      {"box": {"center": [9.5, 8], "size": [5, 4], "angle": 0}}],
      "starts": [{"name": "home", "position": [6.5, 2], "heading": 1.5708}]})");
  write("broad.json", R"({"model": "unicycle", "parameters": {"body_length": 0.5, "body_width": 0.98}})");
  EXPECT_THAT(
      planned({"slot.json", "--goal", "6.5,9,0.2", "--heading", "1.5708", "--improve", "0"}, 0.001, "broad.json"),
      HasSubstr("\n  clearance 0.001 m: with 0.0196 m the robot has no room in the goal (the usual is 0.0196 m, "
                "2 % of the robot's width)\n"));
}

TEST_F(CliClearance, ThatIsAskedForIsSearchedOnce) {
  write("door.json", door("0.623"));
  write("broad.json", kBroad);
  const Outcome outcome =
      krait({"plan", "door.json", "--robot", "broad.json", "--clearance", "0.012", "--iterations", "2000"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("budget_used"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("\n  clearance")));
}

TEST_F(CliClearance, OfAMillimetreIsTheLeast) {
  write("door.json", door("0.59"));
  const Outcome outcome = krait({"plan", "door.json", "--robot", "car"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("it needs 0.602 m"));
}

TEST_F(CliClearance, OfAMillimetreFindsTheLibrarysFirstPlan) {
  write("door.json", door("1.2"));
  expect_done({"compile", "door.json", "-o", "door.krait"});
  expect_done({"plan", "door.krait", "--robot", "car", "--clearance", "0.001", "--improve", "0", "-o", "plan.json"});
  SearchRequest request;
  request.robot = parse_robot("car");
  const std::string file = path("door.krait");
  const SearchResult result = run_search(file, SceneBytes::read(file), request, {});
  EXPECT_EQ(json("plan.json").at("statistics").at("hash"), result.plan.statistics->at("hash"));
}

}  // namespace
}  // namespace krait::host
