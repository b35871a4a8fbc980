// SPDX-License-Identifier: Apache-2.0
/// \file
/// krait: kinodynamic, region-guided, adaptive, in-place tree search. Everything that a firmware needs.
#pragma once

#include "krait/planner.hpp"
#include "krait/robots/all.hpp"
#include "krait/scene.hpp"
#include "krait/status.hpp"
#include "krait/version.h"
