// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;

/**
 * Where two outlines meet.
 *
 * @param places in order along the first shape's outline
 * @param shared whether they have a stretch in common
 */
public record Crossings(List<Point> places, boolean shared) {
  private static final int PLACES = 8;

  /** Bytes of the library's struct. */
  static final int SIZE = 8 + 2 * PLACES * Double.BYTES;

  static Crossings of(byte[] struct) {
    ByteBuffer buffer = ByteBuffer.wrap(struct).order(ByteOrder.nativeOrder());
    List<Point> places = new ArrayList<>();
    for (int i = 0; i < buffer.getInt(0); i++) {
      places.add(new Point(buffer.getDouble(8 + 8 * i), buffer.getDouble(8 + 8 * (PLACES + i))));
    }
    return new Crossings(List.copyOf(places), buffer.getInt(4) != 0);
  }
}
