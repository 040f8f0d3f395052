// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;

/**
 * An index over arrays of shapes laid end to end: item i is shape i of the first array, and the next array's items
 * follow. It holds bounds: the numbers must stay as they were.
 */
public final class Index {
  private static final int ALIGNMENT = 64;
  private static final int PAIRS_A_CALL = 1 << 14;

  /** Each thread's, as large for any join: direct memory takes far longer to get than to use. */
  private static final ThreadLocal<ByteBuffer> JOIN_SCRATCH =
      ThreadLocal.withInitial(() -> aligned(checked(Native.joinScratch())));

  private final Sets sets;
  private final ByteBuffer memory;
  private final boolean incomplete;

  /** Items and their distances. */
  public record Neighbours(long[] items, double[] distances) {}

  /** Invalid shapes are left out; {@link #incomplete} tells. */
  public Index(Shapes... shapes) {
    this(1, new Sets(shapes));
  }

  private Index(int threads, Sets sets) {
    this.sets = sets;
    ByteBuffer room = aligned(checked(Native.indexSize(sets.count)));
    ByteBuffer scratch = aligned(checked(Native.indexScratch(sets.count)));
    long code = build(threads, sets, room, scratch);
    incomplete = code == ErrorCode.SHAPE.value;
    if (!incomplete) checked(code);
    int used = (int) checked(Native.indexBytes(room));
    memory = aligned(used).put(0, room, 0, used);
  }

  /**
   * An index built by so many threads, this one and some of the common pool; 0 stands for all processors, as far as
   * that pays. The bytes are the same.
   */
  public static Index buildParallel(int threads, Shapes... shapes) {
    Sets sets = new Sets(shapes);
    return new Index(Threads.count(threads, sets.count), sets);
  }

  private static long build(int threads, Sets sets, ByteBuffer room, ByteBuffer scratch) {
    int size = room.capacity(), scratchSize = scratch.capacity();
    if (threads == 1) return Native.indexBuild(sets.wide, sets, room, size, scratch, scratchSize);
    long code = 0;
    for (int step = 0; step <= 4 && code >= 0; step++) {
      int now = step, parts = step == 0 || step == 4 ? 1 : threads;
      long[] codes = new long[parts];
      Threads.eachPart(threads, parts, part -> codes[part] =
          Native.indexStep(sets.wide, now, part, parts, sets, room, size, scratch, scratchSize));
      code = Arrays.stream(codes).filter(each -> each < 0).findFirst().orElse(codes[0]);
    }
    return code;
  }

  private Index(byte[] bytes, Sets sets) {
    this.sets = sets;
    memory = aligned(bytes.length).put(0, bytes);
    incomplete = false;
    checked(Native.indexCheck(memory, bytes.length));
    long builtOf = checked(Native.indexCount(memory));
    if (builtOf != sets.count) {
      throw new IllegalArgumentException("an index of " + builtOf + " shapes cannot be that of " + sets.count);
    }
  }

  /** The index whose bytes were saved, over the same shapes. They are checked. */
  public static Index fromBytes(byte[] bytes, Shapes... shapes) {
    return new Index(bytes, new Sets(shapes));
  }

  private static ByteBuffer aligned(long size) {
    Vesica.room("a buffer of Java's", Integer.MAX_VALUE - 2 * ALIGNMENT, size);
    int room = (int) Math.max(size, 1);
    return ByteBuffer.allocateDirect(room + 2 * ALIGNMENT).alignedSlice(ALIGNMENT).slice(0, room);
  }

  /** A copy of the bytes, to be saved. */
  public byte[] bytes() {
    byte[] bytes = new byte[(int) checked(Native.indexBytes(memory))];
    memory.get(0, bytes);
    return bytes;
  }

  /** How many items there are, invalid shapes included. */
  public long count() {
    return sets.count;
  }

  /** Whether invalid shapes were left out. Bytes that were saved do not tell. */
  public boolean incomplete() {
    return incomplete;
  }

  /** A box around all valid shapes, a little larger than the smallest one. */
  public Aabb bounds() {
    double[] out = new double[4];
    checked(Native.indexBounds(memory, out));
    return Aabb.of(out);
  }

  /** The items in spatial order: arrays that are laid so are joined quicker. */
  public long[] order() {
    long[] out = new long[(int) sets.count];
    return Arrays.copyOf(out, (int) checked(Native.indexOrder(memory, out, out.length)));
  }

  /** The items that a single shape overlaps, in the index's order. */
  public long[] select(Shapes one) {
    Vesica.alike(sets.wide, one.wide);
    long found = checked(Native.indexSelect(sets.wide, memory, sets, one, null, 0, null));
    long[] out = new long[(int) found];
    if (found > 0) checked(Native.indexSelect(sets.wide, memory, sets, one, out, found, new long[4]));
    return out;
  }

  /**
   * The items that a single shape touches while it moves, in the index's order. With float shapes the motion is rounded
   * to float first.
   */
  public long[] cast(Shapes one, Motion how) {
    Vesica.alike(sets.wide, one.wide);
    double vx = how.vx(), vy = how.vy(), end = how.end();
    int found = (int) checked(Native.indexCast(sets.wide, memory, sets, one, vx, vy, end, null, 0, null));
    long[] out = new long[found];
    if (found > 0) checked(Native.indexCast(sets.wide, memory, sets, one, vx, vy, end, out, found, new long[4]));
    return out;
  }

  /**
   * The item that a single moving shape touches first, the lowest of several. With float shapes the motion is rounded
   * to float first.
   */
  public Optional<Motion.First> castFirst(Shapes one, Motion how) {
    Vesica.alike(sets.wide, one.wide);
    Object out = numbers(5);
    double vx = how.vx(), vy = how.vy(), end = how.end();
    return Motion.first(
        checked(Native.indexCastFirst(sets.wide, memory, sets, one, vx, vy, end, out)), sets.count, out);
  }

  /**
   * The k items nearest to a single shape, at most {@code within} away; infinity asks for any. With float shapes {@code
   * within} is rounded to float first.
   */
  public Neighbours nearest(Shapes one, int k, double within) {
    Vesica.alike(sets.wide, one.wide);
    if (k < 0) throw new IllegalArgumentException("k is " + k + ", not a count");
    int most = (int) Math.min(k, sets.count);
    long[] items = new long[most];
    Object distances = numbers(most);
    int found = (int) checked(Native.indexNearest(sets.wide, memory, sets, one, most, within, items, distances));
    int written = Math.min(found, most);
    return new Neighbours(Arrays.copyOf(items, written), Arrays.copyOf(doubles(distances), written));
  }

  /**
   * Of each shape of some arrays, the k nearest items: rows of k, one after the other, filled up by -1 at distance
   * infinity. Where a shape is invalid its row holds -1, and the exception has the result. With float shapes {@code
   * within} is rounded to float first.
   */
  public Neighbours nearestOfEach(int k, double within, Shapes... shapes) {
    Sets asked = new Sets(shapes);
    Vesica.alike(sets.wide, asked.wide);
    if (k < 1) throw new IllegalArgumentException("k is " + k + ", not 1 or more");
    int rows = Vesica.length((long) Vesica.length(asked.count) * k);
    long[] items = new long[rows];
    Object distances = numbers(rows);
    long code = Native.joinNearest(sets.wide, asked, memory, sets, k, within, 0, 1, items, distances);
    return VesicaException.finished(code, new Neighbours(items, doubles(distances)));
  }

  private Object numbers(int count) {
    return sets.wide ? new double[count] : new float[count];
  }

  static double[] doubles(Object numbers) {
    if (numbers instanceof double[] doubles) return doubles;
    float[] floats = (float[]) numbers;
    double[] out = new double[floats.length];
    for (int i = 0; i < out.length; i++) out[i] = floats[i];
    return out;
  }

  /** All pairs a &lt; b of items of this index that overlap. */
  public long[][] join() {
    return join(this, JoinQuery.OVERLAP);
  }

  /** All pairs of an item of this index and one of another: two arrays of items. With itself the pairs a &lt; b. */
  public long[][] join(Index other, JoinQuery query) {
    return join(other, query, 0, 1);
  }

  /** One of some parts of a join, which threads may ask at the same time. One after the other they are the join. */
  public long[][] join(Index other, JoinQuery query, long part, long parts) {
    return pairs((a, b, state) -> ask(other, query, part, parts, a, b, state));
  }

  /**
   * {@link #join} by so many threads, this one and some of the common pool; 0 stands for all processors, as far as that
   * pays. The pairs are the same, in the same order.
   */
  public long[][] joinParallel(Index other, JoinQuery query, int threads) {
    int count = Threads.count(threads, sets.count + other.sets.count);
    int parts = count == 1 ? 1 : Math.multiplyExact(8, count);  // some take longer than others
    long[][][] found = new long[parts][][];
    Threads.eachPart(count, parts, part -> found[part] = join(other, query, part, parts));
    return new long[][] {together(found, 0), together(found, 1)};
  }

  private static long[] together(long[][][] found, int side) {
    return Arrays.stream(found).flatMapToLong(pairs -> Arrays.stream(pairs[side])).toArray();
  }

  /**
   * All pairs of an item of this index and one of another that are at most {@code distance} apart, as {@link #join}
   * gives them. Of ellipses also those too near to it to tell. With float shapes {@code distance} is rounded to float
   * first.
   */
  public long[][] joinWithin(Index other, double distance) {
    Vesica.alike(sets.wide, other.sets.wide);
    return pairs((a, b, state) -> checked(
        Native.joinWithin(sets.wide, memory, sets, other.memory, other.sets, distance, 0, 1, a, b, a.length, state)));
  }

  private interface Pairs {
    long write(long[] a, long[] b, long[] state);
  }

  /** All pairs that a join writes in as many calls as it takes. */
  private static long[][] pairs(Pairs ask) {
    long[][] pairs = new long[2][PAIRS_A_CALL];
    long[] a = new long[PAIRS_A_CALL], b = new long[PAIRS_A_CALL], state = new long[4];
    int count = 0;
    while (state[0] != -1) {
      int found = (int) ask.write(a, b, state);
      for (int side = 0; side < 2; side++) {
        if (count + found > pairs[side].length) pairs[side] = Arrays.copyOf(pairs[side], 2 * (count + found));
        System.arraycopy(side == 0 ? a : b, 0, pairs[side], count, found);
      }
      count += found;
    }
    return new long[][] {Arrays.copyOf(pairs[0], count), Arrays.copyOf(pairs[1], count)};
  }

  /**
   * All pairs of an item of this index and one of another that overlap and whose ratio is at least {@code threshold},
   * in the order of {@link #join}. A pair without a ratio is left out. With float shapes {@code threshold} is rounded
   * to float first.
   */
  public Detection.Pairs joinRatio(Index other, Ratio ratio, double threshold) {
    Vesica.alike(sets.wide, other.sets.wide);
    ByteBuffer scratch = JOIN_SCRATCH.get();
    Object values = numbers(PAIRS_A_CALL);
    double[][] found = {new double[PAIRS_A_CALL]};
    int[] count = {0};
    long[][] pairs = pairs((a, b, state) -> {
      int n = (int) checked(Native.joinRatio(sets.wide, ratio.value, threshold, memory, sets, other.memory, other.sets,
          0, 1, scratch, scratch.capacity(), a, b, values, a.length, state));
      if (count[0] + n > found[0].length) found[0] = Arrays.copyOf(found[0], 2 * (count[0] + n));
      System.arraycopy(doubles(values), 0, found[0], count[0], n);
      count[0] += n;
      return n;
    });
    return new Detection.Pairs(pairs[0], pairs[1], Arrays.copyOf(found[0], count[0]));
  }

  /** How many pairs {@link #join} gives. */
  public long joinCount(Index other, JoinQuery query) {
    return ask(other, query, 0, 1, null, null, null);
  }

  private long ask(Index other, JoinQuery query, long part, long parts, long[] a, long[] b, long[] state) {
    Vesica.alike(sets.wide, other.sets.wide);
    ByteBuffer scratch = JOIN_SCRATCH.get();
    int room = a == null ? 0 : a.length;
    return checked(
        Native.join(sets.wide, query.value, memory, sets, other.memory, other.sets, part, parts, scratch,
            scratch.capacity(), a, b, room, state));
  }
}
