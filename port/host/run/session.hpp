// SPDX-License-Identifier: Apache-2.0
// A search that a request asked for, set up and started: robot and planner behind one interface.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "decomposition/regions.hpp"
#include "host/run/query.hpp"
#include "host/run/run.hpp"
#include "krait/planner.hpp"
#include "search/grouped.hpp"

namespace krait::host {

using Watch = std::function<void(const std::vector<float>& from, const std::vector<float>& to)>;

// As the core's planners; what it returns is the planner's own and lives as long. It erases the type of the planner,
// which is the core's or a rival; the robot's is erased in each of them (Robot).
class Session {
 public:
  virtual ~Session() = default;
  virtual Status advance(std::uint64_t iterations) = 0;
  // One iteration; `watch` is called with the states at both ends of every step that the tree grows by.
  virtual Status advance_watched(const Watch& watch) = 0;
  // Only where the request asks for improvement.
  virtual Status improve(std::uint64_t iterations) = 0;
  virtual void stop_for_time() = 0;
  virtual Status status() const = 0;
  virtual Statistics statistics() const = 0;
  virtual const detail::Regions& regions() const = 0;
  virtual Bottleneck bottleneck() = 0;
  virtual Effort effort() const = 0;  // none of a planner without groups
  // States from which the tree grows out of the region; none of a planner without groups.
  virtual std::vector<std::vector<float>> states_in(Index region) const = 0;
  virtual const Robot& robot() const = 0;
  virtual float cost_to_go() const = 0;  // infinite of a planner without groups
  // The states and controls of the plan, if there is one.
  virtual void copy_plan(PlanFile& file) const = 0;
  virtual const ResolvedQuery& query() const = 0;
};

// The planner's one block.
using Block = std::vector<std::uint64_t>;

inline Block block_of(const SearchRequest& request) { return Block((request.memory + 7) / 8); }

// Throws InputError with one line for every status that is not a result of a search; for a start in collision the line
// names what it is too near to.
void refuse(const Failure& failure, const krait::Scene& scene, const SearchRequest& request);
[[noreturn]] void refuse(const Contact& at_start, const krait::Scene& scene, const SearchRequest& request);

// Scene and block must outlive the session. Throws InputError for whatever cannot be used.
std::unique_ptr<Session> start_session(const krait::Scene& scene, const SearchRequest& request, Block& block);

// run_search in a block that is already there, of at least request.memory bytes.
SearchResult run_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                        Block& block, const SearchWatch& watch);

}  // namespace krait::host
