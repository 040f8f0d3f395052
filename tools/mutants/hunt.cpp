// SPDX-License-Identifier: Apache-2.0
// mutant_hunt one|all SECONDS SEED FILE MUTANT...: for mutants that no test finds, searches for cases that they answer
// otherwise. Built of a tree of ./run mutate alone.
//
// It begins with the cases of a file (stress/query.hpp) and changes those to which a mutant makes a difference inside:
// the fewer there are of a mutant, the more often. One query is asked of each case; or of its pair, all functions of
// one pair and the named methods. Each mutant found prints a line: its number and the case; "all" writes the case as a
// cast.
#include <sys/time.h>

#include <chrono>
#include <csetjmp>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>
#include <vesica_mutant.hpp>

#include "answers/answers.hpp"
#include "answers/table.hpp"
#include "cast/motions.hpp"
#include "stress/change.hpp"
#include "stress/groups.hpp"

namespace {

using properties::Random;
using stress::Case;
using stress::Query;

std::uint64_t answer(const Case& c, bool asks_all) {
  answers::Hash hash;
  if (asks_all) {
    const answers::Take take = [&](const std::string&, const answers::Bytes& bytes) { hash.add(bytes); };
    answers::ask(answers::Functions::own, {c.pair, c.motion}, take);
    answers::ask(answers::Functions::by_the_c_library, {c.pair, c.motion}, take);
  } else {
    hash.add(answers::bytes_of(stress::ask(c)));
  }
  return hash.value();
}

sigjmp_buf before_call;

void leave(int signal) { siglongjmp(before_call, signal); }

/// True if a mutant gives this answer to a case, in a second and without a crash.
bool gives(std::uint64_t original, int mutant, const Case& c, bool asks_all) {
  if (sigsetjmp(before_call, 1) == 0) {
    const itimerval second{{0, 0}, {1, 0}}, none{};
    setitimer(ITIMER_VIRTUAL, &second, nullptr);
    vesica_mutant::active = mutant;
    const bool alike = answer(c, asks_all) == original;
    vesica_mutant::active = 0;
    setitimer(ITIMER_VIRTUAL, &none, nullptr);
    return alike;
  }
  vesica_mutant::active = 0;
  return false;
}

struct Hunted {
  int mutant;
  std::uint64_t reached = 0;
  std::vector<Case> cases;  ///< some of those to which it makes a difference inside
};

class Hunt {
 public:
  Hunt(bool asks_all, std::uint64_t seed, const std::vector<int>& mutants)
      : asks_all_(asks_all), seed_(seed), random_(seed) {
    for (const int mutant : mutants) left_.push_back({mutant, 0, {}});
    vesica_mutant::reached = marks_.data();
  }

  bool is_done() const { return left_.empty(); }

  void ask(const Case& c) {
    ++asked_;
    vesica_mutant::active = -1;
    answer(c, asks_all_);
    vesica_mutant::active = 0;
    std::optional<std::uint64_t> original;
    std::erase_if(left_, [&](Hunted& hunted) {
      unsigned char& mark = marks_[static_cast<std::size_t>(hunted.mutant)];
      if (mark == 0) return false;
      mark = 0;
      if (!original) original = answer(c, asks_all_);
      if (!gives(*original, hunted.mutant, c, asks_all_)) {
        std::printf("%d %s\n", hunted.mutant, notation(c).c_str());
        std::fflush(stdout);
        return true;
      }
      keep(hunted, c);
      return false;
    });
  }

  void step() {
    std::vector<const Hunted*> reached;
    for (const Hunted& hunted : left_) {
      if (!hunted.cases.empty()) reached.push_back(&hunted);
    }
    if (reached.empty() || random_.chance(0.2)) return ask_drawn();
    const Hunted& one = *reached[any_of(reached.size())];
    const Hunted& other = *reached[any_of(reached.size())];
    const Hunted& rarer = one.reached < other.reached ? one : other;
    ask(stress::changed(rarer.cases[any_of(rarer.cases.size())], random_));
  }

  void report() const {
    std::fprintf(stderr, "%llu cases asked; left, and how often reached:", static_cast<unsigned long long>(asked_));
    for (const Hunted& hunted : left_) {
      std::fprintf(stderr, " %d (%llu)", hunted.mutant, static_cast<unsigned long long>(hunted.reached));
    }
    std::fprintf(stderr, "\n");
  }

 private:
  static constexpr std::size_t most_cases = 40, most_mutants = 100000;

  std::size_t any_of(std::size_t count) { return static_cast<std::size_t>(random_.below(static_cast<int>(count))); }

  void keep(Hunted& hunted, const Case& c) {
    ++hunted.reached;
    if (hunted.cases.size() < most_cases) {
      hunted.cases.push_back(c);
    } else if (random_.chance(0.1)) {
      hunted.cases[any_of(most_cases)] = c;
    }
  }

  void ask_drawn() {
    const stress::Group group = stress::draw_group(seed_, groups_++);
    for (const auto& pair : group.pairs) {
      Case c{Query::cast, group.scalar, pair};
      if (!asks_all_) {
        do {
          c.query = stress::all_queries[any_of(stress::all_queries.size())];
        } while (c.query == Query::invalid || c.query == Query::batch ||
                 stress::is_refused(c.query, pair.kind_a, pair.kind_b));
      }
      if (of_motion(c.query)) c.motion = cast_test::draw_motion(pair, group.scalar, random_);
      if (c.query == Query::within) c.distance = stress::draw_distance(group.scalar, pair, random_);
      ask(c);
    }
  }

  bool asks_all_;
  std::uint64_t seed_, groups_ = 0, asked_ = 0;
  Random random_;
  std::vector<Hunted> left_;
  std::vector<unsigned char> marks_ = std::vector<unsigned char>(most_mutants);
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) return 2;
  std::vector<int> mutants;
  for (int i = 5; i < argc; ++i) mutants.push_back(std::atoi(argv[i]));
  const std::vector<Case> known = stress::read_cases(argv[4]);
  for (const int signal : {SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGABRT, SIGVTALRM}) std::signal(signal, leave);
  Hunt hunt(std::strcmp(argv[1], "all") == 0, std::strtoull(argv[3], nullptr, 0), mutants);
  for (const Case& c : known) hunt.ask(c);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(argv[2]));
  while (!hunt.is_done() && std::chrono::steady_clock::now() < end) hunt.step();
  hunt.report();
  return 0;
}
