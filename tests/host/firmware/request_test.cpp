// SPDX-License-Identifier: Apache-2.0
// A firmware's words are read as the workstation reads them, or refused with the reason.
#include "firmware/request.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "firmware/decimal.hpp"

namespace krait::firmware {
namespace {

const char* parse_words(const std::vector<const char*>& words, Request& request) {
  return parse(static_cast<int>(words.size()), words.data(), "car", false, request);
}

std::string complaint(const std::vector<const char*>& words) {
  Request request;
  const char* const text = parse_words(words, request);
  return text == nullptr ? "" : text;
}

TEST(Decimal, IsTheNumberOfTheCLibrary) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    char text[40];
    const double number = std::uniform_real_distribution<double>(-3000, 3000)(random);
    const int places = std::uniform_int_distribution<int>(0, 11)(random);
    std::snprintf(text, sizeof text, "%.*f", places, number);
    const char* at = text;
    double read = 0;
    ASSERT_TRUE(take_decimal(at, read)) << text;
    EXPECT_EQ(*at, '\0') << text;
    EXPECT_EQ(read, std::strtod(text, nullptr)) << text;
  }
}

TEST(Decimal, ShortFormsAreNumbers) {
  for (const auto& [text, number] : {std::pair{".5", 0.5}, {"-.25", -0.25}, {"7.", 7.0}, {"007", 7.0}}) {
    const char* at = text;
    double read = 0;
    EXPECT_TRUE(take_decimal(at, read)) << text;
    EXPECT_EQ(read, number) << text;
  }
}

TEST(Decimal, WhatIsNoNumberIsRefused) {
  for (const char* text : {"", "-", ".", "x", "--1", "1234567890123456", "nan", "inf"}) {
    double read = 0;
    EXPECT_FALSE(take_decimal(text, read));
  }
}

TEST(FirmwareRequest, ReadsStartGoalAndHeading) {
  Request request;
  ASSERT_EQ(parse_words({"--start", "2,-3.5,1.25", "--goal", "28.1,13,.5", "--heading", "-1", "--heading-tolerance",
                         "0.2", "--seed", "7"},
                        request),
            nullptr);
  EXPECT_TRUE(request.has_start && request.has_goal && request.has_heading);
  EXPECT_EQ(request.start.x, 2.0);
  EXPECT_EQ(request.start.y, -3.5);
  EXPECT_EQ(request.start.third, 1.25);
  EXPECT_EQ(request.goal.x, 28.1);
  EXPECT_EQ(request.goal.third, 0.5);
  EXPECT_EQ(request.heading, -1.0);
  EXPECT_EQ(request.heading_tolerance, 0.2);
  EXPECT_EQ(request.seed, 7U);
}

TEST(FirmwareRequest, ReadsClearanceAndTimeStep) {
  Request request;
  ASSERT_EQ(parse_words({"--clearance", "0.05", "--dt", "0.02"}, request), nullptr);
  EXPECT_TRUE(request.has_clearance && request.has_dt);
  EXPECT_EQ(request.clearance, 0.05);
  EXPECT_EQ(request.dt, 0.02);
}

TEST(FirmwareRequest, ReadsHowMuchToImprove) {
  Request request;
  for (const auto& [text, multiples] : {std::pair{"0", 0.0}, {"3", 3.0}, {"0.25", 0.25}}) {
    ASSERT_EQ(parse_words({"--improve", text}, request), nullptr) << text;
    EXPECT_EQ(request.improve, multiples) << text;
  }
  ASSERT_EQ(parse_words({}, request), nullptr);
  EXPECT_EQ(request.improve, 0.0);
  for (const char* text : {"-1", "1000001", "much", "1x", ""}) {
    EXPECT_EQ(complaint({"--improve", text}).rfind("--improve: give multiples", 0), 0U) << text;
  }
}

TEST(FirmwareRequest, AsksForTheScenesOwnWithoutThem) {
  Request request;
  ASSERT_EQ(parse_words({}, request), nullptr);
  EXPECT_FALSE(request.has_clearance || request.has_dt);
  EXPECT_FALSE(request.has_start || request.has_goal || request.has_heading);
}

TEST(FirmwareRequest, NamesAnOptionWithoutAValue) {
  for (const char* option : {"--robot", "--seed", "--memory", "--iterations", "--improve", "--start", "--goal",
                             "--heading", "--heading-tolerance", "--clearance", "--dt"}) {
    EXPECT_EQ(complaint({option}).rfind(std::string(option) + ": ", 0), 0U) << option;
    EXPECT_NE(std::string(kKnownOptions).find(option), std::string::npos) << option;
  }
}

TEST(FirmwareRequest, NamesWhatIsNoOption) {
  for (const std::vector<const char*>& words : {std::vector{"--help"}, {"--seed", "3", "--help", "1"}}) {
    Request request;
    EXPECT_EQ(parse_words(words, request), kUnknownOption);
    EXPECT_STREQ(request.unknown, "--help");
  }
}

TEST(FirmwareRequest, RefusesWithTheOptionsName) {
  for (const char* text : {"2,3", "2,3,", "2,3,4,5", "2;3;4", "a,b,c", "2,3,0x1", ""}) {
    EXPECT_EQ(complaint({"--start", text}).rfind("--start: give X,Y,HEADING", 0), 0U) << text;
    EXPECT_EQ(complaint({"--goal", text}).rfind("--goal: give X,Y,RADIUS", 0), 0U) << text;
  }
  for (const char* text : {"2,3,0", "2,3,-1", "2,3,0.0009999"}) {
    EXPECT_EQ(complaint({"--goal", text}), "--goal: the radius is 0.001 metres or more") << text;
  }
  EXPECT_EQ(complaint({"--goal", "2,3,0.001"}), "");
  EXPECT_EQ(complaint({"--heading", "north"}).rfind("--heading: give radians", 0), 0U);
  EXPECT_EQ(complaint({"--heading", "1"}), "--heading: give --goal X,Y,RADIUS with it");
  EXPECT_EQ(complaint({"--heading-tolerance", "0.2", "--goal", "2,3,1"}),
            "--heading-tolerance: give --heading with it");
  EXPECT_EQ(complaint({"--start", "2,3,90"}).rfind("--start: the heading is in radians", 0), 0U);
  EXPECT_EQ(complaint({"--heading", "-90", "--goal", "2,3,1"}).rfind("--heading: in radians", 0), 0U);
  EXPECT_EQ(complaint({"--clearance", "wide"}), "--clearance: give metres, as 0.05");
  EXPECT_EQ(complaint({"--dt", "0.1s"}), "--dt: give seconds, as 0.05");
  EXPECT_EQ(complaint({"--iterations", "0"}), "--iterations: give a whole number from 1 on");
}

TEST(FirmwareRequest, TellsAnotherRobotFromTrailersThatAreMissing) {
  for (const char* other : {"truck", "cart", "car2:1", "ca"}) {
    EXPECT_EQ(complaint({"--robot", other}), kAnotherRobot) << other;
  }
  EXPECT_EQ(complaint({"--robot", "car:1"}), "--robot: this model has no trailers");
  EXPECT_EQ(complaint({"--robot", "car"}), "");
}

}  // namespace
}  // namespace krait::firmware
