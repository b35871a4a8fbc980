// Repeats a search with an eye on it. The core is deterministic, so what is seen is what happened.
#include "host/search/search.hpp"
#include "host/search/session.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kFrames = 60;           // of costs, at most
constexpr std::uint32_t kTreeVertices = 20000;  // shown, at most

Point point(Vec2 p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

Ring ring(Polygon polygon) {
  Ring result;
  for (int i = 0; i < polygon.count; ++i) result.push_back(point(polygon[i]));
  return result;
}

void draw_scene(const krait::Scene& scene, Picture& picture) {
  picture.title = scene.name();
  picture.min = point(scene.bounds().min);
  picture.max = point(scene.bounds().max);
  for (Index p = 0; p < scene.piece_count(); ++p) picture.obstacle_pieces.push_back(ring(scene.piece(p)));
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    picture.triangles.push_back({{point(scene.corner(t, 0)), point(scene.corner(t, 1)), point(scene.corner(t, 2))}});
  }
}

CostFrame costs_now(const Regions& regions, std::uint64_t iteration) {
  CostFrame frame;
  frame.iteration = iteration;
  for (Index t = 0; t < regions.scene().triangle_count(); ++t) frame.costs.push_back(regions.cost(regions.region(t)));
  return frame;
}

// Thins a tree: every `stride`-th vertex stays, hung on its nearest ancestor that stays; the root is vertex 0.
std::vector<TreeVertex> thinned(const MotionTree& tree, const std::vector<std::uint32_t>& iteration_of) {
  const std::uint32_t stride = tree.size() / kTreeVertices + 1;
  std::vector<TreeVertex> shown;
  for (Index v = 0; v < tree.size(); v += stride) {
    Index ancestor = v == 0 ? 0 : tree.parent(v);
    while (ancestor % stride != 0) ancestor = tree.parent(ancestor);
    shown.push_back({tree.state(v)[0], tree.state(v)[1], ancestor / stride, iteration_of[v]});
  }
  return shown;
}

void watch(Session& session, std::uint64_t iterations, Picture& picture) {
  const std::uint64_t slice = iterations / kFrames + 1;
  std::vector<std::uint32_t> iteration_of(session.tree().size(), 0);
  picture.frames.push_back(costs_now(session.regions(), 0));
  for (std::uint64_t done = 0; done < iterations;) {
    for (std::uint64_t i = 0; i < slice && done < iterations; ++i) {
      session.advance(1);
      ++done;
      iteration_of.resize(session.tree().size(), static_cast<std::uint32_t>(done));
    }
    picture.frames.push_back(costs_now(session.regions(), done));
  }
  picture.tree = thinned(session.tree(), iteration_of);
}

}  // namespace

Picture watch_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                     const PlanFile& plan) {
  Block block = block_of(request);
  const krait::Scene scene = open_scene(scene_path, bytes);
  Picture picture;
  picture.plan = plan;
  draw_scene(scene, picture);
  const std::unique_ptr<Session> session = start_session(scene, request, block);
  watch(*session, plan.statistics.at("iterations").get<std::uint64_t>(), picture);
  return picture;
}

}  // namespace krait::host
