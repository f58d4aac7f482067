// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/perfetto_trace.h"

#include <fmt/format.h>

#include <utility>

#include "version.h"

namespace pyrasim::hw {
namespace {

// Numbers of fields, by message; from Perfetto's protos/perfetto/trace.
namespace trace {
constexpr unsigned packet = 1;
}
namespace packet {
constexpr unsigned timestamp = 8, sequence = 10, track_event = 11, interned_data = 12, sequence_flags = 13,
                   track_descriptor = 60;
}
namespace descriptor {
constexpr unsigned uuid = 1, name = 2, process = 3, parent = 5, counter = 8, child_ordering = 11, sibling_rank = 12;
}
namespace process {
constexpr unsigned pid = 1, name = 6;
}
namespace counter {
constexpr unsigned unit = 3;
}
namespace event {
constexpr unsigned annotation = 4, type = 9, name_number = 10, track = 11, name = 23, counter_value = 30, flow = 47;
}
namespace annotation {
constexpr unsigned name_number = 1, number = 3;
}
namespace interned {
constexpr unsigned event_names = 2, annotation_names = 3, number = 1, text = 2;
}

constexpr std::uint64_t slice_begin = 1, slice_end = 2, counter_event = 4;
constexpr std::uint64_t state_cleared = 1, needs_state = 2;  // flags of a sequence
constexpr std::uint64_t explicit_order = 3;                  // of child tracks
constexpr std::uint64_t count = 2;                           // unit of a counter
constexpr std::uint64_t only_sequence = 1;
constexpr std::uint64_t machine_track = 1;
constexpr std::uint64_t ray_annotation = 1, parent_annotation = 2;

std::uint64_t track_of_unit(std::size_t unit) { return machine_track + 1 + unit; }

}  // namespace

PerfettoTrace::PerfettoTrace(const Processor& processor, OutputFile& output) : processor_(processor), output_(output) {
  Protobuf names;
  const auto intern = [&names](unsigned kind, std::uint64_t number, std::string_view name) {
    Protobuf entry;
    entry.number(interned::number, number);
    entry.text(interned::text, name);
    names.message(kind, entry);
  };
  for (std::size_t k = 0; k < state_names.size(); ++k) intern(interned::event_names, k + 1, state_names[k]);
  intern(interned::annotation_names, ray_annotation, "ray");
  intern(interned::annotation_names, parent_annotation, "request");
  packet_.number(packet::sequence, only_sequence);
  packet_.number(packet::sequence_flags, state_cleared);
  packet_.message(packet::interned_data, names);
  write_packet();

  Protobuf machine, its;
  its.number(process::pid, 1);
  its.text(process::name, fmt::format("{}, {} MHz: 1 ns here is 1 cycle; pyrasim {}", processor.basename(),
                                      processor.spec().clock_mhz, version()));
  machine.number(descriptor::uuid, machine_track);
  machine.message(descriptor::process, its);
  machine.number(descriptor::child_ordering, explicit_order);
  write_descriptor(machine);
  for (std::size_t k = 0; k < processor.stages().size(); ++k) {
    write_track(track_of_unit(k), processor.stages()[k]->basename(), false);
  }
  for (std::size_t k = 0; k < processor.fifos().size(); ++k) {
    write_track(track_of_fifo(k), processor.fifos()[k]->basename(), true);
  }
}

std::uint64_t PerfettoTrace::track_of_fifo(std::size_t fifo) const {
  return track_of_unit(processor_.stages().size() + fifo);
}

/// Tracks are shown in the order of their numbers.
void PerfettoTrace::write_track(std::uint64_t track, std::string_view name, bool counts) {
  Protobuf of;
  of.number(descriptor::uuid, track);
  of.number(descriptor::parent, machine_track);
  of.text(descriptor::name, name);
  of.number(descriptor::sibling_rank, track);
  if (counts) {
    Protobuf unit;
    unit.number(counter::unit, count);
    of.message(descriptor::counter, unit);
  }
  write_descriptor(of);
}

void PerfettoTrace::write_descriptor(const Protobuf& track) {
  packet_.number(packet::sequence, only_sequence);
  packet_.message(packet::track_descriptor, track);
  write_packet();
}

void PerfettoTrace::begin_event(std::uint64_t type, std::uint64_t track) {
  event_.clear();
  event_.number(event::type, type);
  event_.number(event::track, track);
}

void PerfettoTrace::write_event(Cycle at) {
  packet_.number(packet::timestamp, at);
  packet_.number(packet::sequence, only_sequence);
  packet_.number(packet::sequence_flags, needs_state);
  packet_.message(packet::track_event, event_);
  write_packet();
}

void PerfettoTrace::write_packet() {
  framed_.clear();
  framed_.message(trace::packet, packet_);
  output_.write(framed_.bytes());
  packet_.clear();
}

void PerfettoTrace::span(const Span& span) {
  begin_event(slice_begin, track_of_unit(span.unit));
  event_.number(event::name_number, static_cast<std::uint64_t>(span.state) + 1);
  if (span.subject.ray != no_number) {
    Protobuf annotation;
    const auto annotate = [&](std::uint64_t name, std::uint64_t value) {
      annotation.clear();
      annotation.number(annotation::name_number, name);
      annotation.number(annotation::number, value);
      event_.message(event::annotation, annotation);
    };
    annotate(ray_annotation, span.subject.ray);
    if (span.subject.request != no_number) annotate(parent_annotation, span.subject.request);
    event_.fixed(event::flow, span.subject.ray + 1);
  }
  write_event(span.begin);
  begin_event(slice_end, track_of_unit(span.unit));
  write_event(span.end);
}

void PerfettoTrace::stretch(const PathStretch& stretch) {
  const std::uint64_t track = track_of_fifo(processor_.fifos().size());
  if (!std::exchange(path_is_named_, true)) write_track(track, "critical path", false);
  begin_event(slice_begin, track);
  event_.text(event::name, text_of(processor_, stretch));
  write_event(stretch.begin);
  begin_event(slice_end, track);
  write_event(stretch.end);
}

void PerfettoTrace::fill(std::size_t fifo, Cycle at, std::size_t tokens) {
  begin_event(counter_event, track_of_fifo(fifo));
  event_.number(event::counter_value, tokens);
  write_event(at);
}

}  // namespace pyrasim::hw
