// SPDX-License-Identifier: Apache-2.0
// A robot as a user names it: "--robot snake:15" or a ROBOT.json. Parameters by the names of the plan's JSON.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/input/json.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

struct RobotSpec {
  std::string model;                           // its name in krait/robots/all.hpp
  int links = 0;                               // trailers; 0 for the models without
  std::map<std::string, double> parameters;    // every number that dynamics and limits use; complete after parsing
  std::vector<Ring> bodies;                    // bodies[k] in body k's frame, counter-clockwise, convex, 3-8 vertices
  std::string about;                           // a line about the machine, from its ROBOT.json; may be empty
  std::map<std::string, std::string> sources;  // where a parameter's number comes from, or that of "bodies"
};

// A model of krait/robots/all.hpp, with its number of trailers where it may have any, as "snake:15" or "car"; the name
// of a shipped robot; or the path of a ROBOT.json (the form of the plan's `robot` object; missing parameters take the
// model's defaults; bodies follow from the parameters if left out; `about` and `sources` are for the reader). Throws
// InputError naming the field that is wrong.
RobotSpec parse_robot(const std::string& text);

// Whether parse_robot takes the text for the path of a file.
bool is_robot_file(const std::string& text);

// The robot of a ROBOT.json or of a plan. Throws as parse_robot.
RobotSpec read_robot(const Field& field);

// The form that read_robot reads, bodies included, without what is for the reader only.
Json to_json(const RobotSpec& robot);

// The components of a state, in their order: kStateNames of the model's class, and theta1, … of the trailers. Throws
// InputError for a model that is not known.
std::vector<std::string> state_names(const RobotSpec& robot);

// The components of a control: kControlNames of the model's class. Throws as state_names.
std::vector<std::string> control_names(const RobotSpec& robot);

// How users name the models: those with trailers, with `between` between them, and what N is, then the others, as in
// "snake:N and truck:N (N trailers), car, unicycle".
std::string model_forms(const std::string& between, const std::string& about_trailers);

// The names of the models, in the order of the documentation.
std::vector<std::string> robot_models();

// The most trailers of a model. Throws InputError if it is unknown.
int most_links(const std::string& model);

// The names and defaults of a model's parameters, in the order of the documentation. Throws InputError if unknown.
std::vector<std::pair<std::string, double>> default_parameters(const std::string& model);

// The names of those that the robot has: without trailers nothing is hitched, and the size of a box says nothing of
// other bodies.
std::vector<std::string> own_parameters(const RobotSpec& robot);

// The unit of a model's parameter, "metres a second"; empty for a number without unit.
std::string unit_of(const std::string& model, const std::string& parameter);

// The least and the most that a model's parameter may be, in that unit. Throws InputError if there is none.
std::pair<double, double> range_of(const std::string& model, const std::string& parameter);

// The boxes that the bodies are where a ROBOT.json has none: of body_length and body_width; a car's is centred on the
// middle of the wheelbase, every other on its axle.
std::vector<Ring> default_bodies(const RobotSpec& robot);

}  // namespace krait::host
