// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <barrier>
#include <thread>

#include "batch/pools.hpp"
#include "batch/run.hpp"

namespace vesica::bench {
namespace {

constexpr int threads = 2;
constexpr std::size_t n = batch_length<float>;

/// The measurement of one thread while the other works as well: a buffer of its own, fresh data each pass.
class Worker {
 public:
  Worker(const Spec& spec, std::uint64_t number)
      : spec_(spec),
        number_(number),
        pool_(spec.kind_a, spec.kind_b, spec.workload),
        batch_(spec.kind_a, spec.kind_b, n),
        out_(allocate<std::uint8_t>(n)) {}

  void work() {
    const auto draw = [this](std::uint64_t round) { batch_.draw(pool_, threads * round + number_, 1, n); };
    const Pass pass = [this] {
      const auto found = batch::many<float>(*spec_.isa->kernels, batch_.a.shapes(1), batch_.b.shapes(n), n, out_.get());
      hits_ += found.overlaps;
      ++rounds_;
      return found.overlaps;
    };
    result_ = summary(contest(draw, {pass}, {.seconds = 1, .rounds = 31})[0], n);
    result_.hits = static_cast<double>(hits_) / static_cast<double>(rounds_ * static_cast<std::int64_t>(n));
  }

  const Result& result() const { return result_; }

 private:
  const Spec& spec_;
  const std::uint64_t number_;
  const PoolColumns<float> pool_;
  Batch<float> batch_;
  Memory<std::uint8_t> out_;
  std::int64_t hits_ = 0, rounds_ = 0;
  Result result_;
};

}  // namespace

Result run_two_threads(const Spec& spec) {
  std::array<Worker, threads> workers{Worker(spec, 0), Worker(spec, 1)};
  std::barrier start(threads);
  {
    std::array<std::jthread, threads> running;
    for (std::size_t i = 0; i < running.size(); ++i) {
      running[i] = std::jthread([&start, &worker = workers[i]] {
        start.arrive_and_wait();
        worker.work();
      });
    }
  }
  Result total;
  for (const Worker& worker : workers) {
    total.tests_a_second += worker.result().tests_a_second;
    total.hits += worker.result().hits / threads;
  }
  total.nanoseconds = 1e9 / total.tests_a_second;
  return total;
}

}  // namespace vesica::bench
