// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.util.Arrays;

/** Polygons and polylines: one, arrays of them, and what is refused. */
final class Paths {
  private static final double[] FRAME = {0, 0, 8, 0, 8, 8, 0, 8, 2, 2, 6, 2, 6, 6, 2, 6};

  /** Squares of side 2, 3 apart. */
  private static final double[] ROW = {
    0, 0, 2, 0, 2, 2, 0, 2, 3, 0, 5, 0, 5, 2, 3, 2, 6, 0, 8, 0, 8, 2, 6, 2
  };

  private static void same(Object got, Object expected) {
    if (!got.equals(expected)) throw new AssertionError(got + ", not " + expected);
  }

  private static void refused(Class<? extends Exception> kind, String words, Runnable call) {
    try {
      call.run();
    } catch (RuntimeException e) {
      if (kind.isInstance(e) && e.getMessage() != null && e.getMessage().contains(words)) return;
      throw new AssertionError("not '" + words + "'", e);
    }
    throw new AssertionError("not refused: " + words);
  }

  private static void one() {
    Polygon frame = new Polygon(FRAME, 0, 4, 8), triangle = new Polygon(new double[] {0, 0, 4, 0, 0, 3});
    Polyline chain = new Polyline(new double[] {-1, 1, 9, 1, 9, 9});
    Circle centre = new Circle(4, 4, 1);
    Aabb box = new Aabb(0, 0, 2, 9);
    same(Vesica.overlap(frame, centre), false);
    same(Vesica.overlap(frame, chain), true);
    same(Vesica.interiorsOverlap(frame, new Circle(4, 4, 2)), false);
    same(Vesica.relation(triangle, new Point(1, 1)), Relation.CONTAINS);
    same(Vesica.contains(frame, new Circle(1, 1, 1)), true);
    same(Vesica.nearest(frame, centre).distance(), 1.0);
    same(Vesica.boundaryDistance(triangle, new Circle(1, 1, 0.5)).distance(), 0.5);
    same(Vesica.depth(triangle, new Point(1, 1)).depth(), 1.0);
    same(Measures.signedDistance(triangle, new Point(-3, 0)), 3.0);
    same(Measures.within(triangle, new Point(-3, 0), 3), Within.YES);
    same(Vesica.area(triangle, box), 4.5);
    same(Vesica.iou(frame, new Aabb(0, 0, 8, 8)), 0.75);
    same(Measures.ratio(Ratio.OVER_FIRST, triangle, box), 0.75);
    same(Vesica.shapeArea(frame), 48.0);
    same(Vesica.bounds(triangle), new Aabb(0, 0, 4, 3));
    Vesica.check(frame);
    same(Arrays.toString(frame.rings()), "[0, 4, 8]");
    same(Shape.of(Kind.POLYGON, triangle.numbers()).numbers().length, 6);
  }

  private static Object numbers(double[] doubles, boolean wide) {
    if (wide) return doubles;
    float[] floats = new float[doubles.length];
    for (int i = 0; i < floats.length; i++) floats[i] = (float) doubles[i];
    return floats;
  }

  private static void arrays(boolean wide) {
    Object row = numbers(ROW, wide);
    Shapes quads = Shapes.evenPaths(Kind.POLYGON, row, 4);
    Shapes ringed = Shapes.paths(Kind.POLYGON, row, new int[] {0, 4, 8, 12}, null);
    Shapes nested = Shapes.paths(Kind.POLYGON, row, new int[] {0, 4, 8, 12}, new int[] {0, 1, 3});
    Shapes discs = Shapes.of(Kind.CIRCLE, numbers(new double[] {1, 1, 1, 4, 1, 1, 9, 9, 1}, wide));
    same(quads.count() + 10 * ringed.count() + 100 * nested.count(), 233L);
    boolean[] hits = new boolean[9];
    same(Vesica.overlapMany(quads, discs, hits), 2L);
    byte[] relations = new byte[3];
    same(Vesica.relationMany(quads, ringed, relations), 3L);
    same(Arrays.toString(relations), "[7, 7, 7]");
    Object areas = wide ? new double[6] : new float[6];
    same(Vesica.areaMatrix(nested, quads, areas), 3L);
    String text = wide ? Arrays.toString((double[]) areas) : Arrays.toString((float[]) areas);
    same(text, "[4.0, 0.0, 0.0, 0.0, 4.0, 4.0]");
    Shapes roof = Shapes.paths(Kind.POLYLINE, numbers(new double[] {0, 5, 9, 5}, wide), new int[] {0, 2}, null);
    Object distances = wide ? new double[3] : new float[3];
    same(Vesica.nearestMany(quads, roof, distances, null, null, null, null), 0L);
    same(wide ? ((double[]) distances)[1] : (double) ((float[]) distances)[1], 3.0);
    long[] chosen = new long[4];
    Shapes two = Shapes.paths(Kind.POLYGON, numbers(new double[] {1, 1, 4, 1, 4, 1.5}, wide), new int[] {0, 3}, null);
    same(Vesica.overlapSelect(two, quads, chosen), 2L);
    same(Arrays.toString(chosen), "[0, 1, -1, 0]");
    Index index = new Index(quads, discs, nested);
    same(index.join(new Index(ringed), JoinQuery.OVERLAP)[0].length, 3 + 2 + 3);
  }

  private static void ofSingleShapes() {
    Polygon frame = new Polygon(FRAME, 0, 4, 8), hole = new Polygon(FRAME, 4, 8), second = new Polygon(ROW, 4, 8);
    Shapes mixed = Shapes.of(Kind.POLYGON, frame, hole, second);
    double[] boxes = new double[12];
    Boxes.bounds(mixed, boxes);
    same(Arrays.toString(boxes), "[0.0, 0.0, 8.0, 8.0, 2.0, 2.0, 6.0, 6.0, 3.0, 0.0, 5.0, 2.0]");
    boolean[] hits = new boolean[3];
    same(Vesica.overlapMany(Shapes.of(Kind.POLYGON, frame), mixed, hits), 3L);
    same(Vesica.overlapMany(mixed, Shapes.of(Kind.CIRCLE, new Circle(4, 4, 1)), hits), 1L);
    same(hits[1], true);
    Shapes none = Shapes.of(Kind.POLYGON), single = Shapes.of(Kind.POLYGON, frame);
    same(Vesica.overlapMany(none, single, hits), 0L);
    DoubleBuffer direct = ByteBuffer.allocateDirect(8 * ROW.length).order(ByteOrder.nativeOrder()).asDoubleBuffer();
    direct.put(ROW).position(0);
    same(Vesica.overlapMany(Shapes.evenPaths(Kind.POLYGON, direct, 4), mixed, hits), 2L);
  }

  private static void refusals() {
    Class<? extends Exception> argument = IllegalArgumentException.class;
    refused(argument, "3 numbers are no pairs", () -> new Polygon(new double[3]));
    refused(argument, "no vertex", () -> new Polyline(new double[0]));
    refused(argument, "ring offsets ascend from 0 to 8 at most: 9 follows 0", () -> new Polygon(FRAME, 0, 9));
    refused(argument, "1 follows 2", () -> new Polygon(FRAME, 0, 2, 1));
    refused(argument, "-1 follows 0", () -> new Polyline(FRAME, -1, 2));
    refused(argument, "8 vertices are no paths of 3", () -> Shapes.evenPaths(Kind.POLYGON, FRAME, 3));
    refused(argument, "no paths of 0", () -> Shapes.evenPaths(Kind.POLYGON, FRAME, 0));
    refused(argument, "a RECT has no rings", () -> Shapes.evenPaths(Kind.RECT, FRAME, 4));
    refused(argument, "any number of vertices", () -> Shapes.of(Kind.POLYGON, FRAME));
    refused(argument, "vertices is null", () -> Shapes.evenPaths(Kind.POLYGON, null, 4));
    refused(argument, "no ring offsets", () -> Shapes.paths(Kind.POLYGON, FRAME, null, null));
    int[] rings = {0, 4, 8};
    refused(argument, "part offsets ascend from 0 to 2", () -> Shapes.paths(Kind.POLYGON, FRAME, rings, new int[] {0, 3}));
    Polygon frame = new Polygon(FRAME, rings);
    refused(argument, "shape 0 is a POLYGON, not", () -> Shapes.of(Kind.POLYLINE, frame));
    refused(VesicaException.class, "convex", () -> Vesica.depth(frame, new Point(1, 1)));
    double[] crossed = {0, 0, 4, 4, 4, 0, 0, 4};
    refused(VesicaException.class, "cross", () -> Vesica.check(new Polygon(crossed)));
    double[] broken = ROW.clone();
    broken[9] = Double.NaN;
    boolean[] hits = new boolean[3];
    Shapes quads = Shapes.evenPaths(Kind.POLYGON, broken, 4), probe = Shapes.of(Kind.POINT, new Point(1, 1));
    refused(VesicaException.class, "invalid", () -> Vesica.overlapMany(quads, probe, hits));
    same(Arrays.toString(hits), "[true, false, false]");
  }

  /** Structs lead into the memory that they are in, so that nothing is lost while it is in use. */
  private static void collected() {
    for (int i = 0; i < 200; i++) {
      Shapes shapes = Shapes.evenPaths(Kind.POLYGON, ROW.clone(), 4);
      if (i % 50 == 0) System.gc();
      same(Vesica.overlapMany(shapes, shapes, new boolean[3]), 3L);
    }
  }

  private Paths() {}

  public static void main(String[] arguments) {
    one();
    arrays(true);
    arrays(false);
    ofSingleShapes();
    refusals();
    collected();
    System.out.println("paths: as they should be");
  }
}
