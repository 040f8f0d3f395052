// SPDX-License-Identifier: Apache-2.0

/** Exact overlap queries between plain 2D shapes, as arrays of their numbers. Touching counts. */
public final class Vesica {
  /** What this class was written to. */
  public static final int VERSION = 100;

  public static final int POINT = 0, SEGMENT = 1, CIRCLE = 2, AABB = 3, RECT = 4, ELLIPSE = 5;

  /** An error of the library. */
  public static final class VesicaException extends IllegalArgumentException {
    private static final long serialVersionUID = 1;
    public final int code;

    VesicaException(int code) {
      super(message(code));
      this.code = code;
    }
  }

  static {
    System.loadLibrary("vesica_jni");
    if (version() < VERSION) throw new UnsatisfiedLinkError("vesica " + version() + " is older than " + VERSION);
  }

  private Vesica() {}

  /** Do two shapes share a point? */
  public static boolean overlap(int kindA, double[] a, int kindB, double[] b) {
    return checked(overlap64(kindA, a, kindB, b)) == 1;
  }

  /** The same in float. */
  public static boolean overlap(int kindA, float[] a, int kindB, float[] b) {
    return checked(overlap32(kindA, a, kindB, b)) == 1;
  }

  /** How far apart are two shapes, and which of their points are closest? The distance, x and y of a's, of b's. */
  public static double[] nearest(int kindA, double[] a, int kindB, double[] b) {
    double[] out = new double[5];
    checked(nearest64(kindA, a, kindB, b, out));
    return out;
  }

  /**
   * Two arrays of shapes in step, their numbers one after the other; an array of one shape is repeated. Nothing is
   * copied. {@code out[i]} says whether they overlap; the result is how many do.
   *
   * @throws VesicaException a shape is invalid: then {@code out} has false for it and every other answer
   */
  public static long overlapMany(int kindA, double[] a, int kindB, double[] b, boolean[] out) {
    return checked(overlapMany64(kindA, a, kindB, b, out));
  }

  private static long checked(long answer) {
    if (answer < 0) throw new VesicaException((int) answer);
    return answer;
  }

  // vesica_jni.c
  private static native int version();
  private static native String message(int code);
  private static native int overlap64(int kindA, double[] a, int kindB, double[] b);
  private static native int nearest64(int kindA, double[] a, int kindB, double[] b, double[] out);
  private static native int overlap32(int kindA, float[] a, int kindB, float[] b);
  private static native long overlapMany64(int kindA, double[] a, int kindB, double[] b, boolean[] out);
}
