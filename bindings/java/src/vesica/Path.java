// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;

/**
 * What polygons and polylines have in common: vertices and the offsets of rings, in memory that the collector does not
 * move. Structs of C are at its beginning, and lead to the rest of it.
 */
abstract class Path {
  /** The bytes of C's struct: x, y, stride, rings, count. */
  static final int STRUCT = 40;

  private final double[] vertices;
  private final int[] rings;
  private final ByteBuffer struct;

  Path(double[] vertices, int[] rings) {
    this.vertices = vertices.clone();
    this.rings = rings.length > 0 ? rings.clone() : new int[] {0, count(vertices)};
    if (vertices.length == 0) throw new IllegalArgumentException("no vertex, where one is needed");
    checked("ring", this.rings, count(vertices));
    struct = structs(this.vertices, this.rings, new int[] {0, this.rings.length - 1});
  }

  static boolean is(Kind kind) {
    return kind == Kind.POLYGON || kind == Kind.POLYLINE;
  }

  /** What a native method takes of one shape. */
  static Object lent(Shape shape) {
    return shape instanceof Path path ? path.struct : shape.numbers();
  }

  /** A copy of the vertices x y x y ... */
  public double[] numbers() {
    return vertices.clone();
  }

  /** Where each ring or chain begins among the vertices, with the end. */
  public int[] rings() {
    return rings.clone();
  }

  /** How many vertices there are. */
  static int count(Object vertices) {
    int length = Shapes.length(vertices, "vertices");
    if (length % 2 == 0) return length / 2;
    throw new IllegalArgumentException(length + " numbers are no pairs x y");
  }

  private static void checked(String name, int[] offsets, int end) {
    if (offsets == null || offsets.length == 0) {
      throw new IllegalArgumentException("no " + name + " offsets: one more is needed than there are parts");
    }
    int before = 0;
    for (int offset : offsets) {
      if (offset < before || offset > end) {
        throw new IllegalArgumentException(
            name + " offsets ascend from 0 to " + end + " at most: " + offset + " follows " + before);
      }
      before = offset;
    }
  }

  /** Structs of shapes, and behind them the offsets and the vertices. */
  static ByteBuffer structs(Object vertices, int[] rings, int[] parts) {
    checked("ring", rings, count(vertices));
    if (parts != null) checked("part", parts, rings.length - 1);
    boolean wide = Shapes.isWide(vertices);
    int size = wide ? Double.BYTES : Float.BYTES, shapes = (parts == null ? rings : parts).length - 1;
    long offsets = (long) STRUCT * shapes, numbers = (offsets + 4L * rings.length + 7) / 8 * 8;
    long bytes = numbers + 2L * size * count(vertices);
    if (bytes > Integer.MAX_VALUE) throw new IllegalArgumentException(bytes + " bytes are more than one buffer has");
    ByteBuffer block = ByteBuffer.allocateDirect((int) bytes).order(ByteOrder.nativeOrder());
    long at = Shapes.address(block);
    for (int i = 0; i < shapes; i++) {
      long x = at + numbers + (parts == null ? 2L * size * rings[i] : 0);
      block.putLong(x).putLong(x + size).putLong(2L * size);
      block.putLong(parts == null ? 0 : at + offsets + 4L * parts[i]);
      block.putLong(parts == null ? rings[i + 1] - rings[i] : parts[i + 1] - parts[i]);
    }
    for (int ring : rings) block.putInt(ring);
    ByteBuffer rest = block.position((int) numbers).slice().order(ByteOrder.nativeOrder());
    block.position(0);
    if (vertices instanceof double[] doubles) rest.asDoubleBuffer().put(doubles);
    else if (vertices instanceof float[] floats) rest.asFloatBuffer().put(floats);
    else if (vertices instanceof DoubleBuffer doubles) rest.asDoubleBuffer().put(doubles.duplicate());
    else rest.asFloatBuffer().put(((FloatBuffer) vertices).duplicate());
    return block;
  }

  /** Structs of single shapes, with copies of the vertices that their rings have. */
  static ByteBuffer joined(Shape[] shapes) {
    int numbers = 0, offsets = 1;
    for (Shape each : shapes) {
      numbers = Math.addExact(numbers, ((Path) each).vertices.length);
      offsets = Math.addExact(offsets, ((Path) each).rings.length - 1);
    }
    double[] vertices = new double[numbers];
    int[] rings = new int[offsets], parts = new int[shapes.length + 1];
    int vertex = 0, ring = 0;
    for (int i = 0; i < shapes.length; i++) {
      Path path = (Path) shapes[i];
      int first = path.rings[0];
      for (int k = 1; k < path.rings.length; k++) rings[++ring] = vertex + path.rings[k] - first;
      int count = rings[ring] - vertex;
      System.arraycopy(path.vertices, 2 * first, vertices, 2 * vertex, 2 * count);
      vertex += count;
      parts[i + 1] = ring;
    }
    return structs(vertices, rings, parts);
  }
}
