// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "../scratch.hpp"
#include "host/import/import.hpp"
#include "png_writer.hpp"

namespace krait::host::import_map_server_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MapServerTest : public ScratchTest {
 protected:
  // A map of one row of grey pixels (0 to 255).
  Workspace read_row(const std::vector<int>& greys, const std::string& rules, Unknown unknown = Unknown::map) const {
    std::string pixels;
    for (const int grey : greys) pixels += std::to_string(grey) + " ";
    write("m.pgm", "P2 " + std::to_string(greys.size()) + " 1 255\n" + pixels);
    return read(rules, unknown);
  }

  Workspace read(const std::string& rules, Unknown unknown = Unknown::map) const {
    return import_workspace(write("m.yaml", "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n" + rules), {unknown});
  }

  std::vector<int> cells(const std::vector<int>& greys, const std::string& rules,
                         Unknown unknown = Unknown::map) const {
    const Workspace w = read_row(greys, rules, unknown);
    return {w.cells->occupied.begin(), w.cells->occupied.end()};
  }

  std::string error(const std::string& yaml) const {
    write("m.pgm", "P2 1 1 1\n0");
    return error_of([&] { import_workspace(write("m.yaml", yaml), {}); });
  }
};

const std::string kUsual = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

// What nav2_map_server answers, written out from its rule: p = 1 - grey / 255; above occupied_thresh 100, below
// free_thresh 0, else -1. 100 and -1 are obstacles here.
TEST_F(MapServerTest, UsualThresholds) {
  EXPECT_THAT(cells({0, 89, 90, 204, 205, 206, 254, 255}, kUsual), ElementsAre(1, 1, 1, 1, 1, 0, 0, 0));
  EXPECT_THAT(cells({0, 89, 90, 204, 205, 206, 254, 255}, kUsual, Unknown::free), ElementsAre(1, 1, 0, 0, 0, 0, 0, 0));
}

TEST_F(MapServerTest, SaysWhichFilesItRead) {
  EXPECT_THAT(read_row({255}, kUsual).files, testing::UnorderedElementsAre(path("m.yaml"), path("m.pgm")));
}

TEST_F(MapServerTest, AMapInBracesIsReadToo) {
  const std::string plain = "{image: m.pgm, resolution: 0.5, origin: [1, 2, 0], negate: 0,\n occupied_thresh: 0.65, ";
  const std::string quoted = R"({"resolution": 0.5, "origin": [1, 2, 0], "occupied_thresh": 0.65, "image": "m.pgm", )";
  write("m.pgm", "P2 2 1 255\n0 255");
  for (const std::string& begin : {plain, quoted}) {
    const Workspace w = import_workspace(write("m.yaml", begin + "\"free_thresh\": 0.196}\n"), {});
    EXPECT_THAT(w.cells->occupied, ElementsAre(1, 0));
    EXPECT_EQ(w.cells->origin.y, 2);
  }
  EXPECT_THAT(error("{ image : m.pgm}"), HasSubstr("m.yaml: resolution, origin"));
  // The key of an inner map, and a longer key, make no map_server YAML of an object.
  EXPECT_THAT(error("{a: {image: m.pgm}, images: 1}"), HasSubstr("is not valid JSON"));
}

TEST_F(MapServerTest, TheNameOfTheImageIsEscapedInMessages) {
  EXPECT_EQ(error("image: \"a\\e[m\\x9B\"\nresolution: 1\norigin: [0, 0, 0]\n" + kUsual),
            path("m.yaml") + ": image: " + path("a\\u001B[m\\u009B") + ": cannot be read: No such file or directory");
}

TEST_F(MapServerTest, TheThresholdsThemselvesAreUnknown) {
  // p = 0.4 and 0.6 exactly at both thresholds: neither below nor above.
  const std::string rules = "occupied_thresh: 0.6\nfree_thresh: 0.4\n";
  EXPECT_THAT(cells({102, 103, 152, 153, 154}, rules, Unknown::free), ElementsAre(0, 0, 0, 0, 0));
  EXPECT_THAT(cells({101, 153, 154}, rules, Unknown::map), ElementsAre(1, 1, 0));
}

TEST_F(MapServerTest, WarnsOfAYawThatMayBeDegreesAndOfPixelsThatModeRawDoesNotKnow) {
  write("m.pgm", "P2 2 1 255\n0 254");
  const Workspace w =
      import_workspace(write("m.yaml", "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 90]\nmode: raw\n" + kUsual), {});
  EXPECT_THAT(w.warnings, ElementsAre(testing::EndsWith("--unknown free makes them free; mode raw knows pixels up to "
                                                        "100 only"),
                                      HasSubstr("m.yaml: the origin's yaw: a heading of 90 radians is more than")));
}

TEST_F(MapServerTest, NegateSwapsBlackAndWhite) {
  const std::string rules = "negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  EXPECT_THAT(cells({0, 49, 50, 165, 166, 255}, rules), ElementsAre(0, 0, 1, 1, 1, 1));
  EXPECT_THAT(cells({0, 49, 50, 165, 166, 255}, rules, Unknown::free), ElementsAre(0, 0, 0, 0, 1, 1));
}

TEST_F(MapServerTest, ScaleModeHasTheSameThresholds) {
  EXPECT_THAT(cells({0, 90, 205, 254}, "mode: scale\n" + kUsual), ElementsAre(1, 1, 1, 0));
}

TEST_F(MapServerTest, RawModeReadsPercent) {
  EXPECT_THAT(cells({0, 19, 20, 65, 66, 100, 101, 255}, "mode: raw\n" + kUsual), ElementsAre(0, 0, 1, 1, 1, 1, 1, 1));
  EXPECT_THAT(cells({0, 19, 20, 65, 66, 100, 101, 255}, "mode: raw\n" + kUsual, Unknown::free),
              ElementsAre(0, 0, 0, 0, 1, 1, 0, 0));
}

TEST_F(MapServerTest, AlphaIsAveragedInTrinaryModeAndTransparentIsUnknown) {
  // (3 grey + alpha) / 4: black 0.75, grey 40 p = 0.632, white transparent, white nearly opaque, black transparent,
  // white.
  const std::string row("\x00\xFF\x28\xFF\xFF\x00\xFF\xFE\x00\x00\xFF\xFF", 12);
  write("m.pgm", encode({PNG_COLOR_TYPE_GRAY_ALPHA, 8}, 6, {row}));
  EXPECT_THAT(read(kUsual).cells->occupied, ElementsAre(1, 1, 1, 1, 1, 0));
  EXPECT_THAT(read(kUsual, Unknown::free).cells->occupied, ElementsAre(1, 0, 0, 0, 0, 0));
  EXPECT_THAT(read("mode: scale\n" + kUsual, Unknown::free).cells->occupied, ElementsAre(1, 1, 0, 0, 0, 0));
}

TEST_F(MapServerTest, ColoursAreAveraged) {
  const std::string row("\xFF\x00\x00\xFF\xFF\x00\xFF\xFF\xF0", 9);  // p = 0.667, 0.333, 0.02
  write("m.pgm", encode({PNG_COLOR_TYPE_RGB, 8}, 3, {row}));
  EXPECT_THAT(read(kUsual, Unknown::free).cells->occupied, ElementsAre(1, 0, 0));
  EXPECT_THAT(read(kUsual).cells->occupied, ElementsAre(1, 1, 0));
}

TEST_F(MapServerTest, Grey205ThatReadsAsFreeIsWarnedOf) {
  const std::string rules = "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
  const Workspace w = read_row({205, 254, 254, 0}, rules);
  EXPECT_THAT(w.cells->occupied, ElementsAre(0, 0, 0, 1));
  ASSERT_EQ(w.warnings.size(), 1U);
  EXPECT_THAT(w.warnings[0], HasSubstr("25 % of the cells are grey 205"));
  EXPECT_THAT(w.warnings[0], HasSubstr("--unknown occupied"));
  EXPECT_THAT(cells({205, 254, 254, 0}, rules, Unknown::occupied), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(read_row({205, 254, 254, 0}, rules, Unknown::occupied).warnings, IsEmpty());
}

TEST_F(MapServerTest, Grey205HereAndThereIsAPensSoftEdge) {
  const auto warnings = [&](const std::vector<int>& greys) {  // cells of a map of 80 by 80
    std::string pixels;
    for (int i = 0; i < 6400; ++i) {
      const bool grey = std::find(greys.begin(), greys.end(), i) != greys.end();
      pixels += grey ? "205 " : "254 ";
    }
    write("m.pgm", "P2 80 80 255\n" + pixels);
    return read("occupied_thresh: 0.65\nfree_thresh: 0.25\n").warnings.size();
  };
  EXPECT_EQ(warnings({}), 0U);
  EXPECT_EQ(warnings({130, 131, 211, 500, 900, 902}), 0U) << "fewer, and no square";
  EXPECT_EQ(warnings({130, 131, 170, 500, 900, 902, 904}), 1U) << "a cell in a thousand";
  EXPECT_EQ(warnings({130, 131, 210, 211}), 1U) << "an area";
}

TEST_F(MapServerTest, TheShareOfUnknownCellsIsWarnedOf) {
  const Workspace w = read_row({205, 205, 254, 0}, kUsual);
  ASSERT_EQ(w.warnings.size(), 1U);
  EXPECT_THAT(w.warnings[0], HasSubstr("50 % of the cells are unknown and count as obstacles; --unknown free"));
  EXPECT_THAT(read_row({205, 205, 254, 0}, kUsual, Unknown::free).warnings[0], HasSubstr("count as free"));
  EXPECT_THAT(read_row({205, 205, 254, 0}, kUsual, Unknown::occupied).warnings, IsEmpty());
  EXPECT_THAT(read_row({254, 0}, kUsual).warnings, IsEmpty());
}

TEST_F(MapServerTest, Grey205ThatReadsAsOccupiedStaysSo) {
  EXPECT_THAT(cells({205}, "occupied_thresh: 0.1\nfree_thresh: 0.05\n", Unknown::free), ElementsAre(1));
}

TEST_F(MapServerTest, TheImagesLastRowIsTheMapsFirst) {
  write("m.pgm", "P2 2 3 255\n 0 254 254 254 254 0");
  const Workspace w = read(kUsual);
  EXPECT_TRUE(w.cells->at(1, 0));
  EXPECT_TRUE(w.cells->at(0, 2));
  EXPECT_FALSE(w.cells->at(0, 0));
  EXPECT_EQ(w.cells->columns, 2);
  EXPECT_EQ(w.cells->rows, 3);
}

TEST_F(MapServerTest, BoundsAreThePlacedMap) {
  write("m.pgm", "P2 2 3 255\n 254 254 254 254 254 254");
  const Workspace w = read(kUsual);
  EXPECT_EQ(w.min.x, 1);
  EXPECT_EQ(w.min.y, 2);
  EXPECT_EQ(w.max.x, 2);
  EXPECT_EQ(w.max.y, 3.5);
  EXPECT_THAT(w.obstacles, IsEmpty());
}

TEST_F(MapServerTest, OutsideATurnedMapEverythingIsObstacle) {
  write("m.pgm", "P2 4 2 255\n 254 254 254 254 254 254 254 254");
  const double yaw = std::numbers::pi / 6;
  const Workspace w = import_workspace(
      write("m.yaml", "image: m.pgm\nresolution: 1\norigin: [10, 20, " + std::to_string(yaw) + "]\n" + kUsual), {});
  EXPECT_NEAR(w.min.x, 10 - 2 * std::sin(yaw), 1e-5);
  EXPECT_NEAR(w.min.y, 20, 1e-5);
  EXPECT_NEAR(w.max.x, 10 + 4 * std::cos(yaw), 1e-5);
  EXPECT_NEAR(w.max.y, 20 + 4 * std::sin(yaw) + 2 * std::cos(yaw), 1e-5);
  ASSERT_EQ(w.obstacles.size(), 1U);
  EXPECT_LT(w.obstacles[0].outer[0].x, w.min.x);
  ASSERT_EQ(w.obstacles[0].holes.size(), 1U);
  EXPECT_NEAR(w.obstacles[0].holes[0][2].x, 10 + 4 * std::cos(yaw) - 2 * std::sin(yaw), 1e-5);
  EXPECT_NEAR(w.obstacles[0].holes[0][2].y, 20 + 4 * std::sin(yaw) + 2 * std::cos(yaw), 1e-5);
}

TEST_F(MapServerTest, NegateMayBeABoolean) {
  EXPECT_THAT(cells({0, 255}, "negate: true\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), ElementsAre(0, 1));
  EXPECT_THAT(cells({0, 255}, "negate: false\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), ElementsAre(1, 0));
}

TEST_F(MapServerTest, WrongFieldsAreNamed) {
  const std::string start = "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n";
  EXPECT_EQ(error(start + kUsual), "");
  EXPECT_THAT(error("image: m.pgm\norigin: [1, 2, 0]\n" + kUsual), HasSubstr("m.yaml: resolution: is missing"));
  EXPECT_THAT(error("resolution: 1\norigin: [1, 2, 0]\n" + kUsual), HasSubstr("m.yaml: image: is missing"));
  EXPECT_THAT(error("image: m.pgm\nresolution: -1\norigin: [1, 2, 0]\n" + kUsual), HasSubstr("resolution: must be"));
  EXPECT_THAT(error("image: m.pgm\nresolution: .nan\norigin: [1, 2, 0]\n" + kUsual), HasSubstr("resolution: must be"));
  EXPECT_THAT(error("image: m.pgm\nresolution: \"1\"\norigin: [1, 2, 0]\n" + kUsual), HasSubstr("resolution: must be"));
  EXPECT_THAT(error("image: m.pgm\nresolution: 1\norigin: [1, 2]\n" + kUsual),
              HasSubstr("origin: must be [x, y, yaw]"));
  EXPECT_THAT(error("image: m.pgm\nresolution: 1\norigin: [1, .inf, 0]\n" + kUsual), HasSubstr("origin[1]: must be"));
  EXPECT_THAT(error("image: m.pgm\nresolution: 1e4\norigin: [9999999999, 2, 0]\n" + kUsual),
              HasSubstr("resolution: the map"));
  EXPECT_THAT(error(start + "occupied_thresh: 65\nfree_thresh: 0.196\n"),
              HasSubstr("occupied_thresh: must be a number"));
  EXPECT_THAT(error(start + "occupied_thresh: 0.65\n"), HasSubstr("free_thresh: is missing"));
  EXPECT_THAT(error(start), HasSubstr("m.yaml: occupied_thresh, free_thresh: are missing"));
  EXPECT_THAT(error(start + "ocupied_thresh: 0.65\n"),
              HasSubstr("occupied_thresh: is missing; is \"ocupied_thresh\" it, misspelt?"));
  EXPECT_THAT(error(start + "occupied_thresh: 0.1\nfree_thresh: 0.2\n"), HasSubstr("free_thresh: must not be over"));
  EXPECT_THAT(error(start + "negate: 2\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), HasSubstr("negate: must be"));
  EXPECT_THAT(error(start + "mode: binary\n" + kUsual),
              HasSubstr("mode: must be trinary, scale or raw, is \"binary\""));
  EXPECT_THAT(error(start + "mode: raw\nnegate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"),
              HasSubstr("negate: ROS 1"));
  EXPECT_THAT(error(start + kUsual + "negate: 1\n"), HasSubstr("key \"negate\" is given twice"));
}

TEST_F(MapServerTest, AMissingImageIsNamedWithItsMap) {
  const std::string rest = "\nresolution: 0.5\norigin: [1, 2, 0]\n" + kUsual;
  EXPECT_THAT(error("image: none.pgm" + rest),
              HasSubstr(path("m.yaml") + ": image: " + path("none.pgm") + ": cannot be read"));
  EXPECT_THAT(error("image: m.yaml" + rest), HasSubstr("is no PGM (P2 or P5), PNG, BMP or JPEG image"));
  EXPECT_THAT(error("image: ." + rest), HasSubstr("is a directory"));
  EXPECT_THAT(error("image: ''" + rest), HasSubstr("must be the path of an image"));
  std::filesystem::create_symlink("loop.pgm", path("loop.pgm"));
  EXPECT_THAT(error("image: loop.pgm" + rest), HasSubstr("symbolic links"));
}

TEST_F(MapServerTest, AnAbsoluteImagePathIsTakenAsItIs) {
  std::filesystem::create_directory(path("images"));
  write("images/a.pgm", "P2 1 1 255\n0");
  const std::string yaml = "image: " + path("images/a.pgm") + "\nresolution: 1\norigin: [0, 0, 0]\n" + kUsual;
  EXPECT_EQ(import_workspace(write("m.yaml", yaml), {}).cells->columns, 1);
}

}  // namespace
}  // namespace krait::host::import_map_server_test
