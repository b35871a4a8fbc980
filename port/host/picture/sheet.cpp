// SPDX-License-Identifier: Apache-2.0
#include "host/picture/sheet.hpp"

#include <cairo-svg.h>

#include <memory>
#include <pugixml.hpp>
#include <sstream>

#include "host/picture/figure.hpp"

#ifdef __SANITIZE_ADDRESS__
// Fontconfig never frees what it keeps for the life of the process: some kilobyte, however much is drawn.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace krait::host {

namespace {

struct Destroy {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void expect(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw InputError(std::string("picture: Cairo: ") + cairo_status_to_string(status));
}

// Cairo numbers its groups by a counter of the process and writes no name for screen readers into a drawing.
std::string with_name(const std::string& svg, const std::string& name) {
  pugi::xml_document document;
  document.load_buffer(svg.data(), svg.size());
  pugi::xml_node root = document.child("svg");
  root.append_attribute("role") = "img";
  root.prepend_child("title").text() = name.c_str();
  root.child("g").attribute("id") = "figure";
  std::ostringstream out;
  document.save(out, "", pugi::format_raw);
  return out.str();
}

}  // namespace

std::string svg_sheet(double width, double height, const std::string& name, const Paint& paint) {
  std::string svg;
  const Surface surface(cairo_svg_surface_create_for_stream(append, &svg, width, height));
  const Context context(cairo_create(surface.get()));
  paint(context.get());
  expect(cairo_status(context.get()));
  cairo_surface_finish(surface.get());
  expect(cairo_surface_status(surface.get()));
  return with_name(svg, name);
}

std::string png_sheet(double width, double height, const Paint& paint) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, kPixelsPerPoint * static_cast<int>(width),
                                                   kPixelsPerPoint * static_cast<int>(height)));
  const Context context(cairo_create(surface.get()));
  cairo_scale(context.get(), kPixelsPerPoint, kPixelsPerPoint);
  paint(context.get());
  expect(cairo_status(context.get()));
  std::string png;
  expect(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

}  // namespace krait::host
