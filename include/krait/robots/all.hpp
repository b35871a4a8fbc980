// SPDX-License-Identifier: Apache-2.0
/// \file
/// The robots of the library: the one list of them, from which the workstation, the firmware's builds and the tests
/// have theirs.
#pragma once

#include "krait/robots/car.hpp"
#include "krait/robots/differential_drive.hpp"
#include "krait/robots/kinematic_truck.hpp"
#include "krait/robots/snake.hpp"
#include "krait/robots/truck.hpp"
#include "krait/robots/unicycle.hpp"
#include "krait/robots/unicycle2.hpp"

/// MODEL(name, class, file, trailers) for every model: its name in commands and files; its class; the name of its
/// header and source; and its default number of trailers, used by tests and tools, or - for a model without trailers.
/// CMake and bash parse these lines: keep one model per line in this form.
// clang-format off
#define KRAIT_MODELS(MODEL)                                  \
  MODEL(snake, Snake, snake, 15)                             \
  MODEL(truck, Truck, truck, 2)                              \
  MODEL(kinematic_truck, KinematicTruck, kinematic_truck, 1) \
  MODEL(car, Car, car, -)                                    \
  MODEL(unicycle, Unicycle, unicycle, -)                     \
  MODEL(unicycle2, Unicycle2, unicycle2, -)                  \
  MODEL(diff_drive, DifferentialDrive, differential_drive, -)
// clang-format on

namespace krait {
namespace detail {

template <template <class...> class List, class, class... Models>
using WithoutFirst = List<Models...>;

}  // namespace detail

/// For AllRobots alone: a class with the comma before it.
#define KRAIT_COMMA_CLASS(name, Class, file, trailers) , Class
/// Their classes as the arguments of a template, as in AllRobots<std::variant>.
template <template <class...> class List>
using AllRobots = detail::WithoutFirst<List, void KRAIT_MODELS(KRAIT_COMMA_CLASS)>;
#undef KRAIT_COMMA_CLASS

}  // namespace krait
