// SPDX-License-Identifier: Apache-2.0
#include "host/robot_file/robot_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "host/import/import.hpp"
#include "host/input/file.hpp"
#include "host/robot_file/mistaken.hpp"
#include "host/robot_file/shipped.hpp"
#include "host/workspace/heading.hpp"
#include "host/workspace/printed.hpp"
#include "host/workspace/ring.hpp"
#include "krait/robots/all.hpp"

namespace krait::host {
namespace {

static_assert(kMaxLinks == kMaxTrailers);

struct Parameter {
  const char* name;
  double normal;  // the default
  double least;
  double most;
  const char* unit = "";
  bool whole = false;
};

struct Model {
  const char* name;
  int most_links;
  std::vector<Parameter> parameters;
  std::vector<std::string> states;    // the components of a state, in their order, but the trailers' headings
  std::vector<std::string> controls;  // the components of a control
  bool centred = false;               // whether the box of body 0 is centred on the wheelbase, not on the axle
};

// Of ROBOT.json: what it does not say has no unit.
template <class P>
std::vector<Parameter> parameters_of(const P& defaults) {
  std::vector<Parameter> all;
  P::describe([&]<class Number>(const ParameterField<P, Number>& field) {
    if (*field.unit == '\0') return;
    all.push_back({field.name, decimal(static_cast<float>(defaults.*field.member)), decimal(field.least),
                   decimal(field.most), field.unit, std::is_same_v<Number, int>});
  });
  return all;
}

template <class R>
int most_trailers() {
  auto parameters = defaults_of<R>();
  if constexpr (requires { parameters.trailers; }) parameters.trailers = kMaxLinks;
  return R(parameters).body_count() - 1;
}

template <class R>
bool is_centred() {
  const R robot(defaults_of<R>());
  if constexpr (requires { robot.parameters().body_offset; }) return robot.parameters().body_offset > 0.0F;
  return false;
}

template <class R>
Model model_of(const char* name) {
  return {name,
          most_trailers<R>(),
          parameters_of(defaults_of<R>()),
          {std::begin(R::kStateNames), std::end(R::kStateNames)},
          {std::begin(R::kControlNames), std::end(R::kControlNames)},
          is_centred<R>()};
}

const std::vector<Model>& models() {
#define KRAIT_ROW(name, Class, file, trailers) model_of<Class>(#name),
  static const std::vector<Model> all = {KRAIT_MODELS(KRAIT_ROW)};
#undef KRAIT_ROW
  return all;
}

const Model* find_model(const std::string& name) {
  const auto found = std::find_if(models().begin(), models().end(), [&](const Model& m) { return m.name == name; });
  return found == models().end() ? nullptr : &*found;
}

std::string known_models() {
  std::string names;
  for (const Model& model : models()) names += (names.empty() ? "" : ", ") + std::string(model.name);
  return names;
}

const Model& known_model(const std::string& name) {
  const Model* model = find_model(name);
  if (model != nullptr) return *model;
  throw InputError("unknown robot model \"" + name + "\"; known are " + known_models());
}

const Model& model_of(const RobotSpec& robot) {
  const Model* model = find_model(robot.model);
  if (model != nullptr) return *model;
  throw InputError("robot.model \"" + robot.model + "\" is not known: use " + known_models());
}

const Parameter* find_parameter(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.parameters.begin(), model.parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return found == model.parameters.end() ? nullptr : &*found;
}

// Every vertex strictly left of every edge that does not end in it; a star, which winds twice, fails.
bool strictly_convex(const Ring& ring) {
  constexpr double kLeast = 1e-9;  // m^2
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    for (std::size_t j = 0; j < ring.size(); ++j) {
      if (j != i && j != next && cross(ring[i], ring[next], ring[j]) <= kLeast) return false;
    }
  }
  return true;
}

Ring read_body(const Field& field) {
  field.keys({"polygon"});
  Ring ring = field.at("polygon").ring(kMaxVertices, static_cast<double>(kMostLength));
  if (twice_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  if (!strictly_convex(ring)) field.fail("must be strictly convex: no crossing edges, no three corners in a line");
  return ring;
}

RobotSpec default_robot(const Model& model, int links) {
  RobotSpec robot;
  robot.model = model.name;
  robot.links = links;
  for (const Parameter& parameter : model.parameters) robot.parameters[parameter.name] = parameter.normal;
  robot.bodies = default_bodies(robot);
  return robot;
}

double read_parameter(const Field& field, const Parameter& parameter) {
  const bool number = field.value().is_number();
  const double value = number ? field.value().get<double>() : std::nan("");
  const bool usable = value >= parameter.least && value <= parameter.most;
  if (usable && (!parameter.whole || value == std::floor(value))) return value;
  const bool degrees = number && std::string(parameter.unit) == "radians" && is_over_a_turn(value);
  field.fail("must be " + std::string(parameter.whole ? "a whole number of " : "") + parameter.unit + " from " +
             shown(parameter.least) + " to " + shown(parameter.most) + ", is " + field.shown_value() +
             (degrees ? "; " + degrees_meant(value) : ""));
}

void read_parameters(const Field& field, const Model& model, std::map<std::string, double>& values) {
  if (!field.value().is_object()) field.fail("must be an object of numbers by name, is " + field.shown_value());
  for (const auto& item : field.value().items()) {
    const Parameter* known = find_parameter(model, item.key());
    if (known == nullptr) {
      std::string names;
      for (const Parameter& p : model.parameters) names += (names.empty() ? "" : ", ") + std::string(p.name);
      field.fail("unknown parameter \"" + cleaned_name(item.key()) + "\"; a " + model.name + " has " + names);
    }
    values[known->name] = read_parameter(field.at(known->name), *known);
  }
  const auto least = values.find("min_speed");
  if (least != values.end() && least->second > values.at("max_speed")) {
    field.fail("min_speed must be at most max_speed, which is " + shown(values.at("max_speed")));
  }
}

// A parameter beside "parameters" in place of in it.
void refuse_stray_parameters(const Field& field) {
  if (!field.value().is_object()) return;
  for (const auto& item : field.value().items()) {
    for (const Model& model : models()) {
      if (find_parameter(model, item.key()) != nullptr)
        field.fail("\"" + item.key() + "\" is a parameter: it goes into \"parameters\": {\"" + item.key() + "\": …}");
    }
  }
}

int read_links(const Field& field, const Model& model) {
  if (model.most_links > 0) return static_cast<int>(field.at("links").integer(0, model.most_links, "trailers"));
  if (field.has("links") && field.at("links").value() != 0)
    field.at("links").fail("a " + std::string(model.name) + " has no trailers: leave it out");
  return 0;
}

int parse_links(const std::string& text, const Model& model, const std::string& whole) {
  int links = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), links);
  if (error == std::errc() && end == text.data() + text.size() && links >= 0 && links <= model.most_links) return links;
  if (model.most_links == 0)
    throw InputError("robot " + whole + ": a " + model.name + " has no trailers; say " + model.name);
  throw InputError("robot " + whole + ": the number of trailers after " + model.name + ": must be from 0 to " +
                   std::to_string(model.most_links));
}

const ShippedRobot* find_shipped(const std::string& name) {
  const auto found = std::find_if(shipped_robots().begin(), shipped_robots().end(),
                                  [&](const ShippedRobot& robot) { return robot.name == name; });
  return found == shipped_robots().end() ? nullptr : &*found;
}

std::string known_shipped() {
  std::string names;
  for (const ShippedRobot& robot : shipped_robots()) names += (names.empty() ? "" : ", ") + robot.name;
  return names;
}

// "is turtlebot4 meant? Known", of the names that the text is misspelt or begins; "known" where there is none.
std::string meant_by(const std::string& text) {
  std::vector<std::string> names = robot_models();
  for (const ShippedRobot& robot : shipped_robots()) names.push_back(robot.name);
  std::string meant;
  for (const std::string& name : names) {
    const bool begins = text.size() > 2 && name.starts_with(text);
    if (begins || is_misspelt(text.substr(0, text.find(':')), name)) meant += (meant.empty() ? "" : " or ") + name;
  }
  return meant.empty() ? "known" : "is " + meant + " meant? Known";
}

RobotSpec read_document(const std::string& text, const std::string& file) {
  const Json document = parse_json(text, file);
  return read_robot(Field(document, file));
}

// What is for the reader only.
void read_remarks(const Field& field, const Model& model, RobotSpec& robot) {
  if (field.has("about")) robot.about = field.at("about").printed();
  if (!field.has("sources")) return;
  const Field sources = field.at("sources");
  if (!sources.value().is_object())
    sources.fail("must be an object of texts by the names of parameters, or bodies, is " + sources.shown_value());
  for (const auto& item : sources.value().items()) {
    const bool known = item.key() == "bodies" || find_parameter(model, item.key()) != nullptr;
    if (!known) sources.fail("\"" + cleaned_name(item.key()) + "\" is no parameter of a " + model.name);
    robot.sources[item.key()] = sources.at(item.key().c_str()).printed();
  }
}

}  // namespace

std::vector<Ring> default_bodies(const RobotSpec& robot) {
  const double half_length = robot.parameters.at("body_length") / 2;
  const double half_width = robot.parameters.at("body_width") / 2;
  const Model* model = find_model(robot.model);
  const double middle = model != nullptr && model->centred ? robot.parameters.at("wheelbase") / 2 : 0;
  const Ring box = {{middle - half_length, -half_width},
                    {middle + half_length, -half_width},
                    {middle + half_length, half_width},
                    {middle - half_length, half_width}};
  return std::vector<Ring>(static_cast<std::size_t>(robot.links) + 1, box);
}

std::vector<std::string> control_names(const RobotSpec& robot) { return model_of(robot).controls; }

std::vector<std::string> state_names(const RobotSpec& robot) {
  std::vector<std::string> names = model_of(robot).states;
  for (int i = 1; i <= robot.links; ++i) names.push_back("theta" + std::to_string(i));
  return names;
}

std::string model_forms(const std::string& between, const std::string& about_trailers) {
  std::string with;
  std::string without;
  for (const Model& model : models()) {
    if (model.most_links > 0) {
      with += (with.empty() ? "" : between) + model.name + ":N";
    } else {
      without += std::string(", ") + model.name;
    }
  }
  return with + " (" + about_trailers + ")" + without;
}

std::vector<std::string> own_parameters(const RobotSpec& robot) {
  const std::vector<Ring> boxes = default_bodies(robot);
  const bool boxed = std::equal(boxes.begin(), boxes.end(), robot.bodies.begin(), robot.bodies.end(), same_ring);
  std::vector<std::string> names;
  for (const auto& [name, normal] : default_parameters(robot.model)) {
    const bool of_trailers = name == "hitch_length" || name == "max_hitch_angle" || name == "self_collision_gap";
    const bool of_box = name == "body_length" || name == "body_width";
    if ((robot.links > 0 || !of_trailers) && (boxed || !of_box)) names.push_back(name);
  }
  return names;
}

std::string unit_of(const std::string& model, const std::string& parameter) {
  const Model* known = find_model(model);
  const Parameter* found = known == nullptr ? nullptr : find_parameter(*known, parameter);
  return found == nullptr ? "" : found->unit;
}

std::pair<double, double> range_of(const std::string& model, const std::string& parameter) {
  const Model* known = find_model(model);
  const Parameter* found = known == nullptr ? nullptr : find_parameter(*known, parameter);
  if (found == nullptr) throw InputError("a robot model \"" + model + "\" has no parameter \"" + parameter + "\"");
  return {found->least, found->most};
}

std::vector<std::string> robot_models() {
  std::vector<std::string> names;
  for (const Model& model : models()) names.emplace_back(model.name);
  return names;
}

int most_links(const std::string& model) { return known_model(model).most_links; }

std::vector<std::pair<std::string, double>> default_parameters(const std::string& model) {
  std::vector<std::pair<std::string, double>> defaults;
  for (const Parameter& parameter : known_model(model).parameters)
    defaults.emplace_back(parameter.name, parameter.normal);
  return defaults;
}

RobotSpec read_robot(const Field& field) {
  refuse_stray_parameters(field);
  field.keys({"about", "model", "links", "parameters", "bodies", "sources"});
  const Field name = field.at("model");
  const Model* model = find_model(name.text());
  if (model == nullptr) name.fail("unknown model \"" + cleaned_name(name.text()) + "\"; known are " + known_models());
  RobotSpec robot = default_robot(*model, read_links(field, *model));
  if (field.has("parameters")) read_parameters(field.at("parameters"), *model, robot.parameters);
  read_remarks(field, *model, robot);
  robot.bodies = default_bodies(robot);
  if (field.has("bodies")) {
    const Field bodies = field.at("bodies");
    if (bodies.size() != robot.bodies.size()) {
      bodies.fail("must have links + 1 = " + std::to_string(robot.bodies.size()) + " bodies, has " +
                  std::to_string(bodies.size()));
    }
    for (std::size_t k = 0; k < robot.bodies.size(); ++k) robot.bodies[k] = read_body(bodies.item(k));
  }
  return robot;
}

RobotSpec parse_robot(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (const Model* model = find_model(text.substr(0, colon))) {
    if (colon != std::string::npos) return default_robot(*model, parse_links(text.substr(colon + 1), *model, text));
    if (model->most_links == 0) return default_robot(*model, 0);
    throw InputError("robot " + text + ": say how many trailers it has, as in " + text + ":2");
  }
  if (const ShippedRobot* shipped = find_shipped(text)) return read_document(shipped->text, text);
  std::error_code ignored;
  if (!text.ends_with(".json") && !std::filesystem::exists(text, ignored)) {
    throw InputError("unknown robot \"" + text + "\"; " + meant_by(text) + " are " +
                     model_forms(" and ", "N trailers") + ", the shipped " + known_shipped() +
                     ", or the path of a ROBOT.json");
  }
  const std::string content = read_file(text, kMaxMapBytes);  // a map is named, however large
  if (const auto what = mistaken_robot(text, content)) throw InputError(text + ": " + *what);
  return read_document(content, text);
}

bool is_robot_file(const std::string& text) {
  return find_model(text.substr(0, text.find(':'))) == nullptr && find_shipped(text) == nullptr;
}

Json to_json(const RobotSpec& robot) {
  Json json = {
      {"model", robot.model}, {"links", robot.links}, {"parameters", Json::object()}, {"bodies", Json::array()}};
  for (const auto& [name, normal] : default_parameters(robot.model)) {
    json["parameters"][name] = robot.parameters.at(name);
  }
  for (const Ring& body : robot.bodies) json["bodies"].push_back({{"polygon", to_json(body)}});
  return json;
}

}  // namespace krait::host
