// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.lang.management.BufferPoolMXBean;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.util.Arrays;
import java.util.Random;

/** What is refused, what memory is taken, that nothing is copied, and that any arguments are survived. */
final class Arguments {
  private static final Shapes THREE = Shapes.of(Kind.CIRCLE, new double[] {0, 0, 1, 0, 0, 1, 0, 0, 1});

  private static void refused(Class<? extends Exception> kind, String words, Runnable call) {
    try {
      call.run();
    } catch (RuntimeException e) {
      if (kind.isInstance(e) && e.getMessage() != null && e.getMessage().contains(words)) return;
      throw new AssertionError("not '" + words + "'", e);
    }
    throw new AssertionError("not refused: " + words);
  }

  private static void check(boolean holds, String what) {
    if (!holds) throw new AssertionError(what);
  }

  private static void cast(Object vx, Object vy, Object t) {
    Motion.castMany(THREE, THREE, vx, vy, 1, t, null, null, null, null);
  }

  private static void refusals() {
    Class<? extends Exception> argument = IllegalArgumentException.class;
    refused(VesicaException.class, "a shape is invalid", () -> Vesica.overlap(new Circle(0, 0, -1), new Point(0, 0)));
    refused(VesicaException.class, "negative", () -> Vesica.check(new Circle(0, 0, -1)));
    refused(argument, "CIRCLE has 3 numbers, not 2", () -> Shape.of(Kind.CIRCLE, 1, 2));
    refused(argument, "2 numbers are no records of 3", () -> Shapes.of(Kind.CIRCLE, new double[2]));
    refused(argument, "numbers is int[]: a double[], a float[]", () -> Shapes.of(Kind.CIRCLE, new int[3]));
    refused(argument, "numbers is null", () -> Shapes.of(Kind.CIRCLE, (Object) null));
    refused(argument, "numbers is HeapDoubleBuffer", () -> Shapes.of(Kind.POINT, DoubleBuffer.allocate(2)));
    Point origin = new Point(0, 0);
    refused(argument, "shape 1 is a POINT, not", () -> Shapes.of(Kind.CIRCLE, new Circle(0, 0, 1), origin));
    Shapes two = Shapes.of(Kind.CIRCLE, new double[6]), narrow = Shapes.of(Kind.CIRCLE, new float[9]);
    refused(argument, "a has 3 shapes and b 2", () -> Vesica.overlapMany(THREE, two, new boolean[3]));
    refused(argument, "one array of shapes has double", () -> Vesica.overlapMany(THREE, narrow, new boolean[3]));
    boolean[] eight = new boolean[8];
    refused(argument, "out has 8 elements, where 9 are needed", () -> Vesica.overlapMatrix(THREE, THREE, eight));
    refused(argument, "one array of shapes has double", () -> Vesica.areaMany(THREE, THREE, new float[3]));
    refused(argument, "out is String", () -> Vesica.areaMany(THREE, THREE, "text"));
    double[] numbers = new double[6];
    Shapes own = Shapes.of(Kind.CIRCLE, numbers);
    refused(argument, "out overlaps an input", () -> Vesica.areaMany(own, own, numbers));
    refused(argument, "columns 0 and 1 overlap", () -> Vesica.depthMany(THREE, THREE, numbers, numbers, null));
    refused(VesicaException.class, "NULL", () -> Vesica.depthMany(THREE, THREE, null, null, null));
    refused(argument, "3 shapes need as many scores, not 1", () -> Vesica.nms(THREE, new double[1], 0.5));
    refused(argument, "1 to 64 are needed", () -> new Index());
    refused(VesicaException.class, "index", () -> Index.fromBytes(new byte[640], THREE));
    byte[] saved = new Index(THREE).bytes();
    refused(argument, "an index of 3 shapes cannot be that of 6", () -> Index.fromBytes(saved, THREE, THREE));
    refused(VesicaException.class, "", () -> new Index(THREE).join(new Index(THREE), JoinQuery.OVERLAP, 2, 2));
    refused(argument, "k is 0", () -> new Index(THREE).nearestOfEach(0, 1, THREE));
    refused(argument, "array of Java's has 2147483639 elements, where 6442450941", () ->
        new Index(THREE).nearestOfEach(Integer.MAX_VALUE, 1, THREE));
    refused(NullPointerException.class, "array of shapes 0 is null", () -> new Index((Shapes) null));
    refused(NullPointerException.class, "array of shapes 1 is null", () -> new Index(THREE, null));
    refused(NullPointerException.class, "the arrays of shapes are null", () -> new Index((Shapes[]) null));
    Shapes[] vast = new Shapes[64];
    Arrays.fill(vast, Shapes.of(Kind.POINT, new float[1 << 22]));
    refused(argument, "a buffer of Java's has 2147483519 elements, where", () -> new Index(vast));
    double[] one = {1}, all = new double[15], three = new double[3];
    refused(argument, "1 or 3 velocities", () -> cast(new double[2], one, all));
    refused(argument, "overlaps the velocities", () -> cast(three, three, three));
    refused(argument, "one array of shapes has double", () -> new Motion(1, 0, 1).castFirst(THREE, narrow));
    refused(VesicaException.class, "", () -> new Motion(1, 0, -1).cast(origin, origin));
    refused(VesicaException.class, "", () -> new Motion(1, 0, 1).castFirst(THREE, THREE));
    refused(argument, "6 numbers are no rows of 5", () -> Boxes.rects(numbers, Angle.RADIANS));
    refused(VesicaException.class, "", () -> Boxes.rects(new double[5], 5, Angle.REVERSED, true));
    refused(VesicaException.class, "", () -> Boxes.corners(THREE, new double[24]));
    refused(argument, "out has 6 elements, where 15", () -> Boxes.of(THREE, Angle.RADIANS, false, new double[6]));
    refused(argument, "3 shapes need as many labels, not 1", () ->
        Measures.suppress(THREE, new double[3], new Measures.Suppression(0.5, Ratio.OVER_UNION, new int[1], 0, 3)));
    refused(NullPointerException.class, "null", () -> Vesica.overlap(null, new Point(0, 0)));
    Shapes none = Shapes.of(Kind.RECT, new double[0]);
    check(Vesica.overlapMany(none, none, new boolean[0]) == 0, "an empty array");
    check(new Index(none).join()[0].length == 0, "an empty index");
  }

  private static void measuresAndMotion() {
    Shapes rects = Boxes.rects(new double[] {1, 2, 6, 4, 90, 3, 4, 5, 2, 180}, Angle.DEGREES);
    double[] boxes = new double[10], corners = new double[16], bounds = new double[8], depths = new double[4];
    Boxes.of(rects, Angle.QUARTERS, true, boxes);
    check(Arrays.equals(boxes, new double[] {1, 2, 6, 4, -1, 3, 4, 5, 2, 2}), "boxes");
    Boxes.corners(rects, corners);
    check(corners[0] == 3 && corners[1] == -1, "corners");
    Boxes.bounds(rects, bounds);
    check(Arrays.equals(bounds, new double[] {-1, -1, 3, 5, 0.5, 3, 5.5, 5}), "bounds");
    check(Vesica.depthMatrix(rects, rects, depths) == 4 && depths[0] == 4 && depths[3] == 2, "depths");
    try {
      Boxes.rects(new double[] {1, 2, 6, 4, 90, 3, 4, -5, 2, 180}, Angle.DEGREES);
      throw new AssertionError("an invalid box");
    } catch (VesicaException e) {
      check(e.errorCode() == ErrorCode.SHAPE && ((Shapes) e.result()).count() == 2, "an invalid box");
    }
    Aabb small = new Aabb(0, 0, 2, 2), large = new Aabb(0, 0, 4, 4);
    check(Measures.ratio(Ratio.OVER_SECOND, small, large) == 0.25, "ratio");
    Shapes both = Shapes.of(Kind.AABB, small, large);
    int[] labels = {1, 2};
    double least = Double.NEGATIVE_INFINITY;
    for (Object[] each : new Object[][] {{null, 2L, 1}, {labels, 2L, 2}, {labels, 1L, 1}}) {
      var how = new Measures.Suppression(0.5, Ratio.OVER_SMALLER, (int[]) each[0], least, (long) each[1]);
      check(Measures.suppress(both, new double[] {1, 2}, how).length == (int) each[2], "suppression");
    }
    Circle disc = new Circle(0, 0, 1);
    Aabb wall = new Aabb(10, -5, 12, 5);
    Impact met = new Impact(3, 10, 0, -1, 0);
    Motion east = new Motion(3, 0, 9);
    check(east.cast(wall, disc).equals(new Motion.Contact(Cast.HIT, met)), "cast");
    check(new Motion(3, 0, 2.5).cast(wall, disc).cast() == Cast.MISS, "too late");
    check(east.cast(wall, wall).cast() == Cast.START, "at the start");
    Shapes walls = Shapes.of(Kind.AABB, new Aabb(20, -5, 22, 5), wall, wall), one = Shapes.of(Kind.CIRCLE, disc);
    check(east.castFirst(one, walls).get().equals(new Motion.First(1, met)), "the first");
    check(new Motion(-3, 0, 9).castFirst(one, walls).isEmpty(), "none");
    Index index = new Index(walls);
    check(index.cast(one, new Motion(1, 0, 10)).length == 2, "items");
    check(index.castFirst(one, east).get().equals(new Motion.First(1, met)), "the first of an index");
    check(Vesica.contains(new Motion(3, 0, 2).bounds(disc), new Aabb(-1, -1, 7, 1)), "bounds of a motion");
    double[] t = new double[3];
    try {
      Motion.castMany(walls, one, new double[] {2, -1, Double.NaN}, new double[3], 99, t, null, null, null, null);
      throw new AssertionError("a velocity that is none");
    } catch (VesicaException e) {
      check(t[0] == 9.5 && t[1] == Double.POSITIVE_INFINITY && Double.isNaN(t[2]), "times");
    }
  }

  private static void turns() {
    Segment bar = new Segment(-1, 0, 1, 0);
    Circle speck = new Circle(0, 0.5, 1e-8);
    Aabb wall = new Aabb(10, -5, 12, 5);
    Turn still = new Turn(0, 0, 0), half = new Turn(0, 0, Math.PI), less = new Turn(0, 0, 1.57);
    Motion.ImpactTime hit = Motion.impactTime(bar, half, speck, still, 1e-7);
    check(hit.cast() == Cast.HIT && hit.gap() <= 1e-7, "a hit");
    check(hit.impact().t() <= 0.5 && hit.impact().t() > 0.499999, "its time");
    Motion.ImpactTime miss = Motion.impactTime(bar, less, speck, still, 1e-7);
    check(miss.cast() == Cast.MISS && miss.impact().t() == Double.POSITIVE_INFINITY, "a miss");
    check(Double.isNaN(miss.gap()), "its gap");
    // Without area contact is never proved.
    check(Motion.impactTime(bar, half, new Point(0, 0.5), still, 1e-7).cast() == Cast.NEAR, "near");
    Motion.ImpactTime start = Motion.impactTime(wall, half, wall, still, 1);
    check(start.cast() == Cast.START && start.impact().t() == 0 && start.gap() == 0, "at the start");
    refused(VesicaException.class, "", () -> Motion.impactTime(wall, still, speck, still, 0));
    refused(VesicaException.class, "", () -> Motion.impactTime(wall, new Turn(0, 0, 2e6), speck, still, 1));
    refused(NullPointerException.class, "null", () -> Motion.impactTime(wall, null, speck, still, 1));
  }

  private static void topology() {
    Aabb a = new Aabb(0, 0, 2, 2), b = new Aabb(1, 1, 3, 3), far = new Aabb(5, 0, 7, 2);
    Circle disc = new Circle(6, 1, 1);
    check(Measures.within(a, disc, 3) == Within.YES, "within");
    check(Measures.within(a, disc, 2.999) == Within.NO, "not within");
    Ellipse left = new Ellipse(-2, 0, 1, 0, 2, 1), right = new Ellipse(5, 0, 1, 0, 2, 1);
    check(Measures.within(new Point(0, 0), right, 3) == Within.YES, "a point within");
    check(Measures.within(left, right, 3) == Within.NEARLY, "nearly within");
    Shapes boxes = Shapes.of(Kind.AABB, a, b, far), one = Shapes.of(Kind.AABB, a);
    byte[] near = new byte[3];
    check(Measures.withinMany(boxes, one, 2, near) == 2 && near[1] == 1 && near[2] == 0, "within, of many");
    double[] signed = new double[3];
    check(Measures.signedDistanceMany(boxes, one, signed) == 2, "signed distances");
    check(Arrays.equals(signed, new double[] {-2, -1, 3}), "signed distances");
    check(new Index(boxes).joinWithin(new Index(one), 2)[0].length == 2, "a join within a distance");
    check(Topology.de9im(a, new Aabb(2, 0, 4, 2)).equals("FF2F11212"), "a matrix");
    check(Topology.matches("FF2F11212", "FF*FT****"), "a pattern");
    check(Topology.intersection(a, b).get(0).equals(new Point(1, 1)), "a region");
    check(Topology.intersection(a, far).isEmpty(), "no region");
    for (String pattern : new String[] {"T*", "T********\0", "\u00e9********", "X********"}) {
      refused(VesicaException.class, "", () -> Topology.matches("FF2F11212", pattern));
    }
    refused(VesicaException.class, "", () -> Topology.intersection(a, disc));
    refused(VesicaException.class, "", () -> Measures.within(a, b, Double.NaN));
    check(Measures.within(a, b, -1) == Within.YES, "deep enough");
    Shapes soft = Shapes.of(Kind.AABB, new Aabb(0, 0, 4, 4), new Aabb(0, 0, 4, 3), new Aabb(9, 9, 10, 10));
    double[] scores = {1, 0.75, 0.5};
    Measures.Kept kept = Measures.suppressSoft(soft, scores, new Measures.SoftSuppression(Decay.LINEAR, 0.5));
    check(Arrays.equals(kept.items(), new long[] {0, 2, 1}), "soft suppression");
    check(Arrays.equals(kept.scores(), new double[] {1, 0.5, 0.1875}), "scores that are left");
  }

  private static void capsulesAndRoundedRectangles() {
    Capsule bar = new Capsule(0, 0, 4, 0, 1);
    RoundRect rounded = new RoundRect(10, 0, 1, 0, 2, 1, 0.5);
    check(Vesica.overlap(bar, new Point(5, 0)), "the end of a capsule");
    check(!Vesica.overlap(bar, new Point(5, Double.MIN_VALUE)), "beyond the end of a capsule");
    check(Vesica.nearest(bar, rounded).distance() == 2.5, "the distance of a rounded rectangle");
    check(Shape.of(Kind.ROUND_RECT, 10, 0, 1, 0, 2, 1, 0.5).equals(rounded), "a shape of numbers");
    check(Vesica.bounds(rounded).equals(new Aabb(7.5, -1.5, 12.5, 1.5)), "bounds of a rounded rectangle");
    Shapes bars = Shapes.of(Kind.CAPSULE, bar, new Capsule(0, 5, 4, 5, 1));
    boolean[] hits = {false, true};
    Shapes end = Shapes.of(Kind.POINT, new Point(5, 0)), two = Shapes.of(Kind.ROUND_RECT, rounded, rounded);
    check(Vesica.overlapMany(bars, end, hits) == 1 && hits[0], "capsules");
    check(new Index(bars).join(new Index(end), JoinQuery.OVERLAP)[0].length == 1, "an index of capsules");
    check(new Index(bars).joinWithin(new Index(two), 2.5)[0].length == 2, "pairs within a distance");
    check(Vesica.area(bar, rounded) == 0, "the area that two share");
    Ellipse disc = new Ellipse(10, 0, 1, 0, 1, 1);
    check(Vesica.contains(rounded, disc), "an ellipse in a rounded rectangle");
    check(Vesica.boundaryDistance(rounded, disc).distance() == 0.5, "an ellipse's outline in another");
  }

  private static DoubleBuffer direct(double... numbers) {
    DoubleBuffer buffer = ByteBuffer.allocateDirect(8 * numbers.length).order(ByteOrder.nativeOrder()).asDoubleBuffer();
    return buffer.put(0, numbers);
  }

  /** Called before anything else: buffers have addresses even if no query has loaded the library yet. */
  private static void buffersFirst() {
    DoubleBuffer out = direct(0, 0, 0);
    check(Vesica.areaMany(Shapes.of(Kind.CIRCLE, direct(0, 0, 1)), THREE, out) == 3, "the first call");
  }

  private static void layouts() {
    Shapes records = Shapes.records(Kind.CIRCLE, new double[] {0, 0, 1, 77, 5, 0, 1, 77}, 4);
    Shapes columns = Shapes.columns(Kind.CIRCLE, direct(0, 5, 0, 0, 1, 1));
    byte[] relations = new byte[2];
    check(Vesica.relationMany(records, columns, relations) == 2, "records and columns");
    check(Relation.of(relations[1]) == Relation.EQUAL, "relation");
    DoubleBuffer out = direct(0, 0);
    Vesica.areaMany(records, columns, out);
    check(out.get(0) == Math.PI && out.get(1) == Math.PI, "a direct buffer");
    DoubleBuffer inside = direct(0, 0, 1, 0, 0, 1);
    Shapes own = Shapes.of(Kind.CIRCLE, inside);
    DoubleBuffer part = inside.slice(4, 2);
    refused(IllegalArgumentException.class, "out overlaps an input", () -> Vesica.areaMany(records, own, part));
    try {
      Vesica.areaMany(records, columns, out.asReadOnlyBuffer());
      throw new AssertionError("wrote to a read-only buffer");
    } catch (java.nio.ReadOnlyBufferException e) {
      // as it should be
    }
  }

  /** Columns of one direct buffer are results as any others, unless they share numbers with what else is passed. */
  private static void columnsOfOneBuffer() {
    DoubleBuffer all = direct(2, 2, 2, 0, 0, 0, 0), head = all.slice(0, 3), within = all.slice(2, 3);
    DoubleBuffer beside = all.slice(3, 3), still = direct(0), rest = direct(0, 0, 0);
    Class<? extends Exception> argument = IllegalArgumentException.class;
    String words = "overlap: results need memory of their own", velocities = "overlaps the velocities";
    refused(argument, "columns 0 and 1 " + words, () ->
        Vesica.nearestMany(THREE, THREE, head, head.duplicate(), null, null, null));
    refused(argument, "columns 0 and 4 " + words, () ->
        Vesica.nearestMany(THREE, THREE, head, null, null, null, within));
    refused(argument, "columns 1 and 4 " + words, () ->
        Vesica.boundaryDistanceMany(THREE, THREE, null, within, null, null, all));
    refused(argument, "columns 0 and 2 " + words, () -> Vesica.depthMany(THREE, THREE, within, null, head));
    refused(argument, "columns 0 and 3 " + words, () ->
        Motion.castMany(THREE, THREE, still, still, 1, head, null, null, within, null));
    for (DoubleBuffer out : new DoubleBuffer[] {all.slice(1, 3), within, head.duplicate(), all}) {
      refused(argument, velocities, () -> cast(head, rest, out));
      refused(argument, velocities, () -> cast(rest, head, out));
    }
    Shapes wall = Shapes.of(Kind.AABB, new Aabb(10, -5, 12, 5));
    check(Motion.castMany(wall, THREE, head, rest, 99, beside, null, null, null, null) == 3, "beside");
    check(all.get(2) == 2 && all.get(3) == 4.5 && all.get(5) == 4.5, "times beside velocities");
    check(Vesica.depthMany(THREE, THREE, head, beside, null) == 3 && all.get(2) == 2, "columns side by side");
  }

  /** What is passed on is what a buffer had when the shapes were made, whatever its limit and position are now. */
  private static void limits() {
    DoubleBuffer numbers = direct(0, 0, 1, 0, 0, 1);
    Shapes own = Shapes.of(Kind.CIRCLE, numbers);
    DoubleBuffer last = numbers.slice(4, 2);
    numbers.position(1).limit(3);
    refused(IllegalArgumentException.class, "out overlaps an input", () -> Vesica.areaMany(own, own, last));
    check(Vesica.areaMany(own, own, new double[2]) == 2, "a position");
  }

  /** The numbers of two million rectangles in a heap that has no room for a second copy of them. */
  private static void nothingIsCopied() {
    int count = 2_000_000;
    double[] numbers = new double[6 * count];
    for (int i = 0; i < count; i++) numbers[6 * i + 2] = 1;
    boolean[] out = new boolean[count];
    Shapes shapes = Shapes.of(Kind.RECT, numbers);
    check(Runtime.getRuntime().maxMemory() < 2L * 8 * numbers.length, "-Xmx is too large for this test");
    check(Vesica.overlapMany(shapes, shapes, out) == count, "all");
  }

  /** As many arrays as there may be, of two indexes: more local references than there is room for unasked. */
  private static void manyArrays() {
    Shapes[] all = new Shapes[64];
    Arrays.fill(all, THREE);
    Index index = new Index(all), other = new Index(all);
    check(index.joinCount(other, JoinQuery.OVERLAP) == 192 * 192, "pairs of many arrays");
  }

  /** Joins take direct memory once, not in each call: the collector does not know how much that is. */
  private static void joinsTakeNoMemory() {
    Index index = new Index(THREE);
    check(index.joinCount(index, JoinQuery.OVERLAP) == 3, "pairs");
    long before = directMemory();
    for (int i = 0; i < 10; i++) index.join(index, JoinQuery.OVERLAP);
    check(directMemory() <= before, "direct memory of a join");
  }

  private static long directMemory() {
    return ManagementFactory.getPlatformMXBeans(BufferPoolMXBean.class).stream()
        .filter(pool -> pool.getName().equals("direct")).mapToLong(BufferPoolMXBean::getMemoryUsed).sum();
  }

  private static final int QUESTIONS = 23;

  private static void anyArguments(int calls) {
    long seed = System.nanoTime();
    System.out.println("seed " + seed);
    Random draw = new Random(seed);
    int[] answered = new int[QUESTIONS];
    for (int i = 0; i < calls; i++) {
      int question = draw.nextInt(QUESTIONS);
      try {
        anyCall(draw, question);
        answered[question]++;
      } catch (IllegalArgumentException | NullPointerException e) {
        // as it should be
      }
    }
    String told = "answered: " + Arrays.toString(answered) + " of " + calls;
    System.out.println(told);
    // Bytes that are 0 are no index.
    int least = Arrays.stream(answered).limit(QUESTIONS - 1).min().getAsInt();
    check(least > 0 || calls < 5000, told);
  }

  private static void anyCall(Random draw, int question) {
    Kind kindA = kind(draw), kindB = kind(draw);
    double[] first = some(draw, kindA), second = some(draw, kindB);
    Shapes a = draw.nextBoolean() ? Shapes.of(kindA, first) : Shapes.columns(kindA, direct(first));
    Shapes b = Shapes.of(kindB, second);
    double[] out = new double[draw.nextInt(100)], scores = new double[(int) a.count() + draw.nextInt(3) / 2];
    double number = special(draw);
    Motion motion = new Motion(number, draw.nextInt(5) - 2, special(draw));
    switch (question) {
      case 0 -> Vesica.overlapMany(a, b, new boolean[draw.nextInt(100)]);
      case 1 -> Vesica.containsMatrix(a, b, new boolean[draw.nextInt(100)]);
      case 2 -> Vesica.areaMany(a, b, draw.nextInt(5) == 0 ? second : out);
      case 3 -> Vesica.iouMatrix(a, b, direct(out));
      case 4 -> Vesica.depthMany(a, b, null, out, draw.nextBoolean() ? null : out);
      case 5 -> Vesica.nms(a, scores, number);
      case 6 -> new Index(a, b).join(new Index(b), JoinQuery.of(draw.nextInt(5)));
      case 7 -> new Index(a).nearestOfEach(draw.nextInt(4), number, b, a);
      case 8 -> Measures.ratioMany(Ratio.of(draw.nextInt(8)), a, b, out);
      case 9 -> Boxes.of(a, Angle.of(draw.nextInt(5)), draw.nextBoolean(), out);
      case 10 -> Boxes.rects(second, draw.nextInt(9), Angle.of(draw.nextInt(5)), draw.nextBoolean());
      case 11 -> Motion.castMany(a, b, scores, scores, number, out, null, null, null, null);
      case 12 -> new Index(a, b).cast(Shapes.of(kindA, single(kindA, first)), motion);
      case 13 -> Measures.withinMatrix(a, b, number, new byte[draw.nextInt(100)]);
      case 14 -> Measures.suppressSoft(a, scores, new Measures.SoftSuppression(Decay.of(draw.nextInt(3)), number));
      case 15 -> Measures.signedDistanceMany(a, b, out);
      case 16 -> Measures.within(single(kindA, first), single(kindB, second), number);
      case 17 -> Measures.signedDistance(single(kindA, first), single(kindB, second));
      case 18 -> Topology.intersection(single(kindA, first), single(kindB, second));
      case 19 -> {
        String[] patterns = {"T*F**FFF*", "0123T*F**", "T*", "", "\0", null};
        Topology.matches(Topology.de9im(single(kindA, first), single(kindB, second)), patterns[draw.nextInt(6)]);
      }
      case 20 -> motion.cast(single(kindA, first), single(kindB, second));
      case 21 -> Motion.impactTime(single(kindA, first), turn(draw), single(kindB, second), turn(draw), number);
      default -> Index.fromBytes(new byte[draw.nextInt(900)], a);
    }
  }

  /** Capsules and rounded rectangles come seldom: many questions are not for them. */
  private static Kind kind(Random draw) {
    return Kind.of(draw.nextInt(draw.nextInt(4) == 0 ? 8 : 6));
  }

  private static double special(Random draw) {
    double[] all = {0, -0.0, 1, -1, 0.5, Double.NaN, Double.POSITIVE_INFINITY, 5e-324, 1.7e308, 1e-200};
    return all[draw.nextInt(all.length)];
  }

  private static Turn turn(Random draw) {
    return draw.nextInt(20) == 0 ? null : new Turn(draw.nextInt(9) - 4, draw.nextInt(5) - 2, special(draw));
  }

  /** The first shape of some numbers, or an exception if there is none. */
  private static Shape single(Kind kind, double[] numbers) {
    return Shape.of(kind, Arrays.copyOf(numbers, Math.min(numbers.length, Shapes.fields(kind))));
  }

  private static double[] some(Random draw, Kind kind) {
    double[] out = new double[draw.nextInt(4) == 0 ? draw.nextInt(40) : Shapes.fields(kind) * draw.nextInt(6)];
    Arrays.setAll(out, i -> draw.nextInt(40) == 0 ? special(draw) : draw.nextInt(9));
    return out;
  }

  private static Shapes scattered(int seed, int n, boolean wide) {
    Random random = new Random(seed);
    double[] numbers = new double[6 * n];
    for (int i = 0; i < 6 * n; i += 6) {
      double[] one = {300 * random.nextDouble(), 300 * random.nextDouble(), 1, random.nextDouble(), 0.5, 0.3};
      System.arraycopy(one, 0, numbers, i, 6);
    }
    if (seed == 2) numbers[4] = -1;
    if (wide) return Shapes.of(Kind.RECT, numbers);
    float[] narrow = new float[6 * n];
    for (int i = 0; i < narrow.length; i++) narrow[i] = (float) numbers[i];
    return Shapes.of(Kind.RECT, narrow);
  }

  private static void threads(boolean wide) {
    Shapes a = scattered(1, 60_000, wide), b = scattered(2, 70_000, wide);
    Index alone = new Index(a), other = new Index(b);
    long[][] pairs = alone.join(other, JoinQuery.OVERLAP);
    check(pairs[0].length > 60_000 && pairs[0].length == alone.joinCount(other, JoinQuery.OVERLAP), "pairs");
    for (int threads = 0; threads < 6; threads++) {
      Index first = Index.buildParallel(threads, a), second = Index.buildParallel(threads, b);
      check(Arrays.equals(first.bytes(), alone.bytes()), "bytes by " + threads + " threads");
      check(Arrays.equals(second.bytes(), other.bytes()), "bytes by " + threads + " threads");
      check(!first.incomplete() && second.incomplete(), "invalid shapes by " + threads + " threads");
      long[][] found = first.joinParallel(second, JoinQuery.OVERLAP, threads);
      check(Arrays.deepEquals(found, pairs), "pairs by " + threads + " threads");
    }
    refused(IllegalArgumentException.class, "-1 threads", () -> Index.buildParallel(-1, a));
    refused(IllegalArgumentException.class, "-1 threads", () -> alone.joinParallel(other, JoinQuery.OVERLAP, -1));
    Index odd = new Index(scattered(1, 9, !wide));
    refused(IllegalArgumentException.class, "double", () -> alone.joinParallel(odd, JoinQuery.OVERLAP, 3));
  }

  private static void detection(boolean wide) {
    Shapes a = scattered(3, 900, wide), b = scattered(4, 800, wide);
    Object matrix = wide ? new double[720_000] : new float[720_000];
    Measures.ratioMatrix(Ratio.OVER_SMALLER, a, b, matrix);
    double[] all = Index.doubles(matrix);
    Detection.Pairs pairs = new Index(a).joinRatio(new Index(b), Ratio.OVER_SMALLER, 0.25);
    check(pairs.values().length == Arrays.stream(all).filter(value -> value >= 0.25).count(), "sparse ratios");
    check(pairs.values().length > 3, "few sparse ratios");
    for (int k = 0; k < pairs.values().length; k++) {
      check(all[(int) (pairs.a()[k] * 800 + pairs.b()[k])] == pairs.values()[k], "a sparse ratio");
    }
    double[] values = {0.5, 0.75, 0.25, 0.625, Double.NaN};
    long[] first = {0, 5, 0, 5, 2}, second = {0, 0, 1, 1, 2};
    long[] chosen = Detection.assignGreedy(new Detection.Pairs(first, second, values));
    check(Arrays.equals(chosen, new long[] {1, 2}), "assignment");
    refused(IllegalArgumentException.class, "not 2, 5 and 5",
        () -> new Detection.Pairs(new long[2], second, values));

    double[] numbers = {0, 0, 4, 4, 0.5, 0, 4.5, 4, 20, 0, 24, 4}, scores = {0.75, 0.25, 0.5}, bad = {0.75, -1, 0.5};
    float[] narrow = {0, 0, 4, 4, 0.5f, 0, 4.5f, 4, 20, 0, 24, 4};
    Shapes boxes = Shapes.of(Kind.AABB, wide ? numbers : narrow);
    Object given = wide ? scores : new float[] {0.75f, 0.25f, 0.5f};
    Detection.Fused fused = Detection.fuse(boxes, given, new Detection.Fusion(0.55));
    double[] means = {0.125, 0, 4.125, 4, 20, 0, 24, 4};
    check(Arrays.equals(Index.doubles(fused.numbers()), means) && fused.boxes().count() == 2, "means");
    check(Arrays.equals(fused.scores(), new double[] {0.5, 0.5}), "scores");
    check(Arrays.equals(fused.clusters(), new long[] {0, 0, 1}), "clusters");
    Detection.Fusion labelled = new Detection.Fusion(0.5, null, new int[] {1, 2, 1}, FusedScore.MAX);
    check(Arrays.equals(Detection.fuse(boxes, given, labelled).clusters(), new long[] {0, 2, 1}), "labels");
    try {
      Detection.fuse(boxes, wide ? bad : new float[] {0.75f, -1, 0.5f}, new Detection.Fusion(0.55));
      check(false, "a negative score");
    } catch (VesicaException e) {
      long[] clusters = ((Detection.Fused) e.result()).clusters();
      check(Arrays.equals(clusters, new long[] {0, -1, 1}), "clusters without an invalid score");
    }
    refused(VesicaException.class, "kind",
        () -> Detection.fuse(THREE, new double[] {1, 1, 1}, new Detection.Fusion(0.5)));

    // Detection 1 is better than 0 and takes truth 0; 2 takes a crowd.
    Detection.Pairs hits =
        new Detection.Pairs(new long[] {0, 1, 2}, new long[] {0, 0, 1}, new double[] {0.875, 0.75, 0.875});
    Truth[] truths = {Truth.COUNTS, Truth.CROWD};
    Detection.Matches matches =
        Detection.matchTruths(MatchRule.COCO, hits, new double[] {0.5, 1, 0.25}, truths, 0.5, 0.8);
    check(Arrays.equals(matches.outcomes(), new byte[] {0, 1, 2, 1, 0, 2}), "outcomes");
    check(matches.outcome(2) == Outcome.IGNORED, "an outcome");
    check(Arrays.equals(matches.taken(), new long[] {-1, 0, 1, 0, -1, 1}), "taken");
    // One hit of two truths, after a miss: the best precision is 1/2 up to recall 1/2, then 0.
    double[] three = {0.5, 1, 2};
    check(Detection.averagePrecision(PrecisionRule.VOC_2010, three, new byte[] {1, 0, 2}, 2) == 0.25, "precision");
    check(Double.isNaN(Detection.averagePrecision(PrecisionRule.COCO, new double[0], new byte[0], 0)), "no truths");
    refused(IllegalArgumentException.class, "3 scores need as many outcomes, not 1",
        () -> Detection.averagePrecision(PrecisionRule.COCO, three, new byte[1], 1));
  }

  public static void main(String[] arguments) {
    buffersFirst();
    refusals();
    layouts();
    columnsOfOneBuffer();
    limits();
    measuresAndMotion();
    turns();
    topology();
    capsulesAndRoundedRectangles();
    nothingIsCopied();
    manyArrays();
    joinsTakeNoMemory();
    threads(true);
    threads(false);
    detection(true);
    detection(false);
    anyArguments(arguments.length > 0 ? Integer.parseInt(arguments[0]) : 5000);
    System.out.println("arguments: as they should be");
  }
}
