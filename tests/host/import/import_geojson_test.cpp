// SPDX-License-Identifier: Apache-2.0
// GeoJSON by hand: every geometry and role, both meanings of coordinates, and files made to hurt.
#include <gmock/gmock.h>

#include <cmath>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_geojson_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kSquare = "[[0, 0], [10, 0], [10, 8], [0, 8], [0, 0]]";
const std::string kTriangle = "[[2, 2], [4, 2], [4, 5], [2, 2]]";

std::string polygon(const std::string& rings) { return R"({"type": "Polygon", "coordinates": [)" + rings + "]}"; }

std::string feature(const std::string& geometry, const std::string& properties = "null") {
  return R"({"type": "Feature", "geometry": )" + geometry + R"(, "properties": )" + properties + "}";
}

std::string collection(const std::string& features, const std::string& members = R"("unit": 1)") {
  return R"({"type": "FeatureCollection", )" + members + R"(, "features": [)" + features + "]}";
}

const std::string kBounds = feature(polygon(kSquare), R"({"role": "bounds"})");

class GeoJsonTest : public ScratchTest {
 protected:
  Workspace read(const std::string& content, const ImportOptions& options = {}) const {
    return import_workspace(write("map.geojson", content), options);
  }
  std::string error(const std::string& content, const ImportOptions& options = {}) const {
    return error_of([&] { read(content, options); });
  }
  // Of a feature among sound ones.
  Workspace read_feature(const std::string& geometry, const std::string& properties = "null") const {
    return read(collection(kBounds + ", " + feature(geometry, properties)));
  }
  std::string feature_error(const std::string& geometry, const std::string& properties = "null") const {
    return error_of([&] { read_feature(geometry, properties); });
  }
};

void expect_ring(const Ring& ring, const Ring& expected) {
  ASSERT_EQ(ring.size(), expected.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_EQ(ring[i].x, expected[i].x) << i;
    EXPECT_EQ(ring[i].y, expected[i].y) << i;
  }
}

TEST_F(GeoJsonTest, PolygonsAreObstaclesWithHoles) {
  const Workspace w = read_feature(polygon(kSquare + ", " + kTriangle), R"({"role": "obstacle", "height": 3})");
  ASSERT_EQ(w.obstacles.size(), 1U);
  EXPECT_EQ(w.obstacles[0].label, "features[1].geometry.coordinates");
  expect_ring(w.obstacles[0].outer, {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
  ASSERT_EQ(w.obstacles[0].holes.size(), 1U);
  expect_ring(w.obstacles[0].holes[0], {{2, 2}, {4, 2}, {4, 5}});
  EXPECT_EQ(w.max.x, 10);
  EXPECT_EQ(w.max.y, 8);
  EXPECT_THAT(w.warnings, IsEmpty());
}

TEST_F(GeoJsonTest, CollectionsAndMultiPolygonsAreUnpacked) {
  const std::string both = R"({"type": "MultiPolygon", "coordinates": [[)" + kTriangle + "], [" + kTriangle + "]]}";
  const Workspace w =
      read_feature(R"({"type": "GeometryCollection", "geometries": [)" + both + ", " + polygon(kTriangle) + "]}");
  ASSERT_EQ(w.obstacles.size(), 3U);
  EXPECT_EQ(w.obstacles[1].label, "features[1].geometry.geometries[0].coordinates[1]");
}

TEST_F(GeoJsonTest, GoalsAndStartsHaveTheirProperties) {
  const Workspace w = read(
      collection(kBounds + ", " + feature(polygon(kTriangle), R"({"role": "goal"})") + ", " +
                 feature(R"({"type": "Point", "coordinates": [5, 6]})", R"({"role": "goal", "radius": 0.5})") + ", " +
                 feature(R"({"type": "Point", "coordinates": [1, 2, 99]})",
                         R"({"role": "start", "name": "home", "heading": 0.5, "angles": [0.25, -1]})")));
  ASSERT_EQ(w.goals.size(), 2U);
  EXPECT_EQ(w.goals[0].name, "goal");
  expect_ring(w.goals[0].polygon, {{2, 2}, {4, 2}, {4, 5}});
  EXPECT_EQ(w.goals[1].name, "goal 2");
  for (const Point& p : w.goals[1].polygon) EXPECT_NEAR(std::hypot(p.x - 5, p.y - 6), 0.5, 1e-6);
  ASSERT_EQ(w.starts.size(), 1U);
  EXPECT_EQ(w.starts[0].name, "home");
  EXPECT_EQ(w.starts[0].position.y, 2);
  EXPECT_EQ(w.starts[0].heading, 0.5);
  EXPECT_THAT(w.starts[0].angles, ElementsAre(0.25, -1));
}

TEST_F(GeoJsonTest, APointWithARadiusIsADisc) {
  const Workspace w = read_feature(R"({"type": "Point", "coordinates": [5, 6]})", R"({"radius": 2})");
  ASSERT_EQ(w.obstacles.size(), 1U);
  for (const Point& p : w.obstacles[0].outer) EXPECT_GE(std::hypot(p.x - 5, p.y - 6), 2);
}

TEST_F(GeoJsonTest, AGoalMayHaveAHeading) {
  const std::string point = R"({"type": "Point", "coordinates": [3, 4]})";
  const std::string heading = R"({"role": "goal", "radius": 0.5, "heading": 1.5, "either_way": true})";
  const Workspace w = read(collection(kBounds + ", " + feature(point, heading), R"("unit": 0.5)"));
  ASSERT_TRUE(w.goals.at(0).pose);
  EXPECT_EQ(w.goals[0].name, "goal");
  EXPECT_EQ(w.goals[0].pose->position.x, 1.5);
  EXPECT_EQ(w.goals[0].pose->radius, 0.25);
  EXPECT_EQ(w.goals[0].pose->facing.heading, 1.5);
  EXPECT_TRUE(w.goals[0].pose->facing.either_way);
  EXPECT_FALSE(read_feature(point, R"({"role": "goal", "radius": 0.5})").goals.at(0).pose);
  EXPECT_THAT(feature_error(point, R"({"role": "goal", "radius": 0.5, "heading_tolerance": 1})"),
              HasSubstr("properties.heading_tolerance: needs a heading beside it"));
  EXPECT_THAT(feature_error(point, R"({"role": "goal", "radius": 0.5, "heading": 1, "heading_tolerance": 9})"),
              HasSubstr("properties.heading_tolerance: must be a number from"));
  EXPECT_THAT(feature_error(polygon(kSquare), R"({"role": "goal", "heading": 1})"),
              HasSubstr("properties.heading: a goal with a heading must be a Point with the property radius"));
}

TEST_F(GeoJsonTest, FeaturesWithoutGeometryOrWithRoleNoneAreSkipped) {
  EXPECT_THAT(read_feature("null").obstacles, IsEmpty());
  EXPECT_THAT(read_feature(R"({"type": "LineString", "coordinates": []})", R"({"role": "none"})").obstacles, IsEmpty());
}

TEST_F(GeoJsonTest, AGeometryAloneIsAMap) {
  const Workspace w = read(R"({"type": "Polygon", "name": "yard", "unit": 0.5, "coordinates": [)" + kSquare + "]}");
  EXPECT_EQ(w.name, "yard");
  EXPECT_EQ(w.max.x, 5);
  EXPECT_THAT(w.warnings, ElementsAre(HasSubstr("has no bounds; they are the box around all its shapes")));
}

TEST_F(GeoJsonTest, BoundsOfAnotherShapeLeaveTheirOutsideBlocked) {
  const Workspace w = read(collection(feature(polygon(kTriangle), R"({"role": "bounds"})")));
  EXPECT_EQ(w.min.x, 2);
  EXPECT_EQ(w.max.y, 5);
  ASSERT_EQ(w.obstacles.size(), 1U);
  expect_ring(w.obstacles[0].outer, {{0, -1}, {6, -1}, {6, 8}, {0, 8}});
  expect_ring(w.obstacles[0].holes[0], {{2, 2}, {4, 2}, {4, 5}});
}

TEST_F(GeoJsonTest, DegreesLieAroundTheDatum) {
  const std::string degrees = "[[20, 0], [20.001, 0], [20.001, 0.001], [20, 0.001], [20, 0]]";
  const std::string with_datum = R"({"type": "Polygon", "datum": [20, 0], "coordinates": [)" + degrees + "]}";
  for (const Workspace& w : {read(with_datum), read(polygon(degrees), {.datum = LonLat{20, 0}}),
                             read(R"({"unit": 1, )" + polygon(degrees).substr(1), {.datum = LonLat{20, 0}})}) {
    EXPECT_NEAR(w.min.x, 0, 1e-6);
    EXPECT_NEAR(w.max.x, 111.320, 0.001);
    EXPECT_NEAR(w.max.y, 110.574, 0.001);
  }
  EXPECT_EQ(read(with_datum, {.unit = 1}).max.x, 20.001) << "the command line goes before the file";
}

TEST_F(GeoJsonTest, AmbiguityIsRefused) {
  EXPECT_EQ(
      error(polygon(kSquare)),
      path("map.geojson") +
          ": are its coordinates longitudes and latitudes? Give --datum LONGITUDE,LATITUDE, the point that becomes "
          "[0, 0] (\"datum\" in the file); are they metres? Give --unit 1 (\"unit\": 1)");
  EXPECT_THAT(error(polygon(kSquare), {.unit = 1, .datum = LonLat{}}), HasSubstr("--unit and --datum exclude"));
  EXPECT_THAT(error(collection(kBounds, R"("unit": 1, "datum": [0, 0])")), HasSubstr("has unit and datum"));
}

TEST_F(GeoJsonTest, OtherReferenceSystemsNeedAUnit) {
  const auto with_crs = [](const std::string& name) {
    return collection(kBounds, R"("datum": [0, 0], "crs": {"type": "name", "properties": {"name": ")" + name + "\"}}");
  };
  EXPECT_THAT(error(with_crs("urn:ogc:def:crs:EPSG::25832")),
              HasSubstr("crs: is urn:ogc:def:crs:EPSG::25832, not WGS84: where its unit is the metre, give --unit 1"));
  EXPECT_EQ(read(with_crs("urn:ogc:def:crs:EPSG::25832"), {.unit = 1}).max.x, 10);
  EXPECT_THAT(error(with_crs("urn:ogc:def:crs:OGC:1.3:CRS84")), HasSubstr("lies more than 100 km from the datum"));
}

TEST_F(GeoJsonTest, ANativeMapWithTheWordTypeStaysNative) {
  EXPECT_EQ(import_workspace(write("n.json", R"({"name": "type", "bounds": {"min": [0, 0], "max": [1, 1]}})"), {}).name,
            "type");
  EXPECT_THAT(error_of([&] { import_workspace(write("n.json", R"({"bounds": {"type": 1}})"), {}); }),
              HasSubstr("bounds: unknown key \"type\""));
  EXPECT_EQ(import_workspace(write("n.json", collection(kBounds)), {}).max.y, 8);
}

TEST_F(GeoJsonTest, WrongGeometriesAreNamed) {
  EXPECT_EQ(feature_error(polygon("[[0, 0], [1, 0], [1, 1], [0, 1]]")),
            path("map.geojson") +
                ": features[1].geometry.coordinates[0]: is not closed: repeat its first position at its end");
  EXPECT_THAT(feature_error(polygon("[[0, 0], [1, 0], [0, 0]]")),
              HasSubstr("coordinates[0]: must be a list of at least"));
  EXPECT_THAT(feature_error(polygon("[[0], [1, 0], [1, 1], [0]]")),
              HasSubstr("coordinates[0][0]: must be a list of at"));
  EXPECT_THAT(feature_error(polygon("")), HasSubstr("coordinates: must be a list of at least 1"));
  EXPECT_THAT(feature_error(polygon("[[0, 0], [1, null], [1, 1], [0, 0]]")),
              HasSubstr("coordinates[0][1][1]: must be"));
  EXPECT_THAT(feature_error(polygon("[[0, 0], [1, 2e10], [1, 1], [0, 0]]")),
              HasSubstr("coordinates[0][1][1]: must be"));
  EXPECT_THAT(feature_error(R"({"type": "LineString", "coordinates": []})"), HasSubstr("LineString has no area: give"));
  EXPECT_THAT(feature_error(R"({"type": "Point", "coordinates": [1, 2]})"), HasSubstr("a Point has no area: give"));
  EXPECT_THAT(feature_error(R"({"type": "Circle"})"), HasSubstr("geometry.type: unknown type \"Circle\""));
  EXPECT_THAT(feature_error("{}"), HasSubstr("features[1].geometry.type: is missing"));
  EXPECT_THAT(error(collection("1")), HasSubstr("features[0]: must be an object"));
  EXPECT_THAT(error(collection(polygon(kSquare))), HasSubstr("features[0].type: must be Feature"));
  EXPECT_THAT(error(collection("")), HasSubstr("is empty: it has no shape"));
}

TEST_F(GeoJsonTest, WrongPropertiesAreNamed) {
  const std::string point = R"({"type": "Point", "coordinates": [1, 2]})";
  EXPECT_THAT(
      feature_error(polygon(kSquare), R"({"role": "wall"})"),
      HasSubstr("features[1].properties.role: must be one of obstacle, bounds, goal, start, none, is \"wall\""));
  EXPECT_THAT(feature_error(polygon(kSquare), R"({"role": "bounds"})"), HasSubstr("there are bounds already"));
  EXPECT_THAT(feature_error(polygon(kSquare), R"({"role": "start"})"), HasSubstr("a start must be a Point"));
  EXPECT_THAT(feature_error(polygon(kSquare + "," + kTriangle), R"({"role": "goal"})"),
              HasSubstr("coordinates[1]: only obstacles can have holes"));
  EXPECT_THAT(feature_error(point, R"({"role": "start"})"), HasSubstr("a start needs the property heading"));
  EXPECT_THAT(feature_error(point, R"({"role": "bounds", "radius": 1})"), HasSubstr("bounds must be a Polygon"));
  EXPECT_THAT(feature_error(point, R"({"radius": -1})"), HasSubstr("properties.radius: must be a number"));
  EXPECT_THAT(feature_error(point, R"({"role": "goal", "radius": 1, "name": "a\u202eb"})"),
              HasSubstr("properties.name: must be a name"));
  EXPECT_THAT(error(collection(kBounds, R"("unit": 0)")), HasSubstr("unit: must be a number from"));
  EXPECT_THAT(error(collection(kBounds, R"("datum": [0, 91])")), HasSubstr("datum[1]: must be a number"));
}

TEST_F(GeoJsonTest, FilesMadeToHurtEndInALine) {
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += R"({"type": "GeometryCollection", "geometries": [)";
  EXPECT_THAT(error(deep), HasSubstr("nested deeper than 64"));
  const std::string whole = collection(kBounds);
  for (std::size_t length = 1; length < whole.size(); ++length) {
    EXPECT_THAT(error(whole.substr(0, length)), HasSubstr("map.geojson: is not valid JSON"));
  }
  EXPECT_THAT(error(collection(feature(polygon("[[1, 1], [1, 1], [1, 1], [1, 1]]")))), HasSubstr("have no area"));
}

}  // namespace
}  // namespace krait::host::import_geojson_test
