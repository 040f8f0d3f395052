/* SPDX-License-Identifier: Apache-2.0 */
/* The native methods of Vesica.java. They return the library's codes; Java makes exceptions of them. */
#include <jni.h>
#include <vesica.h>

JNIEXPORT jint JNICALL Java_Vesica_version(JNIEnv* env, jclass type) {
  (void)env, (void)type;
  return vesica_version();
}

JNIEXPORT jstring JNICALL Java_Vesica_message(JNIEnv* env, jclass type, jint code) {
  (void)type;
  return (*env)->NewStringUTF(env, vesica_strerror(code));
}

/* One shape is copied: six numbers at most. An array that is too short throws in Java, and the result is ignored. */
static int32_t two_shapes(JNIEnv* env, jint kind_a, jdoubleArray a, jint kind_b, jdoubleArray b, double* numbers_a,
                          double* numbers_b) {
  const jint count_a = vesica_field_count(kind_a), count_b = vesica_field_count(kind_b);
  if (a == NULL || b == NULL) return VESICA_E_NULL;
  if (count_a < 0 || count_b < 0) return VESICA_E_KIND;
  (*env)->GetDoubleArrayRegion(env, a, 0, count_a, numbers_a);
  if ((*env)->ExceptionCheck(env)) return VESICA_E_ARGUMENT;
  (*env)->GetDoubleArrayRegion(env, b, 0, count_b, numbers_b);
  return (*env)->ExceptionCheck(env) ? VESICA_E_ARGUMENT : 0;
}

JNIEXPORT jint JNICALL Java_Vesica_overlap64(JNIEnv* env, jclass type, jint kind_a, jdoubleArray a, jint kind_b,
                                             jdoubleArray b) {
  double numbers_a[6], numbers_b[6];
  const int32_t error = two_shapes(env, kind_a, a, kind_b, b, numbers_a, numbers_b);
  (void)type;
  return error != 0 ? error : vesica_overlap_f64(kind_a, numbers_a, kind_b, numbers_b);
}

JNIEXPORT jint JNICALL Java_Vesica_nearest64(JNIEnv* env, jclass type, jint kind_a, jdoubleArray a, jint kind_b,
                                             jdoubleArray b, jdoubleArray out) {
  double numbers_a[6], numbers_b[6];
  vesica_closest_points_f64 points;
  int32_t answer = two_shapes(env, kind_a, a, kind_b, b, numbers_a, numbers_b);
  (void)type;
  if (answer == 0) answer = vesica_nearest_f64(kind_a, numbers_a, kind_b, numbers_b, &points);
  if (answer == 0) (*env)->SetDoubleArrayRegion(env, out, 0, 5, &points.distance);
  return answer;
}

JNIEXPORT jint JNICALL Java_Vesica_overlap32(JNIEnv* env, jclass type, jint kind_a, jfloatArray a, jint kind_b,
                                             jfloatArray b) {
  float numbers_a[6], numbers_b[6];
  const jint count_a = vesica_field_count(kind_a), count_b = vesica_field_count(kind_b);
  (void)type;
  if (a == NULL || b == NULL) return VESICA_E_NULL;
  if (count_a < 0 || count_b < 0) return VESICA_E_KIND;
  (*env)->GetFloatArrayRegion(env, a, 0, count_a, numbers_a);
  if ((*env)->ExceptionCheck(env)) return 0;
  (*env)->GetFloatArrayRegion(env, b, 0, count_b, numbers_b);
  if ((*env)->ExceptionCheck(env)) return 0;
  return vesica_overlap_f32(kind_a, numbers_a, kind_b, numbers_b);
}

/* How many shapes the numbers of an array are, or an error. */
static int64_t shape_count(JNIEnv* env, jint kind, jdoubleArray array) {
  if (array == NULL) return VESICA_E_NULL;
  const jint fields = vesica_field_count(kind), length = (*env)->GetArrayLength(env, array);
  if (fields < 0) return fields;
  return length % fields == 0 ? length / fields : VESICA_E_ARGUMENT;
}

static int64_t overlap_many(jint kind_a, int64_t count_a, const double* a, jint kind_b, int64_t count_b,
                            const double* b, uint8_t* out) {
  vesica_shapes_f64 shapes_a, shapes_b;
  const ptrdiff_t size_a = vesica_field_count(kind_a) * 8, size_b = vesica_field_count(kind_b) * 8;
  vesica_shapes_from_records_f64(kind_a, count_a, a, size_a, &shapes_a);
  vesica_shapes_from_records_f64(kind_b, count_b, b, size_b, &shapes_b);
  return vesica_overlap_many_f64(&shapes_a, &shapes_b, out);
}

/* The arrays stay where they are in Java's heap; the collector waits, or pins them, for the time of the call. */
JNIEXPORT jlong JNICALL Java_Vesica_overlapMany64(JNIEnv* env, jclass type, jint kind_a, jdoubleArray a, jint kind_b,
                                                  jdoubleArray b, jbooleanArray out) {
  const int64_t count_a = shape_count(env, kind_a, a), count_b = shape_count(env, kind_b, b);
  (void)type;
  if (count_a < 0) return count_a;
  if (count_b < 0) return count_b;
  if (out == NULL) return VESICA_E_NULL;
  if (count_a == 0 || count_b == 0) return 0;
  const jint room = (*env)->GetArrayLength(env, out);
  if (room < count_a || room < count_b) return VESICA_E_ARGUMENT;

  int64_t answer = VESICA_E_NULL; /* out of memory, should the machine copy */
  void* numbers_a = (*env)->GetPrimitiveArrayCritical(env, a, NULL);
  void* numbers_b = (*env)->GetPrimitiveArrayCritical(env, b, NULL);
  void* answers = (*env)->GetPrimitiveArrayCritical(env, out, NULL);
  if (numbers_a != NULL && numbers_b != NULL && answers != NULL)
    answer = overlap_many(kind_a, count_a, numbers_a, kind_b, count_b, numbers_b, answers);
  if (answers != NULL) (*env)->ReleasePrimitiveArrayCritical(env, out, answers, 0);
  if (numbers_b != NULL) (*env)->ReleasePrimitiveArrayCritical(env, b, numbers_b, JNI_ABORT);
  if (numbers_a != NULL) (*env)->ReleasePrimitiveArrayCritical(env, a, numbers_a, JNI_ABORT);
  return answer;
}
