// SPDX-License-Identifier: Apache-2.0
// Strokes, fills and text on a sheet, over Cairo. Lengths are points.
#pragma once

#include <cairo.h>

#include <numbers>
#include <string>

#include "host/picture/colors.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

enum class Align { left, center, right };

class Pen {
 protected:
  explicit Pen(cairo_t* context) : cr_(context) {}

  // ---- strokes and fills
  void source(Color color, double alpha = 1) {
    cairo_set_source_rgba(cr_, color.red / 255.0, color.green / 255.0, color.blue / 255.0, alpha);
  }
  void fill(Color color, double alpha = 1) {
    source(color, alpha);
    cairo_fill(cr_);
  }
  void stroke(Color color, double width, double alpha = 1) {
    source(color, alpha);
    cairo_set_line_width(cr_, width);
    cairo_stroke(cr_);
  }
  void fill_and_stroke(Color inside, Color line, double width) {
    source(inside);
    cairo_fill_preserve(cr_);
    stroke(line, width);
  }
  void move_to(Point sheet) { cairo_move_to(cr_, sheet.x, sheet.y); }
  void line_to(Point sheet) { cairo_line_to(cr_, sheet.x, sheet.y); }
  void disc(Point center, double radius) {
    cairo_new_sub_path(cr_);
    cairo_arc(cr_, center.x, center.y, radius, 0, 2 * std::numbers::pi);
  }

  // ---- text
  void font(double size, bool bold = false) {
    cairo_select_font_face(cr_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr_, size);
  }
  double text_width(const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(cr_, text.c_str(), &extents);
    return extents.x_advance;
  }
  void write(const std::string& text, Point at, Align align, Color color) {
    const double shift = align == Align::left ? 0 : text_width(text) * (align == Align::center ? 0.5 : 1.0);
    cairo_move_to(cr_, at.x - shift, at.y);
    source(color);
    cairo_show_text(cr_, text.c_str());
  }
  // The longest beginning of the text that fits, with an ellipsis if it is not the whole.
  std::string fitted(std::string text, double width) {
    if (text_width(text) <= width) return text;
    while (!text.empty() && text_width(text + "…") > width) {
      while ((static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
      text.pop_back();
    }
    return text + "…";
  }

  cairo_t* cr_;
};

}  // namespace krait::host
