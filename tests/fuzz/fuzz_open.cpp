// SPDX-License-Identifier: Apache-2.0
// Scene::open, and every look-up of a scene that it took.
#include <cstring>

#include "decomposition/locate.hpp"
#include "scene_input.hpp"

namespace krait::fuzz {
namespace {

Outcomes scenes("a scene");

void look_at_triangles(const Scene& scene) {
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    const Index found = detail::locate(scene, scene.corner(t, 0), t);
    require(found == t, "a triangle does not contain its own corner");
    require(scene.goal_of(t) == kNone || scene.goal_of(t) < scene.goal_count(), "a triangle has no goal");
    for (int i = 0; i < 3; ++i) {
      if (scene.neighbor(t, i) == kNone) continue;
      require(scene.portal_width(scene.portal(t, i)) >= 0.0F, "a portal has no width");
    }
  }
}

void look_at_pieces(const Scene& scene) {
  for (Index p = 0; p < scene.piece_count(); ++p) {
    const Polygon piece = scene.piece(p);
    require(piece.count >= 3 && piece.count <= format::kMaxPieceVertices, "a piece has too many vertices");
    for (int i = 0; i < piece.count; ++i) require(scene.clearance().at(piece[i]) == 0.0F, "a piece is called clear");
  }
}

void look_at_names(const Scene& scene) {
  std::size_t letters = std::strlen(scene.name());
  const Index most = 50;
  for (Index g = 0; g < scene.goal_count() && g < most; ++g) {
    letters += std::strlen(scene.goal_name(g));
    require(scene.find_goal(scene.goal_name(g)) <= g, "a goal is not found by its name");
  }
  for (Index s = 0; s < scene.start_count() && s < most; ++s) {
    letters += std::strlen(scene.start_name(s));
    const ScenePose pose = scene.start(s);
    require(finite(pose.position) && finite(pose.heading), "a start is not finite");
    for (std::uint32_t i = 0; i < pose.angle_count; ++i) require(finite(pose.angles[i]), "an angle is not finite");
  }
  require(letters < scene.bytes(), "names are longer than the file");
}

}  // namespace
}  // namespace krait::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  return krait::fuzz::change_scene(data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait;
  using namespace krait::fuzz;
  SceneInput input(data, size);
  Scene scene;
  const Failure failure = Scene::open(input.data(), input.size(), scene);
  require(failure.ok() || failure.status == Status::bad_scene, "another status than bad_scene");
  if (!failure.ok()) {
    scenes.refused.reach();
    return 0;
  }
  scenes.accepted.reach();
  look_at_triangles(scene);
  look_at_pieces(scene);
  look_at_names(scene);
  return 0;
}
