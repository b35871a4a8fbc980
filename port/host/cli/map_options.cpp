// SPDX-License-Identifier: Apache-2.0
#include "host/cli/map_options.hpp"

#include "host/cli/options.hpp"
#include "host/input/word_option.hpp"

namespace krait::host {

void MapOptions::add(CLI::App& command) {
  command_ = &command;
  command
      .add_option("--unknown", unknown, "how a map's unknown cells count: by its own thresholds (map), free, occupied")
      ->check(one_of({"map", "free", "occupied"}))
      ->capture_default_str();
  command.add_option("--unit", unit, kAboutUnit)->check(number_in(kMinUnit, kMaxUnit, "metres"))->option_text("METRES");
  command.add_option("--datum", datum, kAboutDatum)->check(not_empty())->option_text("LONGITUDE,LATITUDE");
}

ImportOptions MapOptions::read() const {
  ImportOptions options;
  if (unknown == "free") options.unknown = Unknown::free;
  if (unknown == "occupied") options.unknown = Unknown::occupied;
  if (!unit.empty()) options.unit = std::stod(unit);
  if (!datum.empty()) options.datum = parse_datum(datum);
  return options;
}

std::vector<std::string> MapOptions::arguments() const {
  std::vector<std::string> all = {"--unknown", unknown};
  if (!unit.empty()) all.insert(all.end(), {"--unit", unit});
  if (!datum.empty()) all.push_back("--datum=" + datum);  // a value may begin with a minus
  return all;
}

std::vector<std::string> MapOptions::given() const {
  std::vector<std::string> names;
  for (const char* option : {"--unknown", "--unit", "--datum"}) {
    if (command_->count(option) > 0) names.emplace_back(option);
  }
  return names;
}

}  // namespace krait::host
