/* SPDX-License-Identifier: Apache-2.0 */
/* krait in C: the adaptive planner, its five robots and your own behind plain structs. Nothing allocates; all memory is
   the caller's. The program needs no C++ run-time library, and no special compiler flags but for a robot of your own:
   link krait::c (-lkrait_c -lkrait).
   Metres, radians, seconds. What a function returns or refuses is that of the C++ member of the same name. */
#ifndef KRAIT_KRAIT_H
#define KRAIT_KRAIT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "krait/version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whose result must be looked at: the compiler warns where it is thrown away. */
#if defined(__cplusplus)
#define KRAIT_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define KRAIT_NODISCARD __attribute__((warn_unused_result))
#else
#define KRAIT_NODISCARD
#endif

#define KRAIT_NONE UINT32_MAX
#define KRAIT_MAX_TRAILERS 25
#define KRAIT_MAX_STATE 32  /* floats of a state, any robot's */
#define KRAIT_MAX_CONTROL 8 /* floats of a control, any robot's */
#define KRAIT_MAX_BODIES 32
#define KRAIT_CONTROL 2 /* floats of a control of the library's robots */

/* ---- Answers: krait/status.hpp says what each means ---- */

typedef uint8_t krait_status;
enum {
  KRAIT_OK,        /* of krait_open and krait_init: done */
  KRAIT_READY,     /* of a planner since krait_init: call krait_start */
  KRAIT_SEARCHING, /* not ended: call krait_advance again */
  KRAIT_SOLVED,
  KRAIT_NO_ROUTE,
  KRAIT_BUDGET_USED,
  KRAIT_TREE_FULL,
  KRAIT_TIME_USED,
  KRAIT_BAD_SCENE,
  KRAIT_BAD_ROBOT,
  KRAIT_BAD_ARGUMENT,
  KRAIT_START_OUTSIDE,
  KRAIT_START_IN_COLLISION,
  KRAIT_GOAL_IN_OBSTACLE,
  KRAIT_ARENA_TOO_SMALL,
  KRAIT_BAD_ARITHMETIC,
  KRAIT_INTERNAL
};

/* What went wrong, where. KRAIT_OK where nothing did. Fields that do not apply are zero. */
typedef struct krait_failure {
  krait_status status;
  uint8_t section;       /* KRAIT_BAD_SCENE: of the file; 255 is its header */
  uint32_t element;      /* KRAIT_BAD_SCENE: in the section; KRAIT_BAD_ARGUMENT, KRAIT_BAD_ROBOT: krait_argument_name */
  uint64_t bytes_needed; /* KRAIT_ARENA_TOO_SMALL */
  float most;            /* KRAIT_BAD_ARGUMENT, dt: the longest time step in seconds that the robot allows */
} krait_failure;

/* Lower-case names, in static storage. */
const char* krait_status_name(krait_status status);
const char* krait_argument_name(uint32_t element);

/* ---- The scene ---- */

/* A checked view of a scene file, which stays where it is (in flash). To be filled by krait_open only. */
typedef union krait_scene {
  uint64_t alignment;
  unsigned char opaque[256 + 32 * sizeof(void*)];
} krait_scene;

/* Checks the whole file, then views it. `file` is aligned to 4 and must stay for as long as the scene is used.
   KRAIT_OK or KRAIT_BAD_SCENE. */
KRAIT_NODISCARD krait_failure krait_open(krait_scene* scene, const void* file, size_t file_bytes);

typedef struct krait_scene_facts {
  const char* name;
  double origin_x, origin_y; /* world = origin + local; all that follows is local */
  float min_x, min_y, max_x, max_y;
  uint32_t goals, starts;
} krait_scene_facts;
krait_scene_facts krait_facts(const krait_scene* scene);

/* A robot's place; `angles` are the headings of its trailers, or NULL for `heading`. */
typedef struct krait_pose {
  float x, y, heading;
  const float* angles;
  uint32_t angle_count; /* 0 with NULL */
} krait_pose;
krait_pose krait_start_pose(const krait_scene* scene, uint32_t start); /* start < starts */

const char* krait_goal_name(const krait_scene* scene, uint32_t goal); /* goal < goals */
uint32_t krait_find_goal(const krait_scene* scene, const char* name); /* or KRAIT_NONE */

/* ---- The robot ---- */

/* Snake, truck and car: krait/robots/chain.hpp has the ranges. */
typedef struct krait_chain_parameters {
  int trailers;
  float body_length, body_width, body_offset;
  float wheelbase, hitch_length;
  float max_speed, min_speed;
  float max_steering, max_acceleration, max_steering_rate;
  int self_collision_gap;
  float max_hitch_angle;
} krait_chain_parameters;

/* krait/robots/unicycle.hpp has the ranges. */
typedef struct krait_unicycle_parameters {
  float body_length, body_width;
  float max_speed, min_speed;
  float max_turn_rate;
} krait_unicycle_parameters;

/* krait/robots/differential_drive.hpp has the ranges. */
typedef struct krait_diff_drive_parameters {
  float body_length, body_width;
  float wheel_radius, track_width;
  float max_wheel_speed, max_wheel_acceleration;
} krait_diff_drive_parameters;

typedef struct krait_point {
  float x, y;
} krait_point;

/* A body's outline in its own frame: 3 to 8 corners, convex, counter-clockwise. */
typedef struct krait_polygon {
  const krait_point* corners;
  int count;
} krait_polygon;

/* Where an expansion steers to. */
typedef struct krait_target {
  float x, y;
  float speed; /* share of the top speed in (0, 1]; in [-1, 0): backwards; 0: to rest */
  float dt;    /* seconds that the control will be held */
  float turn;  /* share of the sharpest turn in (0, 1] */
} krait_target;

/* A body's frame in the workspace: its origin and the sine and cosine of its heading. */
typedef struct krait_frame {
  float x, y;
  float sin, cos;
} krait_frame;

/* How a body can have moved during a step: krait/robots/model.hpp says what each bounds. */
typedef struct krait_travel {
  float path, turn, bend, twist;
} krait_travel;

/* The most that a body does at any time of a step, none of it below 0: m/s, rad/s, m/s^2 and rad/s^2, of its frame. */
typedef struct krait_body_rates {
  float speed, turn, acceleration, turn_acceleration;
} krait_body_rates;

/* Whether this file's flags keep float arithmetic as it is written, which the same plan on every machine needs
   (-ffp-contract=off, no -ffast-math): the member `exact` of your own robot's functions. */
static inline bool krait_exact(void) {
  const volatile float factor = 1.0F + 0x1p-12F, product = 1.0F + 0x1p-11F, large = 0x1p26F, one = 1.0F, five = 5.0F;
  const volatile float third = 5.0F / 3.0F;
  const float a = factor;
  const float residue = a * a - product;
  const float b = large;
  const float absorbed = (one + b) - b;
  return residue == 0.0F && absorbed == 0.0F && five / 3.0F == third;
}

/* A robot of your own: pure functions of their arguments and of what lies at `self`, which krait_own_robot is given and
   which must outlive the planner. What each must do is said of the member of its name in krait/robots/model.hpp;
   on a workstation, check_robot of krait/robot_check.hpp says where one breaks it. State components 0 and 1
   are the position in metres. */
typedef struct krait_functions {
  bool (*exact)(void); /* krait_exact, of the file that the functions stand in */
  int state_size;      /* 2 to KRAIT_MAX_STATE */
  int control_size;    /* 1 to KRAIT_MAX_CONTROL */
  int body_count;      /* 1 to KRAIT_MAX_BODIES */

  void (*derivative)(const void* self, const float* s, const float* u, float* ds);
  void (*steer)(const void* self, const float* s, const krait_target* target, float* u);
  bool (*within_limits)(const void* self, const float* s);
  krait_polygon (*body)(const void* self, int k); /* 3 to 8 corners, which stay where they are */
  void (*place)(const void* self, const float* s, krait_frame* frames);

  /* One of these two: `rates` is asked where `travel` is NULL. */
  bool (*travel)(const void* self, const float* s, const float* u, float dt, const float* next, krait_travel* travel);
  bool (*rates)(const void* self, const float* s, const float* u, float dt, const float* next, krait_body_rates* rates);

  /* Each of these may be NULL. */
  float (*speed)(const void* self, const float* s);
  float (*stopping_way)(const void* self, const float* s);
  float (*turning_radius)(const void* self);
  float (*top_speed)(const void* self);
  float (*fastest_rate)(const void* self, float dt);
  void (*track)(const void* self, const float* s, const float* reference, float dt, float* u);
  bool (*keeps_reserve)(const void* self, const float* s);
  bool (*reversible)(const void* self);
  int (*self_collision_gap)(const void* self);
} krait_functions;

/* krait_own_robot's. */
typedef struct krait_own {
  const krait_functions* functions;
  const void* self;
} krait_own;

typedef struct krait_model krait_model;

/* A robot is made by one of the functions below; change its parameters before krait_init. A program contains the models
   whose functions it calls. */
typedef struct krait_robot {
  const krait_model* model;
  union {
    krait_chain_parameters chain;
    krait_unicycle_parameters unicycle;
    krait_diff_drive_parameters diff_drive;
    krait_own own;
  } parameters;
  const krait_polygon* bodies; /* one a body, that is 1 + trailers; NULL for boxes of body_length by body_width; not
                                  looked at for a robot of your own */
} krait_robot;

krait_robot krait_snake(
    int trailers); /* chain; state x y theta0 v psi theta1 ..., control acceleration, steering rate */
krait_robot krait_truck(int trailers); /* chain; likewise */
krait_robot krait_car(void);           /* chain; likewise */
krait_robot krait_unicycle(void);      /* unicycle; state x y theta, control speed, turn rate */
krait_robot krait_diff_drive(void);    /* diff_drive; state x y theta left right, control wheel accelerations */

/* own; functions and what lies at `self` must stay. krait_init refuses it as KRAIT_BAD_ROBOT where a function that it
   needs is NULL or a size is out of range, and as KRAIT_BAD_ARITHMETIC where `exact` is not true. */
krait_robot krait_own_robot(const krait_functions* functions, const void* self);

/* Floats of a state, at most KRAIT_MAX_STATE; 0 where the robot's parameters cannot be used. */
uint32_t krait_state_size(const krait_robot* robot);

/* Writes the state of the robot standing still there. False, and nothing written, where the robot's parameters cannot
   be used, or a robot with trailers is given another number of angles; nor for a robot of your own. */
KRAIT_NODISCARD bool krait_rest(const krait_robot* robot, krait_pose pose, float* state);

/* ---- Planning ---- */

/* krait/parameters.hpp says what each is for, with its range. */
typedef struct krait_search_tuning {
  uint32_t group_sample;
  float alpha, beta, epsilon;
  float gamma, cost_length;
  uint32_t kappa, update_regions;
  bool raise_goal;
  uint32_t max_steps, open_steps, path_regions;
  float near_radius, stray_share, gentle_share;
  uint32_t sight_tries, candidates, least_sketch;
  uint32_t doomed_steps, restart_unit;
  float slowest, reverse_share;
  bool continuous;
  uint32_t max_substeps;
  bool prune_portals;
  bool plain;
} krait_search_tuning;

typedef struct krait_parameters {
  float dt;          /* seconds, 0.001 to 1: a time step */
  float clearance;   /* metres, 0 to 10: a plan keeps it between bodies and everything, on top of rounding */
  float goal_margin; /* metres, 0 to 10, at most a tenth of the goal's size: how deep inside the plan must end */
  float end_speed;   /* m/s, 0 to INFINITY: a plan ends no faster, to 5 mm/s; 0: at rest; INFINITY: at any speed */
  krait_search_tuning tuning;
} krait_parameters;
krait_parameters krait_default_parameters(void);

/* What a search does when its memory is full. */
enum {
  KRAIT_RECYCLE, /* drops what helps least, and goes on */
  KRAIT_STOP     /* ends as KRAIT_TREE_FULL */
};

/* What a search may use. */
typedef struct krait_limits {
  uint32_t vertices;   /* states kept to grow from, at least 2; 0: as many as the block has room for */
  uint32_t expansions; /* kept; 0: half as many as vertices */
  uint64_t iterations; /* expansions made, at least 1 */
  uint8_t when_full;   /* KRAIT_RECYCLE or KRAIT_STOP; krait_init refuses every other number */
  uint32_t way_legs;   /* room for krait_improve: 0, or 16 to 1e6, best a third of a plan's steps; 0: none */
} krait_limits;

/* Lies at the front of the block. */
typedef struct krait_planner krait_planner;

/* Bytes of the block that krait_init needs; no promise for a robot that it would refuse. */
uint64_t krait_bytes_required(const krait_scene* scene, const krait_robot* robot, const krait_limits* limits);

/* The limits that spend a block of `bytes` best; likewise. */
krait_limits krait_limits_for(uint64_t bytes, const krait_scene* scene, const krait_robot* robot);

/* The same with room for krait_improve. */
krait_limits krait_limits_to_improve(uint64_t bytes, const krait_scene* scene, const krait_robot* robot,
                                     uint32_t way_legs);

/* What a planner is made from. Block, scene and file must outlive it and stay where they are; the robot is copied. */
typedef struct krait_setup {
  void* block;    /* aligned to 8 */
  uint64_t bytes; /* of the block */
  const krait_scene* scene;
  const krait_robot* robot;
} krait_setup;

/* Makes a planner in the block. Parameters and limits are copied; NULL stands for the defaults, by which as many
   vertices are kept as the block has room for. `*planner` is NULL where it fails. */
KRAIT_NODISCARD krait_failure krait_init(krait_planner** planner, const krait_setup* setup,
                                         const krait_parameters* parameters, const krait_limits* limits);

/* Where a plan ends. What follows `radius` is for the disc only, and all zero leaves the heading free. */
typedef struct krait_goal {
  uint32_t index;          /* of the scene's goals, or KRAIT_NONE for the disc */
  float x, y, radius;      /* metres, local coordinates; of the position */
  float heading;           /* radians, -8192 to 8192, of body 0 */
  float heading_tolerance; /* radians, above 0 and at most pi: how far off the heading may be; 0: the heading is free,
                              and the two fields below must be zero */
  float hitch_tolerance;   /* radians: every other body's heading is so near to that of the body before it; 0: free */
  bool either_way;         /* whether the opposite heading will do as well */
} krait_goal;
krait_goal krait_named_goal(uint32_t index);
krait_goal krait_disc_goal(float x, float y, float radius);
/* A tolerance of 0 is refused by krait_start, as in C++. */
krait_goal krait_pose_goal(float x, float y, float radius, float heading, float heading_tolerance);

typedef struct krait_query {
  const float* start; /* krait_state_size floats, copied */
  krait_goal goal;
  uint64_t seed;
} krait_query;

/* Begins a search, ending any other. KRAIT_SEARCHING, or how it has ended at once: KRAIT_BAD_SCENE where the file or
   the scene is found to be another than at krait_init. */
KRAIT_NODISCARD krait_status krait_start(krait_planner* planner, const krait_query* query);

/* At most `iterations` expansions more. The plan does not depend on how a search is cut into calls. */
KRAIT_NODISCARD krait_status krait_advance(krait_planner* planner, uint64_t iterations);

/* At most `iterations` more of looking for a plan of fewer steps: the plan is then the best so far, and krait_next
   begins again with its first state. The plan does not depend on how the iterations are cut into calls. KRAIT_SOLVED;
   where there is no plan, the search's status; KRAIT_BAD_ARGUMENT where krait_limits has no way_legs. */
KRAIT_NODISCARD krait_status krait_improve(krait_planner* planner, uint64_t iterations);

/* Ends a search as KRAIT_TIME_USED, for a program whose clock says so. */
void krait_stop_for_time(krait_planner* planner);

/* The last answer, with its details. */
KRAIT_NODISCARD krait_failure krait_last_failure(const krait_planner* planner);

/* What a start lies against: krait/why.hpp says what each is. */
enum { KRAIT_NO_CONTACT, KRAIT_WITH_OBSTACLE, KRAIT_WITH_BOUNDS, KRAIT_WITH_BODY, KRAIT_WITH_GROUND };

typedef struct krait_contact {
  uint8_t with;
  uint32_t body;  /* of the robot */
  uint32_t other; /* the obstacle's piece, or the robot's other body; KRAIT_NONE */
  float distance; /* metres; 0 where they overlap */
  float needed;   /* metres that they must keep */
  float x, y;     /* where, local coordinates */
} krait_contact;

/* After KRAIT_START_IN_COLLISION; KRAIT_NO_CONTACT elsewhere. */
krait_contact krait_start_contact(krait_planner* planner);

/* The widest way to the goal at its narrowest place; krait/decomposition/bottleneck.hpp. Metres, local coordinates. */
typedef struct krait_bottleneck {
  float width; /* 0 where no way leads to the goal at all */
  float needed;
  float x, y;
  bool at_goal; /* the place is the roomiest of the goal itself */
} krait_bottleneck;

/* Of a search that ended without a plan; all zero elsewhere. After KRAIT_NO_ROUTE it is too narrow. It lasts as long as
   krait_start. */
krait_bottleneck krait_bottleneck_of(krait_planner* planner);

/* Where a search that has started has made most of its expansions, as a rule in vain. */
typedef struct krait_effort {
  float x, y;     /* local coordinates */
  uint32_t tries; /* 0: none */
} krait_effort;
krait_effort krait_effort_of(const krait_planner* planner);

typedef struct krait_statistics {
  uint64_t iterations, restarts, vertices, recycled, collision_checks, dijkstra_runs, regions_repaired, plans_refused;
  uint64_t bytes_used, bytes_given; /* of the block behind the planner itself: `krait plan --memory bytes_given` on the
                                       workstation finds the same plan */
  uint32_t plan_steps;
  float plan_length;     /* metres */
  float plan_duration;   /* seconds */
  float plan_end_speed;  /* m/s */
  uint64_t hash;         /* of the plan */
  uint64_t improvements; /* better plans that krait_improve has found */
} krait_statistics;
krait_statistics krait_statistics_of(const krait_planner* planner);

/* ---- The plan ---- */

/* Writes the next state of a solved plan, from the first on, and the KRAIT_CONTROL floats that are held for `dt` from
   it on: zeros with the last state. False, and nothing written, behind it, or without a plan. */
bool krait_next(krait_planner* planner, float* state, float* control);

/* Lets krait_next begin again with the first state, as krait_start does. */
void krait_rewind(krait_planner* planner);

#ifdef __cplusplus
}
#endif

#endif
