// SPDX-License-Identifier: Apache-2.0
/// How the parts of two shapes meet: their insides, outlines and outsides. The relation and the matrix follow from it.
#pragma once

#include <vesica/de9im/matrix.hpp>
#include <vesica/relation_code.hpp>

namespace vesica::detail::polygon {

enum Part { inside_part, outline_part, outside_part };

/// The question. It says which facts are enough.
enum class Asked { insides, relation, matrix };

/// The dimension of what each part of a shares with each part of b, as far as it is known: -1 for nothing.
class Parts {
 public:
  void note(Part a, Part b, int dimension) noexcept {
    signed char& known = of_[a][b];
    if (dimension > known) known = static_cast<signed char>(dimension);
  }
  bool meet(Part a, Part b) const noexcept { return of_[a][b] >= 0; }
  int dimension(Part a, Part b) const noexcept { return of_[a][b]; }

  bool insides_meet() const noexcept { return meet(inside_part, inside_part); }
  bool a_leaves_b() const noexcept { return meet(inside_part, outside_part) || meet(outline_part, outside_part); }
  bool b_leaves_a() const noexcept { return meet(outside_part, inside_part) || meet(outside_part, outline_part); }

  /// True if nothing more that is learned changes the answer. A matrix is never settled early.
  bool settled(Asked asked) const noexcept {
    if (asked == Asked::matrix || !insides_meet()) return false;
    return asked == Asked::insides || (a_leaves_b() && b_leaves_a());
  }

  /// As relation.hpp defines it.
  Relation relation() const noexcept {
    const bool a_in_b = !a_leaves_b(), b_in_a = !b_leaves_a(), outlines = meet(outline_part, outline_part);
    if (a_in_b && b_in_a) return Relation::equal;
    if (a_in_b) {
      return outlines || meet(inside_part, outline_part) ? Relation::inside_touch : Relation::inside;
    }
    if (b_in_a) {
      return outlines || meet(outline_part, inside_part) ? Relation::contains_touch : Relation::contains;
    }
    if (insides_meet()) return Relation::cross;
    return outlines || meet(inside_part, outline_part) || meet(outline_part, inside_part) ? Relation::touch
                                                                                          : Relation::disjoint;
  }

  NineIntersections matrix() const noexcept {
    NineIntersections m{};
    for (int k = 0; k < 9; ++k) m.at[k] = of_[k / 3][k % 3] < 0 ? 'F' : static_cast<char>('0' + of_[k / 3][k % 3]);
    m.at[8] = '2';
    return m;
  }

  Parts exchanged() const noexcept {
    Parts parts;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) parts.of_[i][j] = of_[j][i];
    }
    return parts;
  }

 private:
  signed char of_[3][3] = {{-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}};
};

}  // namespace vesica::detail::polygon
