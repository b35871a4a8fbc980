// SPDX-License-Identifier: Apache-2.0
// Goals of maps that have headings: what krait plan asks for, what krait verify holds it to, what a scene file loses.
#include "host/cli/program.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kYard = R"({"name": "yard", "bounds": {"min": [0, 0], "max": [20, 10]},
  "goals": [{"name": "dock", "position": [12, 5], "radius": 0.2, "heading": 2.5, "heading_tolerance": 0.2},
            {"name": "ramp", "circle": {"center": [6, 6], "radius": 0.3}, "heading": 1.5, "either_way": true},
            {"name": "lawn", "circle": {"center": [15, 5], "radius": 1}}],
  "starts": [{"name": "home", "position": [3, 5], "heading": 0}]})";

class CliPose : public CliTest {
 protected:
  CliPose() { write("yard.json", kYard); }

  Outcome run(const std::string& command, const std::string& map, std::vector<std::string> more) const {
    std::vector<std::string> all = {command, map};
    if (command == "verify") all.emplace_back("plan.json");
    if (command == "plan") all.insert(all.end(), {"-o", "plan.json"});
    all.insert(all.end(), {"--robot", "car"});
    all.insert(all.end(), more.begin(), more.end());
    return krait(all);
  }
  Outcome plan(const std::vector<std::string>& more = {}) const { return run("plan", "yard.json", more); }
  Outcome verify(const std::vector<std::string>& more = {}) const { return run("verify", "yard.json", more); }
  ordered_json goal() const { return json("plan.json").at("goal"); }
  double error_to(double heading) const {
    const double end = json("plan.json").at("states").back()[2].get<double>();
    return std::abs(std::remainder(end - heading, 2 * 3.14159265358979));
  }
};

TEST_F(CliPose, APlanEndsAsTheMapsGoalSays) {
  const Outcome outcome = plan();
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_THAT(outcome.errors, IsEmpty());
  EXPECT_THAT(outcome.output, HasSubstr("\n  goal 'dock': within 0.2 m of 12,5, heading 2.5 rad, within 0.2 rad "
                                        "(--any-heading asks for the place alone)\n"));
  EXPECT_LE(error_to(2.5), 0.2);
  EXPECT_EQ(goal().at("name"), "dock");
  EXPECT_EQ(goal().at("heading"), 2.5);
  EXPECT_EQ(goal().at("heading_tolerance"), 0.2);
  EXPECT_EQ(goal().at("either_way"), false);
  EXPECT_FALSE(goal().contains("hitch_tolerance"));
}

TEST_F(CliPose, AGoalOfTheMapIsChosenByItsName) {
  ASSERT_EQ(plan({"--goal", "ramp"}).code, 0);
  EXPECT_EQ(goal().at("heading"), 1.5);
  EXPECT_EQ(goal().at("either_way"), true);
  EXPECT_EQ(verify({"--goal", "ramp"}).code, 0);
  const Outcome lawn = plan({"--goal", "lawn"});
  EXPECT_EQ(lawn.code, 0);
  EXPECT_THAT(lawn.output, Not(HasSubstr("rad")));
  EXPECT_FALSE(goal().contains("heading"));
  EXPECT_EQ(verify({"--goal", "lawn"}).code, 0);
}

TEST_F(CliPose, OptionsTakeThePlaceOfWhatTheMapSays) {
  ASSERT_EQ(plan({"--heading", "-1", "--either-way"}).code, 0);
  EXPECT_EQ(goal().at("heading"), -1);
  EXPECT_EQ(goal().at("heading_tolerance"), 0.2);
  EXPECT_EQ(goal().at("either_way"), true);
  ASSERT_EQ(plan({"--heading-tolerance", "0.3"}).code, 0);
  EXPECT_EQ(goal().at("heading"), 2.5);
  EXPECT_EQ(goal().at("heading_tolerance"), 0.3);
  ASSERT_EQ(plan({"--goal", "12,5,0.2"}).code, 0);
  EXPECT_EQ(goal().at("name"), "disc");
  EXPECT_FALSE(goal().contains("heading"));
}

TEST_F(CliPose, AnyHeadingLeavesThePlaceAlone) {
  const Outcome outcome = plan({"--any-heading"});
  ASSERT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, Not(HasSubstr("rad")));
  EXPECT_EQ(goal().at("name"), "dock");
  EXPECT_FALSE(goal().contains("heading"));
  EXPECT_GT(error_to(2.5), 0.2);
  for (const char* option : {"--heading=1", "--heading-tolerance=1", "--either-way", "--hitch-tolerance=1"}) {
    expect_refused({"plan", "yard.json", "--any-heading", option}, "--any-heading: excludes --heading");
  }
}

TEST_F(CliPose, AHitchToleranceWithoutTrailersIsNamed) {
  const std::string warning =
      "krait: warning: --hitch-tolerance: the robot has no trailers, of which it could say "
      "anything\n";
  const auto errors = [&](const std::string& robot) {
    return krait({"plan", "yard.json", "--robot", robot, "--hitch-tolerance", "0.5", "--iterations", "1"}).errors;
  };
  EXPECT_EQ(errors("unicycle"), warning);
  EXPECT_THAT(errors("truck:1"), Not(HasSubstr("--hitch-tolerance")));
}

TEST_F(CliPose, AHeadingWithoutAPoseIsRefused) {
  const std::string region = "--heading: give the goal as --goal X,Y,RADIUS with it";
  expect_refused({"plan", "yard.json", "--robot", "car", "--goal", "lawn", "--heading", "1"}, region);
  expect_refused({"plan", "yard.json", "--robot", "car", "--goal", "lawn", "--either-way"},
                 "--either-way: give --heading RADIANS with it");
}

TEST_F(CliPose, VerifyHoldsAPlanToWhatItWasMadeFor) {
  ASSERT_EQ(plan().code, 0);
  const Outcome own = verify();
  EXPECT_EQ(own.code, 0) << own.output;
  EXPECT_THAT(own.output, HasSubstr("to the heading 2.5 to 0.2 rad, the plan's own"));
  EXPECT_EQ(verify({"--heading", "2.5"}).code, 0);
  EXPECT_EQ(verify({"--any-heading"}).code, 0);
  const Outcome other = verify({"--heading", "1"});
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.output, HasSubstr("goal: the plan was not made for the heading"));
  ordered_json forged = json("plan.json");
  forged["goal"]["heading"] = -2.5;
  write("plan.json", forged.dump());
  EXPECT_EQ(verify().code, 1);
}

TEST_F(CliPose, VerifySaysThatAPlanLeavesTheMapsHeadingOut) {
  ASSERT_EQ(plan({"--any-heading"}).code, 0);
  const Outcome own = verify();
  EXPECT_EQ(own.code, 0) << own.output;
  EXPECT_THAT(own.output, HasSubstr("to any heading, the plan's own: the map's goal has the heading 2.5 to 0.2 "
                                    "rad, for which --heading asks"));
  EXPECT_THAT(verify({"--any-heading"}).output, Not(HasSubstr("to any heading")));
  EXPECT_EQ(verify({"--heading", "2.5"}).code, 1);
}

TEST_F(CliPose, VerifySaysThatAPlanHasAnotherHeadingThanTheMap) {
  ASSERT_EQ(plan({"--heading", "-1", "--hitch-tolerance", "0.4"}).code, 0);
  EXPECT_THAT(verify().output, HasSubstr("to the heading -1 to 0.2 rad, hitches to 0.4 rad, the plan's own: the map's "
                                         "goal has the heading 2.5 to 0.2 rad, for which --heading asks"));
  ASSERT_EQ(plan({"--heading-tolerance", "3"}).code, 0);
  EXPECT_THAT(verify().output, HasSubstr("2.5 to 3 rad, the plan's own: the map's goal has the heading 2.5 to 0.2"));
}

TEST_F(CliPose, CompilingSaysHowToAskForTheHeadings) {
  const Outcome outcome = krait({"compile", "yard.json", "-o", "yard.krait"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(
      outcome.errors,
      "krait-compile: warning: a scene file holds no headings of goals: plan in it with --goal 12,5,0.2 --heading "
      "2.5 --heading-tolerance 0.2 for goal 'dock'; --goal 6,6,0.3 --heading 1.5 --either-way for goal 'ramp' "
      "(--any-heading leaves this warning out)\n");
  expect_done({"compile", "yard.json", "-o", "yard.krait", "--any-heading"});
  const Outcome cropped = krait({"compile", "yard.json", "-o", "yard.krait", "--crop", "1,1,19,9", "--cell", "0.1"});
  EXPECT_THAT(cropped.errors, HasSubstr("--goal 12,5,0.2 --heading 2.5"));
  EXPECT_EQ(run("plan", "yard.krait", {}).code, 0);
  EXPECT_FALSE(goal().contains("heading"));
  expect_refused({"plan", "yard.krait", "--heading", "1"}, "--heading: give the goal as --goal X,Y,RADIUS with it");
}

TEST_F(CliPose, CompilingNamesThreeHeadingsAndCountsTheOthers) {
  std::string goals;
  for (int i = 1; i <= 5; ++i) {
    goals += (i > 1 ? ", " : "") +
             printed(R"({"name": "g%d", "position": [%d, 5], "radius": 0.2, "heading": %d})", i, 3 * i, i);
  }
  write("docks.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]}, "goals": [)" + goals + "]}");
  const Outcome outcome = krait({"compile", "docks.json", "-o", "docks.krait"});
  EXPECT_THAT(outcome.errors, HasSubstr("--goal 9,5,0.2 --heading 3 for goal 'g3'; so for 2 more (--any-heading"));
  EXPECT_THAT(outcome.errors, Not(HasSubstr("'g4'")));

  write("turned.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]},
      "goals": [{"name": "dock", "position": [3, 5], "radius": 0.2, "heading": 4}]})");
  EXPECT_THAT(krait({"compile", "turned.json", "-o", "turned.krait"}).errors, HasSubstr(" --heading -2.2831853 for"));
}

TEST_F(CliPose, ADrawingSaysWhatItsLineStandsFor) {
  const Outcome outcome = krait({"export", "yard.json", "--svg", "yard.svg"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.errors,
              HasSubstr("goal 'dock' becomes a line of the drawing, which is read as 0.1 m and 0.1 rad"));
  expect_done({"export", "yard.json", "--json", "copy.json", "--geojson", "copy.geojson"});
  EXPECT_EQ(run("plan", "copy.geojson", {}).code, 0);
  EXPECT_EQ(goal().at("heading_tolerance"), 0.2);
}

}  // namespace
}  // namespace krait::host
