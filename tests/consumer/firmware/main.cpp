// SPDX-License-Identifier: Apache-2.0
// Plans for a snake and for a robot of its own; writes a line "ROBOT STATUS HASH" each. Exit code: the number of
// robots without a plan.
#include "board.h"
#include "hoverer.hpp"
#include "krait/krait.hpp"

namespace {

alignas(krait::Setup::kAlignment) unsigned char block[256 * 1024];
krait::Scene scene;

void write_hash(std::uint64_t hash) {
  char digits[18] = {};
  for (int i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[(hash >> (60 - 4 * i)) & 15U];
  digits[16] = '\n';
  write_text(digits);
}

template <class R>
krait::Status plan(krait::Planner& planner, const R& robot, const float* start) {
  const krait::Failure ready = planner.init({block, sizeof block, &scene, robot});
  if (!ready.ok()) return ready.status;
  krait::Status status = planner.start({start, krait::Goal::named(0), 1});
  while (status == krait::Status::searching) status = planner.advance(10);
  return status;
}

template <class R>
int report(const char* name, const R& robot, const float* start) {
  static krait::Planner planner;
  const krait::Status status = plan(planner, robot, start);
  write_text(name);
  write_text(" ");
  write_text(krait::to_string(status));
  write_text(" ");
  write_hash(planner.plan().hash());
  return status == krait::Status::solved ? 0 : 1;
}

int plan_for_snake(krait::ScenePose pose) {
  krait::ChainParameters parameters;
  parameters.trailers = 3;
  static const krait::Snake snake(parameters);
  float start[krait::Snake::kMaxState];
  snake.rest(pose.position, pose.heading, nullptr, start);
  return report("snake", snake, start);
}

int plan_for_hoverer(krait::ScenePose pose) {
  const float start[] = {pose.position.x, pose.position.y, 0.0F, 0.0F};
  static const Hoverer hoverer;
  return report("hoverer", hoverer, start);
}

}  // namespace

int main() {
  const auto bytes = static_cast<std::size_t>(scene_end - scene_begin);
  if (!krait::Scene::open(scene_begin, bytes, scene).ok() || scene.start_count() == 0) return 100;
  const krait::ScenePose pose = scene.start(0);
  return plan_for_snake(pose) + plan_for_hoverer(pose);
}
