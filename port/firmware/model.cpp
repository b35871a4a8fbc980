// SPDX-License-Identifier: Apache-2.0
// The robot of a program: KRAIT_MODEL is the model's name, KRAIT_ROBOT its class, KRAIT_TRAILERS whether it has any
// (krait/robots/all.hpp).
#include "firmware/application.hpp"

namespace krait::firmware {
namespace {

// The model's defaults, with the request's number of trailers.
template <class R>
auto parameters_for([[maybe_unused]] const Request& request) {
  auto parameters = defaults_of<R>();
  if constexpr (requires { parameters.trailers; }) parameters.trailers = request.trailers;
  return parameters;
}

}  // namespace

const char* const kModel = KRAIT_MODEL;
const bool kHasTrailers = KRAIT_TRAILERS;

Robot robot_for(const Request& request) {
  static const KRAIT_ROBOT robot{parameters_for<KRAIT_ROBOT>(request)};
  return robot;
}

}  // namespace krait::firmware
