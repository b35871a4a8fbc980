// SPDX-License-Identifier: Apache-2.0
// The application: opens the scene in place, plans, reports. One model of robot, or one robot, a program.
#pragma once

#include "firmware/board.hpp"
#include "firmware/report.hpp"
#include "firmware/request.hpp"
#include "krait/krait.hpp"

namespace krait::firmware {

// What model.cpp has, by the line of krait/robots/all.hpp that it is compiled for, or compiled_robot.cpp: the name of
// the model or robot, whether it has a number of trailers to ask for, and the robot, which lasts.
extern const char* const kModel;
extern const bool kHasTrailers;
Robot robot_for(const Request& request);

// Everything, from the command line's words (the program's name not among them) to the exit code.
int run(const Board& board, int count, const char* const* words);

// Views the scene that lies on the board. Its header says how long it is; bytes that are none are refused.
Failure open_scene(const Board& board, Scene& scene);

// The size of the planner's block, bytes: that of --memory; else it is determined by the robot's size, and is at most
// what the board has.
std::uint64_t block_bytes(const Board& board, const Request& request, const Robot& robot);

// The robot standing still where it is asked to start, trailers at its heading, or at the scene's first start, trailers
// at the start's angles.
Failure rest_at_start(const Scene& scene, const Robot& robot, const Request& request, float* state);

}  // namespace krait::firmware
