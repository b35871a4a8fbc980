// SPDX-License-Identifier: Apache-2.0
/// \file
/// Who sees a search as it goes.
#pragma once

#include <concepts>
#include <type_traits>

#include "krait/geometry.hpp"
#include "krait/robots/model.hpp"

namespace krait {

/// Refers to what is called, which must outlive it; by default to nothing. A watched step costs one call through a
/// pointer more.
class Watch {
 public:
  Watch() = default;  ///< calls nothing
  /// Calls watch(from, to) with states, and watch.expands(vertex, target) where there is such a member.
  template <class W>
  requires(!std::same_as<std::remove_cvref_t<W>, Watch> && std::invocable<W&, const float*, const float*>)
      Watch(W&& watch)  // NOLINT(google-explicit-constructor,bugprone-forwarding-reference-overload): made by its name
      : self_(&watch), step_(&step<std::remove_reference_t<W>>), expands_(&expands<std::remove_reference_t<W>>) {}

  /// A step that the tree grew by: states of robot.state_size() floats, which last for the call only.
  void operator()(const float* from, const float* to) const {
    if (step_ != nullptr) step_(self_, from, to);
  }
  /// An expansion that begins: from which vertex of the tree, toward what.
  void expands(Index vertex, const Target& target) const {
    if (expands_ != nullptr) expands_(self_, vertex, target);
  }

 private:
  template <class W>
  static void step(const void* self, const float* from, const float* to) {
    (*const_cast<W*>(static_cast<const W*>(self)))(from, to);
  }
  template <class W>
  static void expands(const void* self, [[maybe_unused]] Index vertex, [[maybe_unused]] const Target& target) {
    auto& watch = *const_cast<W*>(static_cast<const W*>(self));
    if constexpr (requires { watch.expands(vertex, target); }) watch.expands(vertex, target);
  }

  const void* self_ = nullptr;
  void (*step_)(const void* self, const float* from, const float* to) = nullptr;
  void (*expands_)(const void* self, Index vertex, const Target& target) = nullptr;
};

}  // namespace krait
