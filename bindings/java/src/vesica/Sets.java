// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.util.Objects;

/** Arrays of shapes of one scalar type, as an index has them. */
final class Sets {
  private static final int MOST = 64;

  final boolean wide;
  final long count;
  final int[] kinds;
  final long[] counts;
  final long[] strides;
  final long[] steps;
  final Object[] bases;

  Sets(Shapes... sets) {
    Objects.requireNonNull(sets, "the arrays of shapes are null");
    if (sets.length == 0 || sets.length > MOST) {
      throw new IllegalArgumentException(
          sets.length + " arrays of shapes: 1 to " + MOST + " are needed; one may be empty");
    }
    for (int i = 0; i < sets.length; i++) Objects.requireNonNull(sets[i], "array of shapes " + i + " is null");
    wide = sets[0].wide;
    kinds = new int[sets.length];
    counts = new long[sets.length];
    strides = new long[sets.length];
    steps = new long[sets.length];
    bases = new Object[sets.length];
    long items = 0;
    for (int i = 0; i < sets.length; i++) {
      Vesica.alike(wide, sets[i].wide);
      kinds[i] = sets[i].kind;
      counts[i] = sets[i].count;
      strides[i] = sets[i].stride;
      steps[i] = sets[i].step;
      bases[i] = sets[i].base;
      items += sets[i].count;
    }
    count = items;
  }
}
