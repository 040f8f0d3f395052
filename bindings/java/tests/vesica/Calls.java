// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/**
 * The calls that all packages answer alike (bindings/calls/calls.txt), and that wrong answers among them are found. Single
 * shapes are double in this package: in float they are arrays of one, and where there are none, native calls.
 */
final class Calls {
  private static final List<String> KINDS = List.of("point", "segment", "circle", "aabb", "rect", "ellipse");

  private static final Set<String> MOTION = Set.of("sweep_bounds", "impact_time");

  private static final Set<String> TOPOLOGY =
      Set.of("de9im", "de9im_match", "intersection", "join_within", "suppress_soft");

  private final String function;
  private final boolean wide;
  private final String[] arguments;
  private double[] values = {};

  private Calls(String function, boolean wide, String[] arguments) {
    this.function = function;
    this.wide = wide;
    this.arguments = arguments;
  }

  private static double number(String word) {
    return switch (word) {
      case "nan", "-nan" -> Double.NaN;
      case "inf" -> Double.POSITIVE_INFINITY;
      case "-inf" -> Double.NEGATIVE_INFINITY;
      default -> Double.parseDouble(word);
    };
  }

  /** Those of an argument, without its kind. */
  private static double[] numbers(String argument) {
    var words = Arrays.stream(argument.trim().split(" ")).filter(word -> !KINDS.contains(word));
    return words.mapToDouble(Calls::number).toArray();
  }

  private static Kind kind(String argument) {
    return Kind.of(KINDS.indexOf(argument.trim().split(" ")[0]));
  }

  private static float[] narrow(double[] numbers) {
    float[] out = new float[numbers.length];
    for (int i = 0; i < out.length; i++) out[i] = (float) numbers[i];
    return out;
  }

  private static double[] widened(Object numbers) {
    if (numbers instanceof double[] doubles) return doubles;
    float[] floats = (float[]) numbers;
    double[] out = new double[floats.length];
    for (int i = 0; i < out.length; i++) out[i] = floats[i];
    return out;
  }

  private Object scalars(double[] numbers) {
    return wide ? numbers : narrow(numbers);
  }

  private Shapes shapes(String argument) {
    return Shapes.of(kind(argument), scalars(numbers(argument)));
  }

  private Shapes[] sets(List<String> arguments) {
    return arguments.stream().map(this::shapes).toArray(Shapes[]::new);
  }

  private Shape single(int i) {
    return Shape.of(kind(arguments[i]), numbers(arguments[i]));
  }

  private static double[] of(boolean[] booleans) {
    double[] out = new double[booleans.length];
    for (int i = 0; i < out.length; i++) out[i] = booleans[i] ? 1 : 0;
    return out;
  }

  private static double[] of(byte[] bytes) {
    double[] out = new double[bytes.length];
    for (int i = 0; i < out.length; i++) out[i] = bytes[i];
    return out;
  }

  private static double[] of(long... numbers) {
    return LongStream.of(numbers).asDoubleStream().toArray();
  }

  private static double[] joined(double[] a, double[] b) {
    return DoubleStream.concat(DoubleStream.of(a), DoubleStream.of(b)).toArray();
  }

  private long gives(double... numbers) {
    values = numbers;
    return 0;
  }

  // ---- Two shapes, or one ----

  private long inDouble() {
    Shape a = single(0), b = single(arguments.length - 1);
    return switch (function) {
      case "overlap" -> Vesica.overlap(a, b) ? 1 : 0;
      case "interiors_overlap" -> Vesica.interiorsOverlap(a, b) ? 1 : 0;
      case "relation" -> Vesica.relation(a, b).value;
      case "contains" -> Vesica.contains(a, b) ? 1 : 0;
      case "nearest" -> points(Vesica.nearest(a, b));
      case "boundary_distance" -> points(Vesica.boundaryDistance(a, b));
      case "depth" -> depth(Vesica.depth(a, b));
      case "signed_distance" -> gives(Measures.signedDistance(a, b));
      case "area" -> gives(Vesica.area(a, b));
      case "iou" -> gives(Vesica.iou(a, b));
      case "crossings" -> places(Vesica.crossings(a, b));
      case "check" -> {
        Vesica.check(a);
        yield 0;
      }
      case "shape_area" -> gives(Vesica.shapeArea(a));
      case "bounds" -> gives(Vesica.bounds(a).numbers());
      default -> throw new AssertionError(function);
    };
  }

  private long points(ClosestPoints p) {
    return gives(p.distance(), p.ax(), p.ay(), p.bx(), p.by());
  }

  private long depth(Penetration p) {
    return gives(p.depth(), p.x(), p.y());
  }

  private long places(Crossings crossings) {
    double[] shared = {crossings.shared() ? 1 : 0};
    gives(joined(shared, crossings.places().stream().flatMapToDouble(p -> DoubleStream.of(p.x(), p.y())).toArray()));
    return crossings.places().size();
  }

  private long inFloat() {
    int kind = kind(arguments[0]).value;
    float[] numbers = narrow(numbers(arguments[0])), out = new float[4];
    if (Set.of("check", "shape_area", "bounds", "crossings").contains(function)) {
      return VesicaException.checked(
          switch (function) {
            case "check" -> Native.checkF32(kind, numbers);
            case "shape_area" -> gives(Native.shapeAreaF32(kind, numbers, out), Arrays.copyOf(out, 1));
            case "bounds" -> gives(Native.boundsF32(kind, numbers, out), out);
            default -> crossingsInFloat(kind, numbers);
          });
    }
    Shapes a = shapes(arguments[0]), b = shapes(arguments[1]);
    float[][] columns = new float[5][1];
    boolean[] yes = new boolean[1];
    byte[] relation = new byte[1];
    return switch (function) {
      case "overlap" -> Vesica.overlapMany(a, b, yes);
      case "interiors_overlap" -> Vesica.interiorsOverlapMany(a, b, yes);
      case "contains" -> Vesica.containsMany(a, b, yes);
      case "relation" -> {
        Vesica.relationMany(a, b, relation);
        yield relation[0];
      }
      case "nearest" -> {
        Vesica.nearestMany(a, b, columns[0], columns[1], columns[2], columns[3], columns[4]);
        yield gives(0, columns);
      }
      case "boundary_distance" -> {
        Vesica.boundaryDistanceMany(a, b, columns[0], columns[1], columns[2], columns[3], columns[4]);
        yield gives(0, columns);
      }
      case "depth" -> {
        Vesica.depthMany(a, b, columns[0], columns[1], columns[2]);
        yield gives(0, Arrays.copyOf(columns, 3));
      }
      case "signed_distance" -> {
        Measures.signedDistanceMany(a, b, columns[0]);
        yield gives(0, columns[0]);
      }
      case "area" -> {
        Vesica.areaMany(a, b, columns[0]);
        yield gives(0, columns[0]);
      }
      case "iou" -> {
        Vesica.iouMany(a, b, columns[0]);
        yield gives(0, columns[0]);
      }
      default -> throw new AssertionError(function);
    };
  }

  private long crossingsInFloat(int kind, float[] numbers) {
    float[] places = new float[16];
    int[] shared = new int[1];
    float[] other = narrow(numbers(arguments[1]));
    long code = Native.crossingsF32(kind, numbers, kind(arguments[1]).value, other, places, 8, shared);
    double[] found = widened(Arrays.copyOf(places, (int) (2 * Math.max(code, 0))));
    values = joined(new double[] {shared[0]}, found);
    return code;
  }

  private long gives(long code, float[]... columns) {
    values = new double[0];
    for (float[] column : columns) values = joined(values, widened(column));
    return code;
  }

  private long misfit() {
    double[] corners = numbers(arguments[0]);
    if (wide) return gives(Vesica.rectCornersMisfit(corners, (Rect) single(1)));
    float[] out = {0};
    return VesicaException.checked(
        gives(Native.rectCornersMisfitF32(narrow(corners), narrow(numbers(arguments[1])), out), out));
  }

  private long constructor() {
    double[] n = numbers(arguments[0]);
    if (!wide) {
      int count =
          function.startsWith("aabb") ? 4 : function.startsWith("capsule") ? 5 : function.startsWith("round") ? 7 : 6;
      float[] f = narrow(n), out = new float[count];
      int code =
          switch (function) {
            case "aabb_from_corners" -> Native.aabbFromCornersF32(f[0], f[1], f[2], f[3], out);
            case "rect_from_angle" -> Native.rectFromAngleF32(f[0], f[1], f[2], f[3], f[4], out);
            case "rect_from_corners" -> Native.rectFromCornersF32(f, out);
            case "round_rect_from_angle" -> Native.roundRectFromAngleF32(f[0], f[1], f[2], f[3], f[4], f[5], out);
            case "capsule_from_angle" -> Native.capsuleFromAngleF32(f[0], f[1], f[2], f[3], f[4], out);
            case "capsule_from_width" -> Native.capsuleFromWidthF32(f[0], f[1], f[2], f[3], f[4], out);
            case "ellipse_from_angle" -> Native.ellipseFromAngleF32(f[0], f[1], f[2], f[3], f[4], out);
            case "ellipse_from_radius_vector" -> Native.ellipseFromRadiusVectorF32(f[0], f[1], f[2], f[3], f[4], out);
            case "ellipse_from_covariance" -> Native.ellipseFromCovarianceF32(f[0], f[1], f[2], f[3], f[4], f[5], out);
            default -> Native.ellipseFromMatrixF32(f[0], f[1], f[2], f[3], f[4], out);
          };
      return VesicaException.checked(gives(code, out));
    }
    Shape made =
        switch (function) {
          case "aabb_from_corners" -> Vesica.aabb(n[0], n[1], n[2], n[3]);
          case "rect_from_angle" -> Vesica.rect(n[0], n[1], n[2], n[3], n[4]);
          case "rect_from_corners" -> Vesica.rectFromCorners(n);
          case "round_rect_from_angle" -> Vesica.roundRect(n[0], n[1], n[2], n[3], n[4], n[5]);
          case "capsule_from_angle" -> Vesica.capsule(n[0], n[1], n[2], n[3], n[4]);
          case "capsule_from_width" -> Vesica.capsuleFromWidth(n[0], n[1], n[2], n[3], n[4]);
          case "ellipse_from_angle" -> Vesica.ellipse(n[0], n[1], n[2], n[3], n[4]);
          case "ellipse_from_radius_vector" -> Vesica.ellipseFromRadiusVector(n[0], n[1], n[2], n[3], n[4]);
          case "ellipse_from_covariance" -> Vesica.ellipseFromCovariance(n[0], n[1], n[2], n[3], n[4], n[5]);
          default -> Vesica.ellipseFromMatrix(n[0], n[1], n[2], n[3], n[4]);
        };
    return gives(made.numbers());
  }

  // ---- Arrays ----

  private long ofArrays() {
    Shapes a = shapes(arguments[0]), b = shapes(arguments[1]);
    int count = (int) (function.endsWith("_matrix") ? a.count() * b.count() : Math.max(a.count(), b.count()));
    boolean[] yes = new boolean[count];
    byte[] relations = new byte[count];
    Object[] columns = new Object[5];
    for (int i = 0; i < 5; i++) columns[i] = wide ? new double[count] : new float[count];
    long[] indices = new long[count + 1];
    Arrays.fill(indices, -1);
    int used = 0;
    try {
      switch (function) {
        case "overlap_many": return Vesica.overlapMany(a, b, yes);
        case "interiors_overlap_many": return Vesica.interiorsOverlapMany(a, b, yes);
        case "contains_many": return Vesica.containsMany(a, b, yes);
        case "relation_many": return Vesica.relationMany(a, b, relations);
        case "overlap_matrix": return Vesica.overlapMatrix(a, b, yes);
        case "interiors_overlap_matrix": return Vesica.interiorsOverlapMatrix(a, b, yes);
        case "contains_matrix": return Vesica.containsMatrix(a, b, yes);
        case "relation_matrix": return Vesica.relationMatrix(a, b, relations);
        case "overlap_select": return Vesica.overlapSelect(a, b, indices);
        case "interiors_overlap_select": return Vesica.interiorsOverlapSelect(a, b, indices);
        default: break;
      }
      boolean isOne = function.matches("(signed_distance|area|iou)_.*") || function.endsWith("_matrix");
      used = function.equals("depth_many") ? 3 : isOne ? 1 : 5;
      Object[] c = columns;
      return switch (function) {
        case "area_many" -> Vesica.areaMany(a, b, c[0]);
        case "iou_many" -> Vesica.iouMany(a, b, c[0]);
        case "area_matrix" -> Vesica.areaMatrix(a, b, c[0]);
        case "iou_matrix" -> Vesica.iouMatrix(a, b, c[0]);
        case "signed_distance_many" -> Measures.signedDistanceMany(a, b, c[0]);
        case "signed_distance_matrix" -> Measures.signedDistanceMatrix(a, b, c[0]);
        case "nearest_matrix" -> Vesica.nearestMatrix(a, b, c[0]);
        case "boundary_distance_matrix" -> Vesica.boundaryDistanceMatrix(a, b, c[0]);
        case "depth_matrix" -> Vesica.depthMatrix(a, b, c[0]);
        case "depth_many" -> Vesica.depthMany(a, b, c[0], c[1], c[2]);
        case "nearest_many" -> Vesica.nearestMany(a, b, c[0], c[1], c[2], c[3], c[4]);
        case "boundary_distance_many" -> Vesica.boundaryDistanceMany(a, b, c[0], c[1], c[2], c[3], c[4]);
        default -> throw new AssertionError(function);
      };
    } finally {
      if (function.endsWith("overlap_select")) {
        values = Arrays.stream(of(indices)).takeWhile(i -> i >= 0).toArray();
      } else if (used > 0) {
        values = new double[0];
        for (int i = 0; i < used; i++) values = joined(values, widened(columns[i]));
      } else {
        values = function.startsWith("relation") ? of(relations) : of(yes);
      }
    }
  }

  private Object column(int count) {
    return wide ? new double[count] : new float[count];
  }

  private long rows(Object out, Runnable call) {
    try {
      call.run();
    } finally {
      gives(widened(out));
    }
    return 0;
  }

  private long ofBoxes() {
    if (function.endsWith("from_boxes")) {
      int unit = (int) number(arguments[1]);
      Object boxes = scalars(numbers(arguments[0]));
      Angle angle = Angle.of(unit & 3);
      return gives(
          widened(
              function.startsWith("rects")
                  ? Boxes.rects(boxes, 5, angle, unit >= 4).base
                  : Boxes.ellipses(boxes, 5, angle, unit >= 4).base));
    }
    Shapes shapes = shapes(arguments[0]);
    int count = (int) shapes.count();
    Object boxes = column(5 * count), corners = column(8 * count), bounds = column(4 * count);
    return switch (function) {
      case "corners_of_shapes" -> rows(corners, () -> Boxes.corners(shapes, corners));
      case "bounds_many" -> rows(bounds, () -> Boxes.bounds(shapes, bounds));
      default -> {
        int unit = (int) number(arguments[1]);
        yield rows(boxes, () -> Boxes.of(shapes, Angle.of(unit & 3), unit >= 4, boxes));
      }
    };
  }

  private long impact(Impact i) {
    return gives(i.t(), i.x(), i.y(), i.nx(), i.ny());
  }

  private long first(Optional<Motion.First> found, long count) {
    double nan = Double.NaN;
    impact(found.map(Motion.First::impact).orElse(new Impact(Double.POSITIVE_INFINITY, nan, nan, nan, nan)));
    return found.map(Motion.First::item).orElse(count);
  }

  private static Turn turn(double[] n) {
    return new Turn(n[0], n[1], n[2]);
  }

  private long ofTurns() {
    double[] turnA = numbers(arguments[1]), turnB = numbers(arguments[3]);
    double tolerance = numbers(arguments[4])[0];
    if (wide) {
      Motion.ImpactTime found = Motion.impactTime(single(0), turn(turnA), single(2), turn(turnB), tolerance);
      impact(found.impact());
      values = joined(values, new double[] {found.gap()});
      return found.cast().value;
    }
    // Single shapes are double in this package: this is a native call.
    float[] a = narrow(numbers(arguments[0])), b = narrow(numbers(arguments[2])), out = new float[5], gap = {0};
    int kindA = kind(arguments[0]).value, kindB = kind(arguments[2]).value;
    float[] byA = narrow(turnA), byB = narrow(turnB);
    int code = Native.impactTimeF32(kindA, a, byA, kindB, b, byB, (float) tolerance, out, gap);
    return VesicaException.checked(gives(code, out, gap));
  }

  private long ofMotion() {
    if (function.equals("impact_time")) return ofTurns();
    if (function.equals("cast_many")) {
      Shapes a = shapes(arguments[0]), b = shapes(arguments[1]);
      Object[] c = new Object[5];
      Arrays.setAll(c, i -> column((int) Math.max(a.count(), b.count())));
      Object vx = scalars(numbers(arguments[2])), vy = scalars(numbers(arguments[3]));
      try {
        return Motion.castMany(a, b, vx, vy, numbers(arguments[4])[0], c[0], c[1], c[2], c[3], c[4]);
      } finally {
        values = Arrays.stream(c).map(Calls::widened).flatMapToDouble(DoubleStream::of).toArray();
      }
    }
    double[] n = numbers(arguments[function.equals("cast") || function.equals("cast_first") ? 2 : 1]);
    Motion motion = new Motion(n[0], n[1], n[2]);
    switch (function) {
      case "cast_first":
        Shapes many = shapes(arguments[1]);
        return first(motion.castFirst(shapes(arguments[0]), many), many.count());
      case "sweep_bounds": return wide ? gives(motion.bounds(single(0)).numbers()) : motionInFloat(n, new float[4]);
      case "cast": return wide ? contact(motion.cast(single(0), single(1))) : motionInFloat(n, new float[5]);
      default: break;
    }
    Index index = new Index(sets(Arrays.asList(arguments).subList(2, arguments.length)));
    Shapes one = shapes(arguments[0]);
    if (function.equals("index_cast")) return items(index.cast(one, motion));
    return first(index.castFirst(one, motion), index.count());
  }

  private long contact(Motion.Contact contact) {
    impact(contact.impact());
    return contact.cast().value;
  }

  private long motionInFloat(double[] n, float[] out) {
    int kind = kind(arguments[0]).value;
    float[] a = narrow(numbers(arguments[0])), b = narrow(numbers(arguments[1]));
    int code =
        function.equals("sweep_bounds")
            ? Native.sweepBounds(false, kind, a, n[0], n[1], n[2], out)
            : Native.cast(false, kind, a, kind(arguments[1]).value, b, n[0], n[1], n[2], out);
    gives(widened(out));
    return VesicaException.checked(code);
  }

  private long ofRatios() {
    Ratio ratio = Ratio.of((int) number(arguments[0]));
    if (function.equals("ratio") && wide) return gives(Measures.ratio(ratio, single(1), single(2)));
    Shapes a = shapes(arguments[1]), b = shapes(arguments[2]);
    boolean isMatrix = function.endsWith("_matrix");
    Object out = column((int) (isMatrix ? a.count() * b.count() : Math.max(a.count(), b.count())));
    try {
      long above = isMatrix ? Measures.ratioMatrix(ratio, a, b, out) : Measures.ratioMany(ratio, a, b, out);
      return function.equals("ratio") ? 0 : above;
    } finally {
      gives(widened(out));
    }
  }

  private long ofTopology() {
    switch (function) {
      case "de9im_match": return Topology.matches(arguments[0], arguments[1].trim()) ? 1 : 0;
      case "join_within": {
        List<String> rest = Arrays.asList(arguments);
        int slash = rest.indexOf("/");
        Index a = new Index(sets(rest.subList(1, slash)));
        Index b = slash == rest.size() - 1 ? a : new Index(sets(rest.subList(slash + 1, rest.size())));
        long[][] pairs = a.joinWithin(b, numbers(arguments[0])[0]);
        values = new double[2 * pairs[0].length];
        for (int i = 0; i < values.length; i++) values[i] = pairs[i % 2][i / 2];
        return pairs[0].length;
      }
      case "within_many": return nearby(Math.max(shapes(arguments[0]).count(), shapes(arguments[1]).count()));
      case "within_matrix": return nearby(shapes(arguments[0]).count() * shapes(arguments[1]).count());
      case "suppress_soft": return softly();
      default: return wide ? topologyInDouble() : topologyInFloat();
    }
  }

  private long nearby(long count) {
    Shapes a = shapes(arguments[0]), b = shapes(arguments[1]);
    double distance = numbers(arguments[2])[0];
    byte[] out = new byte[(int) count];
    try {
      boolean isMatrix = function.equals("within_matrix");
      return isMatrix ? Measures.withinMatrix(a, b, distance, out) : Measures.withinMany(a, b, distance, out);
    } finally {
      values = of(out);
    }
  }

  private long softly() {
    double[] how = numbers(arguments[2]);
    int[] labels = arguments.length < 4 ? null : Arrays.stream(numbers(arguments[3])).mapToInt(x -> (int) x).toArray();
    Measures.SoftSuppression soft = new Measures.SoftSuppression(
        Decay.of((int) how[1]), how[2], Ratio.of((int) how[0]), labels, how[3], (long) how[4]);
    return kept(Measures.suppressSoft(shapes(arguments[0]), scalars(numbers(arguments[1])), soft));
  }

  private long kept(Measures.Kept kept) {
    return gives(joined(of(kept.items()), kept.scores()));
  }

  private static double[] matrix(byte[] letters) {
    double[] out = new double[9];
    for (int i = 0; i < 9; i++) out[i] = letters[i] == 'F' ? -1 : letters[i] - '0';
    return out;
  }

  private long topologyInDouble() {
    Shape a = single(0), b = single(1);
    if (function.equals("within")) return Measures.within(a, b, numbers(arguments[2])[0]).value;
    if (function.equals("de9im")) return gives(matrix(Topology.de9im(a, b).getBytes()));
    List<Point> vertices = Topology.intersection(a, b);
    gives(vertices.stream().flatMapToDouble(p -> DoubleStream.of(p.x(), p.y())).toArray());
    return vertices.size();
  }

  /** Single shapes are double in this package: these are native calls. */
  private long topologyInFloat() {
    int kindA = kind(arguments[0]).value, kindB = kind(arguments[1]).value;
    float[] a = narrow(numbers(arguments[0])), b = narrow(numbers(arguments[1])), vertices = new float[16];
    byte[] letters = new byte[10];
    if (function.equals("within")) {
      return VesicaException.checked(Native.within(false, kindA, a, kindB, b, numbers(arguments[2])[0]));
    }
    if (function.equals("de9im")) {
      VesicaException.checked(Native.de9imF32(kindA, a, kindB, b, letters));
      return gives(matrix(letters));
    }
    long count = VesicaException.checked(Native.intersectionF32(kindA, a, kindB, b, vertices, 8));
    gives(Arrays.copyOf(widened(vertices), 2 * (int) count));
    return count;
  }

  private long chosen() {
    double[] how = numbers(arguments[2]);
    int[] labels = arguments.length < 4 ? null : Arrays.stream(numbers(arguments[3])).mapToInt(x -> (int) x).toArray();
    Ratio ratio = Ratio.of((int) how[0]);
    Measures.Suppression suppression = new Measures.Suppression(how[1], ratio, labels, how[2], (long) how[3]);
    return gives(of(Measures.suppress(shapes(arguments[0]), scalars(numbers(arguments[1])), suppression)));
  }

  private long suppression() {
    long[] kept = Vesica.nms(shapes(arguments[0]), scalars(numbers(arguments[1])), numbers(arguments[2])[0]);
    return gives(of(kept));
  }

  // ---- Indexes ----

  private long ofIndexes() {
    boolean hasOne = function.equals("index_select") || function.startsWith("join");
    int leading = function.equals("index_nearest") ? 2 : hasOne ? 1 : 0;
    List<String> rest = Arrays.asList(arguments).subList(leading, arguments.length);
    int slash = rest.indexOf("/");
    Shapes[] setsA = sets(slash < 0 ? rest : rest.subList(0, slash));
    Index a = Index.fromBytes(new Index(setsA).bytes(), setsA);
    Index b = slash < 0 || slash == rest.size() - 1 ? a : new Index(sets(rest.subList(slash + 1, rest.size())));
    return switch (function) {
      case "index_bounds" -> gives(a.bounds().numbers());
      case "index_order" -> items(a.order());
      case "index_select" -> items(a.select(shapes(arguments[0])));
      case "index_nearest" -> {
        double[] how = numbers(arguments[1]);
        Index.Neighbours found = a.nearest(shapes(arguments[0]), (int) how[0], how[1]);
        gives(joined(of(found.items()), found.distances()));
        yield found.items().length;
      }
      case "join" -> {
        long[][] pairs = a.join(b, JoinQuery.of((int) number(arguments[0])));
        if (a.joinCount(b, JoinQuery.of((int) number(arguments[0]))) != pairs[0].length) throw new AssertionError();
        values = new double[2 * pairs[0].length];
        for (int i = 0; i < values.length; i++) values[i] = pairs[i % 2][i / 2];
        yield pairs[0].length;
      }
      case "join_nearest" -> {
        double[] how = numbers(arguments[0]);
        Index.Neighbours found = b.nearestOfEach((int) how[0], how[1], setsA);
        gives(joined(of(found.items()), found.distances()));
        yield LongStream.of(found.items()).filter(item -> item >= 0).count();
      }
      default -> throw new AssertionError(function);
    };
  }

  private long items(long[] items) {
    gives(of(items));
    return items.length;
  }

  private long answer() {
    if (function.contains("boxes") || Set.of("corners_of_shapes", "bounds_many").contains(function)) return ofBoxes();
    if (function.contains("cast") || MOTION.contains(function)) return ofMotion();
    if (function.startsWith("ratio")) return ofRatios();
    if (function.equals("suppress")) return chosen();
    if (function.startsWith("within") || TOPOLOGY.contains(function)) return ofTopology();
    if (function.contains("_from_")) return constructor();
    if (function.equals("rect_corners_misfit")) return misfit();
    if (function.equals("nms")) return suppression();
    if (function.startsWith("index_") || function.startsWith("join")) return ofIndexes();
    if (function.endsWith("_many") || function.endsWith("_matrix") || function.endsWith("_select")) return ofArrays();
    return wide ? inDouble() : inFloat();
  }

  private static boolean same(double[] given, double[] expected) {
    // NaN has one form here, and 0 and -0 are two.
    return Arrays.equals(given, expected);
  }

  static boolean isRight(String line) {
    String[] sides = line.split(" = ");
    String[] parts = sides[0].split(" \\| ");
    String[] name = parts[0].split(" ");
    Calls call = new Calls(name[0], name[1].equals("f64"), Arrays.copyOfRange(parts, 1, parts.length));
    String[] right = sides[1].split(" ");
    double[] expected = Arrays.stream(right).skip(1).mapToDouble(Calls::number).toArray();
    try {
      return String.valueOf(call.answer()).equals(right[0]) && same(call.values, expected);
    } catch (VesicaException e) {
      if (e.result() instanceof long[] kept) call.gives(of(kept));
      if (e.result() instanceof Measures.Kept kept) call.kept(kept);
      if (e.result() instanceof Shapes shapes) call.gives(widened(shapes.base));
      if (e.result() instanceof Index.Neighbours found) call.gives(joined(of(found.items()), found.distances()));
      return right[0].equals("E_" + e.errorCode()) && (expected.length == 0 || same(call.values, expected));
    } catch (NumberFormatException e) {
      return false;
    }
  }

  public static void main(String[] files) throws Exception {
    List<String> lines = new ArrayList<>(Files.readAllLines(Path.of(files[0])));
    lines.removeIf(line -> line.startsWith("#"));
    List<String> wrong = lines.stream().filter(line -> !isRight(line)).toList();
    if (!wrong.isEmpty()) throw new AssertionError(String.join("\n", wrong));
    // The first call of each function, with its last word made what no call gives.
    Set<String> functions = new HashSet<>();
    for (String line : lines) {
      String spoilt = line.substring(0, line.lastIndexOf(' ')) + " 7.5";
      if (functions.add(line.split(" ")[0]) && isRight(spoilt)) throw new AssertionError("taken for right: " + spoilt);
    }
    if (lines.size() < 700 || functions.size() < 70) throw new AssertionError("too few");
    System.out.println(lines.size() + " calls of " + functions.size() + " functions");
  }
}
