// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;

/**
 * An array of shapes of one kind, in double or float: numbers that lie in an array or a direct buffer of the caller's.
 * Nothing is copied, and changes of the numbers are seen. Only the vertices of polygons and polylines are copied, once.
 *
 * <p>While a call lasts, arrays keep the collector waiting. For calls of seconds use direct buffers.
 */
public final class Shapes {
  private static final int[] FIELDS = {2, 4, 3, 4, 6, 6, 5, 7};

  static {
    Native.version(); // loads the library, which has address() too
  }

  final int kind;
  final long count;
  final long stride;
  final long step;
  final Object base;
  final boolean wide;
  private final int length;

  private Shapes(Kind kind, long count, long stride, long step, Object base) {
    this.kind = kind.value;
    this.count = count;
    this.base = base;
    length = length(base, "numbers");
    wide = isWide(base);
    int size = wide ? Double.BYTES : Float.BYTES;
    this.stride = stride * size;
    this.step = step * size;
  }

  private Shapes(Kind kind, long count, boolean wide, ByteBuffer structs) {
    this.kind = kind.value;
    this.count = count;
    this.wide = wide;
    base = structs;
    stride = Path.STRUCT;
    step = length = 0;
  }

  /** How many numbers a shape of a kind has. Polygons and polylines, which have any number, are refused. */
  public static int fields(Kind kind) {
    if (Path.is(kind)) {
      throw new IllegalArgumentException("a " + kind + " has any number of vertices: paths() and evenPaths() take them");
    }
    return FIELDS[kind.value];
  }

  /**
   * Shapes whose numbers follow one another.
   *
   * @param numbers a double[], float[], or direct DoubleBuffer or FloatBuffer of the machine's byte order; or one shape
   */
  public static Shapes of(Kind kind, Object numbers) {
    if (numbers instanceof Shape one) return of(kind, new Shape[] {one});
    return records(kind, numbers, fields(kind));
  }

  /** The same from single shapes, whose numbers are copied once. */
  public static Shapes of(Kind kind, Shape... shapes) {
    for (int i = 0; i < shapes.length; i++) {
      if (shapes[i].kind() != kind) {
        throw new IllegalArgumentException("shape " + i + " is a " + shapes[i].kind() + ", not a " + kind);
      }
    }
    if (Path.is(kind)) return new Shapes(kind, shapes.length, true, Path.joined(shapes));
    int fields = fields(kind);
    double[] numbers = new double[fields * shapes.length];
    for (int i = 0; i < shapes.length; i++) {
      System.arraycopy(shapes[i].numbers(), 0, numbers, i * fields, fields);
    }
    return of(kind, numbers);
  }

  /** Records of {@code size} numbers each, of which the first are a shape's. */
  public static Shapes records(Kind kind, Object numbers, int size) {
    int length = length(numbers, "numbers");
    if (size < fields(kind) || length % size != 0) {
      throw new IllegalArgumentException(
          length + " numbers are no records of " + size + ", of which " + fields(kind) + " are a " + kind + "'s");
    }
    return new Shapes(kind, length / size, size, 1, numbers);
  }

  /** A column for each number of the kind, one after the other. */
  public static Shapes columns(Kind kind, Object numbers) {
    int length = length(numbers, "numbers");
    if (length % fields(kind) != 0) {
      throw new IllegalArgumentException(length + " numbers are no " + fields(kind) + " columns of a " + kind);
    }
    long count = length / fields(kind);
    return new Shapes(kind, count, 1, count, numbers);
  }

  /**
   * Polygons or polylines of as many vertices each, in one ring or chain: 4 of quads, 3 of triangles.
   *
   * @param vertices x y x y ..., as numbers elsewhere; they are copied
   */
  public static Shapes evenPaths(Kind kind, Object vertices, int each) {
    int count = Path.count(vertices);
    if (each < 1 || count % each != 0) {
      throw new IllegalArgumentException(count + " vertices are no paths of " + each);
    }
    int[] rings = new int[count / each + 1];
    for (int i = 0; i < rings.length; i++) rings[i] = i * each;
    return paths(kind, vertices, rings, null);
  }

  /**
   * Polygons or polylines of any number of vertices, by the offsets of GeoArrow.
   *
   * @param vertices x y x y ..., as numbers elsewhere; they are copied
   * @param rings where each ring or chain begins among the vertices, with the end
   * @param parts where each shape begins among the rings, with the end; null if a ring is a shape
   */
  public static Shapes paths(Kind kind, Object vertices, int[] rings, int[] parts) {
    if (!Path.is(kind)) throw new IllegalArgumentException("a " + kind + " has no rings");
    ByteBuffer structs = Path.structs(vertices, rings, parts);
    return new Shapes(kind, (parts == null ? rings : parts).length - 1, isWide(vertices), structs);
  }

  /** How many shapes there are. */
  public long count() {
    return count;
  }

  /** Whether numbers are double, not float. */
  static boolean isWide(Object numbers) {
    return numbers instanceof double[] || numbers instanceof DoubleBuffer;
  }

  static native long address(Object buffer);

  /** Whether an output of so many numbers lies where these do. */
  boolean meets(Object out, long needed) {
    return shareMemory(base, length, out, needed, wide);
  }

  /** Whether so many numbers of two arrays or buffers are the same memory. Two arrays never share a part of theirs. */
  static boolean shareMemory(Object a, long countA, Object b, long countB, boolean wide) {
    if (a == b) return true;
    if (!(a instanceof Buffer && b instanceof Buffer)) return false;
    long size = wide ? Double.BYTES : Float.BYTES, startA = address(a), startB = address(b);
    return startA < startB + countB * size && startB < startA + countA * size;
  }

  /** How many numbers an operand or an output has; an error if it is none. */
  static int length(Object numbers, String name) {
    if (numbers instanceof double[] doubles) return doubles.length;
    if (numbers instanceof float[] floats) return floats.length;
    ByteOrder order =
        numbers instanceof DoubleBuffer doubles
            ? doubles.order()
            : numbers instanceof FloatBuffer floats ? floats.order() : null;
    if (order == ByteOrder.nativeOrder() && ((Buffer) numbers).isDirect()) {
      Buffer buffer = (Buffer) numbers;
      if (buffer.position() == 0) return buffer.limit();
      throw new IllegalArgumentException(name + " is a buffer at position " + buffer.position() + ": take its slice()");
    }
    throw new IllegalArgumentException(
        name + " is " + (numbers == null ? "null" : numbers.getClass().getSimpleName())
            + ": a double[], a float[], or a direct DoubleBuffer or FloatBuffer of nativeOrder() is needed");
  }
}
