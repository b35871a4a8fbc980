// SPDX-License-Identifier: Apache-2.0
// What must come out the same to the bit on every machine, stage by stage: each prints one line `name hash`. Stages
// stand in the order in which they build on each other, so the first line that differs names the culprit.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <type_traits>

#include "base/random.hpp"
#include "firmware/board.hpp"
#include "krait/krait.hpp"

namespace krait::stages {

// FNV-1a 64 over 4-byte words, low byte first. Every NaN counts as one: its bits are the machine's own.
class Hash {
 public:
  void add(std::uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      value_ = (value_ ^ ((word >> shift) & 0xFFU)) * 0x100000001B3ULL;
    }
  }
  void add(std::uint64_t number) {
    add(static_cast<std::uint32_t>(number));
    add(static_cast<std::uint32_t>(number >> 32U));
  }
  void add(float x) { add(x == x ? std::bit_cast<std::uint32_t>(x) : 0x7FC00000U); }
  void add(Vec2 p) {
    add(p.x);
    add(p.y);
  }
  void add(const float* numbers, int count) {
    for (int i = 0; i < count; ++i) add(numbers[i]);
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

// Writes a stage's line, its name's parts joined by slashes.
void report(const firmware::Board& board, std::initializer_list<const char*> name, const Hash& hash);

void arithmetic(const firmware::Board& board);
void motion(const firmware::Board& board);
void distances(const firmware::Board& board);
void decomposition(const firmware::Board& board, const Scene& scene);
void searches(const firmware::Board& board, const Scene& scene);
void departures(const firmware::Board& board, const Scene& scene);
void improvements(const firmware::Board& board, const Scene& scene);

// Uniform in [-most, most).
inline float spread(detail::Random& random, float most) { return most * (2.0F * random.unit() - 1.0F); }

inline Vec2 random_in(const Box& box, detail::Random& random) {
  const float u = random.unit();
  const float v = random.unit();
  return {box.min.x + u * (box.max.x - box.min.x), box.min.y + v * (box.max.y - box.min.y)};
}

template <class R>
R with_trailers(int trailers) {
  ChainParameters parameters;
  parameters.trailers = trailers;
  return R(parameters);
}

inline KinematicTruck kinematic_truck() {
  KinematicTruckParameters parameters;
  parameters.trailers = 1;
  parameters.min_speed = -0.5F;
  return KinematicTruck(parameters);
}

// Whether all robots of the library are among those of the classes R.
template <class... Models>
struct Every {
  template <class M, class... R>
  static constexpr bool kIsOneOf = (std::is_same_v<M, R> || ...);
  template <class... R>
  static constexpr bool kAreAmong = (kIsOneOf<Models, R...> && ...);
};

template <class R>
struct Named {
  const char* name;
  const R& robot;
};
template <class R>
Named(const char*, const R&) -> Named<R>;

template <class Visit, class... R>
void visit_each(Visit& visit, const Named<R>&... robots) {
  static_assert(AllRobots<Every>::kAreAmong<R...>);
  (visit(robots.name, robots.robot), ...);
}

// Calls visit(name, robot) for the robots that move and search in the stages; they stay.
template <class Visit>
void for_each_robot(Visit visit) {
  static const Unicycle unicycle{UnicycleParameters{}};
  static const Unicycle2 accelerated{Unicycle2Parameters{}};
  static const DifferentialDrive drive{DifferentialDriveParameters{}};
  static const Car car(Car::defaults());
  static const Truck towing = with_trailers<Truck>(2);
  static const KinematicTruck kinematic = kinematic_truck();
  static const Snake short_snake = with_trailers<Snake>(5);
  static const Snake long_snake = with_trailers<Snake>(15);
  visit_each(visit, Named{"unicycle", unicycle}, Named{"unicycle2", accelerated}, Named{"diff_drive", drive},
             Named{"car", car}, Named{"truck:2", towing}, Named{"kinematic_truck:1", kinematic},
             Named{"snake:5", short_snake}, Named{"snake:15", long_snake});
}

}  // namespace krait::stages
