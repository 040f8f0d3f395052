// SPDX-License-Identifier: Apache-2.0
// The differential stress test: attacks the library with pairs made at contact and holds every answer against its laws,
// the exact stage and slow references. See usage below.
#include <unistd.h>

#include <chrono>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>

#include "cast/motions.hpp"
#include "stress/batches.hpp"
#include "stress/deliberate.hpp"
#include "stress/groups.hpp"
#include "stress/laws.hpp"
#include "stress/libraries.hpp"
#include "stress/progress.hpp"
#include "stress/shrink.hpp"

namespace {

using namespace stress;
using Clock = std::chrono::steady_clock;

constexpr const char* usage =
    R"(usage: vesica_stress [N] [OPTION]...
  N                 stop after so many pairs (default 1000000; 0: no limit)
  --seed S          draw from this seed (default: the date, as 20240229)
  --seconds T       stop after so many seconds
  --query Q         ask only this query, of every pair; "all" asks each query of its share of the pairs
  --resume FILE     go on where FILE says, and keep it up to date
  --known FILE      laws of which faults are known: they are counted, but are no failure
  --needles, --ties draw pairs of needles alone, or of shapes that are equal but for rounding
  --environments    ask under flushed subnormals and directed roundings too, and expect the same bits
  --group G         only this group of the seed
  --stop-at LAW     stop once a fault of this law is found
  --functions       print the functions that batches are asked of, and stop
  --fault NAME      put a deliberate fault in, to see it found
  --replay CASE     judge one case, as in 'overlap_f64 circle 0 0 1 | point 1 0'
  --replay-all FILE judge the cases of a file, a line each; '#' begins a comment
Exit status: 0 without an unknown fault, 1 with one, 2 for a wrong call.
)";

struct Options {
  std::uint64_t pairs = 1000000;
  std::optional<std::uint64_t> seed, group;
  double seconds = 1e9;
  std::optional<Query> query;
  std::string resume, known, replay, replay_all, stop_at;
  bool environments = false, functions = false;
  Drawn drawn = Drawn::all;
};

std::uint64_t seed_of_today() {
  const std::time_t now = std::time(nullptr);
  std::tm day{};
  gmtime_r(&now, &day);
  return static_cast<std::uint64_t>((day.tm_year + 1900) * 10000 + (day.tm_mon + 1) * 100 + day.tm_mday);
}

/// How often a query is asked: of one pair in `every`, with slow references of one in `slow`.
struct Share {
  Query query;
  std::uint64_t every, slow;
};
constexpr Share shares[] = {{Query::overlap, 1, 64},
                            {Query::relation, 2, 64},
                            {Query::contains, 2, 64},
                            {Query::nearest, 8, 128},
                            {Query::boundary_distance, 8, 256},
                            {Query::depth, 8, 256},
                            {Query::area, 8, 512},
                            {Query::iou, 8, 1024},
                            {Query::crossings, 8, 128},
                            {Query::shape_area, 8, 32},
                            {Query::bounds, 8, 8},
                            {Query::ratio, 8, 64},
                            {Query::cast, 4, 256},
                            {Query::sweep_bounds, 8, 64},
                            {Query::within, 4, 64},
                            {Query::signed_distance, 8, 64},
                            {Query::de9im, 4, 64},
                            {Query::intersection, 4, 32},
                            {Query::invalid, 16, 16}};
constexpr std::uint64_t groups_a_batch = 8;
constexpr std::uint64_t most_printed = 3;

/// For the message of a crash.
volatile std::uint64_t current_seed, current_group;

void crashed(int signal) {
  std::array<char, 120> text{};
  const int size = std::snprintf(text.data(), text.size(), "signal %d: --seed %" PRIu64 " --group %" PRIu64 "\n",
                                 signal, current_seed, current_group);
  static_cast<void>(!write(STDOUT_FILENO, text.data(), static_cast<std::size_t>(size)));
  _exit(1);
}

class Attack {
 public:
  explicit Attack(const Options& options) : options_(options), end_(Clock::now() + to_duration(options.seconds)) {
    read_known();
    if (!options.resume.empty() && progress_.load(options.resume)) {
      if (options.seed && *options.seed != progress_.seed) throw std::runtime_error("the resumed run has another seed");
    } else {
      progress_.seed = options.seed.value_or(seed_of_today());
    }
    if (options.group) progress_.next_group = *options.group;
  }

  int run() {
    std::printf("seed %" PRIu64 ", from group %" PRIu64 "; batches on:", progress_.seed, progress_.next_group);
    for (const std::string& isa : instruction_sets()) std::printf(" %s", isa.c_str());
    std::printf("\n");
    std::fflush(stdout);
    current_seed = progress_.seed;
    const std::uint64_t last = options_.pairs == 0 ? UINT64_MAX : progress_.pairs + options_.pairs;
    Clock::time_point saved = Clock::now();
    while (progress_.pairs < last && Clock::now() < end_) {
      current_group = progress_.next_group;
      run_group(draw_group(progress_.seed, progress_.next_group++, options_.drawn));
      if (options_.group || progress_.faults.contains(options_.stop_at)) break;
      if (!options_.resume.empty() && Clock::now() - saved > std::chrono::seconds(10)) {
        progress_.save(options_.resume);
        saved = Clock::now();
      }
    }
    if (!options_.resume.empty()) progress_.save(options_.resume);
    progress_.report(known_);
    return unknown_ ? 1 : 0;
  }

 private:
  static Clock::duration to_duration(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, 1e9)));
  }

  void read_known() {
    if (options_.known.empty()) return;
    std::ifstream in(options_.known);
    if (!in) throw std::runtime_error("cannot read " + options_.known);
    std::string line;
    while (std::getline(in, line)) {
      const std::string law = line.substr(0, line.find(' '));
      if (!law.empty() && law[0] != '#') known_[law] = true;
    }
  }

  void run_group(const Group& group) {
    for (index_ = 0; index_ < group.pairs.size(); ++index_) {
      const Pair& pair = group.pairs[index_];
      for (const Share& share : shares) {
        if (options_.query && *options_.query != share.query) continue;
        const bool slow = turn(options_.query ? (share.slow + 15) / 16 : share.slow);
        const bool asked = options_.query || turn(share.every);
        if (asked) run_case({share.query, group.scalar, pair}, slow);
      }
      ++progress_.pairs;
    }
    const bool batch = options_.query ? *options_.query == Query::batch : progress_.next_group % groups_a_batch == 0;
    if (batch) run_batch(group);
  }

  /// Another for each pair of a group.
  Motion motion_of(const Case& c) const {
    properties::Random random(progress_.seed + (progress_.next_group << 8) + index_);
    return cast_test::draw_motion(c.pair, c.scalar, random);
  }

  /// True for one pair in `every`, whichever group the run began with.
  bool turn(std::uint64_t every) const { return (index_ * 7 + progress_.next_group * 13) % every == 0; }

  void run_case(Case c, bool slow) {
    if (of_motion(c.query)) c.motion = motion_of(c);
    if (c.query == Query::within) {
      properties::Random random(progress_.seed + (progress_.next_group << 8) + index_);
      c.distance = draw_distance(c.scalar, c.pair, random);
    }
    if (c.query == Query::invalid) c.pair = broken(c.pair, progress_.next_group * 16 + index_);
    ++progress_.asked[c.query];
    progress_.slow[c.query] += slow;
    const Choice choice{slow ? Effort::slow : Effort::quick, options_.environments};
    for (const Fault& fault : judge(c, choice)) found(c, fault, choice);
  }

  void found(const Case& c, const Fault& fault, const Choice& choice) {
    const std::uint64_t count = ++progress_.faults[fault.law];
    const bool known = known_.contains(fault.law);
    unknown_ = unknown_ || !known;
    if (count > most_printed || (!options_.stop_at.empty() && fault.law != options_.stop_at)) return;
    Fault last = fault;
    const Case least = shrunk(c, [&](const Case& smaller) {
      for (const Fault& other : judge(smaller, choice)) {
        if (other.law != fault.law) continue;
        last = other;
        return true;
      }
      return false;
    });
    std::printf("%s %s: expected %s, got %s\n  --replay '%s'\n  as drawn: %s (seed %" PRIu64 ", group %" PRIu64 ")\n",
                known ? "known" : "FAULT", fault.law.c_str(), last.expected.c_str(), last.got.c_str(),
                notation(least).c_str(), notation(c).c_str(), progress_.seed, progress_.next_group - 1);
    std::fflush(stdout);
  }

  void run_batch(const Group& group) {
    progress_.asked[Query::batch] += group.pairs.size();
    std::vector<Pair> pairs = group.pairs;
    if (progress_.next_group % 3 == 0) pairs[pairs.size() / 2] = broken(pairs[pairs.size() / 2], progress_.next_group);
    const auto layout = static_cast<unsigned>(progress_.next_group * 2654435761u >> 8 & 0xFFFF);
    report_batch(group.scalar, pairs, judge_batches(group.scalar, pairs, layout));
    for (const Environment& environment : environments()) {
      if (!options_.environments) break;
      report_batch(group.scalar, pairs, judge_batches(group.scalar, pairs, layout, environment));
    }
  }

  void report_batch(Scalar scalar, const std::vector<Pair>& pairs, const std::vector<BatchFault>& faults) {
    for (const BatchFault& fault : faults) {
      const std::size_t element = std::min(fault.element, pairs.size() - 1);
      found({Query::batch, scalar, pairs[element]}, fault.fault, {Effort::quick, options_.environments});
    }
  }

  Options options_;
  Clock::time_point end_;
  Progress progress_;
  std::uint64_t index_ = 0;  ///< of the pair in its group
  std::map<std::string, bool> known_;
  bool unknown_ = false;
};

Case case_of(const std::string& text) {
  const auto c = parse(text);
  if (!c) throw std::runtime_error("not a case: " + text);
  return *c;
}

/// Returns whether there is one.
bool print_faults(const Case& c, const Options& options) {
  const auto faults = judge(c, {Effort::slow, options.environments});
  for (const Fault& fault : faults) {
    std::printf("FAULT %s: expected %s, got %s\n", fault.law.c_str(), fault.expected.c_str(), fault.got.c_str());
  }
  return !faults.empty();
}

int replay(const Options& options) {
  const Case c = case_of(options.replay);
  if (c.query < Query::invalid) std::printf("%s = %s\n", notation(c).c_str(), text(ask(c)).c_str());
  const bool wrong = print_faults(c, options);
  if (!wrong) std::printf("no fault\n");
  return wrong ? 1 : 0;
}

int replay_all(const Options& options) {
  const std::vector<Case> cases = read_cases(options.replay_all);
  int wrong = 0;
  for (const Case& c : cases) {
    if (!print_faults(c, options)) continue;
    ++wrong;
    std::printf("  --replay '%s'\n", notation(c).c_str());
  }
  std::printf("%zu cases, %d wrong\n", cases.size(), wrong);
  return wrong == 0 && !cases.empty() ? 0 : 1;
}

/// Prints the functions that batches ask.
int print_functions() {
  for (std::uint64_t group = 0; group < 64; ++group) {
    const Group drawn = draw_group(1, group);
    judge_batches(drawn.scalar, drawn.pairs, static_cast<unsigned>(group));
  }
  for (const std::string& function : functions_asked()) std::printf("%s\n", function.c_str());
  return 0;
}

/// Nothing where an argument is wrong.
std::optional<Options> read(int count, char** arguments) {
  Options o;
  for (int i = 1; i < count; ++i) {
    const std::string option = arguments[i];
    if (option == "--environments") {
      o.environments = true;
      continue;
    }
    if (option == "--needles" || option == "--ties") {
      o.drawn = option == "--ties" ? Drawn::ties : Drawn::needles;
      continue;
    }
    if (option == "--functions") {
      o.functions = true;
      continue;
    }
    if (option.rfind("--", 0) != 0) {
      char* end = nullptr;
      o.pairs = static_cast<std::uint64_t>(std::strtod(option.c_str(), &end));
      if (end == option.c_str() || *end != '\0') return std::nullopt;
      continue;
    }
    if (++i == count) return std::nullopt;
    const std::string value = arguments[i];
    if (option == "--seed") {
      o.seed = std::strtoull(value.c_str(), nullptr, 0);
    } else if (option == "--group") {
      o.group = std::strtoull(value.c_str(), nullptr, 0);
    } else if (option == "--seconds") {
      o.seconds = std::strtod(value.c_str(), nullptr);
    } else if (option == "--query" && value != "all") {
      o.query = find_query(value);
      if (!o.query) return std::nullopt;
    } else if (option == "--resume") {
      o.resume = value;
    } else if (option == "--known") {
      o.known = value;
    } else if (option == "--stop-at") {
      o.stop_at = value;
    } else if (option == "--replay") {
      o.replay = value;
    } else if (option == "--replay-all") {
      o.replay_all = value;
    } else if (option == "--fault") {
      if (!use_deliberate_fault(value)) return std::nullopt;
    } else if (option != "--query") {
      return std::nullopt;
    }
  }
  return o;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "--help") == 0) return std::printf("%s", usage) < 0;
  const auto options = read(count, arguments);
  if (!options) {
    std::fprintf(stderr, "%sfaults: %s\n", usage, deliberate_fault_names().c_str());
    return 2;
  }
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, crashed);
  try {
    if (options->functions) return print_functions();
    if (!options->replay_all.empty()) return replay_all(*options);
    return options->replay.empty() ? Attack(*options).run() : replay(*options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "vesica_stress: %s\n", error.what());
    return 2;
  }
}
