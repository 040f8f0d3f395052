// SPDX-License-Identifier: Apache-2.0
package vesica;

/** What the library refuses. */
public final class VesicaException extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  /** The library's number, VESICA_E_... */
  public final int code;

  private final transient Object result;

  VesicaException(int code) {
    this(code, null);
  }

  VesicaException(int code, Object result) {
    super(Native.strerror(code));
    this.code = code;
    this.result = result;
  }

  /**
   * After an invalid shape what {@link Vesica#nms}, {@link Boxes#rects}, {@link Index#nearestOfEach} and
   * {@link Detection#fuse} have for all others, else null. What is written to arrays of the caller's is there.
   */
  public Object result() {
    return result;
  }

  /** What the number stands for; null if it is newer than this package. */
  public ErrorCode errorCode() {
    return ErrorCode.of(code);
  }

  /** A result, unless its code is an error. */
  static <T> T finished(long code, T result) {
    boolean isWritten = code == ErrorCode.SHAPE.value || code == ErrorCode.RANGE.value;
    if (code < 0) throw new VesicaException((int) code, isWritten ? result : null);
    return result;
  }

  /** The answer, if it is one. */
  static long checked(long answer) {
    if (answer < 0) throw new VesicaException((int) answer);
    return answer;
  }
}
