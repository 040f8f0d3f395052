// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** How the parts of two shapes meet: nine-intersection matrices, and the region that they share. */
public final class Topology {
  private static final int CHARACTERS = 9;

  private Topology() {}

  /** The nine-intersection matrix, as geographic systems have it, such as "FF2F11212". Exact. */
  public static String de9im(Shape a, Shape b) {
    byte[] out = new byte[CHARACTERS + 1];
    checked(Native.de9imF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return new String(out, 0, CHARACTERS, StandardCharsets.US_ASCII);
  }

  /** Does such a matrix fit a pattern of F, 0, 1, 2, T (any of 0, 1 and 2) and * (anything)? */
  public static boolean matches(String matrix, String pattern) {
    return checked(Native.de9imMatch(text(matrix), text(pattern))) == 1;
  }

  /** Characters and a final 0; those of other lengths, which are no matrices, are passed on as such. */
  private static byte[] text(String characters) {
    byte[] bytes = characters.indexOf(0) < 0 ? characters.getBytes(StandardCharsets.US_ASCII) : new byte[0];
    byte[] out = new byte[bytes.length + 1];
    System.arraycopy(bytes, 0, out, 0, bytes.length);
    return out;
  }

  /**
   * The vertices of the region that two shapes share, counter-clockwise; none if they do not overlap. It is of points,
   * segments, boxes, rectangles and convex polygons, or of a point or a segment and any shape. Of a segment and a
   * polygon or a polyline it has two vertices for each piece, in order along the segment.
   */
  public static List<Point> intersection(Shape a, Shape b) {
    int kindA = a.kind().value, kindB = b.kind().value;
    return Crossings.points(
        (out, room) -> checked(Native.intersectionF64(kindA, Path.lent(a), kindB, Path.lent(b), out, room)));
  }
}
