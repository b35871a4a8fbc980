// SPDX-License-Identifier: Apache-2.0
// What the corpora have grown from: make_seeds FOLDER writes FOLDER/HARNESS/NAME, each NAME telling what the file is.
// Sound ones, and one for every way of being wrong that is known.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "../core/planner_fixture.hpp"
#include "../core/scene_evils.hpp"
#include "../host/import/bmp_writer.hpp"
#include "../host/import/jpeg_writer.hpp"
#include "../host/import/png_writer.hpp"
#include "plan_choice.hpp"

namespace krait::fuzz {
namespace {

using Named = std::vector<std::pair<std::string, std::string>>;

std::string text(const test::SceneBytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// Of few bytes: what is coarse serves a fuzzer as well.
test::Room small(test::Room room) {
  room.spacing = 20;
  room.clearance_cell = 4;
  room.bucket_size = 8;
  return room;
}

test::Room rooms(double door) {
  test::Room room = test::two_rooms(door);
  room.starts = {{2.0F, 6.0F, 0.0F, 0, 0}};
  room.goals.erase(room.goals.begin() + 1);
  return small(room);
}

// With room for trailers.
test::Room hall() {
  test::Room room;
  room.bounds = {0, 0, 60, 20};
  room.boxes = {{30, 0, 31, 8}};
  room.goals = {{46, 4, 56, 16}};
  room.starts = {{22.0F, 12.0F, 0.0F, 0, 0}};
  return small(room);
}

Named sound_scenes() {
  Named all;
  for (const std::uint8_t width : {std::uint8_t{2}, std::uint8_t{4}}) {
    test::Room room = rooms(2);
    room.index_width = width;
    all.emplace_back("two_rooms_" + std::to_string(width), text(test::data_of(room).bytes()));
  }
  for (unsigned seed = 1; seed <= 6; ++seed) {
    test::Room room = test::random_room(seed, 8, 5);
    room.spacing = 4;
    room.starts = {{1.0F, 1.0F, 0.5F, 0, 0}, {7.0F, 7.0F, 0.0F, 0, 0}};
    all.emplace_back("random_" + std::to_string(seed), text(test::data_of(room).bytes()));
  }
  return all;
}

std::string planned(const PlanChoice& choice, const test::Room& room) {
  return std::string(reinterpret_cast<const char*>(&choice), sizeof choice) + text(test::data_of(room).bytes());
}

// Every robot and planner.
void add_kinds(Named& all) {
  for (std::uint8_t robot = 0; robot < std::size(kRobots); ++robot)
    all.emplace_back(std::string("robot_") + kRobots[robot], planned({.robot = robot}, hall()));
  for (std::uint8_t planner = 0; planner < std::size(kPlanners); ++planner)
    all.emplace_back(std::string("planner_") + kPlanners[planner], planned({.planner = planner}, rooms(2)));
}

// Doors that a search needs long for, and blocks that hold few vertices.
void add_corners(Named& all) {
  all.emplace_back("paper", planned({.parameters = 1}, rooms(2)));
  all.emplace_back("paper_recycling", planned({.parameters = 1, .memory = 4}, rooms(0.48)));
  all.emplace_back("any_speed", planned({.parameters = 2}, rooms(2)));
  all.emplace_back("restarts", planned({.restarts = 9}, rooms(0.44)));
  for (std::uint8_t memory = 4; memory <= 10; memory += 2)
    all.emplace_back("recycling_" + std::to_string(memory), planned({.memory = memory}, rooms(0.44)));
  all.emplace_back("restarts_recycling", planned({.memory = 4, .restarts = 4}, rooms(0.44)));
  all.emplace_back("improvement", planned({.improvement = 255}, rooms(2)));
  all.emplace_back("improvement_recycling", planned({.memory = 32 + 5, .improvement = 255}, rooms(0.48)));
  all.emplace_back("budget_used", planned({}, rooms(0.4)));
}

void add_poses(Named& all) {
  all.emplace_back("pose", planned({.goal = 1}, rooms(2)));
  all.emplace_back("pose_either_way", planned({.robot = 1, .goal = 3 | 16 << 3}, hall()));
  all.emplace_back("pose_hitches", planned({.robot = 4, .goal = 5}, hall()));
  all.emplace_back("pose_improvement", planned({.goal = 1, .improvement = 255}, rooms(2)));
}

void add_refused(Named& all) {
  all.emplace_back("too_little_memory", planned({.memory = 0}, rooms(2)));
  all.emplace_back("no_route", planned({}, rooms(0.3)));
  test::Room room = rooms(2);
  room.starts = {{-3.0F, 6.0F, 0.0F, 0, 0}};
  all.emplace_back("start_outside", planned({}, room));
  room.starts = {{6.1F, 1.0F, 0.0F, 0, 0}};
  all.emplace_back("start_in_collision", planned({}, room));
  room = rooms(2);
  room.goals = {{6, 0.5, 6.25, 1.5}};
  all.emplace_back("goal_in_obstacle", planned({}, room));
  all.emplace_back("bad_scene", planned({}, rooms(2)).substr(0, 600));
}

Named plans() {
  Named all;
  add_kinds(all);
  add_corners(all);
  add_poses(all);
  add_refused(all);
  return all;
}

Named evil_scenes() {
  Named all = sound_scenes();
  for (const test::evil::Evil& evil : test::evil::all_evils()) {
    test::SceneBytes bytes = test::evil::sound().bytes();
    evil.spoil(bytes);
    bytes.repair_crc();
    all.emplace_back("evil_" + evil.name, text(bytes));
  }
  return all;
}

std::string repeated(const std::string& one, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += one;
  return all;
}

std::string native(const std::string& obstacles) {
  return R"({"name": "n", "bounds": {"min": [0, 0], "max": [20, 10]}, "obstacles": [)" + obstacles +
         R"(], "goals": [{"name": "g", "box": {"center": [18, 2], "size": [2, 2], "angle": 0}},)"
         R"( {"name": "h", "position": [18, 8], "radius": 1, "heading": 1, "heading_tolerance": 0.2}],)"
         R"( "starts": [{"name": "s", "position": [3, 3], "heading": 0, "angles": [0.1, 0.2]}]})";
}

Named natives() {
  return {{"sound", native(R"({"box": {"center": [10, 3], "size": [1, 6], "angle": 0.3}},
             {"circle": {"center": [14, 8], "radius": 1}},
             {"polygon": [[4, 7], [6, 7], [5, 9]], "holes": [[[4.8, 7.5], [5.2, 7.5], [5, 8]]]})")},
          {"empty_polygon", native(R"({"polygon": []})")},
          {"self_crossing", native(R"({"polygon": [[1, 1], [5, 5], [5, 1], [1, 5]]})")},
          {"all_on_a_line", native(R"({"polygon": [[1, 1], [2, 2], [3, 3]]})")},
          {"at_5e9", native(R"({"box": {"center": [5e9, 5e9], "size": [1, 1]}})")},
          {"nan", native(R"({"circle": {"center": [NaN, 0], "radius": 1}})")},
          {"infinite", native(R"({"circle": {"center": [1e999, 0], "radius": 1}})")},
          {"many", native(repeated(R"({"box": {"center": [10, 3], "size": [1, 6]}},)", 500) +
                          R"({"box": {"center": [10, 3], "size": [1, 6]}})")},
          {"deep", repeated("[", 1000)},
          {"deep_objects", repeated("{\"bounds\":", 1000)},
          {"twice", R"({"bounds": 1, "bounds": 2})"},
          {"half", native("").substr(0, 60)},
          {"key_of_two_lines", R"({"obsta\ncles": []})"},  // once an error of two lines
          {"not_utf8", native("\"\xFF\xFE\"")}};
}

Named dynobenches() {
  const std::string world = "environment:\n  min: [0, 0]\n  max: [10, 6]\n  obstacles:\n";
  return {{"sound", "name: d\n" + world +
                        "    - {type: box, center: [5, 2], size: [0.5, 4], angle: 0.2}\nrobots:\n"
                        "  - {type: car_v0, start: [1, 3, 0, 0.5], goal: [9, 3, 0]}\n"},
          {"no_size", world + "    - {type: box, center: [5, 2]}\n"},
          {"sphere", world + "    - {type: sphere, center: [5, 2], size: [1, 1]}\n"},
          {"nan", world + "    - {type: box, center: [.nan, 2], size: [.inf, -1]}\n"},
          {"at_5e9", world + "    - {type: box, center: [5e9, 2], size: [5e9, 1]}\n"},
          {"deep", "environment: " + repeated("[", 1000)},
          {"aliases",
           "a: &a [x, x, x, x, x, x, x]\nb: &b [*a, *a, *a, *a, *a, *a]\nc: &c [*b, *b, *b, *b, *b]\n"
           "environment: [*c, *c, *c, *c, *c]\n"},
          {"itself", "environment: &a [*a]\n"},
          {"tabs", "environment:\n\tmin: 1\n"}};
}

Named map_servers() {
  const std::string rest =
      "resolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return {{"no_image", "image: gone.pgm\n" + rest},
          {"itself", "image: ../../map\n" + rest},
          {"a_device", "image: /dev/zero\n" + rest},
          {"thresholds", "image: a\nresolution: 1e9\norigin: [1, 2]\noccupied_thresh: .nan\nfree_thresh: 2\n"},
          {"modes",
           "image: a\nmode: raw\nnegate: true\nresolution: 0.05\norigin: [5e9, -.inf, 1]\n"
           "occupied_thresh: 0.65\nfree_thresh: 0.9\n"}};
}

Named movingais() {
  return {{"sound", "type octile\nheight 3\nwidth 4\nmap\n..@@\nTT..\n.S.W\n"},
          {"windows", "type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n..\r\n"},
          {"size_lies", "type octile\nheight 100000\nwidth 100000\nmap\n....\n"},
          {"size_is_huge", "type octile\nheight 2147483647\nwidth 2147483647\nmap\n"},
          {"size_wraps", "type octile\nheight 65536\nwidth 65537\nmap\n"},
          {"negative", "type octile\nheight -1\nwidth 4\nmap\n"},
          {"unknown_cell", "type octile\nheight 1\nwidth 2\nmap\n.x\n"},
          {"row_too_long", "type octile\nheight 1\nwidth 2\nmap\n...\n"},
          {"row_too_many", "type octile\nheight 1\nwidth 2\nmap\n..\n..\n"}};
}

Named tpcaps() {
  const std::string poses = "1,2,0.5,3,4,-0.5,";
  return {{"sound", poses + "2,3,4,0,0,1,0,1,1,5,5,6,5,6,6,5,6\n"},
          {"no_obstacle", poses + "0"},
          {"count_lies", poses + "9999999,3"},
          {"vertices_lie", poses + "1,9999999,0,0"},
          {"fraction", poses + "1.5,3,0,0,1,0,1,1"},
          {"too_many", poses + "1,3,0,0,1,0,1,1,7"},
          {"nan", "nan,inf,-nan,3,4,5,0"},
          {"at_5e9", "5e9,5e9,0,5000000003,5e9,0,0"},
          {"commas", repeated(",", 1000)}};
}

std::string feature(const std::string& properties, const std::string& geometry) {
  return R"({"type": "Feature", "properties": )" + properties + R"(, "geometry": )" + geometry + "}";
}

Named geojsons() {
  const auto collection = [](const std::string& features) {
    return R"({"type": "FeatureCollection", "unit": 1, "features": [)" + features + "]}";
  };
  const std::string square = R"([[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]])";
  const std::string polygon = R"({"type": "Polygon", "coordinates": )" + square + "}";
  const std::string point = R"({"type": "Point", "coordinates": [4, 5, 6]})";
  return {{"sound", collection(feature(R"({"role": "bounds"})", polygon) + "," +
                               feature(R"({"role": "goal", "radius": 1})", point) + "," +
                               feature(R"({"role": "goal", "name": "dock", "radius": 1, "heading": 1})", point) + "," +
                               feature(R"({"role": "start", "heading": 1, "angles": [1]})", point) + "," +
                               feature("null", R"({"type": "MultiPolygon", "coordinates": [)" + square + "]}"))},
          {"degrees", R"({"type": "Polygon", "datum": [11.5, 48.1], "coordinates": [[[11.5, 48.1], [11.501, 48.1],
             [11.5, 48.101], [11.5, 48.1]]]})"},
          {"far_from_datum", R"({"type": "Polygon", "datum": [0, 90], "coordinates": [[[180, -90], [0, 0], [1, 1],
             [180, -90]]]})"},
          {"no_scale", polygon},
          {"collections", collection(feature("{}", repeated(R"({"type": "GeometryCollection", "geometries": [)", 70)))},
          {"open_ring", R"({"type": "Polygon", "unit": 1, "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1]]]})"},
          {"at_5e9", R"({"type": "Polygon", "unit": 1, "coordinates": [[[5e9, 5e9], [5000000009, 5e9],
             [5e9, 5000000009], [5e9, 5e9]]]})"},
          {"huge_unit", R"({"type": "Polygon", "unit": 1e6, "coordinates": [[[0, 0], [1e4, 0], [0, 1e4], [0, 0]]]})"},
          {"nothing", collection("")},
          {"half", collection("").substr(0, 40)}};
}

Named svgs() {
  const auto page = [](const std::string& shapes) {
    return R"(<svg width="20000mm" height="10000mm" viewBox="0 0 20 10">)" + shapes + "</svg>";
  };
  const std::string path = R"(<path d="M1 1h4v4a2 1 30 0 1-4 0zm1 1q1 1 2 0t1 0c1 1 2 2 3 0s1 1 1 1z"/>)";
  return {{"sound", page(R"~(<g transform="translate(1 2) rotate(30)"><rect id="goal" width="1" height="2" rx="0.2"/>
             <circle r="1"/><ellipse rx="1" ry="2"/><polygon points="1,1 2,2 3,1"/></g>
             <line class="start" x1="5" y1="5" x2="6" y2="5"/>)~" +
                         path)},
          {"even_odd", page(R"(<path fill-rule="evenodd" d="M0 0H8V8H0ZM1 1H7V7H1Z"/>)")},
          {"no_scale", R"(<svg><rect width="50%" height="1"/></svg>)"},
          {"transforms", page(R"~(<g transform="matrix(1 2 3 4 5 6),skewX(89.9999),scale(1e9)">)~" + path + "</g>")},
          {"copies", page(R"(<use id="a" href="#a"/><g id="b"><use href="#b"/><use href="#b"/></g>)")},
          {"entities", R"(<!DOCTYPE svg [<!ENTITY a "1"><!ENTITY b "&a;&a;">]>)" + page(R"(<path d="&b;"/>)")},
          {"deep", page(repeated("<g>", 300))},
          {"corners", page(R"(<path d="M0 0Q1e14 1e14 1 1C1e9 1e9 -1e9 1e9 0 0"/>)")},
          {"at_5e9", page(R"(<rect class="bounds" x="5e9" y="5e9" width="9" height="9"/>)")},
          {"nan", page(R"(<path d="MNaN inf"/><rect width="1e400" height="-1"/>)")},
          {"half", page(path).substr(0, 90)}};
}

Named pgms() {
  return {{"binary", std::string("P5 # comment\n3 2\n255\n\0\x40\x80\xC0\xFE\xFF", 26)},
          {"wide", std::string("P5 1 1 65535\n\1\2", 15)},
          {"text", "P2\n3 1\n100\n0 50 100\n"},
          {"size_lies", "P5 100000 100000 255\n...."},
          {"size_wraps", "P5 65536 65536 255\n...."},
          {"size_overflows", "P5 99999999999999999999 1 255\n"},
          {"maximum_zero", "P2 1 1 0 0"},
          {"pixel_over_maximum", "P2 1 1 7 8"},
          {"ends_in_a_comment", "P5 1 1 #"}};
}

Named pngs() {
  using host::encode;
  std::string size_lies = encode({PNG_COLOR_TYPE_GRAY, 8}, 3, {"abc", "def"});
  size_lies[16] = 0x7F;
  const std::string grey = encode({PNG_COLOR_TYPE_GRAY, 8}, 3, {"abc", "def"});
  return {{"grey", grey},
          {"grey_wide", encode({PNG_COLOR_TYPE_GRAY, 16}, 1, {"ab"})},
          {"grey_bits", encode({PNG_COLOR_TYPE_GRAY, 1, true}, 5, {"a", "b", "c"})},
          {"grey_key", encode({PNG_COLOR_TYPE_GRAY, 2, false, true}, 3, {"a"})},
          {"grey_alpha", encode({PNG_COLOR_TYPE_GRAY_ALPHA, 8}, 2, {"abcd"})},
          {"palette", encode({PNG_COLOR_TYPE_PALETTE, 2, false, true}, 4, {"\x1B"})},
          {"rgb", encode({PNG_COLOR_TYPE_RGB, 8, true}, 2, {"abcdef", "ghijkl"})},
          {"rgba_wide", encode({PNG_COLOR_TYPE_RGB_ALPHA, 16}, 1, {"abcdefgh"})},
          {"half", grey.substr(0, grey.size() / 2)},
          {"size_lies", size_lies}};
}

Named bmps() {
  using host::bmp;
  const std::string whole = bmp({24, 2, 2, {}}, {"abcdef", "ghijkl"});
  std::string compressed = whole;
  compressed[30] = 1;
  std::string pixels_first = whole;
  pixels_first[10] = 0;
  return {{"one_bit", bmp({1, 9, 1, {0x000000, 0xFFFFFF}}, {"\xAA\x80"})},
          {"four_bits", bmp({4, 3, 1, {0x000000, 0x102030, 0xFFFFFF}}, {"\x12\x10"})},
          {"eight_bits", bmp({8, 2, -1, {0x000000, 0x102030}}, {std::string("\0\1", 2)})},
          {"no_such_color", bmp({8, 2, 1, {0x000000}}, {"\1\2"})},
          {"rgb", whole},
          {"rgbx", bmp({32, 1, -2, {}}, {"abcd", "efgh"})},
          {"size_lies", bmp({24, 8000, 8000, {}}, {"abc"})},
          {"size_is_huge", bmp({1, 0x7FFFFFFF, -0x7FFFFFFF - 1, {0}}, {"a"})},
          {"compressed", compressed},
          {"pixels_first", pixels_first},
          {"half", whole.substr(0, whole.size() / 2)}};
}

Named jpegs() {
  using host::jpeg;
  const std::string whole = jpeg(16, 8, TJSAMP_GRAY, 100, std::string(16 * 8 * 3, 'a'));
  std::string size_lies = whole;
  size_lies[size_lies.find("\xFF\xC0") + 5] = 0x7F;
  return {{"grey", whole},
          {"color", jpeg(16, 16, TJSAMP_420, 80, std::string(16 * 16 * 3, 'b'))},
          {"progressive", jpeg(9, 7, TJSAMP_444, 50, std::string(9 * 7 * 3, 'c'), TJFLAG_PROGRESSIVE)},
          {"size_lies", size_lies},
          {"half", whole.substr(0, whole.size() / 2)},
          {"start_only", "\xFF\xD8\xFF"}};
}

Named robots() {
  return {{"car", R"({"model": "car", "parameters": {"body_length": 2.5, "max_steering": 0.6}})"},
          {"snake", R"({"model": "snake", "links": 3, "parameters": {"self_collision_gap": 4, "min_speed": -1}})"},
          {"bodies", R"({"model": "unicycle", "bodies": [{"polygon": [[0, 0], [1, 0], [1, 1], [0, 1]]}]})"},
          {"clockwise", R"({"model": "unicycle", "bodies": [{"polygon": [[0, 0], [0, 1], [1, 1], [1, 0]]}]})"},
          {"flat", R"({"model": "unicycle", "bodies": [{"polygon": [[0, 0], [1, 0], [2, 0]]}]})"},
          {"star", R"({"model": "unicycle", "bodies": [{"polygon": [[0, 3], [2, -3], [-3, 1], [3, 1], [-2, -3]]}]})"},
          {"many_links", R"({"model": "truck", "links": 26})"},
          {"nothing", "{}"}};
}

// Turns, drives straight into the goal of fuzz_plan_file and misses the wall.
std::string whole_way() {
  constexpr double kHeading = 0.75;
  constexpr double kSpeed = 0.95;
  std::string states = "[1, 1, 0]";
  std::string controls = "[0, " + std::to_string(kHeading) + "]";
  for (int step = 0; step <= 11; ++step) {
    const double way = kSpeed * step;
    states += ", [" + std::to_string(1 + way * std::cos(kHeading)) + ", " +
              std::to_string(1 + way * std::sin(kHeading)) + ", " + std::to_string(kHeading) + "]";
    if (step > 0) controls += ", [" + std::to_string(kSpeed) + ", 0]";
  }
  return R"("status": "solved", "states": [)" + states + R"(], "controls": [)" + controls + "]}";
}

Named plan_files() {
  const std::string robot = R"("robot": {"model": "unicycle", "links": 0})";
  const std::string head =
      R"({"format": "krait-plan", "version": 1, "scene": "s", "seed": 1, "planner": "adaptive", )" + robot +
      R"(, "dt": 1, "goal": {"name": "g", "polygon": [[8, 8], [9, 8], [9, 9]]}, )"
      R"("state_names": ["x", "y", "theta"], "origin": [0, 0], "statistics": {}, )";
  return {
      {"solved", head + R"("status": "solved", "states": [[1, 1, 0], [1.1, 1, 0]], "controls": [[1, 0]]})"},
      {"holds", head + whole_way()},
      {"unsolved", head + R"("status": "no_route", "states": [], "controls": []})"},
      {"far", head + R"("status": "solved", "states": [[1, 1, 0], [3e38, -3e38, 1e30]], "controls": [[3e38, 3e38]]})"},
      {"one_state_too_many", head + R"("status": "solved", "states": [[1, 1, 0]], "controls": [[1, 0]]})"},
      {"half", head}};
}

Named options() {
  Named all;
  const std::vector<std::vector<std::string>> texts = {
      {"128K", "64G", "18446744073709551615", "65G", "K", ""},
      {"1,2,3", "nan,0,0", "1e7,1e7,1000", "1,2", ",,", "home", "1e999,0,0"},
      {"1,2,3", "1,2,-1", "1,2,0", "dock", "inf,0,1"},
      {"snake:15", "snake:26", "truck:", "car:1", "none.json", "snake:99999999999999999999"},
      {"3", "12", "-1", "1.5", "99999999999999999999"},
      {"11.5,48.1", "181,0", "nan,0", "1,2,3", "-180,-90"}};
  for (std::size_t kind = 0; kind < texts.size(); ++kind) {
    for (std::size_t i = 0; i < texts[kind].size(); ++i) {
      all.emplace_back(std::to_string(kind) + "_" + std::to_string(i), static_cast<char>(kind) + texts[kind][i]);
    }
  }
  return all;
}

// For fuzz_compile: each byte a coordinate on a coarse grid.
Named drawings() {
  return {{"small_angles", std::string("\1\2\20\1\1\37\1\1\37\37\1\1\1", 13)},  // once refined without end
          {"far", std::string("\0\1\10\10\372\10\20\20\10\20\1", 11)},
          {"square", std::string("\0\1\10\10\20\10\20\20\10\20\1", 11)},
          {"crossing", std::string("\1\1\5\5\25\25\25\5\5\25\1\2\1\1\37\37\1\37\37\1\1\5\3\2", 24)},
          {"spike", std::string("\0\0\4\4\36\4\4\4\1\0\10\12\13\14\15\16", 16)}};
}

void write(const std::filesystem::path& folder, const Named& files, const std::string& kind = "") {
  std::filesystem::create_directories(folder);
  for (const auto& [name, bytes] : files) std::ofstream(folder / (kind + name), std::ios::binary) << bytes;
}

}  // namespace
}  // namespace krait::fuzz

int main(int argc, char** argv) {
  using namespace krait::fuzz;
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  write(folder / "fuzz_open", evil_scenes());
  write(folder / "fuzz_plan", plans());
  write(folder / "fuzz_import", evil_scenes(), "scene_");
  write(folder / "fuzz_import", natives(), "native_");
  write(folder / "fuzz_import", dynobenches(), "dynobench_");
  write(folder / "fuzz_import", map_servers(), "map_server_");
  write(folder / "fuzz_import", movingais(), "movingai_");
  write(folder / "fuzz_import", tpcaps(), "tpcap_");
  write(folder / "fuzz_import", geojsons(), "geojson_");
  write(folder / "fuzz_import", svgs(), "svg_");
  write(folder / "fuzz_image", pgms(), "pgm_");
  write(folder / "fuzz_image", pngs(), "png_");
  write(folder / "fuzz_image", bmps(), "bmp_");
  write(folder / "fuzz_image", jpegs(), "jpeg_");
  write(folder / "fuzz_robot", robots());
  write(folder / "fuzz_plan_file", plan_files());
  write(folder / "fuzz_options", options());
  write(folder / "fuzz_compile", drawings());
  return 0;
}
