// SPDX-License-Identifier: Apache-2.0
// mutant_hunt SECONDS SEED FILE MUTANT...: for mutants that no test finds, searches for cases that they answer otherwise.
//
// It begins with the cases of a file (a line a case, hammer/query.hpp) and changes those to which a mutant makes a
// difference inside: the fewer of them, the more often. What it finds is printed, a line a mutant: its number, and the
// case. To be built of a tree of ./run mutate alone.
#include <algorithm>
#include <chrono>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <sys/time.h>
#include <vector>
#include <vesica_mutant.hpp>

#include "answers/answers.hpp"
#include "answers/table.hpp"
#include "cast/motions.hpp"
#include "hammer/call.hpp"
#include "hammer/change.hpp"
#include "hammer/groups.hpp"

namespace {

using hammer::Case;
using hammer::Query;
using properties::Random;

const std::string all = "all_";  ///< in place of a query's name: every function of one pair is asked

std::string text(Case c) {
  if (c.query != Query::batch) return notation(c);
  c.query = Query::cast;
  return all + notation(c).substr(std::strlen("cast_"));
}

sigjmp_buf before_call;

void leave(int signal) { siglongjmp(before_call, signal); }

/// What one query answers to a case; for Query::batch, what every function of one pair does.
std::uint64_t answer(const Case& c) {
  answers::Hash hash;
  if (c.query == Query::batch) {
    const answers::Take take = [&](const std::string&, const answers::Bytes& bytes) { hash.add(bytes); };
    answers::ask(answers::Functions::own, {c.pair, c.motion}, take);
    answers::ask(answers::Functions::by_the_c_library, {c.pair, c.motion}, take);
  } else {
    hash.add(answers::bytes_of(hammer::ask(c)));
  }
  return hash.value();
}

/// Whether a mutant answers a case as the original does, and in a second, and without a crash.
bool answers_alike(const Case& c, int mutant, std::uint64_t original) {
  bool alike = false;
  if (sigsetjmp(before_call, 1) == 0) {
    const itimerval second{{0, 0}, {1, 0}}, none{};
    setitimer(ITIMER_VIRTUAL, &second, nullptr);
    vesica_mutant::active = mutant;
    alike = answer(c) == original;
    setitimer(ITIMER_VIRTUAL, &none, nullptr);
  }
  vesica_mutant::active = 0;
  return alike;
}

struct Hunted {
  int mutant;
  std::uint64_t reached = 0;
  std::vector<Case> cases;  ///< some of those to which it makes a difference inside
};

class Hunt {
 public:
  Hunt(const std::vector<int>& mutants, std::uint64_t seed) : random_(seed), seed_(seed) {
    for (const int mutant : mutants) left_.push_back({mutant, 0, {}});
    marks_.resize(static_cast<std::size_t>(*std::max_element(mutants.begin(), mutants.end())) + 100000);
    vesica_mutant::reached = marks_.data();
  }

  bool done() const { return left_.empty(); }

  void ask(const Case& c) {
    ++asked_;
    vesica_mutant::active = -1;
    answer(c);
    vesica_mutant::active = 0;
    bool is_known = false;
    std::uint64_t original = 0;
    for (std::size_t i = 0; i < left_.size();) {
      Hunted& hunted = left_[i++];
      unsigned char& mark = marks_[static_cast<std::size_t>(hunted.mutant)];
      if (mark == 0) continue;
      mark = 0;
      if (!is_known) original = answer(c);
      is_known = true;
      if (!answers_alike(c, hunted.mutant, original)) {
        std::printf("%d %s\n", hunted.mutant, text(c).c_str());
        std::fflush(stdout);
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(--i));
        continue;
      }
      keep(hunted, c);
    }
  }

  void step() {
    if (random_.chance(0.2)) return ask_drawn();
    std::vector<Hunted*> reached;
    for (Hunted& hunted : left_) {
      if (!hunted.cases.empty()) reached.push_back(&hunted);
    }
    if (reached.empty()) return ask_drawn();
    const auto any = [&](std::size_t count) {
      return static_cast<std::size_t>(random_.below(static_cast<int>(count)));
    };
    const Hunted& one = *reached[any(reached.size())];
    const Hunted& other = *reached[any(reached.size())];
    const Hunted& rarer = one.reached < other.reached ? one : other;
    ask(hammer::changed(rarer.cases[any(rarer.cases.size())], random_));
  }

  void report() const {
    std::fprintf(stderr, "%llu cases asked; left:", static_cast<unsigned long long>(asked_));
    for (const Hunted& hunted : left_) {
      std::fprintf(stderr, " %d(%llu)", hunted.mutant, static_cast<unsigned long long>(hunted.reached));
    }
    std::fprintf(stderr, "\n");
  }

 private:
  static constexpr std::size_t most_cases = 40;

  void keep(Hunted& hunted, const Case& c) {
    ++hunted.reached;
    if (hunted.cases.size() < most_cases) {
      hunted.cases.push_back(c);
    } else if (random_.chance(0.1)) {
      hunted.cases[static_cast<std::size_t>(random_.below(most_cases))] = c;
    }
  }

  void ask_drawn() {
    const hammer::Group group = hammer::draw_group(seed_, groups_++);
    for (const auto& pair : group.pairs) {
      Case c{Query::overlap, group.scalar, pair};
      do {
        c.query = hammer::all_queries[static_cast<std::size_t>(random_.below(hammer::all_queries.size()))];
      } while (c.query == Query::invalid ||
               (c.query == Query::intersection && !hammer::has_intersection(pair.kind_a, pair.kind_b)));
      if (of_motion(c.query) || c.query == Query::batch) c.motion = cast_test::draw_motion(pair, group.scalar, random_);
      if (c.query == Query::within) c.distance = hammer::draw_distance(group.scalar, pair, random_);
      ask(c);
    }
  }

  Random random_;
  std::uint64_t seed_, groups_ = 0, asked_ = 0;
  std::vector<Hunted> left_;
  std::vector<unsigned char> marks_;
};

std::vector<Case> read(const char* file) {
  std::ifstream in(file);
  std::vector<Case> cases;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const bool of_all = line.rfind(all, 0) == 0;
    const auto c = hammer::parse(of_all ? "cast_" + line.substr(all.size()) : line);
    if (!c) throw std::runtime_error("not a case: " + line);
    cases.push_back(*c);
    if (of_all) cases.back().query = Query::batch;
  }
  return cases;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  std::vector<int> mutants;
  for (int i = 4; i < argc; ++i) mutants.push_back(std::atoi(argv[i]));
  Hunt hunt(mutants, std::strtoull(argv[2], nullptr, 0));
  const std::vector<Case> known = read(argv[3]);
  for (const int signal : {SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGABRT, SIGVTALRM}) std::signal(signal, leave);
  for (const Case& c : known) hunt.ask(c);
  hunt.report();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(argv[1]));
  while (!hunt.done() && std::chrono::steady_clock::now() < end) hunt.step();
  hunt.report();
  return 0;
}
