// SPDX-License-Identifier: Apache-2.0
#include "run/process_pool.h"

#include <poll.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "run/interrupt.h"

namespace pyrasim {
namespace {

constexpr int heartbeat = 100;  ///< ms after which a signal that came between two system calls is seen

}  // namespace

void ProcessPool::run(const JobList& list, int at_once) {
  ProcessPool pool(list, at_once);
  while (pool.taken_ < list.size) {
    stop_if_interrupted();
    if (pool.running_.size() < pool.at_once_ && pool.started_ < pool.end_) {
      pool.start_next();
    } else {
      pool.receive();
    }
    pool.take_known();
  }
}

void ProcessPool::start_next() {
  const std::size_t number = started_++;
  try {
    const Job job = list_.prepare(number);
    if (job) {
      running_.emplace_back(number, list_.what, job);
    } else {
      know(number, std::string());
    }
  } catch (const Stopped&) {
    throw;
  } catch (...) {
    know(number, std::current_exception());
  }
}

void ProcessPool::receive() {
  std::vector<pollfd> ends;
  for (const Member& member : running_) ends.push_back({member.process.descriptor(), POLLIN, 0});
  if (poll(ends.data(), ends.size(), heartbeat) <= 0) return;
  std::size_t k = 0;
  for (auto member = running_.begin(); member != running_.end(); ++k) {
    const bool ended = ends[k].revents != 0 && member->process.receive();
    if (ended) end(*member);
    member = ended ? running_.erase(member) : std::next(member);
  }
  show_progress();
}

/// A process that a signal has ended is no failure where the same signal ends this one.
void ProcessPool::end(Member& member) {
  try {
    know(member.number, member.process.result());
  } catch (...) {
    stop_if_interrupted();
    know(member.number, std::current_exception());
  }
}

void ProcessPool::know(std::size_t number, Result result) {
  if (std::holds_alternative<std::exception_ptr>(result)) {
    end_ = std::min(end_, number);
    running_.remove_if([number](const Member& member) { return member.number > number; });
  }
  known_.emplace(number, std::move(result));
}

void ProcessPool::take_known() {
  for (auto next = known_.find(taken_); next != known_.end(); next = known_.find(taken_)) {
    if (const auto* failure = std::get_if<std::exception_ptr>(&next->second)) std::rethrow_exception(*failure);
    list_.take(taken_, std::get<std::string>(next->second));
    known_.erase(next);
    ++taken_;
  }
}

void ProcessPool::show_progress() {
  if (!list_.progress || running_.empty() || running_.front().number != taken_) return;
  if (!bar_ || shown_ != taken_) bar_ = list_.progress(taken_);
  shown_ = taken_;
  bar_(running_.front().process.share());
}

}  // namespace pyrasim
