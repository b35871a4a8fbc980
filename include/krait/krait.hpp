// SPDX-License-Identifier: Apache-2.0
// krait: kinodynamic, region-guided, adaptive, in-place tree search. Everything that a firmware needs.
#pragma once

#include "krait/robot/car.hpp"
#include "krait/robot/differential_drive.hpp"
#include "krait/robot/snake.hpp"
#include "krait/robot/truck.hpp"
#include "krait/robot/unicycle.hpp"
#include "krait/scene/scene.hpp"
#include "krait/search/planner.hpp"
#include "krait/status.hpp"
#include "krait/version.h"
