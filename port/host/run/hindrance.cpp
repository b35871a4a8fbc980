// SPDX-License-Identifier: Apache-2.0
#include "host/run/hindrance.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "decomposition/locate.hpp"
#include "host/run/own_check.hpp"
#include "plan/proven_step.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kStates = 32;  // to drive from, at most
constexpr int kAhead = 3;            // regions to drive toward
constexpr int kSteps = 50;           // of a way, at most

class Driver {
 public:
  Driver(const Robot& robot, const krait::Scene& scene, const Parameters& parameters)
      : robot_(robot), check_(robot, scene, parameters), proof_(robot, scene, parameters, check_) {
    drive_.assign(robot, parameters.dt);
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  // Counts what becomes of the way from the state toward the point.
  void drive(const std::vector<float>& state, Vec2 toward) {
    ++found_.ways;
    drive_.begin(state.data());
    drive_.aim({.point = toward});
    for (int step = 0; step < kSteps; ++step) {
      check_.begin(drive_.state());
      if (!proof_.prove(drive_)) return count_end();
      drive_.go();
    }
  }

  Hindrances found() {
    for (const auto& [body, ended] : ended_by_) {
      if (ended.ways <= found_.stopped) continue;
      found_.stopped = ended.ways;
      found_.contact = ended.contact;
    }
    return found_;
  }

 private:
  struct Ended {
    int ways = 0;
    Contact contact;
  };

  void count_end() {
    check_.begin(drive_.state());
    drive_.follow(check_.poses());
    const float* const next = drive_.next();
    const Contact contact = check_.contact(next);
    if (contact.kind == ContactKind::none) {
      if (!robot_.keeps_reserve(next)) ++found_.beyond;
      return;
    }
    Ended& ended = ended_by_[contact.body];
    if (ended.ways++ == 0) ended.contact = contact;
  }

  Robot robot_;
  OwnCheck check_;
  detail::ProvenStep proof_;
  detail::Drive drive_;
  std::map<Index, Ended> ended_by_;  // by body
  Hindrances found_;
};

}  // namespace

Hindrances hindrances_of(const Session& session, const krait::Scene& scene, const Parameters& parameters) {
  const Effort effort = session.effort();
  const Index triangle = effort.tries > 0 ? detail::locate(scene, effort.at) : kNone;
  if (triangle == kNone) return {};
  const detail::Regions& regions = session.regions();
  Index ahead = regions.region(triangle);
  const std::vector<std::vector<float>> states = session.states_in(ahead);
  Driver driver(session.robot(), scene, parameters);
  for (int i = 0; i < kAhead && (ahead = regions.next(ahead)) != kNone; ++i) {
    const std::size_t count = std::min(states.size(), kStates);
    for (std::size_t k = 0; k < count; ++k) driver.drive(states[k * states.size() / count], scene.centroid(ahead));
  }
  return driver.found();
}

}  // namespace krait::host
