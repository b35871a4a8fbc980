// SPDX-License-Identifier: Apache-2.0
#include "host/import/yaml.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/import/json_keys.hpp"

namespace krait::host {
namespace {

[[noreturn]] void fail_depth(const std::string& file) {
  throw InputError(file + ": lists and maps are nested deeper than " + std::to_string(kMaxDepth));
}

// yaml-cpp parses by recursion: bounds from above the depth that brackets and indentation can reach, before it runs.
// Brackets inside quotes and comments count too; no map nests them that deep.
void check_depth(const std::string& text, const std::string& file) {
  constexpr std::size_t kMostIndent = 4 * kMaxDepth;  // columns before a line's first key or value
  int brackets = 0;
  std::size_t indent = 0;
  bool leading = true;
  for (const char c : text) {
    if (c == '[' || c == '{') brackets += 1;
    if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
    if (c == '\n') indent = 0;
    leading = c == '\n' || (leading && (c == ' ' || c == '\t' || c == '-' || c == '?' || c == ':'));
    if (leading) indent += 1;
    if (brackets > kMaxDepth || indent > kMostIndent) fail_depth(file);
  }
}

// Passes over a document.
class Passer : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

// YAML::Load reads the first document alone, and what follows a line that begins further left than those before it is
// another one to it.
void require_one_document(const std::string& text, const std::string& file) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Passer passer;
  parser.HandleNextDocument(passer);
  if (!parser) return;
  throw InputError(file + ": is more than one YAML document; do all its lines begin in the same column?");
}

class Converter {
 public:
  Converter(const std::string& file, std::size_t most_nodes) : file_(file), most_nodes_(most_nodes) {}

  Json convert(const YAML::Node& node, int depth) {
    if (depth > kMaxDepth) fail_depth(file_);
    if (++nodes_ > most_nodes_) throw InputError(file_ + ": its aliases make it larger than it is");
    if (node.IsMap()) return convert_map(node, depth);
    if (node.IsSequence()) {
      Json list = Json::array();
      for (const YAML::Node& item : node) list.push_back(convert(item, depth + 1));
      return list;
    }
    return node.IsScalar() ? convert_scalar(node) : Json();
  }

 private:
  Json convert_map(const YAML::Node& node, int depth) {
    Json object = Json::object();
    for (const auto& member : node) {
      if (!member.first.IsScalar()) throw InputError(file_ + ": a key is not a text");
      const std::string& key = member.first.Scalar();
      if (object.size() == kMaxKeys) fail_keys(file_);
      if (object.contains(key)) throw InputError(file_ + ": key \"" + cleaned_name(key) + "\" is given twice");
      object[key] = convert(member.second, depth + 1);
    }
    return object;
  }

  static Json convert_scalar(const YAML::Node& node) {
    const bool quoted = node.Tag() == "!";
    double number = 0;
    bool truth = false;
    if (!quoted && YAML::convert<double>::decode(node, number)) return number;
    if (!quoted && YAML::convert<bool>::decode(node, truth)) return truth;
    return node.Scalar();
  }

  const std::string& file_;
  std::size_t most_nodes_;
  std::size_t nodes_ = 0;
};

}  // namespace

Json parse_yaml(const std::string& text, const std::string& file) {
  require_no_zero_bytes(text, "YAML", file);
  check_depth(text, file);
  try {
    require_one_document(text, file);
    return Converter(file, text.size() + 1).convert(YAML::Load(text), 0);
  } catch (const YAML::Exception& error) {
    throw InputError(file + ": is not valid YAML: " + cleaned_name(error.what()));
  }
}

bool has_top_key(const std::string& text, const std::string& key) {
  const std::string start = key + ":";
  return text.starts_with(start) || text.find("\n" + start) != std::string::npos || has_top_json_key(text, key);
}

}  // namespace krait::host
