/* SPDX-License-Identifier: Apache-2.0 */
/* Written by bindings/declare from capi/vesica.json: not to be edited. */
#include "lend.h"

JNIEXPORT jint JNICALL Java_vesica_Native_version(JNIEnv* env, jclass type) {
  (void)env, (void)type;
  return vesica_version();
}

JNIEXPORT jint JNICALL Java_vesica_Native_versionMajor(JNIEnv* env, jclass type) {
  (void)env, (void)type;
  return vesica_version_major();
}

JNIEXPORT jint JNICALL Java_vesica_Native_versionMinor(JNIEnv* env, jclass type) {
  (void)env, (void)type;
  return vesica_version_minor();
}

JNIEXPORT jint JNICALL Java_vesica_Native_versionPatch(JNIEnv* env, jclass type) {
  (void)env, (void)type;
  return vesica_version_patch();
}

JNIEXPORT jstring JNICALL Java_vesica_Native_strerror(JNIEnv* env, jclass type, jint code) {
  (void)type;
  return (*env)->NewStringUTF(env, vesica_strerror(code));
}

JNIEXPORT jint JNICALL Java_vesica_Native_fieldCount(JNIEnv* env, jclass type, jint kind) {
  (void)env, (void)type;
  return vesica_field_count(kind);
}

JNIEXPORT jstring JNICALL Java_vesica_Native_kindName(JNIEnv* env, jclass type, jint kind) {
  (void)type;
  return (*env)->NewStringUTF(env, vesica_kind_name(kind));
}

JNIEXPORT jint JNICALL Java_vesica_Native_checkF64(JNIEnv* env, jclass type, jint kind, jobject numbers) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_check_f64(kind, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_overlapF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_overlap_f64(kindA, held[0].address, kindB, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_relationF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_relation_f64(kindA, held[0].address, kindB, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_containsF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_contains_f64(kindA, held[0].address, kindB, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_crossingsF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_crossings_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_nearestF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_nearest_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_boundaryDistanceF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_boundary_distance_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_depthF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_depth_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_shapeAreaF64(JNIEnv* env, jclass type, jint kind, jobject numbers,
    jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_shape_area_f64(kind, held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_areaF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_area_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_iouF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_iou_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_boundsF64(JNIEnv* env, jclass type, jint kind, jobject numbers, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_bounds_f64(kind, held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_aabbFromCornersF64(JNIEnv* env, jclass type, jdouble x0, jdouble y0,
    jdouble x1, jdouble y1, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_aabb_from_corners_f64(x0, y0, x1, y1, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_rectFromAngleF64(JNIEnv* env, jclass type, jdouble cx, jdouble cy,
    jdouble angle, jdouble width, jdouble height, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_rect_from_angle_f64(cx, cy, angle, width, height, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_rectFromCornersF64(JNIEnv* env, jclass type, jobject corners, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, corners, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_rect_from_corners_f64(held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromAngleF64(JNIEnv* env, jclass type, jdouble cx, jdouble cy,
    jdouble angle, jdouble a, jdouble b, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromRadiusVectorF64(JNIEnv* env, jclass type, jdouble cx, jdouble cy,
    jdouble wx, jdouble wy, jdouble ratio, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromCovarianceF64(JNIEnv* env, jclass type, jdouble meanX,
    jdouble meanY, jdouble cxx, jdouble cxy, jdouble cyy, jdouble k, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_covariance_f64(meanX, meanY, cxx, cxy, cyy, k, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromMatrixF64(JNIEnv* env, jclass type, jdouble cx, jdouble cy,
    jdouble mxx, jdouble mxy, jdouble myy, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_overlapManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_overlap_many_f64(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_relationManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_relation_many_f64(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_containsManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_contains_many_f64(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_nearestManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject distance, jobject ax, jobject ay, jobject bx, jobject by) {
  lent held[7];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, distance, &held[2]);
  prepare(env, ax, &held[3]);
  prepare(env, ay, &held[4]);
  prepare(env, bx, &held[5]);
  prepare(env, by, &held[6]);
  if (lend(env, held, 7)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_nearest_many_f64(&a, &b, held[2].address, held[3].address, held[4].address, held[5].address,
        held[6].address);
  }
  give_back(env, held, 7);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boundaryDistanceManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject distance, jobject ax, jobject ay, jobject bx, jobject by) {
  lent held[7];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, distance, &held[2]);
  prepare(env, ax, &held[3]);
  prepare(env, ay, &held[4]);
  prepare(env, bx, &held[5]);
  prepare(env, by, &held[6]);
  if (lend(env, held, 7)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_boundary_distance_many_f64(&a, &b, held[2].address, held[3].address, held[4].address,
        held[5].address, held[6].address);
  }
  give_back(env, held, 7);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_depthManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject depth, jobject x, jobject y) {
  lent held[5];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, depth, &held[2]);
  prepare(env, x, &held[3]);
  prepare(env, y, &held[4]);
  if (lend(env, held, 5)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_depth_many_f64(&a, &b, held[2].address, held[3].address, held[4].address);
  }
  give_back(env, held, 5);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_areaManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_area_many_f64(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_iouManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount, jlong aStride,
    jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase, jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_iou_many_f64(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_overlapMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_overlap_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_relationMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_relation_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_containsMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_contains_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_areaMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_area_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_iouMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_iou_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_overlapSelectF64(JNIEnv* env, jclass type, jint oneKind, jlong oneCount,
    jlong oneStride, jlong oneStep, jobject oneBase, jint manyKind, jlong manyCount, jlong manyStride, jlong manyStep,
    jobject manyBase, jobject out, jlong capacity) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, oneBase, &held[0]);
  prepare(env, manyBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[0].address, double);
    vesica_shapes_f64 many;
    VIEW(many, manyKind, manyCount, manyStride, manyStep, held[1].address, double);
    answer = vesica_overlap_select_f64(&one, &many, held[2].address, capacity);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_nmsScratch(JNIEnv* env, jclass type, jlong count) {
  (void)env, (void)type;
  return vesica_nms_scratch(count);
}

JNIEXPORT jint JNICALL Java_vesica_Native_nmsF64(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject scores, jdouble threshold, jobject scratch,
    jlong scratchSize, jobject keep, jobject kept) {
  lent held[5];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, scores, &held[1]);
  prepare(env, scratch, &held[2]);
  prepare(env, keep, &held[3]);
  prepare(env, kept, &held[4]);
  if (lend(env, held, 5)) {
    vesica_shapes_f64 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, double);
    answer = vesica_nms_f64(&shapes, held[1].address, threshold, held[2].address, scratchSize, held[3].address,
        held[4].address);
  }
  give_back(env, held, 5);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_checkF32(JNIEnv* env, jclass type, jint kind, jobject numbers) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_check_f32(kind, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_overlapF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_overlap_f32(kindA, held[0].address, kindB, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_relationF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_relation_f32(kindA, held[0].address, kindB, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_containsF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_contains_f32(kindA, held[0].address, kindB, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_crossingsF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_crossings_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_nearestF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_nearest_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_boundaryDistanceF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_boundary_distance_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_depthF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_depth_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_shapeAreaF32(JNIEnv* env, jclass type, jint kind, jobject numbers,
    jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_shape_area_f32(kind, held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_areaF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_area_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_iouF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_iou_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_boundsF32(JNIEnv* env, jclass type, jint kind, jobject numbers, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_bounds_f32(kind, held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_aabbFromCornersF32(JNIEnv* env, jclass type, jfloat x0, jfloat y0, jfloat x1,
    jfloat y1, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_aabb_from_corners_f32(x0, y0, x1, y1, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_rectFromAngleF32(JNIEnv* env, jclass type, jfloat cx, jfloat cy, jfloat angle,
    jfloat width, jfloat height, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_rect_from_angle_f32(cx, cy, angle, width, height, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_rectFromCornersF32(JNIEnv* env, jclass type, jobject corners, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, corners, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_rect_from_corners_f32(held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromAngleF32(JNIEnv* env, jclass type, jfloat cx, jfloat cy,
    jfloat angle, jfloat a, jfloat b, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_angle_f32(cx, cy, angle, a, b, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromRadiusVectorF32(JNIEnv* env, jclass type, jfloat cx, jfloat cy,
    jfloat wx, jfloat wy, jfloat ratio, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_radius_vector_f32(cx, cy, wx, wy, ratio, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromCovarianceF32(JNIEnv* env, jclass type, jfloat meanX, jfloat meanY,
    jfloat cxx, jfloat cxy, jfloat cyy, jfloat k, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_covariance_f32(meanX, meanY, cxx, cxy, cyy, k, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ellipseFromMatrixF32(JNIEnv* env, jclass type, jfloat cx, jfloat cy,
    jfloat mxx, jfloat mxy, jfloat myy, jobject out) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, out, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_ellipse_from_matrix_f32(cx, cy, mxx, mxy, myy, held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_overlapManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_overlap_many_f32(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_relationManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_relation_many_f32(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_containsManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_contains_many_f32(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_nearestManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject distance, jobject ax, jobject ay, jobject bx, jobject by) {
  lent held[7];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, distance, &held[2]);
  prepare(env, ax, &held[3]);
  prepare(env, ay, &held[4]);
  prepare(env, bx, &held[5]);
  prepare(env, by, &held[6]);
  if (lend(env, held, 7)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_nearest_many_f32(&a, &b, held[2].address, held[3].address, held[4].address, held[5].address,
        held[6].address);
  }
  give_back(env, held, 7);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boundaryDistanceManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject distance, jobject ax, jobject ay, jobject bx, jobject by) {
  lent held[7];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, distance, &held[2]);
  prepare(env, ax, &held[3]);
  prepare(env, ay, &held[4]);
  prepare(env, bx, &held[5]);
  prepare(env, by, &held[6]);
  if (lend(env, held, 7)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_boundary_distance_many_f32(&a, &b, held[2].address, held[3].address, held[4].address,
        held[5].address, held[6].address);
  }
  give_back(env, held, 7);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_depthManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject depth, jobject x, jobject y) {
  lent held[5];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, depth, &held[2]);
  prepare(env, x, &held[3]);
  prepare(env, y, &held[4]);
  if (lend(env, held, 5)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_depth_many_f32(&a, &b, held[2].address, held[3].address, held[4].address);
  }
  give_back(env, held, 5);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_areaManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_area_many_f32(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_iouManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount, jlong aStride,
    jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase, jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_iou_many_f32(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_overlapMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_overlap_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_relationMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_relation_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_containsMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_contains_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_areaMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_area_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_iouMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_iou_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_overlapSelectF32(JNIEnv* env, jclass type, jint oneKind, jlong oneCount,
    jlong oneStride, jlong oneStep, jobject oneBase, jint manyKind, jlong manyCount, jlong manyStride, jlong manyStep,
    jobject manyBase, jobject out, jlong capacity) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, oneBase, &held[0]);
  prepare(env, manyBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[0].address, float);
    vesica_shapes_f32 many;
    VIEW(many, manyKind, manyCount, manyStride, manyStep, held[1].address, float);
    answer = vesica_overlap_select_f32(&one, &many, held[2].address, capacity);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_nmsF32(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject scores, jfloat threshold, jobject scratch,
    jlong scratchSize, jobject keep, jobject kept) {
  lent held[5];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, scores, &held[1]);
  prepare(env, scratch, &held[2]);
  prepare(env, keep, &held[3]);
  prepare(env, kept, &held[4]);
  if (lend(env, held, 5)) {
    vesica_shapes_f32 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, float);
    answer = vesica_nms_f32(&shapes, held[1].address, threshold, held[2].address, scratchSize, held[3].address,
        held[4].address);
  }
  give_back(env, held, 5);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_rectsFromBoxesF64(JNIEnv* env, jclass type, jobject boxes, jlong count,
    jlong stride, jint angle, jobject out) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, boxes, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_rects_from_boxes_f64(held[0].address, count, stride, angle, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_ellipsesFromBoxesF64(JNIEnv* env, jclass type, jobject boxes, jlong count,
    jlong stride, jint angle, jobject out) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, boxes, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_ellipses_from_boxes_f64(held[0].address, count, stride, angle, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boxesFromShapesF64(JNIEnv* env, jclass type, jint shapesKind,
    jlong shapesCount, jlong shapesStride, jlong shapesStep, jobject shapesBase, jint angle, jobject boxes) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, boxes, &held[1]);
  if (lend(env, held, 2)) {
    vesica_shapes_f64 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, double);
    answer = vesica_boxes_from_shapes_f64(&shapes, angle, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_cornersOfShapesF64(JNIEnv* env, jclass type, jint shapesKind,
    jlong shapesCount, jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject corners) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, corners, &held[1]);
  if (lend(env, held, 2)) {
    vesica_shapes_f64 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, double);
    answer = vesica_corners_of_shapes_f64(&shapes, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boundsManyF64(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject out) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    vesica_shapes_f64 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, double);
    answer = vesica_bounds_many_f64(&shapes, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_rectsFromBoxesF32(JNIEnv* env, jclass type, jobject boxes, jlong count,
    jlong stride, jint angle, jobject out) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, boxes, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_rects_from_boxes_f32(held[0].address, count, stride, angle, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_ellipsesFromBoxesF32(JNIEnv* env, jclass type, jobject boxes, jlong count,
    jlong stride, jint angle, jobject out) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, boxes, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_ellipses_from_boxes_f32(held[0].address, count, stride, angle, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boxesFromShapesF32(JNIEnv* env, jclass type, jint shapesKind,
    jlong shapesCount, jlong shapesStride, jlong shapesStep, jobject shapesBase, jint angle, jobject boxes) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, boxes, &held[1]);
  if (lend(env, held, 2)) {
    vesica_shapes_f32 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, float);
    answer = vesica_boxes_from_shapes_f32(&shapes, angle, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_cornersOfShapesF32(JNIEnv* env, jclass type, jint shapesKind,
    jlong shapesCount, jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject corners) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, corners, &held[1]);
  if (lend(env, held, 2)) {
    vesica_shapes_f32 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, float);
    answer = vesica_corners_of_shapes_f32(&shapes, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boundsManyF32(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject out) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    vesica_shapes_f32 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, float);
    answer = vesica_bounds_many_f32(&shapes, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexSize(JNIEnv* env, jclass type, jlong count) {
  (void)env, (void)type;
  return vesica_index_size(count);
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexScratch(JNIEnv* env, jclass type, jlong count) {
  (void)env, (void)type;
  return vesica_index_scratch(count);
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinScratch(JNIEnv* env, jclass type) {
  (void)env, (void)type;
  return vesica_join_scratch();
}

JNIEXPORT jint JNICALL Java_vesica_Native_indexCheck(JNIEnv* env, jclass type, jobject index, jlong size) {
  lent held[1];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_index_check(held[0].address, size);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexBytes(JNIEnv* env, jclass type, jobject index) {
  lent held[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_index_bytes(held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexCount(JNIEnv* env, jclass type, jobject index) {
  lent held[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (lend(env, held, 1)) {
    answer = vesica_index_count(held[0].address);
  }
  give_back(env, held, 1);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_indexBounds(JNIEnv* env, jclass type, jobject index, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_index_bounds(held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexOrder(JNIEnv* env, jclass type, jobject index, jobject out,
    jlong capacity) {
  lent held[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_index_order(held[0].address, held[1].address, capacity);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexBuildF64(JNIEnv* env, jclass type, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jobject index,
    jlong indexSize, jobject scratch, jlong scratchSize) {
  lent held[2];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, index, &held[0]);
  prepare(env, scratch, &held[1]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 2)) {
    vesica_shapes_f64 sets[MAX_SETS];
    SETS(sets, lent_to[0], double);
    answer = vesica_index_build_f64(sets, lent_to[0].count, held[0].address, indexSize, held[1].address, scratchSize);
  }
  give_back(env, held, 2);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexSelectF64(JNIEnv* env, jclass type, jobject index, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jint oneKind,
    jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jobject out, jlong capacity, jobject state) {
  lent held[4];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  prepare(env, state, &held[3]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 4)) {
    vesica_shapes_f64 sets[MAX_SETS];
    SETS(sets, lent_to[0], double);
    vesica_shapes_f64 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, double);
    answer = vesica_index_select_f64(held[0].address, sets, lent_to[0].count, &one, held[2].address, capacity,
        held[3].address);
  }
  give_back(env, held, 4);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinF64(JNIEnv* env, jclass type, jint query, jobject indexA,
    jintArray setsAKinds, jlongArray setsACounts, jlongArray setsAStrides, jlongArray setsASteps,
    jobjectArray setsABases, jobject indexB, jintArray setsBKinds, jlongArray setsBCounts, jlongArray setsBStrides,
    jlongArray setsBSteps, jobjectArray setsBBases, jlong part, jlong parts, jobject scratch, jlong scratchSize,
    jobject outA, jobject outB, jlong capacity, jobject state) {
  lent held[6];
  lent_sets lent_to[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, indexA, &held[0]);
  if (!prepare_sets(env, setsAKinds, setsACounts, setsAStrides, setsASteps, setsABases, &lent_to[0])) return NOT_LENT;
  prepare(env, indexB, &held[1]);
  if (!prepare_sets(env, setsBKinds, setsBCounts, setsBStrides, setsBSteps, setsBBases, &lent_to[1])) return NOT_LENT;
  prepare(env, scratch, &held[2]);
  prepare(env, outA, &held[3]);
  prepare(env, outB, &held[4]);
  prepare(env, state, &held[5]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, lent_to[1].held, lent_to[1].count)
      && lend(env, held, 6)) {
    vesica_shapes_f64 setsA[MAX_SETS];
    SETS(setsA, lent_to[0], double);
    vesica_shapes_f64 setsB[MAX_SETS];
    SETS(setsB, lent_to[1], double);
    answer = vesica_join_f64(query, held[0].address, setsA, lent_to[0].count, held[1].address, setsB, lent_to[1].count,
        part, parts, held[2].address, scratchSize, held[3].address, held[4].address, capacity, held[5].address);
  }
  give_back(env, held, 6);
  give_back(env, lent_to[0].held, lent_to[0].count);
  give_back(env, lent_to[1].held, lent_to[1].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinWithinF64(JNIEnv* env, jclass type, jobject indexA, jintArray setsAKinds,
    jlongArray setsACounts, jlongArray setsAStrides, jlongArray setsASteps, jobjectArray setsABases, jobject indexB,
    jintArray setsBKinds, jlongArray setsBCounts, jlongArray setsBStrides, jlongArray setsBSteps,
    jobjectArray setsBBases, jdouble distance, jlong part, jlong parts, jobject outA, jobject outB, jlong capacity,
    jobject state) {
  lent held[5];
  lent_sets lent_to[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, indexA, &held[0]);
  if (!prepare_sets(env, setsAKinds, setsACounts, setsAStrides, setsASteps, setsABases, &lent_to[0])) return NOT_LENT;
  prepare(env, indexB, &held[1]);
  if (!prepare_sets(env, setsBKinds, setsBCounts, setsBStrides, setsBSteps, setsBBases, &lent_to[1])) return NOT_LENT;
  prepare(env, outA, &held[2]);
  prepare(env, outB, &held[3]);
  prepare(env, state, &held[4]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, lent_to[1].held, lent_to[1].count)
      && lend(env, held, 5)) {
    vesica_shapes_f64 setsA[MAX_SETS];
    SETS(setsA, lent_to[0], double);
    vesica_shapes_f64 setsB[MAX_SETS];
    SETS(setsB, lent_to[1], double);
    answer = vesica_join_within_f64(held[0].address, setsA, lent_to[0].count, held[1].address, setsB, lent_to[1].count,
        distance, part, parts, held[2].address, held[3].address, capacity, held[4].address);
  }
  give_back(env, held, 5);
  give_back(env, lent_to[0].held, lent_to[0].count);
  give_back(env, lent_to[1].held, lent_to[1].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexNearestF64(JNIEnv* env, jclass type, jobject index, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jint oneKind,
    jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jlong k, jdouble within, jobject out,
    jobject distance) {
  lent held[4];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  prepare(env, distance, &held[3]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 4)) {
    vesica_shapes_f64 sets[MAX_SETS];
    SETS(sets, lent_to[0], double);
    vesica_shapes_f64 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, double);
    answer = vesica_index_nearest_f64(held[0].address, sets, lent_to[0].count, &one, k, within, held[2].address,
        held[3].address);
  }
  give_back(env, held, 4);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinNearestF64(JNIEnv* env, jclass type, jintArray setsAKinds,
    jlongArray setsACounts, jlongArray setsAStrides, jlongArray setsASteps, jobjectArray setsABases, jobject indexB,
    jintArray setsBKinds, jlongArray setsBCounts, jlongArray setsBStrides, jlongArray setsBSteps,
    jobjectArray setsBBases, jlong k, jdouble within, jlong part, jlong parts, jobject out, jobject distance) {
  lent held[3];
  lent_sets lent_to[2];
  int64_t answer = NOT_LENT;
  (void)type;
  if (!prepare_sets(env, setsAKinds, setsACounts, setsAStrides, setsASteps, setsABases, &lent_to[0])) return NOT_LENT;
  prepare(env, indexB, &held[0]);
  if (!prepare_sets(env, setsBKinds, setsBCounts, setsBStrides, setsBSteps, setsBBases, &lent_to[1])) return NOT_LENT;
  prepare(env, out, &held[1]);
  prepare(env, distance, &held[2]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, lent_to[1].held, lent_to[1].count)
      && lend(env, held, 3)) {
    vesica_shapes_f64 setsA[MAX_SETS];
    SETS(setsA, lent_to[0], double);
    vesica_shapes_f64 setsB[MAX_SETS];
    SETS(setsB, lent_to[1], double);
    answer = vesica_join_nearest_f64(setsA, lent_to[0].count, held[0].address, setsB, lent_to[1].count, k, within, part,
        parts, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  give_back(env, lent_to[0].held, lent_to[0].count);
  give_back(env, lent_to[1].held, lent_to[1].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexBuildF32(JNIEnv* env, jclass type, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jobject index,
    jlong indexSize, jobject scratch, jlong scratchSize) {
  lent held[2];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, index, &held[0]);
  prepare(env, scratch, &held[1]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 2)) {
    vesica_shapes_f32 sets[MAX_SETS];
    SETS(sets, lent_to[0], float);
    answer = vesica_index_build_f32(sets, lent_to[0].count, held[0].address, indexSize, held[1].address, scratchSize);
  }
  give_back(env, held, 2);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexSelectF32(JNIEnv* env, jclass type, jobject index, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jint oneKind,
    jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jobject out, jlong capacity, jobject state) {
  lent held[4];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  prepare(env, state, &held[3]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 4)) {
    vesica_shapes_f32 sets[MAX_SETS];
    SETS(sets, lent_to[0], float);
    vesica_shapes_f32 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, float);
    answer = vesica_index_select_f32(held[0].address, sets, lent_to[0].count, &one, held[2].address, capacity,
        held[3].address);
  }
  give_back(env, held, 4);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinF32(JNIEnv* env, jclass type, jint query, jobject indexA,
    jintArray setsAKinds, jlongArray setsACounts, jlongArray setsAStrides, jlongArray setsASteps,
    jobjectArray setsABases, jobject indexB, jintArray setsBKinds, jlongArray setsBCounts, jlongArray setsBStrides,
    jlongArray setsBSteps, jobjectArray setsBBases, jlong part, jlong parts, jobject scratch, jlong scratchSize,
    jobject outA, jobject outB, jlong capacity, jobject state) {
  lent held[6];
  lent_sets lent_to[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, indexA, &held[0]);
  if (!prepare_sets(env, setsAKinds, setsACounts, setsAStrides, setsASteps, setsABases, &lent_to[0])) return NOT_LENT;
  prepare(env, indexB, &held[1]);
  if (!prepare_sets(env, setsBKinds, setsBCounts, setsBStrides, setsBSteps, setsBBases, &lent_to[1])) return NOT_LENT;
  prepare(env, scratch, &held[2]);
  prepare(env, outA, &held[3]);
  prepare(env, outB, &held[4]);
  prepare(env, state, &held[5]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, lent_to[1].held, lent_to[1].count)
      && lend(env, held, 6)) {
    vesica_shapes_f32 setsA[MAX_SETS];
    SETS(setsA, lent_to[0], float);
    vesica_shapes_f32 setsB[MAX_SETS];
    SETS(setsB, lent_to[1], float);
    answer = vesica_join_f32(query, held[0].address, setsA, lent_to[0].count, held[1].address, setsB, lent_to[1].count,
        part, parts, held[2].address, scratchSize, held[3].address, held[4].address, capacity, held[5].address);
  }
  give_back(env, held, 6);
  give_back(env, lent_to[0].held, lent_to[0].count);
  give_back(env, lent_to[1].held, lent_to[1].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinWithinF32(JNIEnv* env, jclass type, jobject indexA, jintArray setsAKinds,
    jlongArray setsACounts, jlongArray setsAStrides, jlongArray setsASteps, jobjectArray setsABases, jobject indexB,
    jintArray setsBKinds, jlongArray setsBCounts, jlongArray setsBStrides, jlongArray setsBSteps,
    jobjectArray setsBBases, jfloat distance, jlong part, jlong parts, jobject outA, jobject outB, jlong capacity,
    jobject state) {
  lent held[5];
  lent_sets lent_to[2];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, indexA, &held[0]);
  if (!prepare_sets(env, setsAKinds, setsACounts, setsAStrides, setsASteps, setsABases, &lent_to[0])) return NOT_LENT;
  prepare(env, indexB, &held[1]);
  if (!prepare_sets(env, setsBKinds, setsBCounts, setsBStrides, setsBSteps, setsBBases, &lent_to[1])) return NOT_LENT;
  prepare(env, outA, &held[2]);
  prepare(env, outB, &held[3]);
  prepare(env, state, &held[4]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, lent_to[1].held, lent_to[1].count)
      && lend(env, held, 5)) {
    vesica_shapes_f32 setsA[MAX_SETS];
    SETS(setsA, lent_to[0], float);
    vesica_shapes_f32 setsB[MAX_SETS];
    SETS(setsB, lent_to[1], float);
    answer = vesica_join_within_f32(held[0].address, setsA, lent_to[0].count, held[1].address, setsB, lent_to[1].count,
        distance, part, parts, held[2].address, held[3].address, capacity, held[4].address);
  }
  give_back(env, held, 5);
  give_back(env, lent_to[0].held, lent_to[0].count);
  give_back(env, lent_to[1].held, lent_to[1].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexNearestF32(JNIEnv* env, jclass type, jobject index, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jint oneKind,
    jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jlong k, jfloat within, jobject out,
    jobject distance) {
  lent held[4];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  prepare(env, distance, &held[3]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 4)) {
    vesica_shapes_f32 sets[MAX_SETS];
    SETS(sets, lent_to[0], float);
    vesica_shapes_f32 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, float);
    answer = vesica_index_nearest_f32(held[0].address, sets, lent_to[0].count, &one, k, within, held[2].address,
        held[3].address);
  }
  give_back(env, held, 4);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_joinNearestF32(JNIEnv* env, jclass type, jintArray setsAKinds,
    jlongArray setsACounts, jlongArray setsAStrides, jlongArray setsASteps, jobjectArray setsABases, jobject indexB,
    jintArray setsBKinds, jlongArray setsBCounts, jlongArray setsBStrides, jlongArray setsBSteps,
    jobjectArray setsBBases, jlong k, jfloat within, jlong part, jlong parts, jobject out, jobject distance) {
  lent held[3];
  lent_sets lent_to[2];
  int64_t answer = NOT_LENT;
  (void)type;
  if (!prepare_sets(env, setsAKinds, setsACounts, setsAStrides, setsASteps, setsABases, &lent_to[0])) return NOT_LENT;
  prepare(env, indexB, &held[0]);
  if (!prepare_sets(env, setsBKinds, setsBCounts, setsBStrides, setsBSteps, setsBBases, &lent_to[1])) return NOT_LENT;
  prepare(env, out, &held[1]);
  prepare(env, distance, &held[2]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, lent_to[1].held, lent_to[1].count)
      && lend(env, held, 3)) {
    vesica_shapes_f32 setsA[MAX_SETS];
    SETS(setsA, lent_to[0], float);
    vesica_shapes_f32 setsB[MAX_SETS];
    SETS(setsB, lent_to[1], float);
    answer = vesica_join_nearest_f32(setsA, lent_to[0].count, held[0].address, setsB, lent_to[1].count, k, within, part,
        parts, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  give_back(env, lent_to[0].held, lent_to[0].count);
  give_back(env, lent_to[1].held, lent_to[1].count);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ratioF64(JNIEnv* env, jclass type, jint ratio, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_ratio_f64(ratio, kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_ratioManyF64(JNIEnv* env, jclass type, jint ratio, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_ratio_many_f64(ratio, &a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_ratioMatrixF64(JNIEnv* env, jclass type, jint ratio, jint aKind,
    jlong aCount, jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep,
    jobject bBase, jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_ratio_matrix_f64(ratio, &a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_nearestMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_nearest_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boundaryDistanceMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_boundary_distance_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_depthMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_depth_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_signedDistanceF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_signed_distance_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_signedDistanceManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_signed_distance_many_f64(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_signedDistanceMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_signed_distance_matrix_f64(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_withinF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jdouble distance) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_within_f64(kindA, held[0].address, kindB, held[1].address, distance);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_withinManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jdouble distance, jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_within_many_f64(&a, &b, distance, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_withinMatrixF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jdouble distance, jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_within_matrix_f64(&a, &b, distance, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_suppressF64(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject scores, jobject labels, jint ratio,
    jdouble threshold, jdouble leastScore, jlong most, jobject scratch, jlong scratchSize, jobject keep, jobject kept) {
  lent held[6];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, scores, &held[1]);
  prepare(env, labels, &held[2]);
  prepare(env, scratch, &held[3]);
  prepare(env, keep, &held[4]);
  prepare(env, kept, &held[5]);
  if (lend(env, held, 6)) {
    vesica_shapes_f64 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, double);
    answer = vesica_suppress_f64(&shapes, held[1].address, held[2].address, ratio, threshold, leastScore, most,
        held[3].address, scratchSize, held[4].address, held[5].address);
  }
  give_back(env, held, 6);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_suppressSoftScratch(JNIEnv* env, jclass type, jlong count) {
  (void)env, (void)type;
  return vesica_suppress_soft_scratch(count);
}

JNIEXPORT jint JNICALL Java_vesica_Native_suppressSoftF64(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject scores, jobject labels, jint ratio, jint decay,
    jdouble parameter, jdouble leastScore, jlong most, jobject scratch, jlong scratchSize, jobject keep,
    jobject decayed, jobject kept) {
  lent held[7];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, scores, &held[1]);
  prepare(env, labels, &held[2]);
  prepare(env, scratch, &held[3]);
  prepare(env, keep, &held[4]);
  prepare(env, decayed, &held[5]);
  prepare(env, kept, &held[6]);
  if (lend(env, held, 7)) {
    vesica_shapes_f64 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, double);
    answer = vesica_suppress_soft_f64(&shapes, held[1].address, held[2].address, ratio, decay, parameter, leastScore,
        most, held[3].address, scratchSize, held[4].address, held[5].address, held[6].address);
  }
  give_back(env, held, 7);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_ratioF32(JNIEnv* env, jclass type, jint ratio, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_ratio_f32(ratio, kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_ratioManyF32(JNIEnv* env, jclass type, jint ratio, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_ratio_many_f32(ratio, &a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_ratioMatrixF32(JNIEnv* env, jclass type, jint ratio, jint aKind,
    jlong aCount, jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep,
    jobject bBase, jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_ratio_matrix_f32(ratio, &a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_nearestMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_nearest_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_boundaryDistanceMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_boundary_distance_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_depthMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_depth_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_suppressF32(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject scores, jobject labels, jint ratio,
    jfloat threshold, jfloat leastScore, jlong most, jobject scratch, jlong scratchSize, jobject keep, jobject kept) {
  lent held[6];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, scores, &held[1]);
  prepare(env, labels, &held[2]);
  prepare(env, scratch, &held[3]);
  prepare(env, keep, &held[4]);
  prepare(env, kept, &held[5]);
  if (lend(env, held, 6)) {
    vesica_shapes_f32 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, float);
    answer = vesica_suppress_f32(&shapes, held[1].address, held[2].address, ratio, threshold, leastScore, most,
        held[3].address, scratchSize, held[4].address, held[5].address);
  }
  give_back(env, held, 6);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_signedDistanceF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_signed_distance_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_signedDistanceManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_signed_distance_many_f32(&a, &b, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_signedDistanceMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_signed_distance_matrix_f32(&a, &b, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_withinF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jfloat distance) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_within_f32(kindA, held[0].address, kindB, held[1].address, distance);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_withinManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jfloat distance, jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_within_many_f32(&a, &b, distance, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_withinMatrixF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jfloat distance, jobject out, jlong rowStride) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_within_matrix_f32(&a, &b, distance, held[2].address, rowStride);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_suppressSoftF32(JNIEnv* env, jclass type, jint shapesKind, jlong shapesCount,
    jlong shapesStride, jlong shapesStep, jobject shapesBase, jobject scores, jobject labels, jint ratio, jint decay,
    jfloat parameter, jfloat leastScore, jlong most, jobject scratch, jlong scratchSize, jobject keep, jobject decayed,
    jobject kept) {
  lent held[7];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, shapesBase, &held[0]);
  prepare(env, scores, &held[1]);
  prepare(env, labels, &held[2]);
  prepare(env, scratch, &held[3]);
  prepare(env, keep, &held[4]);
  prepare(env, decayed, &held[5]);
  prepare(env, kept, &held[6]);
  if (lend(env, held, 7)) {
    vesica_shapes_f32 shapes;
    VIEW(shapes, shapesKind, shapesCount, shapesStride, shapesStep, held[0].address, float);
    answer = vesica_suppress_soft_f32(&shapes, held[1].address, held[2].address, ratio, decay, parameter, leastScore,
        most, held[3].address, scratchSize, held[4].address, held[5].address, held[6].address);
  }
  give_back(env, held, 7);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jdouble vx, jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_f64(kindA, held[0].address, kindB, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_castManyF64(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject vx, jobject vy, jlong stride, jdouble tEnd, jobject t, jobject x, jobject y, jobject nx, jobject ny) {
  lent held[9];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, vx, &held[2]);
  prepare(env, vy, &held[3]);
  prepare(env, t, &held[4]);
  prepare(env, x, &held[5]);
  prepare(env, y, &held[6]);
  prepare(env, nx, &held[7]);
  prepare(env, ny, &held[8]);
  if (lend(env, held, 9)) {
    vesica_shapes_f64 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, double);
    vesica_shapes_f64 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, double);
    answer = vesica_cast_many_f64(&a, &b, held[2].address, held[3].address, stride, tEnd, held[4].address,
        held[5].address, held[6].address, held[7].address, held[8].address);
  }
  give_back(env, held, 9);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_castFirstF64(JNIEnv* env, jclass type, jint oneKind, jlong oneCount,
    jlong oneStride, jlong oneStep, jobject oneBase, jint manyKind, jlong manyCount, jlong manyStride, jlong manyStep,
    jobject manyBase, jdouble vx, jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, oneBase, &held[0]);
  prepare(env, manyBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f64 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[0].address, double);
    vesica_shapes_f64 many;
    VIEW(many, manyKind, manyCount, manyStride, manyStep, held[1].address, double);
    answer = vesica_cast_first_f64(&one, &many, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_sweepBoundsF64(JNIEnv* env, jclass type, jint kind, jobject numbers,
    jdouble vx, jdouble vy, jdouble tEnd, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_sweep_bounds_f64(kind, held[0].address, vx, vy, tEnd, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexCastF64(JNIEnv* env, jclass type, jobject index, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jint oneKind,
    jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jdouble vx, jdouble vy, jdouble tEnd, jobject out,
    jlong capacity, jobject state) {
  lent held[4];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  prepare(env, state, &held[3]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 4)) {
    vesica_shapes_f64 sets[MAX_SETS];
    SETS(sets, lent_to[0], double);
    vesica_shapes_f64 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, double);
    answer = vesica_index_cast_f64(held[0].address, sets, lent_to[0].count, &one, vx, vy, tEnd, held[2].address,
        capacity, held[3].address);
  }
  give_back(env, held, 4);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexCastFirstF64(JNIEnv* env, jclass type, jobject index,
    jintArray setsKinds, jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases,
    jint oneKind, jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jdouble vx, jdouble vy, jdouble tEnd,
    jobject out) {
  lent held[3];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 3)) {
    vesica_shapes_f64 sets[MAX_SETS];
    SETS(sets, lent_to[0], double);
    vesica_shapes_f64 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, double);
    answer = vesica_index_cast_first_f64(held[0].address, sets, lent_to[0].count, &one, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_impactTimeF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jobject turnA, jint kindB, jobject numbersB, jobject turnB, jdouble tolerance, jobject out, jobject gap) {
  lent held[6];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, turnA, &held[1]);
  prepare(env, numbersB, &held[2]);
  prepare(env, turnB, &held[3]);
  prepare(env, out, &held[4]);
  prepare(env, gap, &held[5]);
  if (lend(env, held, 6)) {
    answer = vesica_impact_time_f64(kindA, held[0].address, held[1].address, kindB, held[2].address, held[3].address,
        tolerance, held[4].address, held[5].address);
  }
  give_back(env, held, 6);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castPointPointF64(JNIEnv* env, jclass type, jobject a, jobject b, jdouble vx,
    jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_point_point_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castSegmentPointF64(JNIEnv* env, jclass type, jobject a, jobject b,
    jdouble vx, jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_segment_point_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castCirclePointF64(JNIEnv* env, jclass type, jobject a, jobject b, jdouble vx,
    jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_circle_point_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castAabbPointF64(JNIEnv* env, jclass type, jobject a, jobject b, jdouble vx,
    jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_aabb_point_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castRectPointF64(JNIEnv* env, jclass type, jobject a, jobject b, jdouble vx,
    jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_rect_point_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castEllipsePointF64(JNIEnv* env, jclass type, jobject a, jobject b,
    jdouble vx, jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_ellipse_point_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castCircleCircleF64(JNIEnv* env, jclass type, jobject a, jobject b,
    jdouble vx, jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_circle_circle_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castRectRectF64(JNIEnv* env, jclass type, jobject a, jobject b, jdouble vx,
    jdouble vy, jdouble tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_rect_rect_f64(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jfloat vx, jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_f32(kindA, held[0].address, kindB, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_castManyF32(JNIEnv* env, jclass type, jint aKind, jlong aCount,
    jlong aStride, jlong aStep, jobject aBase, jint bKind, jlong bCount, jlong bStride, jlong bStep, jobject bBase,
    jobject vx, jobject vy, jlong stride, jfloat tEnd, jobject t, jobject x, jobject y, jobject nx, jobject ny) {
  lent held[9];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, aBase, &held[0]);
  prepare(env, bBase, &held[1]);
  prepare(env, vx, &held[2]);
  prepare(env, vy, &held[3]);
  prepare(env, t, &held[4]);
  prepare(env, x, &held[5]);
  prepare(env, y, &held[6]);
  prepare(env, nx, &held[7]);
  prepare(env, ny, &held[8]);
  if (lend(env, held, 9)) {
    vesica_shapes_f32 a;
    VIEW(a, aKind, aCount, aStride, aStep, held[0].address, float);
    vesica_shapes_f32 b;
    VIEW(b, bKind, bCount, bStride, bStep, held[1].address, float);
    answer = vesica_cast_many_f32(&a, &b, held[2].address, held[3].address, stride, tEnd, held[4].address,
        held[5].address, held[6].address, held[7].address, held[8].address);
  }
  give_back(env, held, 9);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_castFirstF32(JNIEnv* env, jclass type, jint oneKind, jlong oneCount,
    jlong oneStride, jlong oneStep, jobject oneBase, jint manyKind, jlong manyCount, jlong manyStride, jlong manyStep,
    jobject manyBase, jfloat vx, jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, oneBase, &held[0]);
  prepare(env, manyBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    vesica_shapes_f32 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[0].address, float);
    vesica_shapes_f32 many;
    VIEW(many, manyKind, manyCount, manyStride, manyStep, held[1].address, float);
    answer = vesica_cast_first_f32(&one, &many, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_sweepBoundsF32(JNIEnv* env, jclass type, jint kind, jobject numbers,
    jfloat vx, jfloat vy, jfloat tEnd, jobject out) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbers, &held[0]);
  prepare(env, out, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_sweep_bounds_f32(kind, held[0].address, vx, vy, tEnd, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexCastF32(JNIEnv* env, jclass type, jobject index, jintArray setsKinds,
    jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases, jint oneKind,
    jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jfloat vx, jfloat vy, jfloat tEnd, jobject out,
    jlong capacity, jobject state) {
  lent held[4];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  prepare(env, state, &held[3]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 4)) {
    vesica_shapes_f32 sets[MAX_SETS];
    SETS(sets, lent_to[0], float);
    vesica_shapes_f32 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, float);
    answer = vesica_index_cast_f32(held[0].address, sets, lent_to[0].count, &one, vx, vy, tEnd, held[2].address,
        capacity, held[3].address);
  }
  give_back(env, held, 4);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jlong JNICALL Java_vesica_Native_indexCastFirstF32(JNIEnv* env, jclass type, jobject index,
    jintArray setsKinds, jlongArray setsCounts, jlongArray setsStrides, jlongArray setsSteps, jobjectArray setsBases,
    jint oneKind, jlong oneCount, jlong oneStride, jlong oneStep, jobject oneBase, jfloat vx, jfloat vy, jfloat tEnd,
    jobject out) {
  lent held[3];
  lent_sets lent_to[1];
  int64_t answer = NOT_LENT;
  (void)type;
  prepare(env, index, &held[0]);
  if (!prepare_sets(env, setsKinds, setsCounts, setsStrides, setsSteps, setsBases, &lent_to[0])) return NOT_LENT;
  prepare(env, oneBase, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, lent_to[0].held, lent_to[0].count)
      && lend(env, held, 3)) {
    vesica_shapes_f32 sets[MAX_SETS];
    SETS(sets, lent_to[0], float);
    vesica_shapes_f32 one;
    VIEW(one, oneKind, oneCount, oneStride, oneStep, held[1].address, float);
    answer = vesica_index_cast_first_f32(held[0].address, sets, lent_to[0].count, &one, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  give_back(env, lent_to[0].held, lent_to[0].count);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_impactTimeF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jobject turnA, jint kindB, jobject numbersB, jobject turnB, jfloat tolerance, jobject out, jobject gap) {
  lent held[6];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, turnA, &held[1]);
  prepare(env, numbersB, &held[2]);
  prepare(env, turnB, &held[3]);
  prepare(env, out, &held[4]);
  prepare(env, gap, &held[5]);
  if (lend(env, held, 6)) {
    answer = vesica_impact_time_f32(kindA, held[0].address, held[1].address, kindB, held[2].address, held[3].address,
        tolerance, held[4].address, held[5].address);
  }
  give_back(env, held, 6);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castPointPointF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_point_point_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castSegmentPointF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_segment_point_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castCirclePointF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_circle_point_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castAabbPointF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_aabb_point_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castRectPointF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_rect_point_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castEllipsePointF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_ellipse_point_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castCircleCircleF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_circle_circle_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_castRectRectF32(JNIEnv* env, jclass type, jobject a, jobject b, jfloat vx,
    jfloat vy, jfloat tEnd, jobject out) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, a, &held[0]);
  prepare(env, b, &held[1]);
  prepare(env, out, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_cast_rect_rect_f32(held[0].address, held[1].address, vx, vy, tEnd, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_de9imF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject matrix) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, matrix, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_de9im_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_de9imMatch(JNIEnv* env, jclass type, jobject matrix, jobject pattern) {
  lent held[2];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, matrix, &held[0]);
  prepare(env, pattern, &held[1]);
  if (lend(env, held, 2)) {
    answer = vesica_de9im_match(held[0].address, held[1].address);
  }
  give_back(env, held, 2);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_intersectionF64(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject vertices) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, vertices, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_intersection_f64(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_de9imF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA, jint kindB,
    jobject numbersB, jobject matrix) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, matrix, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_de9im_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}

JNIEXPORT jint JNICALL Java_vesica_Native_intersectionF32(JNIEnv* env, jclass type, jint kindA, jobject numbersA,
    jint kindB, jobject numbersB, jobject vertices) {
  lent held[3];
  int32_t answer = NOT_LENT;
  (void)type;
  prepare(env, numbersA, &held[0]);
  prepare(env, numbersB, &held[1]);
  prepare(env, vertices, &held[2]);
  if (lend(env, held, 3)) {
    answer = vesica_intersection_f32(kindA, held[0].address, kindB, held[1].address, held[2].address);
  }
  give_back(env, held, 3);
  return answer;
}
