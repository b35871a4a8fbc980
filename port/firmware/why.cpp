// SPDX-License-Identifier: Apache-2.0
#include "firmware/why.hpp"

#include "firmware/report.hpp"

namespace krait::firmware {
namespace {

const char* name_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::obstacle:
      return "obstacle";
    case ContactKind::bounds:
      return "bounds";
    case ContactKind::body:
      return "body";
    case ContactKind::ground:
      return "ground";
    default:
      return "none";
  }
}

// "at (1.000, 2.000)", in the world.
Line& put_place(Line& line, const Why& why, Vec2 at) {
  line.put("at (").put_metres(why.origin_x + static_cast<double>(at.x)).put(", ");
  return line.put_metres(why.origin_y + static_cast<double>(at.y)).put(')');
}

Line& put_length(Line& line, float metres) { return line.put_metres(static_cast<double>(metres)).put(" m"); }

void put_other(Line& line, const Contact& contact) {
  switch (contact.kind) {
    case ContactKind::bounds:
      line.put("the bounds ");
      break;
    case ContactKind::body:
      line.put("body ").put(std::uint64_t{contact.other}).put(' ');
      break;
    default:
      line.put("an obstacle ");
  }
}

// Where no more is lacking than obstacles may have grown, on both sides of a passage.
void put_growth(Line& line, const Why& why, float lacking) {
  if (!(why.tolerance > 0.0F) || lacking > 2.0F * why.tolerance) return;
  put_length(line.put("; when the scene was compiled, obstacles were grown by up to "), why.tolerance);
  line.put(" a side, which may be why: --tolerance 0 leaves them as they are");
}

void put_contact(Line& line, const Why& why) {
  const Contact& contact = why.contact;
  if (contact.kind == ContactKind::ground) {
    put_place(line.put(": the position "), why, contact.at).put(" lies in an obstacle");
    return;
  }
  const bool apart = contact.distance > 0.0F;
  line.put(apart ? ": the start does not keep the clearance: body " : ": body ").put(std::uint64_t{contact.body});
  if (apart) {
    put_length(line.put(" is "), contact.distance).put(" from ");
  } else {
    line.put(contact.kind == ContactKind::bounds ? " reaches to or beyond " : " overlaps ");
  }
  put_other(line, contact);
  put_place(line, why, contact.at);
  if (apart) put_length(line.put(", and must keep "), contact.needed);
  line.put(apart ? ": ask with less --clearance, or another --start" : ": ask with another --start");
  if (apart && contact.kind == ContactKind::obstacle) {
    put_growth(line, why, 2.0F * (contact.needed - contact.distance));
  }
}

void put_bottleneck(Line& line, const Why& why) {
  const Bottleneck& bottleneck = why.bottleneck;
  if (!(bottleneck.width > 0.0F)) {
    line.put(": no way leads from the start to the goal");
    return;
  }
  line.put(bottleneck.at_goal ? ": the robot cannot stand in the goal: its roomiest place is "
                              : ": every way to the goal is narrower than the robot: ");
  put_place(put_length(line, bottleneck.width).put(' '), why, bottleneck.at);
  put_length(line.put(", it needs "), bottleneck.needed);
  put_growth(line, why, bottleneck.needed - bottleneck.width);
}

void put_effort(Line& line, const Why& why) {
  if (why.effort.tries == 0) return;
  put_place(line.put(": the search tried most "), why, why.effort.at);
  line.put(", ").put(std::uint64_t{why.effort.tries}).put(" expansions");
  if (!(why.bottleneck.width > 0.0F)) return;
  put_length(line.put("; the widest way to the goal is "), why.bottleneck.width).put(" wide ");
  put_length(put_place(line, why, why.bottleneck.at).put(", the robot needs at least "), why.bottleneck.needed);
}

void add_place(JsonLine& line, const char* x, const char* y, const Why& why, Vec2 at) {
  line.add_metres(x, why.origin_x + static_cast<double>(at.x)).add_metres(y, why.origin_y + static_cast<double>(at.y));
}

}  // namespace

Why ask_why(Planner& planner, const Scene& scene) {
  Why why;
  why.origin_x = scene.header().origin_x;
  why.origin_y = scene.header().origin_y;
  why.tolerance = scene.header().tolerance;
  const Status status = planner.failure().status;
  if (status == Status::start_in_collision) why.contact = planner.contact();
  if (exit_code(status) != kHonestNo) return why;
  why.bottleneck = planner.bottleneck();
  why.effort = planner.effort();
  return why;
}

bool explains(Status status) { return status == Status::start_in_collision || exit_code(status) == kHonestNo; }

void put_why(Line& line, Status status, const Why& why) {
  if (status == Status::start_in_collision) {
    put_contact(line, why);
  } else if (status == Status::no_route) {
    put_bottleneck(line, why);
  } else {
    put_effort(line, why);
  }
}

void add_why(JsonLine& line, Status status, const Why& why) {
  if (status == Status::start_in_collision) {
    line.add("contact", name_of(why.contact.kind)).add("contact_body", std::uint64_t{why.contact.body});
    line.add_decimal("contact_distance_m", why.contact.distance).add_decimal("contact_needed_m", why.contact.needed);
    add_place(line, "contact_x", "contact_y", why, why.contact.at);
  }
  if (explains(status)) line.add_decimal("tolerance_m", why.tolerance);
  if (exit_code(status) != kHonestNo) return;
  line.add_decimal("bottleneck_m", why.bottleneck.width).add_decimal("bottleneck_needed_m", why.bottleneck.needed);
  add_place(line, "bottleneck_x", "bottleneck_y", why, why.bottleneck.at);
  line.add("bottleneck_in_goal", std::uint64_t{why.bottleneck.at_goal ? 1U : 0U});
  if (why.effort.tries == 0) return;
  line.add("effort_tries", std::uint64_t{why.effort.tries});
  add_place(line, "effort_x", "effort_y", why, why.effort.at);
}

}  // namespace krait::firmware
