// SPDX-License-Identifier: Apache-2.0
// MovingAI's grid maps: a header of four lines, then one character a cell, the top row first. Cells are 1 m wide.
#include <cctype>
#include <charconv>
#include <string_view>

#include "host/import/format.hpp"
#include "host/import/image.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr std::string_view kPassable = ".GS";  // ground, ground, swamp
constexpr std::string_view kBlocked = "@OTW";  // out of bounds, out of bounds, trees, water

bool recognise(const Source& source) { return source.content.starts_with("type "); }

class Lines {
 public:
  explicit Lines(const Source& source) : file_(source.path), rest_(source.content) {}

  bool done() const { return rest_.empty(); }

  std::string_view next() {
    if (done()) fail("ends early");
    number_ += 1;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ": line " + std::to_string(number_) + ": " + what);
  }

 private:
  const std::string& file_;
  std::string_view rest_;
  int number_ = 0;
};

int read_size(Lines& lines, std::string_view key) {
  const std::string_view line = lines.next();
  int size = 0;
  if (line.starts_with(key) && line.size() > key.size()) {
    std::from_chars(line.data() + key.size() + 1, line.data() + line.size(), size);
  }
  if (size < 1) lines.fail("must be \"" + std::string(key) + " N\" with N at least 1");
  return size;
}

std::uint8_t read_cell(const Lines& lines, char c, int column) {
  if (kPassable.find(c) != std::string_view::npos) return 0;
  if (kBlocked.find(c) != std::string_view::npos) return 1;
  const std::string shown_c = std::isprint(static_cast<unsigned char>(c)) != 0 ? std::string("'") + c + "'"
                                                                               : "byte " + std::to_string(c & 0xFF);
  lines.fail("column " + std::to_string(column + 1) + ": unknown terrain " + shown_c + "; known are " +
             std::string(kPassable) + std::string(kBlocked));
}

void read_row(Lines& lines, int row, CellMap& cells) {
  const std::string_view line = lines.next();
  if (line.size() != static_cast<std::size_t>(cells.columns)) {
    lines.fail("has " + std::to_string(line.size()) + " cells, the header says " + std::to_string(cells.columns));
  }
  const std::size_t first = static_cast<std::size_t>(row) * line.size();
  for (std::size_t i = 0; i < line.size(); ++i) {
    cells.occupied[first + i] = read_cell(lines, line[i], static_cast<int>(i));
  }
}

Workspace read(const Source& source, const ImportOptions&) {
  Lines lines(source);
  if (lines.next() != "type octile") lines.fail("must be \"type octile\"");
  CellMap cells;
  cells.rows = read_size(lines, "height");
  cells.columns = read_size(lines, "width");
  if (lines.next() != "map") lines.fail("must be \"map\"");
  require_cells(static_cast<std::uint64_t>(cells.columns), static_cast<std::uint64_t>(cells.rows), source.path);
  const std::size_t count = static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows);
  if (source.content.size() < count) {
    throw InputError(source.path + ": is too short for the " + std::to_string(cells.columns) + " x " +
                     std::to_string(cells.rows) + " cells of its header");
  }
  cells.resolution = 1;
  cells.occupied.resize(count);
  for (int row = cells.rows - 1; row >= 0; --row) read_row(lines, row, cells);
  while (!lines.done()) {
    if (!lines.next().empty()) lines.fail("is one row more than the header says");
  }
  Workspace workspace;
  workspace.max = {static_cast<double>(cells.columns), static_cast<double>(cells.rows)};
  workspace.cells = std::move(cells);
  return workspace;
}

}  // namespace

const Format kMovingAi = {"MovingAI .map", ".map", recognise, read};

}  // namespace krait::host
