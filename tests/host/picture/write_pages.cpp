// SPDX-License-Identifier: Apache-2.0
// Writes the pages and still pictures that page_test.py looks at into the directory that it is given.
#include <fstream>
#include <iostream>
#include <string>

#include "synthetic.hpp"

namespace {

using krait::host::Picture;

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void write_all(const std::string& base, const Picture& picture) {
  write(base + ".html", krait::host::draw_html(picture));
  write(base + ".svg", krait::host::draw_svg(picture));
  write(base + ".png", krait::host::draw_png(picture));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: write_pages DIRECTORY\n";
    return 2;
  }
  const std::string directory = std::string(arguments[1]) + "/";
  const Picture picture = krait::host::test::synthetic_picture();
  write_all(directory + "solved", picture);

  Picture unsolved = picture;
  unsolved.plan.states.clear();
  unsolved.plan.controls.clear();
  unsolved.plan.status = "budget_used";
  unsolved.marks = {{{4, 4}, "tried most"}, {{5, 4}, "stops body 1"}};
  write_all(directory + "unsolved", unsolved);

  Picture hostile = picture;
  hostile.title =
      "</script><script>window.hostile = 1</script><img src=x onerror='window.hostile = 1'> {{data}} "
      "\xff\x01\xEF\xBF\xBF\"";
  hostile.plan.state_names[0] = "</script><script>window.hostile = 1</script>";
  hostile.plan.planner = "<b>&";
  write_all(directory + "hostile", hostile);

  write_all(directory + "bare", krait::host::test::bare_picture(3, 2));
  write_all(directory + "small", krait::host::test::scaled(picture, 0.06));
  write_all(directory + "large", krait::host::test::scaled(picture, 8));
  for (const std::string model : {"car", "unicycle", "diff_drive"}) {
    write_all(directory + model, krait::host::test::driven_by(model));
  }
  Picture wide = picture;
  wide.max = {400, 20};
  write_all(directory + "wide", wide);
  Picture tall = picture;
  tall.max = {12, 50};
  write_all(directory + "tall", tall);
}
