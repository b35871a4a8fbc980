// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/hindered.hpp"

#include <cstring>

#include "host/compiler/blocked_starts.hpp"
#include "host/compiler/closed_goals.hpp"
#include "host/import/format.hpp"
#include "host/verify/obstacle_near.hpp"
#include "host/workspace/printed.hpp"
#include "krait/format.hpp"

namespace krait::host {
namespace {

Point middle_of(const Ring& ring) {
  Point middle;
  for (const Point& p : ring) {
    middle.x += p.x / static_cast<double>(ring.size());
    middle.y += p.y / static_cast<double>(ring.size());
  }
  return middle;
}

}  // namespace

double tolerance_of(const CompiledScene& scene) {
  format::Header header;
  std::memcpy(&header, scene.bytes.data(), sizeof header);
  return decimal(header.tolerance);
}

Hindered hindered(const CompiledScene& scene, const RobotSpec& robot) {
  return {blocked_starts(scene, robot), closed_goals(scene, robot)};
}

std::vector<std::string> narrowed_goals(const Workspace& workspace, const CompiledScene& compiled) {
  constexpr double kShare = 0.1;
  if (workspace.goals.empty()) return {};
  std::vector<Point> middles;
  for (const Goal& goal : workspace.goals) middles.push_back(middle_of(goal.polygon));
  const double grown = tolerance_of(compiled);
  const Workspace scene =
      read_workspace({"the compiled scene", std::string(compiled.bytes.begin(), compiled.bytes.end())}, {});
  const std::vector<double> before = rooms_around(workspace, middles, grown / kShare);
  const std::vector<double> after = rooms_around(scene, middles, grown / kShare);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!(after[i] < (1 - kShare) * before[i])) continue;
    lines.push_back("goal '" + workspace.goals[i].name +
                    printed("' is %.3g m from the nearest obstacle, and %.3g m in the scene, whose obstacles are grown "
                            "by up to %.4g m: a robot that stands free there may not in the scene; --for ROBOT looks "
                            "whether it does, --tolerance 0 leaves obstacles as they are",
                            before[i], after[i], grown));
  }
  return lines;
}

}  // namespace krait::host
