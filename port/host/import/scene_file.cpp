// SPDX-License-Identifier: Apache-2.0
// A compiled scene, read by the page FORMAT.md with code of its own: the verifier may not share the core's reader.
// A checked file is expected (krait compile writes one); sizes are checked here again, so that no byte lies outside.
#include <cmath>
#include <cstring>

#include "host/import/format.hpp"
#include "host/input/json.hpp"
#include "krait/format.hpp"

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
    return world(read<float>(section, 2 * index), read<float>(section, 2 * index + 1));
  }

  Point world(float x, float y) const {
    const Point p{header_.origin_x + static_cast<double>(x), header_.origin_y + static_cast<double>(y)};
    if (!(std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate)) refuse("has a point out of all bounds");
    return p;
  }

  double angle(float radians) const {
    if (!(std::abs(static_cast<double>(radians)) <= kMaxAngle)) refuse("has an angle out of all bounds");
    return static_cast<double>(radians);
  }

  // The points from offsets[index] to offsets[index + 1]: 3 to `most`.
  Ring ring(Section offsets, Section points, std::size_t index, std::uint32_t most) const {
    const auto first = read<std::uint32_t>(offsets, index);
    const auto end = read<std::uint32_t>(offsets, index + 1);
    if (end < first || end - first < 3 || end - first > most) refuse("has a polygon of too few or too many vertices");
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
      if (!is_safe_to_print(name)) refuse("has a name with control characters");
      all.push_back(name);
      name.clear();
    }
    if (all.size() != 1 + std::size_t{header_.goals} + header_.starts) refuse("has the wrong number of names");
    return all;
  }

  [[noreturn]] void refuse(const char* what) const { throw InputError(source_.path + ": " + what); }

 private:
  const Source& source_;
  Header header_{};
};

Start read_start(const Reader& reader, std::size_t index, const std::string& name) {
  const auto record = reader.read<format::StartRecord>(Section::starts, index);
  Start start{name, reader.world(record.x, record.y), reader.angle(record.heading), {}};
  if (record.angle_count > kMaxLinks) reader.refuse("has a start with angles for too many trailers");
  for (std::uint32_t i = 0; i < record.angle_count; ++i) {
    start.angles.push_back(
        reader.angle(reader.read<float>(Section::start_angles, std::size_t{record.first_angle} + i)));
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
  workspace.min = reader.world(h.bounds_min_x, h.bounds_min_y);
  workspace.max = reader.world(h.bounds_max_x, h.bounds_max_y);
  if (!(workspace.min.x < workspace.max.x && workspace.min.y < workspace.max.y)) reader.refuse("has no bounds");
  for (std::uint32_t i = 0; i < h.pieces; ++i) {
    workspace.obstacles.push_back(
        {"piece " + std::to_string(i),
         reader.ring(Section::piece_offsets, Section::piece_vertices, i, format::kMaxPieceVertices),
         {}});
  }
  for (std::uint32_t i = 0; i < h.goals; ++i) {
    workspace.goals.push_back(
        {names[1 + i], reader.ring(Section::goal_offsets, Section::goal_vertices, i, h.goal_vertices)});
  }
  for (std::uint32_t i = 0; i < h.starts; ++i) {
    workspace.starts.push_back(read_start(reader, i, names[1 + h.goals + i]));
  }
  return workspace;
}

}  // namespace

const Format kSceneFile{"compiled scene (.krait)", ".krait", recognise, read};

}  // namespace krait::host
