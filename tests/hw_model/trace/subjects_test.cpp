// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "../../test_scenes.h"
#include "../event_list.h"
#include "../random_machine.h"
#include "../simulation.h"

namespace pyrasim::hw {
namespace {

using Kind = Event::Kind;

constexpr const char* requests = "subdivision_controller_to_view_vector_generator";
constexpr const char* nodes = "subdivision_controller_to_pyramid_classifier";

/// Events of the FIFOs of all units, in order. `to_units`: of rays; else of samples.
std::vector<Event> at_units(const EventList& list, Kind kind, bool to_units) {
  std::vector<Event> result;
  for (const Event& event : list.all()) {
    if (event.kind != kind || kind == Kind::firing) continue;
    const std::string name = list.name_of(event);
    const bool from_units = (name.starts_with("intersection_unit") || name.starts_with("shadow_unit")) &&
                            name.ends_with("_to_pyramid_classifier");
    if (to_units ? name.starts_with("view_vector_generator_to_intersection_unit") : from_units) {
      result.push_back(event);
    }
  }
  return result;
}

std::vector<std::uint64_t> rays_of(const std::vector<Event>& events) {
  std::vector<std::uint64_t> rays;
  for (const Event& event : events) rays.push_back(event.subject.ray);
  return rays;
}

std::vector<std::uint64_t> numbers(std::size_t count) {
  std::vector<std::uint64_t> result(count);
  std::iota(result.begin(), result.end(), 0U);
  return result;
}

/// Some machines of each dispatch, with the events of a frame.
class Rays : public testing::Test {
 protected:
  Rays() {
    std::mt19937_64 random(43);
    for (int k = 0; k < 24; ++k) {
      SimulationOptions options;
      options.max_level = static_cast<int>(random() % 5);
      Scene scene = random_scene(random(), {12, 12, 0}, 12, 10);
      if (k % 3 == 0) scene = under_lights(std::move(scene), random);
      lists_.emplace_back(simulation_.add(scene, random_machine(random, options.max_level), options));
    }
    simulation_.run();
  }

  Simulation simulation_;
  std::deque<EventList> lists_;
};

/// Issued in the order of their numbers, and so taken by the classifier, though units return them in any order.
TEST_F(Rays, AreNumberedInOrderOfIssue) {
  for (const EventList& list : lists_) {
    const std::vector<std::uint64_t> all = numbers(list.machine().statistics().total_rays());
    EXPECT_EQ(rays_of(at_units(list, Kind::write, true)), all);
    EXPECT_EQ(rays_of(at_units(list, Kind::read, false)), all);
    EXPECT_EQ(rays_of(list.of(Kind::firing, "view_vector_generator")), all);
    const std::string queue = "view_vector_generator_to_pyramid_classifier";
    const std::vector<Event> queued = list.of(Kind::read, queue);
    if (!queued.empty()) {
      EXPECT_EQ(rays_of(queued), all);
    }
    EXPECT_EQ(rays_of(list.of(Kind::write, queue)), rays_of(queued));
  }
}

/// A unit's ray is the one that it reads from `before`, works on and writes to `after` in the same cycle.
void expect_through(const EventList& list, const std::string& before, const std::string& unit,
                    const std::string& after) {
  const std::vector<Event> read = list.of(Kind::read, before + "_to_" + unit);
  const std::vector<Event> firings = list.of(Kind::firing, unit);
  const std::vector<Event> written = list.of(Kind::write, unit + "_to_" + after);
  EXPECT_EQ(rays_of(read), rays_of(list.of(Kind::write, before + "_to_" + unit)));
  EXPECT_EQ(rays_of(read), rays_of(firings));
  EXPECT_EQ(rays_of(read), rays_of(written));
  for (std::size_t n = 0; n < read.size(); ++n) {
    EXPECT_EQ(read[n].at, firings[n].at);
    EXPECT_EQ(read[n].at, written[n].at);
  }
}

TEST_F(Rays, GoThroughAUnitInOneFiring) {
  std::size_t with_shadows = 0;
  for (const EventList& list : lists_) {
    const bool shadows = list.machine().contents().lights_with_shadows > 0;
    for (std::size_t k = 0; k < list.machine().spec().intersection_units; ++k) {
      const std::string number = "_" + std::to_string(k);
      const std::string unit = "intersection_unit" + number;
      const std::string shadow_unit = "shadow_unit" + number;
      expect_through(list, "view_vector_generator", unit, shadows ? shadow_unit : "pyramid_classifier");
      if (!shadows) continue;
      ++with_shadows;
      expect_through(list, unit, shadow_unit, "pyramid_classifier");
    }
  }
  EXPECT_GT(with_shadows, 0U);
}

/// A request's rays are five in a row, the first with its reading; the others are corners.
TEST_F(Rays, HaveTheirRequestAsParent) {
  for (const EventList& list : lists_) {
    const FrameStatistics statistics = list.machine().statistics();
    std::map<std::uint64_t, std::vector<Event>> children;
    for (const Event& ray : at_units(list, Kind::write, true)) children[ray.subject.request].push_back(ray);
    EXPECT_EQ(children[no_number].size(), statistics.primary_rays());
    EXPECT_EQ(children.size() - 1, statistics.subdivisions);
    for (const char* fifo : {requests, nodes}) {
      const std::vector<Event> written = list.of(Kind::write, fifo);
      const std::vector<Event> read = list.of(Kind::read, fifo);
      ASSERT_EQ(written.size(), statistics.subdivisions);
      ASSERT_EQ(read.size(), statistics.subdivisions);
      for (std::uint64_t k = 0; k < read.size(); ++k) {
        EXPECT_EQ(written[k].subject.request, k);
        EXPECT_EQ(read[k].subject.request, k);
        const std::vector<Event>& rays = children[k];
        ASSERT_EQ(rays.size(), subdivision_rays);
        EXPECT_EQ(rays.back().subject.ray, rays.front().subject.ray + subdivision_rays - 1);
        if (fifo == requests) {
          EXPECT_EQ(read[k].at, rays.front().at);
        }
      }
    }
  }
}

/// The classifier reads a node together with the first of its samples.
TEST_F(Rays, MeetTheirNodeAtTheClassifier) {
  for (const EventList& list : lists_) {
    std::map<Cycle, std::uint64_t> parents;
    for (const Event& sample : at_units(list, Kind::read, false)) parents[sample.at] = sample.subject.request;
    for (const Event& node : list.of(Kind::read, nodes)) EXPECT_EQ(parents.at(node.at), node.subject.request);
  }
}

std::vector<Subject> subjects_of(const std::vector<Event>& events) {
  std::vector<Subject> subjects;
  for (const Event& event : events) subjects.push_back(event.subject);
  return subjects;
}

std::tuple<std::uint32_t, std::uint32_t, std::uint32_t> address_of(const Cell& cell) {
  return {cell.corner.row, cell.corner.column, cell.log2_side};
}
Cell cell_of(const Subject& node) { return {node.point, node.log2_side}; }

/// A request's rays go through the points of its subdivision, in their order; corners through those of the raster.
TEST_F(Rays, HaveTheirPoints) {
  for (const EventList& list : lists_) {
    std::map<std::uint64_t, Subject> split;
    for (const Event& request : list.of(Kind::read, requests)) split[request.subject.request] = request.subject;
    std::map<std::uint64_t, std::size_t> rays_of_request;
    std::vector<Subject> corners;
    for (Subject ray : subjects_of(list.of(Kind::firing, "view_vector_generator"))) {
      EXPECT_FALSE(ray.is_node());
      if (ray.request == no_number) {
        ray.ray = no_number;
        corners.push_back(ray);
        continue;
      }
      const Subject& node = split.at(ray.request);
      EXPECT_EQ(ray.point, subdivision_point(cell_of(node), rays_of_request[ray.request]++));
      EXPECT_EQ(ray.pixel, node.pixel);
    }
    EXPECT_EQ(corners, subjects_of(list.of(Kind::firing, "pixel_scan")));
    std::uint32_t pixels = 0;
    const auto columns = static_cast<std::uint32_t>(list.machine().image().columns()) + 1;
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t steps = 1U << list.machine().max_level();
      EXPECT_EQ(corners[k].point, (GridPoint{k / columns * steps, k % columns * steps}));
      EXPECT_EQ(corners[k].pixel, k < columns || k % columns == 0 ? no_pixel : pixels++);
    }
  }
}

/// Every node is classified once, and those that the colour unit gets fill their pixel. A node that is split has been
/// sent for it, and comes back with the first of its rays.
TEST_F(Rays, MakeNodesThatFillTheirPixels) {
  for (const EventList& list : lists_) {
    const int max_level = list.machine().max_level();
    std::map<std::uint32_t, std::uint64_t> area;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> terminal;
    const std::vector<Subject> colors = subjects_of(list.of(Kind::firing, "color_unit"));
    for (const Subject& node : colors) {
      ASSERT_TRUE(node.is_node());
      EXPECT_TRUE(terminal.insert(address_of(cell_of(node))).second);
      const auto columns = static_cast<std::uint32_t>(list.machine().image().columns());
      EXPECT_EQ(node.pixel, (node.point.row >> max_level) * columns + (node.point.column >> max_level));
      area[node.pixel] += std::uint64_t{side(cell_of(node))} * side(cell_of(node));
    }
    EXPECT_EQ(area.size(), list.machine().image().pixels().size());
    for (const auto& [pixel, its] : area) EXPECT_EQ(its, std::uint64_t{1} << (2 * max_level));
    EXPECT_EQ(subjects_of(list.of(Kind::firing, "tree_accumulator")), colors);
    std::map<Cycle, std::uint64_t> classified;
    for (const Event& firing : list.of(Kind::firing, "pyramid_classifier")) classified[firing.at] = firing.subject.ray;
    for (const char* fifo : {"pyramid_classifier_to_color_unit", "pyramid_classifier_to_subdivision_controller"}) {
      for (const Event& node : list.of(Kind::write, fifo)) EXPECT_EQ(node.subject.ray, classified.at(node.at));
    }
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> sent;
    for (const Event& node : list.of(Kind::read, "pyramid_classifier_to_subdivision_controller")) {
      sent.insert(address_of(cell_of(node.subject)));
    }
    const std::vector<Event> issued = list.of(Kind::write, nodes);
    for (const Event& node : issued) EXPECT_TRUE(sent.contains(address_of(cell_of(node.subject))));
    EXPECT_EQ(subjects_of(list.of(Kind::read, nodes)), subjects_of(issued));
    EXPECT_EQ(subjects_of(list.of(Kind::write, requests)), subjects_of(issued));
    std::map<Cycle, Subject> at_controller;
    for (const Event& firing : list.of(Kind::firing, "subdivision_controller"))
      at_controller[firing.at] = firing.subject;
    for (const Event& node : issued) EXPECT_EQ(at_controller.at(node.at), node.subject);
  }
}

}  // namespace
}  // namespace pyrasim::hw
