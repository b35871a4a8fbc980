// A compiled scene, read by the page FORMAT.md with code of its own: the verifier may not share the core's reader.
// A checked file is expected (krait compile writes one); sizes are checked here again, so that no byte lies outside.
#include <cstring>

#include "host/import/format.hpp"
#include "krait/scene/format.hpp"

namespace krait::host {
namespace {

using format::Header;
using format::Section;

class Reader {
 public:
  explicit Reader(const Source& source) : source_(source) {
    if (source.content.size() < sizeof(Header)) refuse("is shorter than a scene's header");
    std::memcpy(&header_, source.content.data(), sizeof(Header));
    if (header_.version != format::kVersion) refuse("is a scene of another version; compile it again");
    if (header_.total_bytes != source.content.size()) refuse("is cut short or has bytes after its end");
  }

  const Header& header() const { return header_; }

  template <class T>
  T read(Section section, std::size_t index) const {
    const std::size_t offset = header_.section_offsets[static_cast<std::size_t>(section)] + index * sizeof(T);
    if (offset + sizeof(T) > source_.content.size()) refuse("has a section that reaches past its end");
    T value;
    std::memcpy(&value, source_.content.data() + offset, sizeof(T));
    return value;
  }

  Point point(Section section, std::size_t index) const {
    const float x = read<float>(section, 2 * index);
    const float y = read<float>(section, 2 * index + 1);
    return {header_.origin_x + static_cast<double>(x), header_.origin_y + static_cast<double>(y)};
  }

  // The points from offsets[index] to offsets[index + 1].
  Ring ring(Section offsets, Section points, std::size_t index) const {
    const auto first = read<std::uint32_t>(offsets, index);
    const auto end = read<std::uint32_t>(offsets, index + 1);
    if (end < first || end - first > source_.content.size()) refuse("has offsets that do not ascend");
    Ring ring;
    for (std::uint32_t i = first; i < end; ++i) ring.push_back(point(points, i));
    return ring;
  }

  // The NUL-terminated names, in order.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    std::string name;
    for (std::uint32_t i = 0; i < header_.names_bytes; ++i) {
      const char c = read<char>(Section::names, i);
      if (c != '\0') {
        name += c;
        continue;
      }
      all.push_back(name);
      name.clear();
    }
    if (all.size() != 1 + std::size_t{header_.goals} + header_.starts) refuse("has the wrong number of names");
    return all;
  }

 private:
  [[noreturn]] void refuse(const char* what) const { throw InputError(source_.path + ": " + what); }

  const Source& source_;
  Header header_{};
};

Start read_start(const Reader& reader, std::size_t index, const std::string& name) {
  const auto record = reader.read<format::StartRecord>(Section::starts, index);
  const Header& h = reader.header();
  Start start{name,
              {h.origin_x + static_cast<double>(record.x), h.origin_y + static_cast<double>(record.y)},
              static_cast<double>(record.heading),
              {}};
  for (std::uint32_t i = 0; i < record.angle_count; ++i) {
    start.angles.push_back(static_cast<double>(reader.read<float>(Section::start_angles, record.first_angle + i)));
  }
  return start;
}

bool recognise(const Source& source) { return source.content.starts_with("KRSC"); }

Workspace read(const Source& source, const ImportOptions&) {
  const Reader reader(source);
  const Header& h = reader.header();
  const std::vector<std::string> names = reader.names();
  Workspace workspace;
  workspace.name = names[0];
  workspace.min = {h.origin_x + static_cast<double>(h.bounds_min_x), h.origin_y + static_cast<double>(h.bounds_min_y)};
  workspace.max = {h.origin_x + static_cast<double>(h.bounds_max_x), h.origin_y + static_cast<double>(h.bounds_max_y)};
  for (std::uint32_t i = 0; i < h.pieces; ++i) {
    workspace.obstacles.push_back(
        {"piece " + std::to_string(i), reader.ring(Section::piece_offsets, Section::piece_vertices, i), {}});
  }
  for (std::uint32_t i = 0; i < h.goals; ++i) {
    workspace.goals.push_back({names[1 + i], reader.ring(Section::goal_offsets, Section::goal_vertices, i)});
  }
  for (std::uint32_t i = 0; i < h.starts; ++i) {
    workspace.starts.push_back(read_start(reader, i, names[1 + h.goals + i]));
  }
  return workspace;
}

}  // namespace

const Format kSceneFile{"compiled scene (.krait)", recognise, read};

}  // namespace krait::host
