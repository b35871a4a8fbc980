// SPDX-License-Identifier: Apache-2.0
// A robot of the campaign: the parameters that the core is handed, and its bodies as the judge sees them.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <vector>

#include "krait/robots/all.hpp"

namespace krait::campaign {

#define KRAIT_NAME(name, Class, file, trailers) name,
enum class Model { KRAIT_MODELS(KRAIT_NAME) };
#undef KRAIT_NAME

#define KRAIT_NAME(name, Class, file, trailers) #name,
inline constexpr const char* kNames[] = {KRAIT_MODELS(KRAIT_NAME)};
#undef KRAIT_NAME
inline constexpr int kModels = std::size(kNames);

inline const char* name(Model model) { return kNames[static_cast<int>(model)]; }

struct Robot {
  Model model = Model::car;
  ChainParameters chain;  // of snake, truck and car
  KinematicTruckParameters kinematic;
  UnicycleParameters unicycle;
  Unicycle2Parameters unicycle2;
  DifferentialDriveParameters drive;

  // Those of one of these types.
  template <class P>
  const P& parameters() const {
    if constexpr (std::is_same_v<P, ChainParameters>) return chain;
    if constexpr (std::is_same_v<P, KinematicTruckParameters>) return kinematic;
    if constexpr (std::is_same_v<P, UnicycleParameters>) return unicycle;
    if constexpr (std::is_same_v<P, Unicycle2Parameters>) return unicycle2;
    if constexpr (std::is_same_v<P, DifferentialDriveParameters>) return drive;
  }

  std::vector<std::vector<Vec2>> own_bodies;  // one a body, in place of the boxes; or empty

  bool is_chain() const { return model == Model::snake || model == Model::truck || model == Model::car; }
  int trailers() const {
    if (model == Model::kinematic_truck) return kinematic.trailers;
    return model == Model::snake || model == Model::truck ? chain.trailers : 0;
  }
  int bodies() const { return 1 + trailers(); }
};

// A convex polygon, counter-clockwise, metres.
struct Convex {
  static constexpr int kMost = 8;
  int count = 0;
  double x[kMost];
  double y[kMost];

  void add(double px, double py) {
    x[count] = px;
    y[count++] = py;
  }
};

// The boxes that the parameters describe: a car's is centred on the middle of its wheelbase.
inline Convex box_of(const Robot& robot, int body) {
  double length = 0, width = 0, middle = 0;
  if (robot.model == Model::unicycle) {
    length = static_cast<double>(robot.unicycle.body_length);
    width = static_cast<double>(robot.unicycle.body_width);
  } else if (robot.model == Model::unicycle2) {
    length = static_cast<double>(robot.unicycle2.body_length);
    width = static_cast<double>(robot.unicycle2.body_width);
  } else if (robot.model == Model::kinematic_truck) {
    length = static_cast<double>(robot.kinematic.body_length);
    width = static_cast<double>(robot.kinematic.body_width);
    if (body == 0) middle = static_cast<double>(robot.kinematic.body_offset);
  } else if (robot.model == Model::diff_drive) {
    length = static_cast<double>(robot.drive.body_length);
    width = static_cast<double>(robot.drive.body_width);
  } else {
    length = static_cast<double>(robot.chain.body_length);
    width = static_cast<double>(robot.chain.body_width);
    if (robot.model == Model::car) middle = static_cast<double>(robot.chain.wheelbase) / 2;
    if (robot.model != Model::car && body == 0) middle = static_cast<double>(robot.chain.body_offset);
  }
  Convex box;
  box.add(middle - length / 2, -width / 2);
  box.add(middle + length / 2, -width / 2);
  box.add(middle + length / 2, width / 2);
  box.add(middle - length / 2, width / 2);
  return box;
}

// In each body's frame.
inline std::vector<Convex> bodies_of(const Robot& robot) {
  std::vector<Convex> bodies;
  for (int k = 0; k < robot.bodies(); ++k) {
    if (robot.own_bodies.empty()) {
      bodies.push_back(box_of(robot, k));
      continue;
    }
    Convex body;
    for (const Vec2 p : robot.own_bodies[static_cast<std::size_t>(k)]) {
      body.add(static_cast<double>(p.x), static_cast<double>(p.y));
    }
    bodies.push_back(body);
  }
  return bodies;
}

}  // namespace krait::campaign
