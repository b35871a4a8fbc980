// SPDX-License-Identifier: Apache-2.0
// Says what the planners answer to the flags of this file: "adaptive ANSWER prior ANSWER rrt ANSWER".
#include "answer.hpp"
#include "firmware/application.hpp"

namespace krait::firmware {

int run(const Board& board, int, const char* const*) {
  const char* const words[] = {"adaptive ", test::answer<Planner>(),    " prior ", test::answer<PriorPlanner>(),
                               " rrt ",     test::answer<RrtPlanner>(), "\n"};
  for (const char* word : words) board.port.log(board.port.context, word);
  return kDone;
}

}  // namespace krait::firmware
