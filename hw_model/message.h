// SPDX-License-Identifier: Apache-2.0
// What travels between the stages. All are trivially copyable.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "hw_model/cycle.h"
#include "hw_model/trace/subject.h"
#include "pyramid/classifier.h"
#include "pyramid/terminal_color.h"

namespace pyrasim::hw {

/// A pixel in flight.
struct PixelTag {
  std::uint32_t pixel = no_pixel;  ///< row * columns + column, inside the window
  std::uint32_t slot = 0;          ///< of the tree accumulator, where its trace tree is summed
  Cycle admitted = 0;              ///< when the pixel scan sent the corner that completes it
};

/// A free slot of the tree accumulator.
struct SlotCredit {
  std::uint32_t slot;
};

/// A corner of the pixel raster. `tag` names the pixel that it completes; the first row and column complete none.
struct CornerRequest {
  GridPoint point;
  PixelTag tag;
};

/// A case-3 pyramid to be split by five rays.
struct SubdivisionRequest {
  Cell cell;
};

struct RayMessage {
  glm::dvec3 view_vector;
  GridPoint point;   ///< its address: what tells rays apart
  PixelTag tag;      ///< meaningful for corners
  bool subdivision;  ///< false: a corner of the raster
};

/// The intersection unit that got a ray, in the order of issue.
struct UnitNumber {
  std::uint32_t unit;
};

struct SampleMessage {
  Sample sample;
  PixelTag tag;
  bool subdivision;
  std::uint32_t shadow_rays = 0;  ///< that a shadow unit has to follow
  Cycle shadow_tests = 0;         ///< that these take, in cycles
};

/// A case-3 pyramid with what its corners saw: to the controller for subdivision, and from it back to the classifier,
/// which needs the corners again when the five samples arrive.
struct NodeMessage {
  Cell cell;
  PixelTag tag;
  CornerSamples corners;
  bool subdivide = true;       ///< false: nothing to subdivide, the message only closes a family
  bool closes_family = false;  ///< the last message about the four subpixels of one request
};

/// A terminal node: what its corners saw, and where it lies.
struct TerminalMessage {
  Cell cell;
  PixelTag tag;
  CornerSamples corners;
  PyramidCase which;
};

/// The colour of a terminal node.
struct ColorMessage {
  FixedColor color;
  PixelTag tag;
  std::uint32_t log2_side;  ///< of its cell
};

struct PixelMessage {
  std::uint32_t pixel;
  glm::vec3 color;
};

inline Subject subject_of(const Cell& cell) { return {.point = cell.corner, .log2_side = cell.log2_side}; }
inline Subject subject_of(const CornerRequest& corner) { return {.point = corner.point, .pixel = corner.tag.pixel}; }
inline Subject subject_of(const SubdivisionRequest& request) { return subject_of(request.cell); }
inline Subject subject_of(const NodeMessage& node) { return subject_of(node.cell); }
inline Subject subject_of(const SampleMessage& sample) { return {.object = sample.sample.seen.object}; }
inline Subject subject_of(const TerminalMessage& node) {
  return {.point = node.cell.corner, .log2_side = node.cell.log2_side, .which = node.which};
}

}  // namespace pyrasim::hw
