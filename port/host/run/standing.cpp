// SPDX-License-Identifier: Apache-2.0
#include "host/run/standing.hpp"

#include <vector>

#include "collision/motion_check.hpp"
#include "decomposition/locate.hpp"
#include "host/run/query.hpp"
#include "host/run/why.hpp"

namespace krait::host {
namespace {

// The check with the memory that it needs.
class OwnCheck {
 public:
  OwnCheck(const Robot& robot, const krait::Scene& scene, const Parameters& parameters) {
    detail::Arena counting;
    check_.allocate(counting, robot);
    block_.resize((counting.needed() + 7) / 8);
    detail::Arena arena(block_.data(), counting.needed());
    check_.allocate(arena, robot);
    check_.assign(robot, scene, parameters.clearance, static_cast<int>(parameters.tuning.max_substeps), true);
  }
  OwnCheck(const OwnCheck&) = delete;
  OwnCheck& operator=(const OwnCheck&) = delete;

  Contact contact(const std::vector<float>& state) { return check_.contact(state.data()); }

 private:
  std::vector<std::uint64_t> block_;
  detail::MotionCheck check_;
};

}  // namespace

std::optional<std::string> why_it_cannot_start(const krait::Scene& scene, const SearchRequest& request) {
  const CoreRobot core(request.robot);
  const Robot robot = core.view();
  const std::vector<float> state = state_at(robot, scene, resolve_start(scene, request));
  Contact contact = OwnCheck(robot, scene, request.parameters).contact(state);
  const Vec2 at{state[0], state[1]};
  if (contact.kind == ContactKind::none && detail::locate(scene, at) == kNone) {
    contact = {.kind = ContactKind::ground, .at = at};
  }
  if (contact.kind == ContactKind::none) return std::nullopt;
  return why_not_there(contact, scene, request);
}

}  // namespace krait::host
