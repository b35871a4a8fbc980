// SPDX-License-Identifier: Apache-2.0
#include "firmware/request.hpp"

#include <cstring>
#include <limits>

#include "firmware/decimal.hpp"
#include "krait/robots/chain.hpp"

namespace krait::firmware {
namespace {

constexpr int kDefaultTrailers = 15;
constexpr double kMostImprove = 1e6;
constexpr double kLeastRadius = 0.001;       // metres: a smaller one is most likely a slip, as on the workstation
constexpr double kTurn = 6.283185307179586;  // radians: a larger heading was meant in degrees

bool same(const char* a, const char* b) { return std::strcmp(a, b) == 0; }

bool parse_number(const char* text, std::uint64_t& number) { return take_number(text, number) && *text == '\0'; }

bool parse_bytes(const char* text, std::uint64_t& bytes) {
  if (!take_number(text, bytes)) return false;
  const unsigned shift = *text == 'K' ? 10 : *text == 'M' ? 20 : 0;
  if (bytes > (std::numeric_limits<std::uint64_t>::max() >> shift)) return false;
  bytes <<= shift;
  return text[shift == 0 ? 0 : 1] == '\0';
}

bool parse_decimal(const char* text, double& number) { return take_decimal(text, number) && *text == '\0'; }

bool parse_triple(const char* text, Triple& triple) {
  for (double* number : {&triple.x, &triple.y}) {
    if (!take_decimal(text, *number) || *text != ',') return false;
    ++text;
  }
  return parse_decimal(text, triple.third);
}

bool is_heading(double radians) { return radians >= -kTurn && radians <= kTurn; }

const char* parse_parameter(const char* option, const char* value, Request& request) {
  if (same(option, "--clearance")) {
    request.has_clearance = true;
    return parse_decimal(value, request.clearance) ? nullptr : "--clearance: give metres, as 0.05";
  }
  if (same(option, "--dt")) {
    request.has_dt = true;
    return parse_decimal(value, request.dt) ? nullptr : "--dt: give seconds, as 0.05";
  }
  request.unknown = option;
  return kUnknownOption;
}

const char* parse_query(const char* option, const char* value, Request& request) {
  if (same(option, "--start")) {
    request.has_start = true;
    if (!parse_triple(value, request.start)) return "--start: give X,Y,HEADING in metres and radians, as 2,3.5,0";
    const bool sound = is_heading(request.start.third);
    return sound ? nullptr : "--start: the heading is in radians, at most 6.283: were degrees meant?";
  }
  if (same(option, "--goal")) {
    request.has_goal = true;
    if (!parse_triple(value, request.goal)) return "--goal: give X,Y,RADIUS in metres, as 28,13,0.5";
    return request.goal.third >= kLeastRadius ? nullptr : "--goal: the radius is 0.001 metres or more";
  }
  if (same(option, "--heading")) {
    request.has_heading = true;
    if (!parse_decimal(value, request.heading)) return "--heading: give radians, as 1.57";
    return is_heading(request.heading) ? nullptr : "--heading: in radians, at most 6.283: were degrees meant?";
  }
  if (same(option, "--heading-tolerance")) {
    request.has_heading_tolerance = true;
    return parse_decimal(value, request.heading_tolerance) ? nullptr : "--heading-tolerance: give radians, as 0.1";
  }
  return parse_parameter(option, value, request);
}

const char* parse_robot(const char* text, const char* model, bool has_trailers, Request& request) {
  const std::size_t length = std::strlen(model);
  const bool begins = std::strncmp(text, model, length) == 0;  // as "unicycle2" with "unicycle", too
  const char* rest = begins ? text + length : text;
  if (!begins || (*rest != '\0' && *rest != ':')) return kAnotherRobot;
  request.robot = text;
  if (!has_trailers) return *rest == '\0' ? nullptr : "--robot: this model has no trailers";
  std::uint64_t trailers = 0;
  static_assert(kMaxTrailers == 25, "the message states it");
  if (*rest != ':' || !parse_number(rest + 1, trailers) || trailers > kMaxTrailers) {
    return "--robot: give the number of trailers, 0 to 25, as in snake:5";
  }
  request.trailers = static_cast<int>(trailers);
  return nullptr;
}

const char* parse_option(const char* option, const char* value, const char* model, bool has_trailers,
                         Request& request) {
  if (same(option, "--robot")) return parse_robot(value, model, has_trailers, request);
  if (same(option, "--seed")) return parse_number(value, request.seed) ? nullptr : "--seed: give a whole number";
  if (same(option, "--memory")) {
    const bool good = parse_bytes(value, request.memory) && request.memory > 0;
    return good ? nullptr : "--memory: give bytes above 0, as 131072, 128K or 1M";
  }
  if (same(option, "--iterations")) {
    const bool good = parse_number(value, request.iterations) && request.iterations > 0;
    return good ? nullptr : "--iterations: give a whole number from 1 on";
  }
  if (same(option, "--improve")) {
    const bool good =
        parse_decimal(value, request.improve) && request.improve >= 0.0 && request.improve <= kMostImprove;
    return good ? nullptr : "--improve: give multiples of the first plan's collision checks, 0 to 1000000, as 3 or 0.5";
  }
  return parse_query(option, value, request);
}

}  // namespace

const char* parse(int count, const char* const* words, const char* model, bool has_trailers, Request& request) {
  request = {};
  request.robot = model;
  request.trailers = has_trailers ? kDefaultTrailers : 0;
  for (int i = 0; i < count; ++i) {
    if (same(words[i], "--icount")) {
      request.clock_counts_instructions = true;
      continue;
    }
    const char* value = i + 1 < count ? words[i + 1] : "";  // no option accepts an empty value
    const char* wrong = parse_option(words[i], value, model, has_trailers, request);
    if (wrong != nullptr) return wrong;
    ++i;
  }
  if (request.has_heading && !request.has_goal) return "--heading: give --goal X,Y,RADIUS with it";
  const bool alone = request.has_heading_tolerance && !request.has_heading;
  return alone ? "--heading-tolerance: give --heading with it" : nullptr;
}

}  // namespace krait::firmware
