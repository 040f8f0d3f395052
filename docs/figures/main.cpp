// SPDX-License-Identifier: Apache-2.0
/// vesica_figures FOLDER: writes the figures of docs/ into an existing folder.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "figures.hpp"

namespace figures {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "vesica_figures: a caption is not true: %s\n", what);
  std::exit(1);
}

}  // namespace figures

namespace {

bool write(const std::string& path, const std::string& text) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return std::fclose(file) == 0 && written;
}

struct Figure {
  const char* name;
  std::string (*draw)();
};

constexpr Figure all[] = {
    {"gradient_descent_convergence", figures::gradient_descent_convergence},
    {"nineteen_ellipses", figures::nineteen_ellipses},
    {"polygonal_sandwich", figures::polygonal_sandwich},
    {"minkowski_sum", figures::minkowski_sum},
    {"closest_features", figures::closest_features},
    {"separating_lines", figures::separating_lines},
    {"first_contact", figures::first_contact},
    {"coverage", figures::coverage},
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: vesica_figures FOLDER\n");
    return 2;
  }
  for (const Figure& figure : all) {
    const std::string path = std::string(argv[1]) + "/" + figure.name + ".svg";
    if (!write(path, figure.draw())) {
      std::fprintf(stderr, "vesica_figures: cannot write %s\n", path.c_str());
      return 1;
    }
    std::printf("%s\n", path.c_str());
  }
  return 0;
}
