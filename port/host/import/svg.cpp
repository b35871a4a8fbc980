// SPDX-License-Identifier: Apache-2.0
// SVG drawings: filled shapes are obstacles unless a class, id or label says otherwise. One unit of the drawing is what
// its width and viewBox make of it; y points up in the map, so that (x, y) of the drawing is (x, -y).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>

#include "host/import/format.hpp"
#include "host/import/shapes.hpp"
#include "host/import/svg_path.hpp"
#include "host/import/svg_style.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr double kFlatness = 0.001;              // m, between a curve of a path and its polygon
constexpr double kPixel = 0.0254 / 96;           // m, a user unit where the drawing has no other
constexpr double kSmall = 1;                     // m: a map that is smaller has a unit that was not meant
constexpr std::size_t kMaxCorners = 4'000'000;   // of a drawing
constexpr std::size_t kMaxElements = 1'000'000;  // of a drawing, copies by <use> counted
constexpr std::size_t kMaxRead = 128'000'000;    // bytes of attributes that are read, copies counted
constexpr std::size_t kFillWork = 200'000'000;   // comparisons of edges

bool recognise(const Source& source) {
  const std::string_view head = std::string_view(source.content).substr(0, 4096);
  const std::size_t first = text_begin(head);
  if (first == std::string_view::npos || head[first] != '<') return false;
  return head.find("<svg") != std::string_view::npos;
}

struct ViewBox {
  double x = 0, y = 0, width = 0, height = 0;
};

// The page and what one of its units is.
struct Page {
  std::optional<ViewBox> view;  // in units
  double unit = kPixel;         // m
  bool has_scale = false;       // a physical one, or the user's
};

std::optional<ViewBox> read_view(const pugi::xml_node& svg, const SvgPlaces& places) {
  if (!svg.attribute("viewBox")) return std::nullopt;
  SvgScanner text = places.scan(svg, "viewBox");
  ViewBox view;
  for (double* value : {&view.x, &view.y, &view.width, &view.height}) *value = text.number();
  if (!text.done() || !(view.width > 0 && view.height > 0)) text.fail("must be x, y, width and height, above 0");
  return view;
}

bool is_relative(const pugi::xml_node& svg, const char* attribute) {
  const std::string_view value = svg.attribute(attribute).value();
  return value.empty() || value.ends_with('%') || value == "auto";
}

bool is_physical(const pugi::xml_node& svg) {
  const std::string_view width = svg.attribute("width").value();
  return !width.empty() && (width.back() < '0' || width.back() > '9') && !width.ends_with("px");
}

// The pixels of a unit: the view fits into width and height as a whole.
double fit(const pugi::xml_node& svg, const SvgPlaces& places, double across, double up) {
  constexpr double kRounding = 1e-4;  // of widths and heights, relative
  const std::string_view ratio = svg.attribute("preserveAspectRatio").value();
  const bool fits = ratio.find("none") == std::string_view::npos && ratio.find("slice") == std::string_view::npos;
  if (!fits && std::abs(across - up) > kRounding * up) {
    places.fail(svg,
                "preserveAspectRatio: none and slice are read only where the viewBox is as wide for its height as "
                "the page: leave it out, or give width and height the viewBox's proportions");
  }
  return std::min(across, up);
}

Page read_page(const pugi::xml_node& svg, const SvgPlaces& places, const ImportOptions& options) {
  Page page;
  page.view = read_view(svg, places);
  if (!is_relative(svg, "width") && !is_relative(svg, "height")) {
    const double width = places.length(svg, "width");
    const double height = places.length(svg, "height");
    if (!(width > 0 && height > 0)) places.fail(svg, "width and height must be above 0");
    if (page.view) {
      page.unit = kPixel * fit(svg, places, width / page.view->width, height / page.view->height);
      page.has_scale = is_physical(svg);
    } else {
      page.view = {0, 0, width, height};
    }
  }
  if (options.unit) {
    page.unit = *options.unit;
    page.has_scale = true;
  }
  if (!(page.unit >= kMinUnit && page.unit <= kMaxUnit)) {
    places.fail(svg, "width, height and viewBox make one unit " + shown(page.unit) + " m long: give --unit METRES");
  }
  return page;
}

class Reader {
 public:
  Reader(const std::string& file, const SvgPlaces& places, const Page& page)
      : file_(file), places_(places), page_(page), drawing_(file) {}

  Workspace read(const pugi::xml_node& svg) {
    SvgStyle style;
    style.place = {page_.unit, 0, 0, -page_.unit, 0, 0};
    read_children(svg, style, 0);
    if (!drawing_.has_bounds() && page_.view) bound_by_page(*page_.view);
    warn();
    Workspace workspace = drawing_.take();
    warn_of_size(workspace);
    return workspace;
  }

 private:
  void read_children(const pugi::xml_node& parent, const SvgStyle& style, int depth) {
    if (depth > kMaxDepth) places_.fail(parent, "is nested deeper than " + std::to_string(kMaxDepth));
    for (const pugi::xml_node& child : parent.children()) {
      if (child.type() == pugi::node_element) read_element(child, style, depth);
    }
  }

  void read_element(const pugi::xml_node& element, const SvgStyle& outer, int depth) {
    if (++elements_ > kMaxElements) places_.fail(element, more_than(kMaxElements, "elements"));
    const std::string_view name = element.name();
    const SvgStyle style = style_of(element, outer);
    if (style.role == Role::none || !style.is_shown) return;
    const bool groups = name == "g" || name == "a" || name == "switch";
    if (groups || name == "use" || is_shape(name)) check_placing(element, places_);
    if (groups) return read_children(element, style, depth + 1);
    if (name == "use") return read_use(element, style, depth);
    if (name == "svg") places_.fail(element, "a drawing in the drawing is not read: ungroup it");
    if (name == "style") has_sheet_ = true;
    if (!style.is_visible) return;
    if (name == "text" || name == "image" || name == "foreignObject") others_ += 1;
    if (is_shape(name)) read_shape(element, name, style);
  }

  // An element is read anew for each of its copies.
  SvgStyle style_of(const pugi::xml_node& element, const SvgStyle& outer) {
    for (const pugi::xml_attribute& attribute : element.attributes()) read_ += std::strlen(attribute.value());
    if (read_ > kMaxRead) places_.fail(element, "the drawing's copies are too many and too large to be read");
    return outer.of(element, places_);
  }

  static std::string more_than(std::size_t most, const char* what) {
    return "the drawing has more than " + std::to_string(most) + " " + what + ", copies counted";
  }

  // A copy of the element that it names; one in itself ends at the depth's bound.
  void read_use(const pugi::xml_node& use, const SvgStyle& style, int depth) {
    if (depth > kMaxDepth) places_.fail(use, "copies are nested deeper than " + std::to_string(kMaxDepth));
    const pugi::xml_attribute plain = use.attribute("href");
    const std::string target = (plain ? plain : use.attribute("xlink:href")).value();
    if (!target.starts_with('#')) places_.fail(use, "href: must name an element of this file, as #name");
    const pugi::xml_node element = by_id(use, target.substr(1));
    if (!element) places_.fail(use, "href: there is no element " + cleaned_name(target));
    SvgStyle moved = style;
    moved.place = style.place.after({1, 0, 0, 1, places_.length(use, "x"), places_.length(use, "y")});
    if (std::strcmp(element.name(), "symbol") == 0) return read_symbol(element, moved, depth);
    read_element(element, moved, depth + 1);
  }

  void read_symbol(const pugi::xml_node& symbol, const SvgStyle& outer, int depth) {
    if (symbol.attribute("viewBox")) places_.fail(symbol, "a symbol with a viewBox is not read: make it a group");
    read_children(symbol, style_of(symbol, outer), depth + 1);
  }

  pugi::xml_node by_id(const pugi::xml_node& any, const std::string& id) {
    if (ids_.empty()) index(any.root());
    const auto found = std::lower_bound(ids_.begin(), ids_.end(), id,
                                        [](const auto& entry, const std::string& key) { return entry.first < key; });
    return found != ids_.end() && found->first == id ? found->second : pugi::xml_node();
  }

  void index(const pugi::xml_node& root) {
    for (pugi::xml_node node = root.first_child(); node; node = following(node)) {
      if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace_back(id.value(), node);
    }
    std::stable_sort(ids_.begin(), ids_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  // In the order of the document, without recursion.
  static pugi::xml_node following(pugi::xml_node node) {
    if (node.first_child()) return node.first_child();
    while (node && !node.next_sibling()) node = node.parent();
    return node.next_sibling();
  }

  static bool is_shape(std::string_view name) {
    return name == "path" || name == "rect" || name == "circle" || name == "ellipse" || name == "polygon" ||
           name == "polyline" || name == "line";
  }

  void read_shape(const pugi::xml_node& element, std::string_view name, const SvgStyle& style) {
    if (style.role == Role::start) return read_start(element, name, style);
    if (style.role == Role::obstacle && (!style.is_filled || name == "line")) {
      hollow_ += 1;
      return;
    }
    std::vector<Ring> rings = rings_of(element, name, style);
    if (style.role == Role::obstacle) {
      const bool drawn = std::any_of(rings.begin(), rings.end(), [](const Ring& ring) { return !ring.empty(); });
      Filling filling = filled(label(element, name), std::move(rings), style.rule, fill_work_);
      if (drawn && filling.obstacles.empty()) hollow_ += 1;
      if (filling.loses_hole) touching_ += 1;
      for (Obstacle& obstacle : filling.obstacles) drawing_.add_obstacle(std::move(obstacle));
      return;
    }
    if (style.role == Role::goal && rings.size() == 1 && rings[0].size() == 2) {
      return drawing_.add_goal(svg_name(element),
                               pose_goal({}, {rings[0][0], kStateGoalRadius, {heading(rings[0], 0)}}));
    }
    if (rings.size() != 1 || rings[0].size() < 3) places_.fail(element, "a goal and bounds must be one closed outline");
    if (style.role == Role::goal) return drawing_.add_goal(svg_name(element), {{}, std::move(rings[0])});
    drawing_.set_bounds(label(element, name), rings[0]);
  }

  std::string label(const pugi::xml_node& element, std::string_view name) const {
    const std::string id = svg_name(element);
    return id.empty() ? std::string(name) + ", element " + std::to_string(elements_) : id;
  }

  // Of the segment from that point on.
  static double heading(const Ring& points, std::size_t first) {
    return std::atan2(points[first + 1].y - points[first].y, points[first + 1].x - points[first].x);
  }

  // Its last segment points from the position to where the robot looks; those before are trailers, from the last one.
  void read_start(const pugi::xml_node& element, std::string_view name, const SvgStyle& style) {
    std::vector<Ring> lines;
    if (name == "line") lines = {line(element, style)};
    if (name == "polyline" || name == "path") lines = rings_of(element, name, style);
    if (lines.size() != 1 || lines[0].size() < 2 || lines[0].size() > kMaxLinks + 2) {
      places_.fail(element, "a start must be a line from its position to where the robot looks");
    }
    const Ring& points = lines[0];
    const auto same = [](const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; };
    if (std::adjacent_find(points.begin(), points.end(), same) != points.end()) {
      places_.fail(element, "a start's line has a part without length, which says no heading");
    }
    const std::size_t last = points.size() - 2;
    Start start{{}, points[last], heading(points, last), {}};
    for (std::size_t i = last; i > 0; --i) start.angles.push_back(heading(points, i - 1));
    drawing_.add_start(svg_name(element), std::move(start));
  }

  Ring line(const pugi::xml_node& element, const SvgStyle& style) const {
    Ring points = {{places_.length(element, "x1"), places_.length(element, "y1")},
                   {places_.length(element, "x2"), places_.length(element, "y2")}};
    place(points, element, style);
    return points;
  }

  std::vector<Ring> rings_of(const pugi::xml_node& element, std::string_view name, const SvgStyle& style) {
    std::vector<Ring> rings;
    if (name == "line") return {line(element, style)};
    if (name == "circle" || name == "ellipse") {
      rings = {ellipse(element, name == "circle", style)};
    } else if (name == "rect") {
      rings = rectangle(element, style);
    } else if (name == "path") {
      SvgScanner data = places_.scan(element, "d");
      rings = read_path(data, flatness(style));
    } else {
      rings = {points_of(element)};
    }
    if (name != "path") count_corners(element, rings);
    for (Ring& ring : rings) place(ring, element, style);
    return rings;
  }

  // Of a shape without curves, or with a circle's; read_path counts its own.
  void count_corners(const pugi::xml_node& element, const std::vector<Ring>& rings) {
    for (const Ring& ring : rings) {
      if (ring.size() > corners_) places_.fail(element, more_than(kMaxCorners, "corners"));
      corners_ -= ring.size();
    }
  }

  Flatness flatness(const SvgStyle& style) { return {kFlatness / style.place.stretch(), corners_}; }

  Ring points_of(const pugi::xml_node& element) const {
    SvgScanner text = places_.scan(element, "points");
    Ring ring;
    while (!text.done()) {
      const double x = text.number();
      ring.push_back({x, text.number()});
    }
    return ring;
  }

  // Around the ellipse for obstacles, inside for goals and bounds: a circle of its size in metres, squeezed.
  Ring ellipse(const pugi::xml_node& element, bool circle, const SvgStyle& style) const {
    const double rx = places_.length(element, circle ? "r" : "rx");
    const double ry = places_.length(element, circle ? "r" : "ry");
    const double radius = std::max(rx, ry) * style.place.stretch();
    if (!(rx >= 0 && ry >= 0 && radius <= kMaxFarCoordinate)) places_.fail(element, "has no sound radius");
    if (!(std::min(rx, ry) > 0 && radius > 0)) return {};  // SVG draws nothing
    Ring ring = style.role == Role::obstacle ? ring_around_circle({0, 0}, radius) : ring_inside_circle({0, 0}, radius);
    const Point center = {places_.length(element, "cx"), places_.length(element, "cy")};
    for (Point& p : ring) p = {center.x + rx * p.x / radius, center.y + ry * p.y / radius};
    return ring;
  }

  std::vector<Ring> rectangle(const pugi::xml_node& element, const SvgStyle& style) const {
    const double x = places_.length(element, "x"), y = places_.length(element, "y");
    const double width = places_.length(element, "width"), height = places_.length(element, "height");
    if (!(width >= 0 && height >= 0)) places_.fail(element, "width and height must be 0 or more");
    if (width == 0 || height == 0) return {};  // SVG draws nothing
    const bool has_rx = !is_relative(element, "rx");
    const double rx = std::min(places_.length(element, has_rx ? "rx" : "ry"), width / 2);
    const double ry = std::min(places_.length(element, is_relative(element, "ry") ? "rx" : "ry"), height / 2);
    const Point min = {x, y};
    const Point max = {x + width, y + height};
    if (!(rx > 0 && ry > 0) || style.role == Role::obstacle) return {{min, {max.x, y}, max, {x, max.y}}};
    return {beveled(min, max, {rx, ry})};
  }

  // Inside a rectangle with round corners, as a goal has to be; an obstacle keeps the corners.
  static Ring beveled(const Point& min, const Point& max, const Point& r) {
    return {{min.x + r.x, min.y}, {max.x - r.x, min.y}, {max.x, min.y + r.y}, {max.x, max.y - r.y},
            {max.x - r.x, max.y}, {min.x + r.x, max.y}, {min.x, max.y - r.y}, {min.x, min.y + r.y}};
  }

  void place(Ring& ring, const pugi::xml_node& element, const SvgStyle& style) const {
    for (Point& p : ring) {
      p = style.place.at(p);
      if (std::abs(p.x) <= kMaxFarCoordinate && std::abs(p.y) <= kMaxFarCoordinate) continue;
      places_.fail(element, "lies further than " + shown(kMaxFarCoordinate) + " m from the origin");
    }
  }

  void bound_by_page(const ViewBox& view) {
    const double u = page_.unit;
    const Point min = {u * view.x, -u * (view.y + view.height)};
    const Point max = {u * (view.x + view.width), -u * view.y};
    const double reach = std::max({std::abs(min.x), std::abs(min.y), std::abs(max.x), std::abs(max.y)});
    if (!(reach <= kMaxFarCoordinate)) throw InputError(file_ + ": the page reaches too far: give --unit METRES");
    drawing_.set_bounds("the page", {min, {max.x, min.y}, max, {min.x, max.y}});
  }

  void warn() {
    std::vector<std::string>& warnings = drawing_.workspace().warnings;
    const auto count = [&](std::size_t number, const std::string& what) {
      if (number > 0) warnings.push_back(file_ + ": " + std::to_string(number) + what);
    };
    count(hollow_,
          " shapes without a fill or an area are no obstacles, also where they have a stroke: draw walls as filled "
          "shapes");
    count(touching_, " shapes have holes that touch or cross another outline, and are filled: keep the holes apart");
    count(others_, " texts and images are not read");
    if (has_sheet_)
      warnings.push_back(file_ + ": style sheets are not read: shapes count as filled unless they say not");
  }

  // Of the page, or where there is none, of what bounds the map.
  void warn_of_size(Workspace& workspace) const {
    const bool paged = page_.view.has_value();
    const double width = paged ? page_.unit * page_.view->width : workspace.max.x - workspace.min.x;
    const double height = paged ? page_.unit * page_.view->height : workspace.max.y - workspace.min.y;
    if (page_.has_scale && std::max(width, height) >= kSmall) return;
    workspace.warnings.push_back(file_ + ": the " + (paged ? "page" : "drawing") + " measures " + shown(width) +
                                 " m x " + shown(height) + " m; --unit 1 makes one unit of the drawing a metre");
  }

  const std::string& file_;
  const SvgPlaces& places_;
  const Page& page_;
  Drawing drawing_;
  std::vector<std::pair<std::string, pugi::xml_node>> ids_;
  std::size_t corners_ = kMaxCorners;
  std::size_t elements_ = 0;
  std::size_t read_ = 0;  // bytes of attributes
  std::size_t fill_work_ = kFillWork;
  std::size_t hollow_ = 0;    // shapes
  std::size_t touching_ = 0;  // shapes
  std::size_t others_ = 0;    // elements that a map has no use for
  bool has_sheet_ = false;
};

// Entities that the file defines are not expanded by pugixml: they cannot multiply.
Workspace read(const Source& source, const ImportOptions& options) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(source.content.data(), source.content.size());
  if (!parsed) {
    throw InputError(source.path + ": is not valid XML: " + parsed.description() + " at byte " +
                     std::to_string(parsed.offset));
  }
  const pugi::xml_node svg = document.child("svg");
  if (!svg) throw InputError(source.path + ": is XML, but no SVG: its first element must be svg");
  const SvgPlaces places(source.path, source.content);
  const Page page = read_page(svg, places, options);
  Workspace workspace = Reader(source.path, places, page).read(svg);
  workspace.name = cleaned_name(svg.child_value("title"));
  return workspace;
}

}  // namespace

const Format kSvg = {"SVG", ".svg", recognise, read, {.unit = true}};

}  // namespace krait::host
