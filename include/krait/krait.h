/* SPDX-License-Identifier: Apache-2.0 */
/** \file
    krait in C: the adaptive planner, its robots and your own behind plain structs. Nothing allocates; all memory is the
    caller's. Link krait::c (-lkrait_c -lkrait -lm). The program needs no C++ run-time library; only a robot of your own
    needs special compiler flags (krait_exact). The two functions at the end are for workstations.

    Units are metres, radians and seconds. Positions are in the scene's local coordinates. A pointer argument must not
    be NULL where nothing else is said, and what it points to is read during the call only. R is the number of the
    scene's triangles. */
#ifndef KRAIT_KRAIT_H
#define KRAIT_KRAIT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "krait/version.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Marks a function whose result must be used: the compiler warns where it is thrown away. */
#if defined(__cplusplus)
#define KRAIT_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define KRAIT_NODISCARD __attribute__((warn_unused_result))
#else
#define KRAIT_NODISCARD
#endif

#define KRAIT_NONE UINT32_MAX /**< the number of nothing: no goal, no other body, no piece */
#define KRAIT_MAX_TRAILERS 25 /**< the most that a robot of the library pulls */
#define KRAIT_MAX_STATE 32    /**< floats of a state, any robot's */
#define KRAIT_MAX_CONTROL 8   /**< floats of a control, any robot's */
#define KRAIT_MAX_BODIES 32   /**< bodies, any robot's */
#define KRAIT_CONTROL 2       /**< floats of a control of the library's robots */

/* ---- Statuses ---- */

/** How a call or a search has ended: one of KRAIT_OK to KRAIT_INTERNAL. */
typedef uint8_t krait_status;
/** The values of a krait_status. */
enum {
  KRAIT_OK,                 /**< of krait_open and krait_init: done */
  KRAIT_READY,              /**< of a planner since krait_init: call krait_start */
  KRAIT_SEARCHING,          /**< not ended: call krait_advance again */
  KRAIT_SOLVED,             /**< a plan is ready */
  KRAIT_NO_ROUTE,           /**< no path of regions leads from the start to the goal for a robot of this width */
  KRAIT_BUDGET_USED,        /**< as many expansions were made as krait_limits' iterations says */
  KRAIT_TREE_FULL,          /**< no memory for vertices or expansions, and nothing that may be recycled */
  KRAIT_TIME_USED,          /**< set by krait_stop_for_time */
  KRAIT_BAD_SCENE,          /**< krait_failure's section and element say where; of krait_start: the scene is no longer
                                 that of krait_init */
  KRAIT_BAD_ROBOT,          /**< a dimension, a limit, a body or a size of the robot is unusable */
  KRAIT_BAD_ARGUMENT,       /**< a parameter, pose or goal is NaN, infinite or out of range; krait_failure's element
                                 says which */
  KRAIT_START_OUTSIDE,      /**< the start's position lies outside the scene's bounds */
  KRAIT_START_IN_COLLISION, /**< a body of the robot is too near to an obstacle, the bounds or another body at the
                                 start, or its position lies in no triangle: krait_start_contact says which */
  KRAIT_GOAL_IN_OBSTACLE,   /**< no part of the goal is free */
  KRAIT_ARENA_TOO_SMALL,    /**< krait_failure's bytes_needed says how large the block must be */
  KRAIT_BAD_ARITHMETIC,     /**< floating point contracted, relaxed, rounded otherwise or flushed: build with
                                 -ffp-contract=off */
  KRAIT_INTERNAL            /**< the plan's replay did not reproduce it: a bug of krait */
};

/** What went wrong, where. KRAIT_OK where nothing did. Fields that do not apply are zero. */
typedef struct krait_failure {
  krait_status status;   /**< KRAIT_OK where nothing went wrong */
  uint8_t section;       /**< KRAIT_BAD_SCENE: the section of the file, by the table of FORMAT.md; 255 is its header */
  uint32_t element;      /**< KRAIT_BAD_SCENE: an index in the section, or an offset in the header; KRAIT_BAD_ARGUMENT,
                              KRAIT_BAD_ROBOT: a number for krait_argument_name */
  uint64_t bytes_needed; /**< KRAIT_ARENA_TOO_SMALL: the length of the block that suffices */
  float most;            /**< KRAIT_BAD_ARGUMENT, dt: the longest time step in seconds that the robot allows */
} krait_failure;

/** The lower-case name of a status, in static storage; "unknown" for any other number. O(1). */
const char* krait_status_name(krait_status status);
/** The lower-case name of the argument that krait_failure's element says, in static storage: that of the field in the
    structs below, or block, scene, start, goal, robot_dimensions (a length or a limit), robot_polygon (a body),
    robot_sizes; "unknown" for any other number. O(1). */
const char* krait_argument_name(uint32_t element);

/* ---- The scene ---- */

/** A checked view of a scene file, which stays where it is, for example in flash. Only krait_open fills it; copies are
    views of the same file. */
typedef union krait_scene {
  uint64_t alignment;                             /**< aligns the union to 8 bytes; do not use it */
  unsigned char opaque[256 + 32 * sizeof(void*)]; /**< the view; do not use it */
} krait_scene;

/** Checks the whole file, then views it. `file` is aligned to 4 and must stay, unchanged, for as long as the scene is
    used. KRAIT_OK, or KRAIT_BAD_SCENE with section and element; then no krait_init accepts the scene. Writes to `scene`
    only. O(file_bytes log l), l the longest list of a bucket. */
KRAIT_NODISCARD krait_failure krait_open(krait_scene* scene, const void* file, size_t file_bytes);

/** What a scene says of itself. */
typedef struct krait_scene_facts {
  const char* name; /**< UTF-8 in the file's bytes, safe to print */
  double origin_x,  /**< whole metres: world = origin + local; all that follows is local */
      origin_y;     /**< whole metres, of y */
  float min_x,      /**< metres: the least x of the workspace */
      min_y,        /**< metres: the least y of the workspace */
      max_x,        /**< metres: the largest x of the workspace */
      max_y;        /**< metres: the largest y of the workspace */
  uint32_t goals,   /**< how many goals it has, numbered from 0; at most 65,535 */
      starts;       /**< how many starts it has, numbered from 0; at most 65,535 */
} krait_scene_facts;
/** Returns the facts of a scene that krait_open has filled. O(1). */
krait_scene_facts krait_facts(const krait_scene* scene);

/** A robot's place. */
typedef struct krait_pose {
  float x,              /**< metres, local coordinates, of the position */
      y,                /**< metres, local coordinates, of the position */
      heading;          /**< radians, -8192 to 8192, of body 0 */
  const float* angles;  /**< radians: the headings of its trailers, or NULL where they have `heading`; not owned */
  uint32_t angle_count; /**< how many there are: as many as trailers; or 0, also with NULL: they have `heading` */
} krait_pose;
/** A start of the scene, 0 <= start < krait_scene_facts' starts, which is not checked. `angles` lie in the file.
    O(1). */
krait_pose krait_start_pose(const krait_scene* scene, uint32_t start);

/** A goal's name, 0 <= goal < krait_scene_facts' goals, which is not checked: UTF-8 in the file's bytes, safe to print.
    O(bytes of the names before it). */
const char* krait_goal_name(const krait_scene* scene, uint32_t goal);
/** The number of the goal of that name, which ends with NUL; or KRAIT_NONE. O(bytes of the names). */
uint32_t krait_find_goal(const krait_scene* scene, const char* name);

/* ---- The robot ---- */

/** Snake, truck and car: a car with steered front wheels at speed v, turned by psi, that pulls trailers, each hitched
    to the axle before it. Body 0's frame is the rear axle, trailer i's its own axle, x forward. Defaults are those of
    krait_snake and krait_truck, and in brackets of krait_car. All numbers are finite. */
typedef struct krait_chain_parameters {
  int trailers;           /**< 0 to KRAIT_MAX_TRAILERS; a car has none, whatever stands here */
  float body_length,      /**< metres, > 0; default 0.7 (1.2) */
      body_width,         /**< metres, > 0; default 0.5 (0.6) */
      body_offset;        /**< metres: of body 0's centre ahead of the rear axle; default 0; a car's is half the
                               wheelbase, whatever stands here */
  float wheelbase,        /**< metres, > 0: rear axle to front axle; default 0.8 */
      hitch_length;       /**< metres, > 0: axle to axle; default 0.8 */
  float max_speed,        /**< m/s, > 0: of v; default 2.5 */
      min_speed;          /**< m/s, <= 0: of v; below 0 the car may reverse; default 0 */
  float max_steering,     /**< radians, above 0, up to 1.57: the most of psi, either way; default 1 */
      max_acceleration,   /**< m/s^2, > 0: of v, either way; default 5 */
      max_steering_rate;  /**< rad/s, > 0: of psi, either way; default 4 */
  int self_collision_gap; /**< >= 1: bodies i and j are tested against each other where |i - j| is at least this;
                               default 2 */
  float max_hitch_angle;  /**< radians, above 0, at most pi: the most between the headings of two bodies in a row;
                               default pi/2 */
} krait_chain_parameters;

/** A car whose speed and steering angle change at once, and its trailers, each hitched to the axle before it. Body 0's
    frame is the rear axle, trailer i's its own axle, x forward. All numbers are finite. */
typedef struct krait_kinematic_truck_parameters {
  int trailers;           /**< 0 to KRAIT_MAX_TRAILERS */
  float body_length,      /**< metres, > 0; default 0.7 */
      body_width,         /**< metres, > 0; default 0.5 */
      body_offset;        /**< metres: of body 0's centre ahead of the rear axle; default 0 */
  float wheelbase,        /**< metres, > 0: rear axle to front axle; default 0.8 */
      hitch_length;       /**< metres, > 0: axle to axle; default 0.8 */
  float max_speed,        /**< m/s, > 0: of the rear axle; default 2.5 */
      min_speed;          /**< m/s, <= 0: of the rear axle; below 0 it may reverse; default 0 */
  float max_steering;     /**< radians, above 0, up to 1.5: of the steering angle, either way; default 1 */
  int self_collision_gap; /**< >= 1: bodies i and j are tested against each other where |i - j| is at least this;
                               default 2 */
  float max_hitch_angle;  /**< radians, above 0, at most pi: the most between the headings of two bodies in a row;
                               default pi/2 */
} krait_kinematic_truck_parameters;

/** A unicycle, whose speed and turn rate change at once; its body's frame is the axle. All numbers are finite. */
typedef struct krait_unicycle_parameters {
  float body_length,   /**< metres, > 0; default 0.5 */
      body_width;      /**< metres, > 0; default 0.4 */
  float max_speed,     /**< m/s, > 0; default 1 */
      min_speed;       /**< m/s, <= max_speed; below 0 it may reverse, above 0 it never stands still; default -1 */
  float max_turn_rate; /**< rad/s, > 0, either way; default 2 */
} krait_unicycle_parameters;

/** A unicycle whose speed and turn rate change at bounded rates; its body's frame is the axle. All numbers are
    finite. */
typedef struct krait_unicycle2_parameters {
  float body_length,         /**< metres, > 0; default 0.5 */
      body_width;            /**< metres, > 0; default 0.4 */
  float max_speed,           /**< m/s, > 0; default 1 */
      min_speed;             /**< m/s, <= 0; below 0 it may reverse; default -1 */
  float max_turn_rate;       /**< rad/s, > 0, either way; default 2 */
  float max_acceleration,    /**< m/s^2, > 0, either way; default 2 */
      max_turn_acceleration; /**< rad/s^2, > 0, either way; default 4 */
} krait_unicycle2_parameters;

/** A differential drive: two driven wheels on an axle, which is its body's frame. All numbers are finite. */
typedef struct krait_diff_drive_parameters {
  float body_length,          /**< metres, > 0; default 0.5 */
      body_width;             /**< metres, > 0; default 0.4 */
  float wheel_radius,         /**< metres, > 0; default 0.08 */
      track_width;            /**< metres, > 0: between the wheels; default 0.36 */
  float max_wheel_speed,      /**< rad/s, > 0, both ways; default 12 */
      max_wheel_acceleration; /**< rad/s^2, > 0, both ways; default 24 */
} krait_diff_drive_parameters;

/** A point in the plane. */
typedef struct krait_point {
  float x, /**< metres */
      y;   /**< metres */
} krait_point;

/** A body's outline in its own frame: strictly convex, counter-clockwise, within 100 m, no side shorter than 0.1 mm. */
typedef struct krait_polygon {
  const krait_point* corners; /**< `count` of them; not owned */
  int count;                  /**< 3 to 8 */
} krait_polygon;

/** Where an expansion steers to. */
typedef struct krait_target {
  float x,     /**< metres, local coordinates */
      y;       /**< metres, local coordinates */
  float speed; /**< share of the top speed in (0, 1]; in [-1, 0): backwards; 0: to rest */
  float dt;    /**< seconds that the control will be held */
  float turn;  /**< share of the sharpest turn in (0, 1] */
} krait_target;

/** A body's frame in the workspace: its origin and the sine and cosine of its heading. */
typedef struct krait_frame {
  float x,   /**< metres, local coordinates */
      y;     /**< metres, local coordinates */
  float sin, /**< -1 to 1, no unit */
      cos;   /**< -1 to 1, no unit */
} krait_frame;

/** Bounds on how a body moves during a step. A point of it that is r metres from its frame's origin travels at most
    path + r turn, and is never further than bend + r twist from the straight line between its places at the step's
    ends. With accelerations of at most A and angular ones of at most W, bend = A dt^2 / 8 and twist = (W +
    (turn / dt)^2) dt^2 / 8; path / 2 and turn / 2 are always right. All are 0 or more. */
typedef struct krait_travel {
  float path, /**< metres, of the frame's origin */
      turn,   /**< radians */
      bend,   /**< metres, of the frame's origin */
      twist;  /**< radians */
} krait_travel;

/** The most that a body does at any time of a step, none of it below 0. */
typedef struct krait_body_rates {
  float speed,           /**< m/s, of the frame's origin */
      turn,              /**< rad/s */
      acceleration,      /**< m/s^2, of the frame's origin */
      turn_acceleration; /**< rad/s^2 */
} krait_body_rates;

/** The sine and cosine of `angle` radians, -8192 to 8192, with an error below 8e-8; NaN beyond. The same bits on every
    machine, which those of the C library are not: a robot of your own uses these, and of the C library sqrtf at most.
    O(1). */
void krait_sin_cos(float angle, float* sine, float* cosine);
/** The angle of the vector (x, y), -pi to pi radians, with an error below 4e-7; 0 of the zero vector. The same bits on
    every machine. O(1). */
float krait_atan2(float y, float x);

/** Whether this file's flags keep float arithmetic as it is written, which the same plan on every machine needs
    (-ffp-contract=off, no -ffast-math): the member `exact` of your own robot's functions. Costs a dozen operations. */
static inline bool krait_exact(void) {
  const volatile float factor = 1.0F + 0x1p-12F, product = 1.0F + 0x1p-11F, large = 0x1p26F, one = 1.0F, five = 5.0F;
  const volatile float third = 5.0F / 3.0F;
  const float a = factor;
  const float residue = a * a - product;
  const float b = large;
  const float absorbed = (one + b) - b;
  return residue == 0.0F && absorbed == 0.0F && five / 3.0F == third;
}

/** A robot of your own: pure functions of their arguments and of what lies at `self`, the argument of krait_own_robot,
    which must outlive the planner. Arrays are the caller's: states (s, next, reference, ds) have state_size floats,
    controls (u) have control_size, and frames, travel and rates have one element for each body. A function that writes
    to an array writes all of it. State components 0 and 1 are the position in metres, local coordinates. dt is in
    seconds. A planner calls them during its own calls only, derivative most often. On a workstation, krait_check_robot
    reports where one of them does not do what is said here. */
typedef struct krait_functions {
  bool (*exact)(void); /**< krait_exact, of the file that the functions stand in */
  int state_size;      /**< 2 to KRAIT_MAX_STATE */
  int control_size;    /**< 1 to KRAIT_MAX_CONTROL */
  int body_count;      /**< 1 to KRAIT_MAX_BODIES */

  /** Writes the dynamics ds = f(s, u), in units of the state a second. Called four times for each Runge-Kutta step. */
  void (*derivative)(const void* self, const float* s, const float* u, float* ds);
  /** Writes the control that steers s toward the target, inside its limits and such that a step of target->dt keeps the
      state inside its own. Called once for each time step. */
  void (*steer)(const void* self, const float* s, const krait_target* target, float* u);
  /** Whether speeds, steering and hitch angles of s are valid. */
  bool (*within_limits)(const void* self, const float* s);
  /** The outline of body k, 0 to body_count - 1, in its own frame, metres; the corners are yours and stay where they
      are. */
  krait_polygon (*body)(const void* self, int k);
  /** Writes the frame of every body in s; body 0's origin is the position. */
  void (*place)(const void* self, const float* s, krait_frame* frames);

  /* One of these two: `rates` is called where `travel` is NULL. */
  /** Writes bounds on every body's motion while u is held for dt from s to next, which prove that no obstacle is jumped
      over. Returns false when the limits, which hold in s and next, are not proven to hold in between; it writes the
      bounds in either case. */
  bool (*travel)(const void* self, const float* s, const float* u, float dt, const float* next, krait_travel* travel);
  /** Replaces travel: writes the most that every body does at any time of that step, and returns what travel
      returns. */
  bool (*rates)(const void* self, const float* s, const float* u, float dt, const float* next, krait_body_rates* rates);

  /* Each of these may be NULL. */
  /** m/s, at least 0: how fast it moves in s, 0 at rest. A plan then ends at rest, or as slow as krait_parameters'
      end_speed requires: steer with a target whose speed is 0 must decrease it at every step until it is 0. NULL: a
      plan ends at any speed. */
  float (*speed)(const void* self, const float* s);
  /** Metres along body 0's x axis, negative backwards: how far from the position it comes to rest, roughly, when it
      brakes in s. Used to know where it pays to brake for the goal. NULL: 0. */
  float (*stopping_way)(const void* self, const float* s);
  /** Metres, at least 0: the radius of the sharpest turn that it can drive forwards for long; 0: it turns on the spot,
      at any target speed above 0 toward a point that it does not face. Used to find the way to a pose. NULL: the length
      of body 0. */
  float (*turning_radius)(const void* self);
  /** m/s, above 0: the speed of the position, straight ahead at a target's speed of 1. Used to come to rest at a pose.
      NULL: one length of body 0 a second. */
  float (*top_speed)(const void* self);
  /** 1/s, at least 0: Runge-Kutta steps of at most 0.32 / fastest_rate(dt) seconds end within 0.5 mm and 0.5 mrad of
      where derivative leads, whatever state and control the limits allow in a time step of dt. NULL: every time step
      counts as short enough. */
  float (*fastest_rate)(const void* self, float dt);
  /** Changes u, the control of the state `reference` that s is very near to, to the one that brings s back to the
      motion of the reference within some time steps of dt, inside the limits as steer's. NULL: u stays, and a plan's
      error grows with its length. */
  void (*track)(const void* self, const float* s, const float* reference, float dt, float* u);
  /** Whether s, which is within the limits, is so far within them that a plan, which is driven a little beside the
      tree, keeps them. NULL: within_limits is all that the tree keeps. */
  bool (*keeps_reserve)(const void* self, const float* s);
  /** Whether it can drive backwards, at a target's speed below 0. NULL: it cannot. */
  bool (*reversible)(const void* self);
  /** At least 1: bodies i and j are tested against each other where |i - j| is at least this. NULL: 2. */
  int (*self_collision_gap)(const void* self);
  /** 0 to body_count - 1: the body whose origin steer brings to the target's point when it drives backwards, as the
      last of the trailers that a truck pushes. The last metres to a pose are driven backwards by a robot of several
      bodies only where it is not 0. NULL: 0. */
  int (*backing_body)(const void* self);
} krait_functions;

/** The arguments of krait_own_robot; neither is owned, and both must stay. */
typedef struct krait_own {
  const krait_functions* functions; /**< of the robot */
  const void* self;                 /**< what they are called with; may be NULL */
} krait_own;

/** What the library knows of a model; in static storage, for the library only. */
typedef struct krait_model krait_model;

/** A robot is made by one of the functions below; change its parameters before krait_init. A program contains the
    models whose functions it calls. It is a plain value, except for what it points to. Where a function here is passed
    NULL for a robot, or a robot that is all zeros, krait_state_size and krait_control_size return 0, krait_rest returns
    false, krait_init refuses it as KRAIT_BAD_ROBOT, and krait_check_robot reports it. */
typedef struct krait_robot {
  const krait_model* model; /**< set by the function that made it; not to be changed */
  /** The one that the function that made it names. */
  union {
    krait_chain_parameters chain;                     /**< of krait_snake, krait_truck and krait_car */
    krait_kinematic_truck_parameters kinematic_truck; /**< of krait_kinematic_truck */
    krait_unicycle_parameters unicycle;               /**< of krait_unicycle */
    krait_unicycle2_parameters unicycle2;             /**< of krait_unicycle2 */
    krait_diff_drive_parameters diff_drive;           /**< of krait_diff_drive */
    krait_own own;                                    /**< of krait_own_robot */
  } parameters;
  const krait_polygon* bodies; /**< one a body, that is 1 + trailers; NULL for boxes of body_length by body_width; not
                                    looked at for a robot of your own. krait_init copies them; not owned */
} krait_robot;

/** `chain`, with the defaults and 0 to KRAIT_MAX_TRAILERS trailers, which slip so that the tail pulls straight. State x
    y theta0 v psi theta1 ...: metres, radians, m/s of the front wheels, radians of the wheels, a heading a trailer;
    control acceleration of v, m/s^2, and steering rate, rad/s. O(1). */
krait_robot krait_snake(int trailers);
/** `chain`, with the defaults and 0 to KRAIT_MAX_TRAILERS trailers, which roll without slip. State and control as
    krait_snake's. O(1). */
krait_robot krait_truck(int trailers);
/** `kinematic_truck`, with the defaults and 0 to KRAIT_MAX_TRAILERS trailers, which roll without slip. State x y theta0
    theta1 ...: metres, radians, a heading a trailer; control speed of the rear axle, m/s, and steering angle, rad.
    O(1). */
krait_robot krait_kinematic_truck(int trailers);
/** `chain`, with the defaults, without trailers. State and control as krait_snake's. O(1). */
krait_robot krait_car(void);
/** `unicycle`, with the defaults. State x y theta: metres, radians; control speed, m/s, and turn rate, rad/s. O(1). */
krait_robot krait_unicycle(void);
/** `unicycle2`, with the defaults. State x y theta v omega: metres, radians, m/s, rad/s; control acceleration, m/s^2,
    and turn acceleration, rad/s^2. O(1). */
krait_robot krait_unicycle2(void);
/** `diff_drive`, with the defaults. State x y theta left right: metres, radians, rad/s of the wheels; control rad/s^2
    of the left and the right wheel. O(1). */
krait_robot krait_diff_drive(void);

/** `own`; functions and what lies at `self` must stay. krait_init refuses it as KRAIT_BAD_ROBOT where `functions` or
    a function that it needs is NULL or a size is out of range, and as KRAIT_BAD_ARITHMETIC where `exact` is not true.
    O(1). */
krait_robot krait_own_robot(const krait_functions* functions, const void* self);

/** Floats of a state, at most KRAIT_MAX_STATE; 0 where the robot's parameters cannot be used. O(bodies). */
uint32_t krait_state_size(const krait_robot* robot);

/** Floats of a control, at most KRAIT_MAX_CONTROL; 0 where the robot's parameters cannot be used. O(bodies). */
uint32_t krait_control_size(const krait_robot* robot);

/** Writes the state in which the robot stands still there, krait_state_size floats. Returns false, and writes nothing,
    where the robot's parameters cannot be used, where the pose of a robot with trailers has another number of angles,
    and for a robot of your own. O(bodies). */
KRAIT_NODISCARD bool krait_rest(const krait_robot* robot, krait_pose pose, float* state);

/* ---- Planning ---- */

/** How the search proceeds. The defaults are measured (bench/ABLATIONS.md, which is installed below share/doc/krait),
    and few programs change them. Ranges include their ends where nothing else is said.

    A region is a triangle of the scene, or all triangles of a named goal together; a portal is an edge that two
    triangles share. The tree's states in one region form a group; an expansion drives from a state of a group toward a
    target, and each part of a plan that is driven toward one target is a leg. A try is the search between two restarts.
    A robot parks, that is, it is driven in reverse into narrow places and out of them, if it has one body, can drive
    backwards and does not turn on the spot: a car or a kinematic_truck without trailers whose min_speed is below 0, or
    a robot of your own with `reversible` and a turning_radius above 0.

    The group with the largest weight grows. The weight is (epsilon + 1 - h / h_max)^alpha beta^n after n selections of
    the group, where h is the cost of the shortest path of regions to the goal and h_max the largest h. The cost C of an
    edge between two regions is at first the distance of their centroids, metres. An expansion that fails raises the
    costs of the edges of the next region on the shortest path. */
typedef struct krait_search_tuning {
  uint32_t group_sample; /**< 1 to 65535, default 12: states that a group keeps to grow from, a random sample of all */
  float alpha,           /**< 1 to 64, default 8, no unit: strength of the heuristic */
      beta,              /**< above 0, below 1, default 0.85, no unit: a group's weight shrinks by this factor
                              with each selection */
      epsilon;           /**< above 0, up to 1, default 0.01, no unit: keeps every weight positive */
  float gamma,           /**< 0 to 1e6, default 20: how much a failure raises edge costs; no unit, but with cost_length
                              0 square metres; 0: costs never change */
      cost_length;       /**< 0 to 10, default 1, in lengths of body 0: with this length l, a failure raises C,
                              at first C0, by gamma l min(C0, l) / max(C, l), and the edges of the regions within
                              0.35 l around as well, at most 32 in all; 0: by gamma / C */
  uint32_t kappa,        /**< 1 to 10000, default 10: expansions between updates of the heuristic costs */
      update_regions;    /**< 0 to 1e6, default 100: after an update that looked at n regions, the next waits for at
                              least n / update_regions expansions; 0: no such wait */
  bool raise_goal;       /**< default false: whether a failure in the last region before the goal raises the goal's
                              edges */
  uint32_t max_steps,    /**< 1 to 1000, default 40: time steps of one expansion, at most */
      open_steps,        /**< 0 to 1000, default 1000: the same limit in the open: an expansion goes on past max_steps,
                              up to this number, as long as every step brings it nearer to its target and it has crossed
                              at most one portal */
      path_regions;      /**< 1 to 64, default 6: targets are points of the next so many regions on the shortest path
                              from the group's region to the goal */
  float path_lengths,    /**< 0 to 100, default 8, in lengths of body 0: targets also come from further regions on that
                              path, up to the 32nd, as long as their centroids lie nearer than this to the centroid of
                              the group's region */
      near_radius,       /**< 0 to 10, default 0.7, in lengths of body 0: a target counts as reached within this
                              distance */
      goal_near_radius,  /**< 0 to 10, default 0, in lengths of body 0: the same distance for a target that lies in the
                              goal; 0: such an expansion goes on until the plan may end there, its steps are used up,
                              or a step is not free */
      stray_share,       /**< 0 to 1, default 0.1: share of expansions toward a random point of the workspace instead */
      gentle_share;      /**< 0 to 1, default 0.35: share of gentle turns among the expansions from a group that was
                              often selected */
  uint32_t sight_tries,  /**< 0 to 64, default 16: points that are drawn, at most, until one is in sight of the state;
                              0: the first point is used */
      candidates,        /**< 0 to 8, default 4: ways that are sketched before one is driven; 0: none is sketched */
      least_sketch;      /**< 0 to 20, default 8: steps, of at most 2 dt each, that the best sketch must get; with fewer
                              no way is driven, and costs rise */
  uint32_t doomed_steps, /**< 0 to 3, default 2: this many states before a collision are not kept to grow from */
      restart_unit,      /**< 0 to 1e9, default 4000: how many expansions the shortest try has if the shortest path from
                              the start to the goal has 90 regions. If it has n regions, this number is multiplied by
                              (n / 90)^2, but by at least 0.1 and at most 1 + n / 90. The tries last 1, 1, 2, 1, 1, 2,
                              4, ... times as long as the shortest (Luby's sequence). 0: the search never restarts */
      stuck_expansions;  /**< 0 to 1e9, default 16: for a robot that parks: if, after so many expansions of a try, no
                              expansion has ended away from the start, the robot is driven along a way out of the narrow
                              place, and along another one after every so many further expansions; 0: it is not */
  float slowest,         /**< 0.05 to 1, default 1: speed set-points are uniform from this share of the top speed to all
                              of it */
      stopping_ways,     /**< 0 to 10, default 1, in stopping distances of the robot at its present speed: toward a
                              target outside the goal that is nearer than this, the robot drives at a lower speed, at
                              which this many stopping distances lead to the target. A robot that brakes weakly then
                              drives no faster than it can stop. Only for robots that have `speed`. 0: at any speed */
      reverse_share;     /**< 0 to 1, default 0.2: share of backward drives among the expansions from a group that was
                              often selected, of a robot that can reverse */
  bool continuous;       /**< default true: whether whole steps are proven free, or states only */
  uint32_t max_substeps; /**< 1 to 64, a power of two, default 16: how finely a step is cut to prove it */
  bool prune_portals;    /**< default true: whether portals too narrow for the robot are removed before the search */
} krait_search_tuning;

/** What a program says of its robot's motion and of its plans. */
typedef struct krait_parameters {
  float dt;                   /**< seconds, 0.001 to 1, default 0.1: a time step */
  float clearance;            /**< metres, 0 to 10, default 0.001: the distance that a plan keeps between the robot's
                                   bodies and everything else, and between those bodies that are tested against each
                                   other; what rounding needs comes on top */
  float goal_margin;          /**< metres, 0 to 10, at most a tenth of the goal's size, less where it is long and
                                   narrow, default 0.03: how deep inside the goal the plan must end */
  float end_speed;            /**< m/s, 0 to INFINITY, default 0: a plan ends no faster than this, within 5 mm/s;
                                   0: at rest; INFINITY: at any speed */
  krait_search_tuning tuning; /**< how the search proceeds */
} krait_parameters;
/** All fields with their defaults. O(1). */
krait_parameters krait_default_parameters(void);

/** What a search does when its memory is full. */
enum {
  KRAIT_RECYCLE, /**< drops what helps least, never the start, and goes on */
  KRAIT_STOP     /**< ends as KRAIT_TREE_FULL */
};

/** What a search may use. Without limits krait_init uses 0 vertices, 0 expansions, a million iterations, KRAIT_RECYCLE
    and 0 way_legs. It refuses a number out of its range as KRAIT_BAD_ARGUMENT. */
typedef struct krait_limits {
  uint32_t vertices;   /**< states kept to grow from, 2 to 4,192,256; 0: as many as the block has room for */
  uint32_t expansions; /**< expansions that are kept, 2 to 4,192,256; 0: half as many as vertices */
  uint64_t iterations; /**< expansions that a search makes at most, at least 1 */
  uint8_t when_full;   /**< KRAIT_RECYCLE or KRAIT_STOP; krait_init refuses every other number */
  uint32_t way_legs;   /**< 0, or 16 to 1e6: how many legs krait_improve has room for; half of a plan's steps is the
                            best number. 0: no memory is taken, and krait_improve cannot be used */
} krait_limits;

/** Lies at the front of the block; to be used by its address only, never copied. Planners in blocks of their own may be
    used in threads of their own. */
typedef struct krait_planner krait_planner;

/** The bytes of the block that krait_init needs, the planner itself among them. Vertices 0 are counted as no vertices
    at all, so state a number. Unspecified for a robot that krait_init would refuse. O(bodies). */
uint64_t krait_bytes_required(const krait_scene* scene, const krait_robot* robot, const krait_limits* limits);

/** The limits that use a block of `bytes` fully: as many vertices as fit, at least 2, and a million iterations.
    Unspecified for a robot that krait_init would refuse. Work: 22 times that of krait_bytes_required. */
krait_limits krait_limits_for(uint64_t bytes, const krait_scene* scene, const krait_robot* robot);

/** The same with room for krait_improve: `way_legs` is 0, or 16 to 1e6. As much work. */
krait_limits krait_limits_to_improve(uint64_t bytes, const krait_scene* scene, const krait_robot* robot,
                                     uint32_t way_legs);

/** The arguments of krait_init. Block, scene and file must outlive the planner and stay where they are; the robot is
    copied, and so are its bodies, but for what a robot of your own points to. */
typedef struct krait_setup {
  void* block;              /**< the caller's, aligned to 8; the planner alone writes to it */
  uint64_t bytes;           /**< length of the block */
  const krait_scene* scene; /**< opened */
  const krait_robot* robot; /**< copied */
} krait_setup;

/** Makes a planner in the block. Parameters and limits are copied; NULL stands for the defaults, by which as many
    vertices are kept as the block has room for. `*planner` is NULL where it fails: KRAIT_BAD_ARITHMETIC,
    KRAIT_BAD_ARGUMENT (a scene that was not opened, too), KRAIT_BAD_ROBOT or KRAIT_ARENA_TOO_SMALL. There is nothing to
    be freed: the block is the caller's again when the planner is no longer used. Work: copies the robot and looks at
    every vertex of its bodies, calls its fastest_rate at most 26 times, reads at most 310 words of the scene, and
    counts the bytes once, or with vertices 0 23 times, each O(1). */
KRAIT_NODISCARD krait_failure krait_init(krait_planner** planner, const krait_setup* setup,
                                         const krait_parameters* parameters, const krait_limits* limits);

/** Where a plan ends. What follows `radius` is for the disc only, and all zero leaves the heading free. */
typedef struct krait_goal {
  uint32_t index;          /**< of the scene's goals, or KRAIT_NONE for the disc */
  float x,                 /**< metres, local coordinates, in the scene's bounds: of the disc that the position ends
                                in */
      y,                   /**< metres, local coordinates, in the scene's bounds */
      radius;              /**< metres, > 0; x, y and radius are not looked at for the scene's goals */
  float heading;           /**< radians, -8192 to 8192, of body 0 */
  float heading_tolerance; /**< radians, above 0 and at most pi: how far off the heading may be; 0: the heading is free,
                                and the two fields below must be zero */
  float hitch_tolerance;   /**< radians, > 0: how far the heading of every other body may differ from that of the
                                body before it; 0: free */
  bool either_way;         /**< whether the opposite heading is accepted as well */
} krait_goal;
/** The scene's goal of that number, its heading free. O(1). */
krait_goal krait_named_goal(uint32_t index);
/** The disc around a point, metres, local coordinates, its heading free. O(1). */
krait_goal krait_disc_goal(float x, float y, float radius);
/** The disc, body 0 turned to `heading` within `heading_tolerance`, radians. A tolerance of 0 is refused by
    krait_start. O(1). */
krait_goal krait_pose_goal(float x, float y, float radius, float heading, float heading_tolerance);

/** A planning problem. */
typedef struct krait_query {
  const float* start; /**< krait_state_size finite floats within the robot's limits, in the units of its state, copied;
                         the position in local metres, headings within 8192 radians either way */
  krait_goal goal;    /**< copied */
  uint64_t seed;      /**< any; the same seed, the same plan */
} krait_query;

/** Begins a search, ending any other and its plan. KRAIT_SEARCHING, or how it has ended at once: KRAIT_SOLVED where a
    plan may end with the start; KRAIT_NO_ROUTE, KRAIT_GOAL_IN_OBSTACLE, KRAIT_START_OUTSIDE, KRAIT_START_IN_COLLISION,
    KRAIT_BAD_ARGUMENT; KRAIT_BAD_SCENE where the file or the scene is found to be another than at krait_init. Work: one
    Dijkstra over the scene's triangles, O(R log R); at most 2,730 distances of a point from the obstacles; one
    collision check; and at most 310 words of the file. */
KRAIT_NODISCARD krait_status krait_start(krait_planner* planner, const krait_query* query);

/** Runs at most `iterations` more expansions, each of at most max_steps steps; returns at once when the search has
    ended. Returns KRAIT_SEARCHING where it goes on, or how it has ended: KRAIT_SOLVED, KRAIT_BUDGET_USED,
    KRAIT_TREE_FULL (when_full of krait_limits), KRAIT_INTERNAL, or what krait_start returned. A way that reached the
    goal is driven once more before it becomes the plan: each max_steps steps of that use up one of `iterations`, but do
    not count in krait_statistics and krait_limits. The plan does not depend on how a search is split into calls.

    Work per iteration, at most; `krait info` on the workstation prints these bounds for a scene and a robot:
    - max_steps steps, each with its collision check and a test for the goal, O(vertices of its polygon);
    - the lines of sight and the sketches that sight_tries and candidates allow;
    - one Dijkstra, O(R log R).

    And, where the query causes it:
    - when the memory is full: O(R) for each step and for each group whose states are dropped;
    - near a pose, at every fourth state: 288 lines to the pose, with 128 looks at a disc each. Where none of these
      lines ends in the goal, a robot that pushes trailers tries 288 more, and one that parks (krait_search_tuning) 576;
    - for a robot that parks, 147,456 placements of its body to find the ways out of the pose: once a query, and again
      after each search for ways out of the start;
    - for a robot that parks and has not come away from its start, 73,728 placements before each way out that it drives
      (stuck_expansions). */
KRAIT_NODISCARD krait_status krait_advance(krait_planner* planner, uint64_t iterations);

/** Runs at most `iterations` iterations that look for a plan with fewer steps. The plan and its figures in
    krait_statistics are then those of the best plan so far, and krait_next begins again with its first state. Returns
    KRAIT_SOLVED; where there is no plan, the search's status; else KRAIT_BAD_ARGUMENT where way_legs of krait_limits is
    0: krait_next begins again then, too, and what krait_status_of and krait_failure_of return stays. The plan does not
   depend on how iterations are split into calls.

    An iteration either drives along a line or belongs to a search that starts again with an empty tree. Such searches
    take most iterations for a chain of four or more bodies. They do so for any other robot, too, until a line that is
    driven forwards from the start has led to a better plan. Their iterations count in krait_statistics and krait_limits
    as those of krait_advance do.

    Work per iteration of such a search: that of krait_advance. Work of any other iteration: at most max_steps steps
    along a line, a choice of lines to a pose, as in krait_advance, after at most every third step, and the unproven
    steps of 16 legs or of 16 of the first plan's expansions; or O(way_legs). One Dijkstra more in the first call after
    krait_start, at the begin of each search, and at the end of the last search of a series. */
KRAIT_NODISCARD krait_status krait_improve(krait_planner* planner, uint64_t iterations);

/** Ends a search as KRAIT_TIME_USED, for a program whose clock says so. No effect once it has ended. O(1). */
void krait_stop_for_time(krait_planner* planner);

/** Returns the last status of krait_init, krait_start or the search, with its details. O(1). */
KRAIT_NODISCARD krait_failure krait_last_failure(const krait_planner* planner);

/** What a robot is too near to at its start. */
enum {
  KRAIT_NO_CONTACT,    /**< nothing */
  KRAIT_WITH_OBSTACLE, /**< a piece of the scene */
  KRAIT_WITH_BOUNDS,   /**< the bounds of the workspace */
  KRAIT_WITH_BODY,     /**< another body of the robot */
  KRAIT_WITH_GROUND    /**< the position lies in no triangle of the scene */
};

/** What a body is too near to, and where. */
typedef struct krait_contact {
  uint8_t kind;   /**< KRAIT_NO_CONTACT to KRAIT_WITH_GROUND */
  uint32_t body;  /**< the robot's body, from 0 */
  uint32_t other; /**< the obstacle's piece, or the robot's other body; KRAIT_NONE */
  float distance; /**< metres; 0 where they overlap */
  float needed;   /**< metres that they must keep: the clearance, and what rounding needs */
  float x,        /**< metres, local coordinates: the middle between their nearest points, or a point of both */
      y;          /**< metres, local coordinates, of the same point */
} krait_contact;

/** After KRAIT_START_IN_COLLISION; KRAIT_NO_CONTACT elsewhere. O(pieces near the robot + bodies^2). */
krait_contact krait_start_contact(krait_planner* planner);

/** The narrowest place of the widest way from the start to the goal. */
typedef struct krait_bottleneck {
  float width;  /**< metres, of a disc that passes there; 0 where no way leads to the goal at all */
  float needed; /**< metres, of the disc that lies in body 0, with the clearance on both sides */
  float x,      /**< metres, local coordinates: the place, where there is a way */
      y;        /**< metres, local coordinates, of the same place */
  bool at_goal; /**< true: the robot cannot stand in the goal, and the place is the goal's point of most room */
} krait_bottleneck;

/** Returns the bottleneck after a search that ended without a plan; all zeros after every other status. After
    KRAIT_NO_ROUTE it is too narrow for the robot. Work: at most four Dijkstras, O(R log R), and 2,730 distances of a
    point. */
krait_bottleneck krait_bottleneck_of(krait_planner* planner);

/** The region from which a search has made most expansions since its last restart, as a rule without success. */
typedef struct krait_effort {
  float x,        /**< metres, local coordinates: the middle of a triangle of the scene */
      y;          /**< metres, local coordinates, of the same point */
  uint32_t tries; /**< expansions from there since the last restart; 0: there was none */
} krait_effort;
/** Returns the effort of a search that has started; of several regions with equally many tries the first. O(R). */
krait_effort krait_effort_of(const krait_planner* planner);

/** What a search and the calls of krait_improve after it have done so far. */
typedef struct krait_statistics {
  uint64_t iterations,  /**< expansions; each max_steps steps of a long one count as one */
      restarts,         /**< tries after the first (krait_search_tuning's restart_unit) */
      vertices,         /**< states that were added to the motion tree, with the start */
      recycled,         /**< states that were kept to grow from and dropped for lack of memory */
      collision_checks, /**< placements of the whole robot that were tested */
      dijkstra_runs,    /**< computations of the shortest paths of all regions */
      regions_repaired, /**< single shortest paths that were recomputed after costs had risen */
      plans_refused;    /**< ways to the goal that failed the proof when they were driven once more */
  uint64_t bytes_used,  /**< bytes of the block behind the planner itself: those of the tables, and the most that
                             vertices and expansions took */
      bytes_given;      /**< length of the block behind the planner itself: `krait plan --memory bytes_given --clearance
                             0.001 --improve 0` on the workstation finds the same plan */
  uint32_t plan_steps;  /**< controls of the plan, each held for a time step */
  float plan_length;    /**< metres */
  float plan_duration;  /**< seconds */
  float plan_end_speed; /**< m/s, of the last state; 0 of a robot whose states have no speed */
  uint64_t hash;        /**< of the plan: FNV-1a 64 over the bytes of s0, u0, s1, u1, ..., sL; 0 without a plan */
  uint64_t improvements; /**< better plans found by krait_improve */
} krait_statistics;
/** Returns the statistics of the search that started last. O(1). */
krait_statistics krait_statistics_of(const krait_planner* planner);

/* ---- The plan ---- */

/** Writes the next state of a solved plan, from the first on, and the control that is held for `dt` from it on: zeros
    with the last state. `state` has room for krait_state_size floats, `control` for krait_control_size. Returns false,
    and writes nothing, behind the last state or without a plan. Work: that of a time step's motion, and O(legs of the
    plan). */
KRAIT_NODISCARD bool krait_next(krait_planner* planner, float* state, float* control);

/** Lets krait_next begin again with the first state, as krait_start does. O(1). */
void krait_rewind(krait_planner* planner);

/* ---- A robot of your own, held to what it promises: on a workstation ---- */
/* These two are in an archive of their own, krait::c_robot_check (-lkrait_c_robot_check -lkrait_robot_check, before the
    others), which allocates and needs C++'s run-time library. */

/** The range of a component, which includes both ends. They and their difference are finite. */
typedef struct krait_range {
  float low;  /**< in the component's own unit */
  float high; /**< in the component's own unit, not below low */
} krait_range;

/** The ranges of a robot's states and controls, in its own units, and what else krait_check_robot must know of it.
    Nothing in it is owned. */
typedef struct krait_ranges {
  const krait_range* state;   /**< one for each component. Samples are uniform in it; except for the position, some are
                                   at its ends */
  const krait_range* control; /**< one for each component: the limits that steer keeps to. Samples are drawn in the same
                                   way */
  const float* dt;            /**< seconds, finite and above 0: the time steps to be tried */
  uint32_t dt_count;          /**< of them; 0: 0.1 s alone */
  /** The components of the state that are headings, in radians: to turn the whole robot changes only these, by the
      angle, and the position. If there are any, krait_check_robot checks that the robot moves in the same way in every
      direction. */
  const int* headings;
  uint32_t heading_count;     /**< of them, or 0; 0 with NULL */
  bool translation_invariant; /**< default true: whether to check that the robot moves in the same way at every
                                   position */
  float leaving_share, /**< 0 to 1, default 0: share of steered steps that may leave the limits, as when hitches fold */
      step_rate,       /**< finite, 0 or more, default 0.32: Runge-Kutta steps of step_rate / fastest_rate(dt) seconds,
                            but of at most dt, must be accurate to step_error; 0: not checked */
      step_error;      /**< metres and radians, finite, 0 or more, default 5e-4 */
  /** Turns the numbers that were drawn into a state, for a robot whose components depend on each other; NULL: the
      numbers are the state. */
  void (*complete_state)(const void* self, float* state);
  const void* self; /**< what complete_state is called with; may be NULL */
} krait_ranges;
/** Ranges with these two arrays, which must stay, and the defaults of all other fields. O(1). */
krait_ranges krait_default_ranges(const krait_range* state, const krait_range* control);

/** Draws `samples` states and controls from the ranges, and returns how many promises of krait_functions the robot
    breaks at one of them. 0 means that no broken promise was found, which is no proof. If the ranges do not fit the
    robot's sizes, or a number in them is not as its comment says, no sample is drawn, and that counts as one broken
    promise. Each time step counts as one, too, if the motion could be checked in fewer than a tenth of its samples: in
    the other samples, no control that was drawn ended the step within the limits. Writes a line for each into `text`:
    what is broken, by how much and where in the worst case, and what to do. It writes at most `bytes` bytes, with the
    zero at the end; `text` may be NULL where `bytes` is 0. The result is the same for the same seed. Work: some
    thousand derivatives a sample. */
KRAIT_NODISCARD uint32_t krait_check_robot(const krait_robot* robot, const krait_ranges* ranges, uint32_t samples,
                                           uint64_t seed, char* text, size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
