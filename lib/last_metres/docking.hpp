// SPDX-License-Identifier: Apache-2.0
// How robots push trailers back to a pose. The functions are called by their addresses, which the tables of the models
// hold that do so (krait/robots/detail/functions.hpp): a program of other models does not contain them.
#pragma once

#include "krait/geometry.hpp"

namespace krait::detail {

class CurvedLine;
class LastMetres;
struct Shot;

// Each does what the member of its name does.
struct Docking {
  void (*measure)(LastMetres& last_metres, const Pose* poses);  // measure_push
  void (*choose)(LastMetres& last_metres, const Pose* poses);   // choose_swings, then choose_stages
  bool (*allows)(const LastMetres& last_metres, const Pose* poses, const Shot& shot, const CurvedLine& line);
  void (*turn_back)(LastMetres& last_metres);
};

}  // namespace krait::detail
