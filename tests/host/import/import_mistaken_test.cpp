// SPDX-License-Identifier: Apache-2.0
// Files that are no maps, or maps under the name of another format.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_mistaken_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MistakenTest : public ScratchTest {
 protected:
  std::string error(const std::string& name, const std::string& content) const {
    return error_of([&] { import_workspace(write(name, content), {}); });
  }
  std::vector<std::string> warnings(const std::string& name, const std::string& content) const {
    return import_workspace(write(name, content), {}).warnings;
  }
};

const std::string kMap = R"({"bounds": {"min": [0, 0], "max": [9, 9]}})";
const std::string kDrawing = R"(<svg width="9000mm" height="9000mm" viewBox="0 0 9 9"><circle r="1"/></svg>)";

TEST_F(MistakenTest, RobotsAndPlansAreNamed) {
  EXPECT_EQ(error("car.json", R"({"model": "car", "parameters": {}})"),
            path("car.json") + ": is a robot, not a map: give it to --robot");
  EXPECT_EQ(error("plan.json", R"({"format": "krait-plan", "robot": {"model": "car"}, "controls": []})"),
            path("plan.json") + ": is a plan, not a map: krait verify MAP PLAN judges it");
  EXPECT_THAT(error("model.yaml", "max_vel: 0.5\ndynamics: unicycle1\n"),
              HasSubstr("is a robot of dynobench, not a map: give a problem, which has an environment"));
  EXPECT_THAT(warnings("m.yaml", "dynamics: 1\nenvironment:\n  min: [0, 0]\n  max: [1, 1]\n"), IsEmpty());
  EXPECT_THAT(error("t.json", R"({"type": "Topology", "arcs": []})"), HasSubstr("is TopoJSON: convert it to GeoJSON"));
  EXPECT_THAT(error("a.json", R"({"model": 1, "bounds": 2})"), HasSubstr("unknown key \"model\""));
}

TEST_F(MistakenTest, PicturesAndArchivesAreNamed) {
  for (const char* image : {"P5 1 1 255\nx", "\x89PNG\r\n\x1a\n", "BM123", "\xFF\xD8\xFF\xE0"}) {
    EXPECT_THAT(error("m.yaml", image), HasSubstr("is an image alone; give the map's YAML file")) << image;
    EXPECT_THAT(error("room.png", image), HasSubstr("or write one, a line each: image: room.png, resolution: 0.05"));
  }
  EXPECT_THAT(error("m", "GIF89a"), HasSubstr("convert it to PNG, and give a map_server YAML that names it"));
  EXPECT_THAT(error("m", "\x1F\x8B\x08"), HasSubstr("is compressed: unpack it first"));
  EXPECT_THAT(error("m", "%PDF-1.4"), HasSubstr("is a PDF: save its drawing as SVG"));
}

TEST_F(MistakenTest, OtherMapsAndPagesAreNamed) {
  EXPECT_THAT(error("p.html", "<!DOCTYPE HTML><body>" + kDrawing), HasSubstr("is a web page, not a map"));
  EXPECT_THAT(error("o.osm", "<?xml version=\"1.0\"?><osm version=\"0.6\"/>"),
              HasSubstr("OpenStreetMap's XML: convert"));
  EXPECT_THAT(error("a.scen", "version 1\n0\tarena.map"), HasSubstr("is a list of MovingAI queries: give the .map"));
  EXPECT_THAT(error("a.dxf", "  0\r\nSECTION\r\n"), HasSubstr("is a DXF drawing: save it as SVG"));
  EXPECT_THAT(error("r.xml", "<robot name=\"a\"/>"), HasSubstr("is a robot's URDF, not a map"));
}

// Other drawings for screen readers begin as krait's pictures do.
TEST_F(MistakenTest, ADrawingWithATitleIsAMap) {
  EXPECT_THAT(
      warnings("icon.svg", R"(<svg width="9000mm" height="9000mm" viewBox="0 0 9 9" role="img"><title>a</title>)"
                           R"(<circle r="1"/></svg>)"),
      IsEmpty());
}

TEST_F(MistakenTest, AMapUnderAnotherNameIsReadAndSaysSo) {
  EXPECT_THAT(warnings("m.json", kDrawing),
              ElementsAre(path("m.json") + ": is read as SVG, which it is, whatever its name says"));
  EXPECT_THAT(warnings("m.svg", kMap), ElementsAre(HasSubstr("is read as krait's JSON")));
  EXPECT_THAT(warnings("m.csv", "type octile\nheight 1\nwidth 1\nmap\n.\n"),
              ElementsAre(HasSubstr("is read as MovingAI .map")));
  EXPECT_THAT(warnings("m.map", kMap), ElementsAre(HasSubstr("is read as krait's JSON")));
  write("m.pgm", std::string("P5 1 1 255\n\xFF"));
  EXPECT_THAT(warnings("m.json",
                       "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                       "free_thresh: 0.196\n"),
              ElementsAre(HasSubstr("m.json: is read as map_server YAML")));
  EXPECT_THAT(warnings("m.txt", kMap), IsEmpty());
  EXPECT_THAT(warnings("m.yaml", "environment:\n  min: [0, 0]\n  max: [1, 1]\n"), IsEmpty());
}

TEST_F(MistakenTest, OptionsThatSayNothingOfTheFormatAreRefused) {
  const auto refusal = [&](const std::string& name, const std::string& content, const ImportOptions& options) {
    return error_of([&] { import_workspace(write(name, content), options); });
  };
  EXPECT_EQ(refusal("m.json", kMap, {.unit = 1}),
            path("m.json") + ": --unit says nothing of krait's JSON: leave it out");
  EXPECT_THAT(refusal("m.json", kMap, {.unknown = Unknown::free}), HasSubstr("--unknown says nothing of krait's JSON"));
  EXPECT_THAT(refusal("m.json", kMap, {.datum = LonLat{}}), HasSubstr("--datum says nothing of krait's JSON"));
  EXPECT_THAT(refusal("m.svg", kDrawing, {.datum = LonLat{}}), HasSubstr("--datum says nothing of SVG"));
  EXPECT_EQ(refusal("m.svg", kDrawing, {.unit = 1}), "");
  EXPECT_EQ(refusal("m.json", kMap, {}), "");
}

TEST_F(MistakenTest, WithoutContentToGoByTheNameDecides) {
  EXPECT_THAT(error("m.json", "[]"), HasSubstr("must be an object"));
  EXPECT_THAT(error("m.geojson", "[]"), HasSubstr("must be an object"));
  EXPECT_THAT(error("m.svg", "hello"), HasSubstr("is not valid XML"));
  EXPECT_THAT(error("m.csv", "hello"), HasSubstr("value 1: the x of the start must be a number"));
  EXPECT_THAT(error("m.map", "hello"), HasSubstr("line 1: must be \"type octile\""));
}

}  // namespace
}  // namespace krait::host::import_mistaken_test
