// SPDX-License-Identifier: Apache-2.0
// A plan's JSON, and the verifier on whatever it says.
#include <string>

#include "harness.hpp"
#include "host/plan_file/plan_file.hpp"
#include "host/verify/verify.hpp"

namespace {

using namespace krait::host;

krait::fuzz::Outcomes files("a plan's file"), plans("a plan");

Workspace room() {
  Workspace w;
  w.max = {10, 10};
  w.obstacles.push_back({"wall", {{5, 0}, {5.5, 0}, {5.5, 4}, {5, 4}}, {}});
  return w;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const PlanFile plan = parse_plan(std::string(reinterpret_cast<const char*>(data), size), "plan");
    files.accepted.reach();
    Asked asked;
    asked.robot = plan.robot;
    asked.start = {"start", {1, 1}, 0, {}};
    asked.goal = {{8, 8}, {9, 8}, {9, 9}};
    const Verdict verdict = verify(room(), plan, asked);
    krait::fuzz::require(verdict.holds == verdict.complaints.empty(), "a verdict without a reason");
    (verdict.holds ? plans.accepted : plans.refused).reach();
  } catch (const InputError& error) {
    files.refused.reach();
    krait::fuzz::require(std::string(error.what()).find('\n') == std::string::npos, "an error of more than one line");
  }
  return 0;
}
