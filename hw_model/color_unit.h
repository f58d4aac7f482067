// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/plan/tester_parts.h"
#include "hw_model/record/work_sink.h"
#include "hw_model/stage/stage_of.h"

namespace pyrasim::hw {

/// Turns terminal nodes into colours (decisions D2 and D6): the classifier says what a node's corners see, the colour
/// unit what that looks like. Every node passes through it, in order: a way around it for nodes that need less would
/// make the accumulator choose by what arrives first. Its texture part is there
/// where an object has a texture; a node that needs it takes longer.
class ColorUnit final : public StageOf<ColorUnit> {
 public:
  FifoPort<TerminalMessage> pyramid_classifier{"pyramid_classifier"};
  FifoPort<ColorMessage> tree_accumulator{"tree_accumulator"};

  ColorUnit(const sc_core::sc_module_name& name, const FrameSetup& frame);

  const TextureWork& work() const { return work_; }
  std::vector<StagePart> parts() const;
  /// `sink` is told of every node from now on, in scenes with textures.
  void report_work_to(WorkSink& sink) { work_sink_ = &sink; }

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<TerminalMessage> pyramid_classifier;
    FifoWriter<ColorMessage> tree_accumulator;
  };
  Ends ends() const { return {FifoReader(*pyramid_classifier), FifoWriter(*tree_accumulator)}; }
  static Plan next(const Ends& ends, Cycle ready) {
    return {Start(ready).needs_token(ends.pyramid_classifier).needs_room(ends.tree_accumulator)};
  }
  Cycle fire(Ends& ends, const Plan& plan);
  FixedColor color_of(const TerminalMessage& node, TextureWork& work) const;
  /// The same in a scene with textures, recorded or to be.
  FixedColor textured_color(const TerminalMessage& node, TextureWork& work) const;

  StageTiming timing_;
  Palette palette_;
  EdgePolicy edge_policy_;
  TextureCost texture_cost_;
  std::shared_ptr<const RecordedTextures> recorded_textures_;  ///< in place of the scene's; or none
  std::size_t textured_objects_ = 0;
  TextureWork work_;
  WorkSink* work_sink_ = nullptr;
};

extern template class StageOf<ColorUnit>;

}  // namespace pyrasim::hw
