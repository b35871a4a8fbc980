// SPDX-License-Identifier: Apache-2.0
// GeoJSON (RFC 7946): polygons are obstacles unless the property "role" of their feature says otherwise. Coordinates
// are longitudes and latitudes around a datum, or lengths in a unit: the file or the command line has to say which.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/import/drawing.hpp"
#include "host/import/format.hpp"
#include "host/import/json_keys.hpp"
#include "host/import/local_plane.hpp"
#include "host/import/shapes.hpp"
#include "host/input/facing.hpp"

namespace krait::host {
namespace {

constexpr double kMinRadius = 1e-6;  // m

bool recognise(const Source& source) { return has_top_json_key(source.content, "type"); }

// What coordinates mean.
struct Scale {
  std::optional<LocalPlane> plane;
  double unit = 1;  // m, without a plane

  double metres() const { return plane ? 1 : unit; }  // of one unit of a radius
};

// How the feature around a geometry describes it.
struct Context {
  Role role = Role::obstacle;
  std::string name;
  const Field* properties = nullptr;  // null: none
};

bool is_wgs84(const std::string& crs) {
  return crs.ends_with("CRS84") || crs.ends_with(":4326") || crs.ends_with("/4326");
}

// The member of GeoJSON's first edition, which later ones dropped.
void check_crs(const Field& document) {
  if (!document.has("crs") || document.at("crs").value().is_null()) return;
  const std::string crs = document.at("crs").at("properties").at("name").text();
  if (is_wgs84(crs)) return;
  document.at("crs").fail("is " + cleaned_name(crs) + ", not WGS84: where its unit is the metre, give --unit 1");
}

LonLat read_datum(const Field& field) {
  if (field.size() != 2) field.fail("must be [longitude, latitude]");
  return {field.item(0).number(-kMaxLongitude, kMaxLongitude, "degrees"),
          field.item(1).number(-kMaxLatitude, kMaxLatitude, "degrees")};
}

// The command line goes before the file.
Scale read_scale(const Field& document, const ImportOptions& options) {
  if (options.unit && options.datum) document.fail("--unit and --datum exclude each other: give the one that holds");
  if (options.unit) return {std::nullopt, *options.unit};
  if (options.datum) return {LocalPlane(*options.datum), 1};
  if (document.has("unit") && document.has("datum")) document.fail("has unit and datum: keep the one that holds");
  if (document.has("unit")) return {std::nullopt, document.at("unit").number(kMinUnit, kMaxUnit, "metres")};
  check_crs(document);
  if (document.has("datum")) return {LocalPlane(read_datum(document.at("datum"))), 1};
  document.fail(
      "are its coordinates longitudes and latitudes? Give --datum LONGITUDE,LATITUDE, the point that becomes [0, 0] "
      "(\"datum\" in the file); are they metres? Give --unit 1 (\"unit\": 1)");
}

class Reader {
 public:
  Reader(const std::string& file, const Scale& scale) : drawing_(file), scale_(scale) {}

  void read_object(const Field& object) {
    const std::string type = object.at("type").text();
    if (type == "FeatureCollection") {
      const Field features = object.at("features");
      for (std::size_t i = 0; i < features.size(); ++i) read_feature(features.item(i));
    } else if (type == "Feature") {
      read_feature(object);
    } else {
      read_geometry(object, {});
    }
  }

  Workspace take() { return drawing_.take(); }

 private:
  void read_feature(const Field& feature) {
    if (feature.at("type").text() != "Feature") feature.at("type").fail("must be Feature");
    const Field geometry = feature.at("geometry");
    if (geometry.value().is_null()) return;
    if (!feature.has("properties") || feature.at("properties").value().is_null()) return read_geometry(geometry, {});
    const Field properties = feature.at("properties");
    Context context{Role::obstacle, {}, &properties};
    if (properties.has("role")) context.role = read_role(properties.at("role"));
    const bool named = context.role == Role::goal || context.role == Role::start;
    if (named && properties.has("name")) context.name = properties.at("name").name();
    if (context.role != Role::none) read_geometry(geometry, context);
  }

  static Role read_role(const Field& field) {
    const std::optional<Role> role = role_of(field.text());
    if (!role) field.fail("must be one of " + std::string(kRoles) + ", is \"" + cleaned_name(field.text()) + "\"");
    return *role;
  }

  void read_geometry(const Field& geometry, const Context& context) {
    const std::string type = geometry.at("type").text();
    if (type == "Polygon") return read_polygon(geometry.at("coordinates"), context);
    if (type == "MultiPolygon") return read_each(geometry.at("coordinates"), context, &Reader::read_polygon);
    if (type == "GeometryCollection") return read_each(geometry.at("geometries"), context, &Reader::read_geometry);
    if (type == "Point") return read_point(geometry.at("coordinates"), context);
    if (type == "LineString" || type == "MultiLineString" || type == "MultiPoint") {
      geometry.at("type").fail(type + " has no area: give it one (buffer it), or its feature the role none");
    }
    geometry.at("type").fail("unknown type \"" + cleaned_name(type) + "\"; known are the types of RFC 7946");
  }

  void read_each(const Field& list, const Context& context, void (Reader::*read)(const Field&, const Context&)) {
    for (std::size_t i = 0; i < list.size(); ++i) (this->*read)(list.item(i), context);
  }

  void read_polygon(const Field& rings, const Context& context) {
    const std::size_t count = rings.size(1);
    Obstacle obstacle{rings.place(), read_ring(rings.item(0)), {}};
    for (std::size_t i = 1; i < count; ++i) obstacle.holes.push_back(read_ring(rings.item(i)));
    if (context.role == Role::obstacle) return drawing_.add_obstacle(std::move(obstacle));
    if (context.role == Role::start) rings.fail("a start must be a Point with the property heading");
    if (!obstacle.holes.empty()) rings.item(1).fail("only obstacles can have holes");
    if (context.role == Role::goal) return read_region(std::move(obstacle.outer), context);
    drawing_.set_bounds(rings.place(), obstacle.outer);
  }

  // The last position repeats the first, which a workspace's rings do not.
  Ring read_ring(const Field& positions) const {
    Ring ring(positions.size(4));
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = read_position(positions.item(i));
    if (ring.front().x != ring.back().x || ring.front().y != ring.back().y) {
      positions.fail("is not closed: repeat its first position at its end");
    }
    ring.pop_back();
    return ring;
  }

  // A third number is a height, which a plane has no place for.
  Point read_position(const Field& position) const {
    position.size(2, 4);
    if (!scale_.plane) {
      const double most = kMaxFarCoordinate / scale_.unit;
      return {scale_.unit * position.item(0).number(-most, most), scale_.unit * position.item(1).number(-most, most)};
    }
    const LonLat place{position.item(0).number(-kMaxLongitude, kMaxLongitude, "degrees"),
                       position.item(1).number(-kMaxLatitude, kMaxLatitude, "degrees")};
    if (!scale_.plane->reaches(place)) position.fail("lies more than 100 km from the datum: are both right?");
    return scale_.plane->at(place);
  }

  void read_point(const Field& coordinates, const Context& context) {
    const Point p = read_position(coordinates);
    if (context.role == Role::start) return read_start(p, coordinates, context);
    if (context.properties == nullptr || !context.properties->has("radius")) {
      coordinates.fail("a Point has no area: give its feature the property radius, or the role start or none");
    }
    const double most = kMaxCoordinate / scale_.metres();
    const double radius = scale_.metres() * context.properties->at("radius").number(kMinRadius, most);
    if (context.role == Role::obstacle) {
      return drawing_.add_obstacle({coordinates.place(), ring_around_circle(p, radius), {}});
    }
    if (context.role == Role::goal) return read_goal(p, radius, context);
    coordinates.fail("bounds must be a Polygon");
  }

  void read_region(Ring polygon, const Context& context) {
    if (context.properties->has("heading")) {
      context.properties->at("heading").fail("a goal with a heading must be a Point with the property radius");
    }
    require_no_tolerance(*context.properties);
    drawing_.add_goal(context.name, {{}, std::move(polygon)});
  }

  void read_goal(const Point& position, double radius, const Context& context) {
    if (context.properties->has("heading")) {
      return drawing_.add_goal(context.name, pose_goal({}, {position, radius, read_facing(*context.properties)}));
    }
    require_no_tolerance(*context.properties);
    drawing_.add_goal(context.name, {{}, ring_inside_circle(position, radius)});
  }

  void read_start(const Point& position, const Field& coordinates, const Context& context) {
    if (!context.properties->has("heading")) {
      coordinates.fail("a start needs the property heading: radians, counter-clockwise from east");
    }
    Start start{{}, position, context.properties->at("heading").number(-kMaxAngle, kMaxAngle, "radians"), {}};
    if (context.properties->has("angles")) {
      const Field angles = context.properties->at("angles");
      for (std::size_t i = 0; i < angles.size(0, kMaxLinks); ++i) {
        start.angles.push_back(angles.item(i).number(-kMaxAngle, kMaxAngle, "radians"));
      }
    }
    drawing_.add_start(context.name, std::move(start));
  }

  Drawing drawing_;
  const Scale& scale_;
};

Workspace read(const Source& source, const ImportOptions& options) {
  const Json document = parse_json(source.content, source.path);
  const Field field(document, source.path);
  (void)field.at("type").text();  // before the question for the scale
  const Scale scale = read_scale(field, options);
  Reader reader(source.path, scale);
  reader.read_object(field);
  Workspace workspace = reader.take();
  if (field.has("name") && field.at("name").value().is_string()) workspace.name = cleaned_name(field.at("name").text());
  return workspace;
}

}  // namespace

const Format kGeoJson = {"GeoJSON", ".geojson", recognise, read, {.unit = true, .datum = true}};

}  // namespace krait::host
